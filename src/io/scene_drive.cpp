// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/scene_drive.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "io/option_toml.hpp"
#include "io/toml_points.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t max_legs = 1'000'000;

/// A point [x, y], or a table with `to` or `turn_deg`.
std::optional<sim::DriveLeg> read_leg(TomlFields& drive, const toml::node& node) {
  sim::DriveLeg leg{.line = toml_line(node)};
  const toml::table* table = node.as_table();
  if (table == nullptr) {
    leg.to = toml_point(drive, node, "a leg");
    return leg.to ? std::optional(leg) : std::nullopt;
  }
  TomlFields fields(*table, drive.source(), "leg");
  leg.to = read_point(fields, "to", false);
  leg.turn = fields.angle("turn");
  if (leg.to.has_value() == leg.turn.has_value())
    fields.fail(nullptr, "a leg is either straight or a turn", "write { to = [x, y] } or { turn_deg = 90 }");
  if (const Result<void> done = fields.finish(); !done) {
    drive.fail(done.error());
    return std::nullopt;
  }
  return leg;
}

void read_legs(TomlFields& fields, sim::Drive& drive) {
  const toml::array* legs = fields.array("legs");
  if (legs == nullptr) return;
  if (legs->size() > max_legs)
    fields.fail(legs, fmt::format("{} legs are too many", legs->size()),
                fmt::format("at most {} are allowed", max_legs));
  for (const toml::node& node : *legs) {
    const std::optional<sim::DriveLeg> leg = read_leg(fields, node);
    if (!leg) return;
    drive.legs.push_back(*leg);
  }
}

}  // namespace

sim::Drive read_drive(TomlFields& scene) {
  sim::Drive drive;
  const toml::table* table = scene.table("drive");
  if (table == nullptr) return drive;
  TomlFields fields(*table, scene.source(), "drive");
  if (const toml::node* start = fields.node("start"))
    if (const auto pose = toml_numbers(fields, *start, 3, "start", "start = [x, y, heading], in metres and degrees"))
      drive.start = {{(*pose)[0], (*pose)[1]}, degrees((*pose)[2])};
  read_legs(fields, drive);
  read_options(fields, drive);
  if (const Result<void> done = fields.finish(); !done) scene.fail(done.error());
  return drive;
}

}  // namespace echoarc::io
