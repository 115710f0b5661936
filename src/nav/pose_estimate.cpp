// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>

#include "echoarc/nav/global_localisation.hpp"

namespace echoarc::nav {
namespace {

constexpr double least_bin_share = 1e-3;  // lighter bins belong to no cluster
constexpr double cluster_bin_m = 0.5;
constexpr Angle cluster_bin_turn = degrees(15.0);

/// "0.3", of a number that is not negative.
std::string tenths(double value) {
  const auto n = static_cast<long long>(std::llround(std::min(value, 1e9) * 10.0));
  return std::to_string(n / 10) + "." + std::to_string(n % 10);
}

std::string percent(double share) {
  return std::to_string(std::lround(100.0 * share)) + " %";
}

}  // namespace

std::string_view name(LocalisationState state) {
  constexpr std::array<std::string_view, 3> names = {"lost", "ambiguous", "localised"};
  return names[static_cast<std::size_t>(state)];
}

/// What the particles say, at the last step.
void GlobalLocalisation::look() {
  estimate_.fit = fit_fast_;
  estimate_.particles = filter_.particles().size();
  // While everything is possible the last belief stays as a guess.
  if (searching_ || filter_.particles().empty()) return;
  estimate_.clusters = belief();
}

std::vector<PoseCluster> GlobalLocalisation::belief() const {
  return clusters_of(filter_.particles(), cluster_bin_m, cluster_bin_turn, least_bin_share);
}

void GlobalLocalisation::judge() {
  if (!estimate_.clusters.empty()) {
    const PoseCluster& best = estimate_.clusters.front();
    const Pose2 T_step_now = T_odom_robot_ ? inverse(T_odom_step_) * *T_odom_robot_ : Pose2{};
    estimate_.T_map_robot = best.T_map_robot * T_step_now;
    estimate_.T_map_robot.heading = wrap(estimate_.T_map_robot.heading);
    estimate_.spread = spread_of(best);
    estimate_.spread.T_world_axes.position = estimate_.T_map_robot.position;
    estimate_.heading_deviation = radians(std::sqrt(best.covariance.heading_rad2));
  }
  estimate_.state = LocalisationState::lost;
  if (estimate_.reason = fault(); !estimate_.reason.empty()) return;
  estimate_.state = LocalisationState::ambiguous;
  if (estimate_.reason = doubt(); !estimate_.reason.empty()) return;
  estimate_.state = LocalisationState::localised;
  estimate_.reason = "within " + tenths(100.0 * estimate_.spread.deviation_m.x) + " cm and " +
                     tenths(estimate_.heading_deviation.deg()) + " degrees";
}

/// Why nothing is known; empty when something is.
std::string GlobalLocalisation::fault() const {
  if (!has_map_) return "there is no map";
  if (!map_.has_walls()) return "the map holds no wall to localise by";
  if (!map_.has_floor()) return "the map holds no free floor to stand on";
  if (odometry_is_bad_) return "the pose of odometry is not finite";
  if (searching_ && search_.progress() == 0.0) return search_reason_ + "; listening for echoes";
  if (searching_) return search_reason_ + "; " + percent(search_.progress()) + " of the map is searched";
  if (jumped_m_ > 0.0) return "odometry jumped by " + tenths(jumped_m_) + " m";
  if (silent_m_ >= options_.silent_m) return "no echo for " + tenths(silent_m_) + " m";
  if (estimate_.clusters.empty()) return "the particles agree on no place";
  return {};
}

/// Why the pose is not to be relied on; empty when it is.
std::string GlobalLocalisation::doubt() const {
  const double others = 1.0 - estimate_.clusters.front().share;
  if (estimate_.clusters.size() > 1 && others >= options_.other_share)
    return std::to_string(estimate_.clusters.size()) + " places fit, the best with " + percent(1.0 - others);
  if (estimate_.spread.deviation_m.x > options_.spread_m)
    return "the place is known to " + tenths(estimate_.spread.deviation_m.x) + " m only";
  if (estimate_.heading_deviation > options_.spread_turn)
    return "the heading is known to " + tenths(estimate_.heading_deviation.deg()) + " degrees only";
  if (!confirmed_) return "one place fits; whether no other does is being looked at";
  return {};
}

}  // namespace echoarc::nav
