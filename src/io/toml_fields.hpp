// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "echoarc/core/angle.hpp"
#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// `text` as TOML. `source` names it in messages (a file name). The error says line and column.
[[nodiscard]] Result<toml::table> parse_toml(std::string_view text, std::string_view source);

/// "file.toml:12", the place of a node.
[[nodiscard]] std::string toml_place(std::string_view source, const toml::source_region& region);

/// Reads the keys of one TOML table, one by one.
///
/// Every getter returns nothing when the key is absent, and also when its value is illegal; the first such error is
/// kept and comes out of `finish`, as does a key that no getter ever asked for. So a reader asks for everything it
/// knows, and checks once:
///
///     TomlFields fields(table, "robot.toml", "sensor");
///     sensor.x_m = fields.length_m("x").value_or(0.0);
///     if (const auto done = fields.finish(); !done) return done.error();
///
/// The table must outlive this object.
class TomlFields {
 public:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// `what` names the table in messages: "robot", "sensor", "ring".
  TomlFields(const toml::table& table, std::string_view source, std::string_view what)
      : table_(table), source_(source), what_(what) {}

  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
  /// A finite number, whole or not, within [min, max].
  std::optional<double> number(std::string_view key, double min = -infinity, double max = infinity);
  /// Metres, spelled `key` or `key_m`.
  std::optional<double> length_m(std::string_view key, double min = -infinity, double max = infinity);
  /// An angle, spelled `key` (radians) or `key_deg` (degrees).
  std::optional<Angle> angle(std::string_view key);
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t min, std::int64_t max);
  std::optional<bool> boolean(std::string_view key);
  std::optional<std::string> text(std::string_view key);
  const toml::table* table(std::string_view key);
  const toml::array* array(std::string_view key);
  /// One table, or every table of an array of them. At most `max_count`.
  std::vector<const toml::table*> tables(std::string_view key, std::size_t max_count);
  /// Any value; the caller checks its type.
  const toml::node* node(std::string_view key);

  /// Keeps an error of the caller, unless there already is one. Without `at` it points to the table.
  void fail(const toml::node* at, std::string message, std::string remedy);
  void fail(Error error);
  /// The first error met, or an error for the first key that was never asked for.
  [[nodiscard]] Result<void> finish();
  [[nodiscard]] std::string_view source() const { return source_; }

 private:
  void wrong_type(const toml::node& node, std::string_view key, std::string_view wanted);
  [[nodiscard]] Error unknown_key(const toml::key& key) const;

  const toml::table& table_;
  std::string source_;
  std::string what_;
  std::set<std::string, std::less<>> known_;
  std::optional<Error> error_;
};

}  // namespace echoarc::io
