// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/maps/dense_grid.hpp"

/// How well readings fit a pose on a map: the likelihood field of Thrun, Burgard and Fox (Probabilistic Robotics, 2005,
/// 6.4), taken along the whole arc of a reading since a sonar does not know where on its arc the echo arose.
namespace echoarc::nav {

/// A map made ready for localisation: every cell knows its distance to the nearest occupied one. Frame "map", metres.
class LikelihoodMap {
 public:
  /// Distances beyond this are not told apart, m. On grids finer than 1 cm it is 50 cells.
  static constexpr double cap_m = 0.5;
  /// Distances are kept in steps of this, m.
  static constexpr double step_m = 0.002;

  LikelihoodMap() = default;
  explicit LikelihoodMap(const DenseGrid<CellState>& map);

  [[nodiscard]] bool has_walls() const { return has_walls_; }
  [[nodiscard]] bool has_floor() const { return !free_cells_.empty(); }
  /// Area of the free cells, m^2.
  [[nodiscard]] double floor_m2() const;
  /// Whether a robot may stand here: on the map and in no wall.
  [[nodiscard]] bool may_stand(Vec2 p) const;
  /// Distance of the centre of the cell of `p` to that of the nearest occupied cell, at most `cap_m`.
  [[nodiscard]] double wall_distance_m(Vec2 p) const { return step_m * level(to_cells(p)); }
  /// Whether the straight way from `from` towards `to` meets an occupied cell before its end. Passes over corners of
  /// cells that it cuts by less than half a cell.
  [[nodiscard]] bool blocked(Vec2 from, Vec2 to) const;
  /// Any place on the free floor, all equally likely. Requires `has_floor()`.
  [[nodiscard]] Vec2 any_place(Rng& rng) const { return place_at(rng.uniform(), rng); }
  /// Any place of the free cell before which this share of them lies, in [0, 1), row by row. Requires `has_floor()`.
  [[nodiscard]] Vec2 place_at(double share, Rng& rng) const;

  /// A place in cells from the lower left corner of the stored field, for those who ask often.
  struct Place {
    float i = 0.0F;
    float j = 0.0F;
  };
  [[nodiscard]] Place to_cells(Vec2 p) const {
    return {static_cast<float>((p.x - low_.x) / cell_m_), static_cast<float>((p.y - low_.y) / cell_m_)};
  }
  [[nodiscard]] double cell_m() const { return cell_m_; }
  /// Distance to the nearest occupied cell in steps of `step_m`. NaN is as far away as can be.
  [[nodiscard]] int level(Place p) const {
    if (!(p.i >= 0.0F && p.j >= 0.0F && p.i < width_ && p.j < height_)) return far_level_;
    return levels_[static_cast<std::size_t>(p.j) * row_ + static_cast<std::size_t>(p.i)];
  }
  /// As `blocked`, along the unit vector (`di`, `dj`) over `reach` cells.
  [[nodiscard]] bool blocked(Place from, float di, float dj, float reach) const;

  static constexpr int cap_level = 250;

 private:
  double cell_m_ = 1.0;
  Vec2 low_;            // of the field, which surrounds the map by `cap_m`
  float width_ = 0.0F;  // of the field, in cells
  float height_ = 0.0F;
  std::size_t row_ = 0;               // cells
  std::vector<std::uint8_t> levels_;  // distance in steps of `step_m`
  int far_level_ = cap_level;         // the largest in the field
  bool has_walls_ = false;
  GridGeometry geometry_;  // of the map
  CellBox box_;
  std::vector<Cell> free_cells_;
};

struct ReadingModelOptions {
  double hit_share = 0.9;
  double random_share = 0.1;
  double sigma_m = 0.08;
  double spacing_m = 0.02;
  double through_wall_factor = 0.2;
  double through_wall_margin_m = 0.15;
  double silent_wall_factor = 0.5;
  double range_max_m = 6.0;

