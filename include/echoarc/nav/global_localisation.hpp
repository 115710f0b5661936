// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "echoarc/nav/particle_filter.hpp"
#include "echoarc/nav/pose_search.hpp"

namespace echoarc::nav {

struct LocalisationOptions {
  ParticleFilterOptions filter;
  MotionNoiseOptions noise;
  ReadingModelOptions model;
  PoseSearchOptions search;
  double step_m = 0.1;
  Angle step_turn = degrees(5.0);
  int reading_stride = 2;
  double readings_per_m = 80.0;
  double turn_way_m = 0.2;
  double slow_m = 10.0;
  double fast_m = 1.0;
  double newcomer_ratio = 0.83;
  double lost_ratio = 0.6;
  double lost_fit = 0.3;
  double jump_m = 1.0;
  Angle jump_turn = degrees(90.0);
  double confirm_m = 4.0;
  double unconfirmed_exponent = 0.1;
  int unconfirmed_particles = 2'000;
  double silent_m = 3.0;
  double window_readings = 20.0;
  double challenge = 0.3;
  double other_share = 0.03;
  double spread_m = 0.4;
  Angle spread_turn = degrees(10.0);

  static constexpr auto fields() {
    using O = LocalisationOptions;
    return std::tuple{
        field("step_m", &O::step_m,
              {.unit = "m", .min = 0.01, .max = 10.0, .doc = "readings are weighed when the robot has moved so far"}),
        field("step_turn_deg", &O::step_turn,
              {.unit = "deg", .min = 0.5, .max = 90.0, .doc = "or when it has turned so far"}),
        field("reading_stride", &O::reading_stride,
              {.min = 1, .max = 100, .doc = "of the readings of a step every so-manyth is weighed"}),
        field(
            "readings_per_m", &O::readings_per_m,
            {.unit = "1/m",
             .min = 0.1,
             .max = 1e5,
             .doc = "or fewer, evenly, so that no more are weighed on the way: those of one place say much the same"}),
        field("turn_way_m", &O::turn_way_m,
              {.unit = "m/rad", .min = 0.0, .max = 10.0, .doc = "way that shows as much that is new as a turn"}),
        field("slow_m", &O::slow_m,
              {.unit = "m", .min = 0.01, .max = 1000.0, .doc = "way over which the long average of the fit goes"}),
        field("fast_m", &O::fast_m,
              {.unit = "m", .min = 0.01, .max = 1000.0, .doc = "way over which the short average of the fit goes"}),
        field("newcomer_ratio", &O::newcomer_ratio,
              {.min = 0.0,
               .max = 1.0,
               .doc = "when the short average is below this share of the long, newcomers join, and the pose has to "
                      "be confirmed"}),
        field("lost_ratio", &O::lost_ratio,
              {.min = 0.0, .max = 1.0, .doc = "the pose is lost when it is below this share"}),
        field("lost_fit", &O::lost_fit, {.min = 0.0, .max = 1.0, .doc = "or when the short average is below this"}),
        field("jump_m", &O::jump_m,
              {.unit = "m", .min = 0.01, .max = 1000.0, .doc = "odometry that moves farther at once has jumped"}),
        field("jump_turn_deg", &O::jump_turn,
              {.unit = "deg", .min = 1.0, .max = 180.0, .doc = "so has odometry that turns farther at once"}),
        field(
            "confirm_m", &O::confirm_m,
            {.unit = "m",
             .min = 0.0,
             .max = 1000.0,
             .doc = "way after which a pose is believed that was searched for or has become doubtful; at most the root "
                    "of the floor's area"}),
        field("unconfirmed_exponent", &O::unconfirmed_exponent,
              {.min = 0.01,
               .max = 1.0,
               .doc = "until then the dependence of readings is rated higher: of places that look alike none shall win "
                      "by chance"}),
        field("unconfirmed_particles", &O::unconfirmed_particles,
              {.min = 10, .max = 1e6, .doc = "and at least so many particles are kept"}),
        field("silent_m", &O::silent_m,
              {.unit = "m", .min = 0.1, .max = 1000.0, .doc = "way without any echo after which it no longer is"}),
        field("window_readings", &O::window_readings,
              {.min = 0.1,
               .max = 1000.0,
               .doc = "the recent readings count like so many independent ones, whatever their number"}),
        field("challenge", &O::challenge,
              {.min = 0.0,
               .max = 100.0,
               .doc = "another place joins in when it fits the recent readings so much better than the best one: "
                      "logarithm of the ratio of their likelihoods"}),
        field("other_share", &O::other_share,
              {.min = 0.0, .max = 1.0, .doc = "weight of other places from which on the pose is ambiguous"}),
        field(
            "spread_m", &O::spread_m,
            {.unit = "m", .min = 0.01, .max = 100.0, .doc = "largest deviation of the place of a pose that is known"}),
        field("spread_turn_deg", &O::spread_turn,
              {.unit = "deg", .min = 0.1, .max = 180.0, .doc = "largest deviation of its heading"})};
  }
};

enum class LocalisationState : std::uint8_t { lost, ambiguous, localised };
[[nodiscard]] std::string_view name(LocalisationState state);  ///< "lost", "ambiguous", "localised"

/// Where the robot seems to be. The pose is of use only when `state` is `localised`; otherwise it is the best guess.
struct PoseEstimate {
  LocalisationState state = LocalisationState::lost;
  std::string reason;                 ///< for people, one line
  Pose2 T_map_robot;                  ///< mean of the heaviest cluster, carried on to the newest odometry
  Sketch::Spread spread;              ///< one standard deviation of its place, to be drawn
  Angle heading_deviation;            ///< one standard deviation
  std::vector<PoseCluster> clusters;  ///< by falling share; poses at the last step
  double fit = 0.0;                   ///< short average of the echoes' weights, 0 ... 1
  std::size_t particles = 0;
};

/// Finds and keeps a robot's pose on a finished map by what its sonars hear: a particle filter that tracks, searches
/// the whole map when it knows nothing or is lost, and says which. Silence counts as weak evidence (see ReadingProbes);
/// without any echo for `silent_m` the pose is not believed any more. Recovers from being carried away by the ratio of
/// short and long average of the fit (augmented Monte Carlo localisation: Thrun, Burgard and Fox 2005, table 8.3): its
/// newcomers are places that fit the recent readings, and when the fit breaks down the whole map is searched anew.
/// A pose that was found by a search is believed only after a second look over the whole map has found no place that
/// fits the newest readings clearly better.
///
/// Frames: "map" that of the map, "odom" that of odometry and of the readings' own poses, related by nothing but
/// this estimate. Everything happens when the robot moves; one that stands learns nothing new. One seed and the same
/// calls give the same estimates, bit for bit.
class GlobalLocalisation {
 public:
  explicit GlobalLocalisation(const LocalisationOptions& options = {}, std::uint64_t seed = 1);

