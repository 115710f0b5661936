// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/executor.hpp"
#include "echoarc/live/map_store.hpp"
#include "echoarc/live/reading_log.hpp"
#include "echoarc/live/source.hpp"
#include "echoarc/live/truth_log.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/sensing_options.hpp"
#include "echoarc/sensing/sensing_report.hpp"

namespace echoarc::live {

/// A method that is to run. Several of one name may, with different options: their ids tell them apart.
struct MethodChoice {
  std::string name;     ///< in the catalogue
  OptionMap options;    ///< what differs from the defaults
  std::string id = {};  ///< empty: its name

  [[nodiscard]] const std::string& key() const { return id.empty() ? name : id; }
};
/// What an id may be: 1 to 64 of a-z, 0-9, `_` and `-`, a letter or digit first. So it is a name of a folder, too.
[[nodiscard]] bool is_method_id(std::string_view id);

/// How one method of a mapper is doing.
struct RunningMethod {
  enum class State : std::uint8_t { ok, recomputing, failed };
  MethodChoice choice;
  [[nodiscard]] const std::string& id() const { return choice.key(); }
  OptionMap options;        ///< all of them, defaults included
  InsertCounters counters;  ///< as of `map`
  State state = State::ok;
  std::string reason;          ///< of a failure
  std::size_t recomputed = 0;  ///< readings, while recomputing
  std::size_t recompute_total = 0;
  std::shared_ptr<const MapExport> map;  ///< newest export; null before the first
  MapStore store;
  double insert_cpu_s = 0.0;  ///< 0 without a clock
  bool point_method = false;
};

struct TimelineBin {
  std::uint32_t echoes = 0;
  std::uint32_t no_echoes = 0;
  std::uint32_t rejected = 0;
};

/// Records in, maps out, several methods over one pass, and options that change on the way: a changed method is
/// computed anew from the readings so far, in slices, and takes the place of the old one when it has caught up.
///
/// Methods are brought up to date (`finish`) by the records' own time, every `finish_interval_s`, never by a clock, so
/// the same records give the same maps, byte for byte, however they came in.
class Mapper {
 public:
  static constexpr double finish_interval_s = 0.1;
  static constexpr double timeline_bin_s = 1.0;
  static constexpr std::size_t max_methods = 32;

  /// Errors: unknown methods, options out of range.
  [[nodiscard]] static Result<Mapper> make(const SourceDescription& source, const SensingOptions& sensing,
                                           std::span<const MethodChoice> methods, Executor& executor,
                                           std::function<double()> thread_cpu_s = {});
  Mapper(Mapper&&) noexcept;
  Mapper& operator=(Mapper&&) noexcept;
  ~Mapper();

  void push(const Record& record);
  /// No more records: waiting pings are decided.
  void end_of_records();
  /// A slice of pending recomputation, about so many readings. True while more is left.
  bool work(std::size_t readings);
  /// Exports every method that changed since into its store. Returns whether anything did.
  bool refresh();
  /// All records so far are forgotten (a log that is played jumped back); methods and options stay.
  void restart();

  /// Errors: unknown methods, options out of range, an id that is taken, or none, or another method's name.
  Result<void> add_method(const MethodChoice& choice);
  Result<void> remove_method(std::string_view id);
  Result<void> set_options(std::string_view id, const OptionMap& options);
  /// Turns a sensor's readings off or on for all maps; they are recomputed.
  Result<void> use_sensor(SensorId sensor, bool on);

  [[nodiscard]] std::span<const RunningMethod> methods() const;
  [[nodiscard]] const ReadingLog& readings() const;
  [[nodiscard]] const SensingReport& report() const;
  [[nodiscard]] std::span<const Odometry> path() const;
  [[nodiscard]] const TruthLog& truth() const;
  [[nodiscard]] std::span<const Vec2> laser() const;  ///< returns of the newest scan, world
  [[nodiscard]] std::span<const TimelineBin> timeline() const;
  [[nodiscard]] const std::set<SensorId>& sensors_off() const;
  /// The finished map as a batch over the same readings gives it (a whole `finish`): what is saved.
  [[nodiscard]] Result<MapExport> final_map(std::string_view id) const;

 private:
  class State;
  explicit Mapper(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace echoarc::live
