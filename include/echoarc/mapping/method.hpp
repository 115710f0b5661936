// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/core/executor.hpp"
#include "echoarc/core/options.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/maps/arc_state.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/maps/point_map.hpp"

namespace echoarc {

/// What became of the readings a method was given. Every reading is counted once.
struct InsertCounters {
  std::uint64_t used = 0;            ///< changed the map
  std::uint64_t no_information = 0;  ///< says nothing to this method (silence, to a method of arcs alone)
  std::uint64_t no_arc = 0;       ///< bistatic geometry without an arc: path too short, axes more than 90 degrees apart
  std::uint64_t bistatic = 0;     ///< receiver and transmitter differ, and the method takes circular arcs alone
  std::uint64_t passed_over = 0;  ///< an echo that the method's options leave out, by range or by how soon it came
  std::uint64_t memory_limit = 0;  ///< left out because the grid had reached its memory limit
  friend bool operator==(const InsertCounters&, const InsertCounters&) = default;
};

/// A count that only some methods keep, of arcs or whatever else they deal in: "removed_split" of arc carving.
struct Tally {
  std::string_view name;  ///< as files spell it; lives as long as the program
  std::uint64_t count = 0;
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// A method that keeps counts of its own beside `InsertCounters`: always the same names in the same order.
template <class M>
concept Tallying = requires(const M method) {
  { method.tallies() } -> std::same_as<std::vector<Tally>>;
};

/// A method that works on a history of arcs and lets others look at it:
///
/// - `visit_arcs` shows the arcs of the history as things stand, oldest first.
/// - `history_full` tells whether arcs leave it by now.
/// - `watch_leaving` shows from then on every arc that leaves the history, in its last state; an empty visitor ends it.
///   The watcher is no part of the method's state: `save` leaves it out.
///
/// Looking changes nothing, and costs nothing where nobody looks.
template <class M>
concept ArcKeeping = requires(M method, const M constant, ArcVisitor visitor) {
  { constant.visit_arcs(visitor) } -> std::same_as<void>;
  { constant.history_full() } -> std::same_as<bool>;
  { method.watch_leaving(visitor) } -> std::same_as<void>;
};

/// A method that wants its readings shortened to what a laser saw nearer; see `LaserLimiter` of sensing.
template <class M>
concept LaserLimited = requires { requires M::takes_laser_limited; };

/// One named number of a method's formula, for people who want to follow it step by step.
struct Term {
  std::string_view name;
  double value = 0.0;
  std::string_view unit = "";
};

/// What one reading does to one cell.
struct CellChange {
  Cell cell;
  Vec2 centre;
  double before = 0.0;  ///< in the unit of the method's own cell value
  double after = 0.0;
  std::vector<Term> terms;
};

/// What inserting a reading into the present map would do; the map is not changed.
struct Trace {
  std::optional<Arc> arc;
  std::vector<Vec2> points;  ///< points added, for point methods
  std::vector<CellChange> cells;
};

/// Dense exports are at most this large: 2^28 cells, a square of 164 m at 1 cm.
inline constexpr std::int64_t max_export_cells = std::int64_t{1} << 28;

/// What every method can hand over, whatever its own map looks like.
struct MapExport {
  PointMap points;              ///< the map's points; of a grid the centres of its occupied cells
  DenseGrid<CellState> states;  ///< free, unknown, occupied
  std::variant<std::monostate, DenseGrid<float>, DenseGrid<std::uint16_t>> values;  ///< the method's own cell values
};

/// A mapping method: readings in, map out, incrementally.
///
/// - `insert` takes readings in the order of time; in one span or one by one, the result is the same.
/// - `finish` brings the map up to date with everything inserted so far; more readings may follow.
/// - `map` is the method's own representation, valid after `finish`; `export_map` is what all methods share, an error
/// when
///   the map is spread too far to be drawn as one picture (`max_export_cells`).
/// - `trace` tells what a reading would change; `supports` whether it speaks for something at a position, so that the
///   pings behind a grid cell are found by replaying the log (point methods also keep them in their map).
/// - `save` and `restore` carry the whole state; afterwards both behave the same.
template <class M>
concept MappingMethod =
    OptionStruct<typename M::Options> && std::constructible_from<M, typename M::Options> && std::movable<M> &&
    requires(M method, const M constant, std::span<const Reading> readings, const Reading& reading, Vec2 position,
             Executor& executor, std::span<const std::byte> bytes) {
      typename M::Map;
      { M::name } -> std::convertible_to<std::string_view>;
      { constant.options() } -> std::same_as<const typename M::Options&>;
      { method.insert(readings, executor) } -> std::same_as<void>;
      { method.finish(executor) } -> std::same_as<void>;
      { constant.map() } -> std::convertible_to<const typename M::Map&>;
      { constant.export_map() } -> std::same_as<Result<MapExport>>;
      { constant.counters() } -> std::same_as<const InsertCounters&>;
      { constant.trace(reading) } -> std::same_as<Trace>;
      { constant.supports(reading, position) } -> std::same_as<bool>;
      { constant.save() } -> std::same_as<std::vector<std::byte>>;
      { M::restore(bytes) } -> std::same_as<Result<M>>;
    };

}  // namespace echoarc
