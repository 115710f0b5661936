// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/eval/correct_detection.hpp"
#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/eval/reference.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/sensing_options.hpp"
#include "echoarc/sensing/sensing_report.hpp"
#include "echoarc/sim/world.hpp"
#include "echoarc/studies/study_host.hpp"

namespace echoarc::studies {

/// What the papers say of a map ([Barshan07] 3.8).
struct MapScore {
  double mae_m = 0.0;          ///< mean absolute error; NaN for an empty map
  CorrectDetection detection;  ///< over the scene's directions of interest
  std::uint64_t points = 0;    ///< of the map inside the judged region
};

/// Holds maps of one scene against its reference. Const calls from several threads are safe.
class SceneScorer {
 public:
  /// Errors: those of `validate(DirectionSet)`.
  [[nodiscard]] static Result<SceneScorer> make(Reference reference, const SceneScoring& scoring);

  /// Only points inside the region count, its upper edges left out.
  [[nodiscard]] MapScore score(const PointSet& map) const;
  /// The part of `map` that counts.
  [[nodiscard]] PointSet judged(const PointSet& map) const;
  [[nodiscard]] bool inside(Vec2 p) const;
  /// Metres to the nearest reference point.
  [[nodiscard]] double distance_m(Vec2 p) const { return nearest_.distance_m(p); }
  /// Of a map whose points are all inside.
  [[nodiscard]] CorrectDetection detection(const PointSet& map) const;

  [[nodiscard]] const Reference& reference() const { return *reference_; }
  [[nodiscard]] const DirectionSet& directions() const { return directions_; }
  [[nodiscard]] const SceneScoring& scoring() const { return scoring_; }

 private:
  SceneScorer(std::shared_ptr<const Reference> reference, DirectionSet directions, SceneScoring scoring)
      : reference_(std::move(reference)),
        directions_(std::move(directions)),
        scoring_(std::move(scoring)),
        nearest_(reference_->points) {}

  std::shared_ptr<const Reference> reference_;  // `nearest_` refers to it
  DirectionSet directions_;
  SceneScoring scoring_;
  NearestPoints nearest_;
};

/// One drive through a scene: what was measured, and the truth it is judged by.
struct Trial {
  std::uint64_t seed = 0;
  Log log;                        ///< with truth and causes
  SensingReport sensing;          ///< what became of the pings
  std::vector<Reading> readings;  ///< of `log`, in the order of its pings
  std::vector<Reading> limited;   ///< the same, laser-limited; empty unless asked for
  std::shared_ptr<const SceneScorer> scorer;

  [[nodiscard]] const SceneScoring& scoring() const { return scorer->scoring(); }
};

/// Fills in the readings of a trial's log, and what became of its pings.
void sense_into(Trial& trial, const SensingOptions& options, bool with_laser_limited);

/// A scene made ready for many seeds. What does not depend on the seed is worked out once: the world, and the truth
/// visible from the path, which is that of the first trial.
class Experiment {
 public:
  /// Errors: those of `World::make`, and a scoring without a region.
  [[nodiscard]] static Result<Experiment> make(StudyScene scene, SensingOptions sensing = {});

  /// Simulates, senses, makes the reference. The same seed gives the same trial. Errors: those of `simulate`,
  /// `scene_reference` and `SceneScorer::make`. May be called from several threads.
  [[nodiscard]] Result<Trial> trial(std::uint64_t seed, bool with_laser_limited = false) const;
  /// The same with a log that is there already.
  [[nodiscard]] Result<Trial> trial(std::uint64_t seed, Log log, bool with_laser_limited = false) const;

  [[nodiscard]] const StudyScene& scene() const { return scene_; }
  [[nodiscard]] const sim::World& world() const { return *world_; }

 private:
  struct SharedTruth;
  Experiment(StudyScene scene, SensingOptions sensing, std::shared_ptr<const sim::World> world);
  [[nodiscard]] Result<std::shared_ptr<const SceneScorer>> scorer_for(const Log& log) const;

  StudyScene scene_;
  SensingOptions sensing_;
  std::shared_ptr<const sim::World> world_;
  std::shared_ptr<SharedTruth> truth_;
};

/// A method with options, and how tables call it.
struct MethodSpec {
  std::string label;   ///< "VT, threshold 4"
  std::string method;  ///< of the catalogue
  OptionMap options;   ///< those that differ from the defaults; the grid is the scoring's unless named here
};

/// What a method made of a trial.
struct MethodResult {
  MapScore cells;   ///< centres of occupied cells, whatever the method: the papers' "nonzero pixels"
  MapScore points;  ///< exact points where the method has them, else the cells again
  PointSet map;     ///< the judged cells
  InsertCounters counters;
  double insert_cpu_s = 0.0;  ///< 0 without a clock
  double finish_cpu_s = 0.0;

  [[nodiscard]] double cpu_s() const { return insert_cpu_s + finish_cpu_s; }
};

/// Grid options that put cell (0, 0) into the lower left corner of the judged region.
[[nodiscard]] OptionMap grid_of(const SceneScoring& scoring);

/// The method of a spec, empty, on the scoring's grid. Errors: those of `make_method`.
[[nodiscard]] Result<AnyMethod> make_method(const MethodSpec& spec, const SceneScoring& scoring);

/// Every method over the trial's readings (laser-limited ones to those that take them), in the order of `specs`, on the
/// calling thread. `thread_cpu_s` as in `StudyHost`. Errors: those of `make_method` and `export_map`.
[[nodiscard]] Result<std::vector<MethodResult>> run_methods(const Trial& trial, std::span<const MethodSpec> specs,
                                                            const std::function<double()>& thread_cpu_s = {});

}  // namespace echoarc::studies