  static constexpr auto fields() {
    using O = ReadingModelOptions;
    return std::tuple{
        field("hit_share", &O::hit_share,
              {.min = 0.0, .max = 1.0, .doc = "weight of an echo that fits the map (z_hit)"}),
        field("random_share", &O::random_share,
              {.min = 1e-6, .max = 1.0, .doc = "weight of an echo that nothing on the map explains (z_rand)"}),
        field("sigma_m", &O::sigma_m,
              {.unit = "m", .min = 0.001, .max = 10.0, .doc = "standard deviation between arc and wall (sigma_h)"}),
        field("spacing_m", &O::spacing_m,
              {.unit = "m", .min = 0.005, .max = 1.0, .doc = "between neighbouring samples of an arc"}),
        field("through_wall_factor", &O::through_wall_factor,
              {.min = 1e-6, .max = 1.0, .doc = "an echo from behind a wall counts so much"}),
        field("through_wall_margin_m", &O::through_wall_margin_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "a wall so much nearer than the echo is in its way"}),
        field("silent_wall_factor", &O::silent_wall_factor,
              {.min = 1e-6,
               .max = 1.0,
               .doc = "silence although a wall stands in the way within the trusted range; not small, for smooth walls "
                      "at a slant are silent"}),
        field("range_max_m", &O::range_max_m,
              {.unit = "m", .min = 0.1, .max = 1000.0, .doc = "echoes from farther away are passed over"})};
  }
};

/// How well some readings fit one pose.
struct ReadingFit {
  double log_likelihood = 0.0;  ///< sum over the readings
  double mean_echo = 0.0;       ///< mean weight of those with an echo, in (0, 1]; 0 when there is none
};

/// Readings made ready to be held against many poses. For each one
///
///     w = z_hit exp(-(delta / sigma_h)^2 / 2) + z_rand,
///
/// delta being the least distance to a wall of any sample of its arc, times `through_wall_factor` if the axis meets a
/// wall more than the margin before the range. Silence is weak evidence: w = 1, or `silent_wall_factor` if the axis
/// meets a wall within the sensor's trusted range. Other outcomes say nothing.
class ReadingProbes {
 public:
  /// `map` must outlive the probes.
  ReadingProbes(const LikelihoodMap& map, const ReadingModelOptions& options);

  /// False: the reading says nothing here (too far, no arc, not finite). `T_world_now` is the robot's pose for which
  /// the fit is asked, in the frame of the reading's own poses.
  bool add(const Reading& reading, const Pose2& T_world_now);

  [[nodiscard]] std::size_t size() const { return probes_.size(); }
  [[nodiscard]] std::size_t echoes() const { return echoes_; }
  [[nodiscard]] ReadingFit fit(const Pose2& T_map_robot) const;

 private:
  struct Probe {
    std::size_t begin = 0;  // of its samples; none: silence
    std::size_t end = 0;
    LikelihoodMap::Place eye;  // in the robot's frame, cells
    LikelihoodMap::Place axis;
    float reach = 0.0F;
    float skip_per_level = 0.0F;
  };
  struct Heading {
    LikelihoodMap::Place at;
    float c = 1.0F;
    float s = 0.0F;
    [[nodiscard]] LikelihoodMap::Place place(LikelihoodMap::Place p) const {
      return {at.i + c * p.i - s * p.j, at.j + s * p.i + c * p.j};
    }
  };

  bool add_axis(Probe probe, const Pose2& T_now_eye, double reach_m);
  [[nodiscard]] int nearest_level(const Probe& probe, const Heading& robot) const;
  [[nodiscard]] bool wall_in_the_way(const Probe& probe, const Heading& robot) const;

  const LikelihoodMap* map_;
  ReadingModelOptions options_;
  std::array<double, LikelihoodMap::cap_level + 1> weights_{};
  std::array<double, LikelihoodMap::cap_level + 1> log_weights_{};
  double log_through_wall_;
  double log_silent_wall_;
  int start_level_;  // what is farther from a wall than this has the weight of chance alone
  int slack_level_;  // a sample may be so much nearer to a wall than its distance to its neighbour allows: cells
  std::vector<LikelihoodMap::Place> samples_;
  std::vector<Probe> probes_;
  std::size_t echoes_ = 0;
};

}  // namespace echoarc::nav