  /// The map to localise on; particles stay where they are.
  void set_map(const DenseGrid<CellState>& map);
  /// The pose is known so well.
  void start_at(const Pose2& T_map_robot, double deviation_m = 0.1, Angle deviation = degrees(5.0));
  /// The pose is not known at all. This is how it begins.
  void start_anywhere();

  /// The newest pose by odometry and the readings since the last call, at a rate so high that the robot moves less
  /// than `jump_m` between calls.
  void update(const Pose2& T_odom_robot, std::span<const Reading> readings);
  /// The direction of a corridor as the robot sees it now and that of the map, both modulo a quarter turn.
  void correct_heading(Angle seen_by_robot, Angle on_map, Angle deviation);

  [[nodiscard]] const PoseEstimate& estimate() const { return estimate_; }
  [[nodiscard]] std::span<const Particle> particles() const { return filter_.particles(); }

 private:
  [[nodiscard]] bool take_odometry(const Pose2& T_odom_robot);
  void keep(std::span<const Reading> readings);
  void step(const Pose2& T_before_now);
  void forget();
  [[nodiscard]] std::size_t stride_of(double way_m) const;
  void remember(double way_m);
  void search();
  void begin_search(std::string why);
  void track(double length_m, double way_m);
  [[nodiscard]] double average_fit(double fit, double way_m);
  [[nodiscard]] std::vector<Pose2> newcomers(double ratio);
  void confirm();
  void believe(bool confirmed);
  [[nodiscard]] double confirm_way_m() const;
  void challenge(const ReadingProbes& fine);
  [[nodiscard]] ReadingProbes window_probes(double sigma_m, std::size_t most) const;
  [[nodiscard]] std::vector<PoseCluster> belief() const;
  void look();
  void judge();
  [[nodiscard]] std::string fault() const;
  [[nodiscard]] std::string doubt() const;

  LocalisationOptions options_;
  LikelihoodMap map_;
  bool has_map_ = false;
  ParticleFilter filter_;
  PoseSearch search_;
  bool searching_ = true;
  std::string search_reason_;

  std::optional<Pose2> T_odom_robot_;  // newest
  Pose2 T_odom_step_;                  // at the last step: there the particles are
  bool odometry_is_bad_ = false;
  double jumped_m_ = 0.0;  // by odometry, not yet confirmed
  std::vector<Reading> pending_;
  std::size_t heard_ = 0;       // readings so far, to take every so-manyth
  std::deque<Reading> window_;  // some of the last steps', for searching
  double window_way_m_ = 0.0;   // on which they were heard, so far

  double fit_slow_ = 0.0;
  double fit_fast_ = 0.0;
  double fit_way_m_ = 0.0;  // over which they go; 0: there are none yet
  bool confirmed_ = false;
  double unconfirmed_m_ = 0.0;  // way still to go until the pose can be confirmed
  double next_look_m_ = 0.0;    // of that way, when the map is looked over again
  double silent_m_ = 0.0;       // way since the last echo
  PoseEstimate estimate_;
};

}  // namespace echoarc::nav
