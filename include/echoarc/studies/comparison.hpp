// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/eval/calibration.hpp"
#include "echoarc/eval/wall_distance.hpp"
#include "echoarc/studies/experiment.hpp"
#include "echoarc/studies/map_picture.hpp"
#include "echoarc/studies/study_host.hpp"

/// Every method on every log and scene, held against the same references with the same scores.
namespace echoarc::studies {

/// A method as the comparison runs it: catalogue and defaults, but for what the label says.
struct ComparedMethod {
  std::string label;   ///< unique: "atm_mod 5° < 3 m"
  std::string method;  ///< of the catalogue
  OptionMap options;
  double range_cut_m = 0.0;  ///< echoes beyond are left out; 0: none
};

/// The whole catalogue as shipped, with all echoes; the same with echoes below 3 m alone (`consensus` has that limit
/// of its own); `atm_mod` also with crossings from 5 degrees on; `consensus` in its three modes.
[[nodiscard]] std::vector<ComparedMethod> compared_methods();

/// `consensus` as it is shipped.
inline constexpr std::string_view default_consensus = "consensus balanced";
/// The most accurate of the published methods, as independent programs run it: crossings from 13 degrees on, echoes
/// below 3 m.
inline constexpr std::string_view careful_median = "atm_mod < 3 m";

/// A recorded log with a laser.
struct ComparedLog {
  std::string name;
  Log log;
};

struct ComparisonRequest {
  std::vector<ComparedLog> logs;
  std::vector<std::string> scenes;  ///< names that the host knows
  std::vector<ComparedMethod> methods = compared_methods();
};

enum class PlaceKind : std::uint8_t {
  log,        ///< a whole recorded log against its laser
  truncated,  ///< its first seconds against the laser of those seconds
  scene,      ///< a simulated scene against the surfaces visible from the path
};

/// One method's map of one run.
struct ComparedMap {
  TwoWayWallDistance distance;
  /// Of a truncated log: against the laser of the whole log.
  std::optional<TwoWayWallDistance> against_whole;
  /// Of the scenes of [Barshan07]: pixels against their own reference, on their grid.
  std::optional<MapScore> pixels;
  std::vector<ClaimedPoint> claims;  ///< one point per 5 cm cell; empty for methods that claim nothing
};

struct ComparedPlace {
  std::string name;        ///< "run1", "run1, first 20 s", "room-a"
  std::string experiment;  ///< "E1", "E3", "E4" of [Barshan07], else empty
  PlaceKind kind = PlaceKind::log;
  double seconds = 0.0;    ///< length of the log; of a scene the first seed's
  std::string provenance;  ///< of the reference
  /// By method, then by seed; recorded logs have one.
  std::vector<std::vector<ComparedMap>> maps;
  std::optional<PictureFigure> picture;  ///< of whole logs and scenes
};

struct Comparison {
  int seeds = 0;  ///< of every scene; a drive of more than half an hour is simulated once
  std::vector<ComparedMethod> methods;
  std::vector<ComparedPlace> places;

  /// Place of a label among the methods, if it was run.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view label) const;
};

/// The lengths to which logs are cut, s; those that a log does not reach are left out.
inline constexpr std::array<double, 3> truncations_s = {20.0, 40.0, 60.0};

/// The records of a log's first seconds, counted from its first odometry.
[[nodiscard]] Log first_seconds(const Log& log, double seconds);

/// Runs everything. Tasks are runs of a place: results do not depend on the threads. Errors: those of the host, of
/// `simulate`, of `laser_reference` for a whole log, and of `export_map`.
[[nodiscard]] Result<Comparison> compare_methods(const StudyHost& host, const ComparisonRequest& request);

}  // namespace echoarc::studies
