// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/live/mapper.hpp"
#include "echoarc/live/reading_log.hpp"

/// Questions of people about a map, answered from copies, beside the mapping. The answers follow `explanation` and
/// `stepped` of schema/messages.schema.json field by field. Methods are named by their ids.
namespace echoarc::live {

/// What a question is asked about: all of it cheap copies.
struct Evidence {
  ReadingLog readings;
  std::vector<MethodChoice> methods;  ///< in order; the first with cells explains cells of point methods
  std::vector<std::shared_ptr<const MapExport>> maps;  ///< of each method; may be null
  std::vector<Polyline> walls;
  TruthLog truth;
  std::set<SensorId> sensors_off;
};

struct Support {
  JudgedPing ping;
  std::optional<Angle> t;  ///< where it speaks, on the arc of the point's own ping
  std::optional<Angle> crossing_angle;
  std::optional<Vec2> crossing;
  std::string note;
};
struct UnusedPings {
  std::string reason;
  std::uint64_t count = 0;
};
struct CellHistoryEntry {
  enum class Where : std::uint8_t { on, before, beside };
  JudgedPing ping;
  double before = 0.0;
  double after = 0.0;
  Where where = Where::beside;
};
struct CellHistory {
  std::string method;
  Cell cell;
  std::string unit;
  double value = 0.0;
  std::optional<double> probability;
  std::vector<CellHistoryEntry> changes;  ///< the newest 200, oldest first
  std::uint64_t total = 0;
};
struct Explanation {
  std::string method;
  bool is_point = false;
  std::string sentence;
  Vec2 position;
  std::string label;
  std::optional<double> bound_m;
  std::optional<double> probability;
  std::optional<double> off_wall_m;
  std::optional<JudgedPing> own;
  std::optional<Arc> arc;
  std::optional<Angle> t;        ///< the point on it
  std::optional<Angle> bound_t;  ///< half the bracket of its bound, on the arc
  std::vector<Support> support;
  std::vector<UnusedPings> unused;
  std::optional<CellHistory> cell;
  std::size_t searched = 0;
};
/// Why the map has this point (an index in its export).
[[nodiscard]] Result<Explanation> explain_point(const Evidence& evidence, std::string_view method, std::size_t index);
/// Why the cell at a position holds what it holds, ping by ping, by replaying the readings that reach it.
[[nodiscard]] Result<Explanation> explain_cell(const Evidence& evidence, std::string_view method, Vec2 position);

/// A formula as data; see `Formula` of the schema. `tree` is its JSON text.
struct FormulaLine {
  std::string words;
  std::string tree;
  std::string result;
};
struct TouchedArc {
  enum class What : std::uint8_t { crossed, cut, removed };
  JudgedPing ping;
  What what = What::crossed;
  std::optional<Vec2> crossing;
  std::optional<Arc> left;  ///< what is left of it
  std::string note;
};
struct Step {
  std::string method;
  JudgedPing ping;
  bool used = false;
  std::string reason;                 ///< why not
  std::optional<Pose2> T_world_true;  ///< of the robot, where the source knows it
  std::optional<Arc> arc;
  std::optional<double> cell_m;
  std::string unit;
  std::vector<CellChange> cells;
  std::vector<FormulaLine> formulas;
  std::vector<TouchedArc> arcs;
  std::vector<Vec2> points;
  std::string summary;
  std::shared_ptr<const MapExport> before;  ///< the map before the ping
};
[[nodiscard]] Result<Step> step_ping(const Evidence& evidence, std::string_view method, PingId ping);

/// The maps after all pings up to a time.
struct PastMap {
  std::vector<std::shared_ptr<const MapExport>> maps;
  std::size_t pings = 0;
  std::optional<Pose2> T_world_robot;
};
[[nodiscard]] Result<PastMap> map_at(const Evidence& evidence, std::span<const std::string> methods, double time_s);

}  // namespace echoarc::live
