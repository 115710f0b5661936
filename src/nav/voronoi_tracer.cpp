// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoarc::nav {
namespace {

constexpr double record_step_m = 0.05;   // between vertices of the recorded polyline
constexpr double track_radius_m = 0.40;  // a closest point moves less between two views
constexpr double beside_band_m = 0.30;   // how much further than the nearest an obstacle of a new pair may be
constexpr double slow_band_m = 0.30;     // a third obstacle so little further slows down
constexpr double slowest = 0.35;         // of the speed, close to a meet point
constexpr double slack_m = 0.02;         // a cautious control never comes as near as the least distance
constexpr double creep_m_s = 0.04;       // towards an obstacle as near as the body may come
constexpr double approach_per_s = 0.8;   // and so much more for every metre before it

Vec2 normalised(Vec2 v, Vec2 otherwise) {
  const double length = norm(v);
  return length > 1e-9 ? v / length : otherwise;
}

}  // namespace

TraceControl trace_control(Vec2 place, Vec2 closest_1, Vec2 closest_2, Vec2 previous_direction,
                           const TracerOptions& options) {
  constexpr double singular = 0.05;
  const double d1 = norm(place - closest_1);
  const double d2 = norm(place - closest_2);
  TraceControl control;
  control.difference_m = d1 - d2;
  if (d1 < 1e-9 || d2 < 1e-9) return control.tangent = normalised(previous_direction, {1.0, 0.0}), control;
  const Vec2 grad_1 = (place - closest_1) / d1;
  const Vec2 grad_2 = (place - closest_2) / d2;
  control.gradient = grad_1 - grad_2;
  const double squared = squared_norm(control.gradient);
  // Both obstacles in one direction: the way leads along the bisector of their bearings, and nothing tells them apart.
  const bool is_singular = squared < singular * singular;
  control.tangent = normalised(is_singular ? grad_1 + grad_2 : perpendicular(control.gradient), {1.0, 0.0});
  if (dot(control.tangent, previous_direction) < 0.0) control.tangent = -control.tangent;
  if (is_singular) return control;
  control.correction_m_s = control.gradient * (-options.correction_per_s * control.difference_m / squared);
  const double length = norm(control.correction_m_s);
  if (length > options.correction_limit_m_s)
    control.correction_m_s = control.correction_m_s * (options.correction_limit_m_s / length);
  return control;
}

VoronoiTracer::VoronoiTracer(double body_radius_m, const TracerOptions& options, const ObstacleOptions& obstacles)
    : options_(options), obstacle_options_(obstacles), least_distance_m_(body_radius_m + options.margin_m) {}

void VoronoiTracer::begin(Vec2 place, Angle direction) {
  pair_.reset();
  direction_ = unit(direction);
  last_place_ = place;
  polyline_.assign(1, place);
  travelled_m_ = 0.0;
  min_clearance_m_ = std::numeric_limits<double>::infinity();
  resume();
  is_new_ = true;
}

void VoronoiTracer::resume() {
  pair_.reset();
  is_new_ = false;
  since_node_m_ = blind_s_ = 0.0;
  meets_ = ends_ = 0;
  armed_for_meet_ = armed_for_boundary_ = false;
}

void VoronoiTracer::record(Vec2 place) {
  const double moved_m = norm(place - last_place_);
  travelled_m_ += moved_m;
  since_node_m_ += moved_m;
  last_place_ = place;
  if (norm(place - polyline_.back()) >= record_step_m) polyline_.push_back(place);
}

bool VoronoiTracer::is_gap(const NearObstacle& a, const NearObstacle& b) const {
  return norm(a.closest - b.closest) >= 2.0 * least_distance_m_;
}

/// Of a new edge: the obstacles to both sides of its direction, next to it in bearing, among the near ones.
std::optional<VoronoiTracer::Pair> VoronoiTracer::first_pair(std::span<const NearObstacle> obstacles) const {
  const NearObstacle* left = nullptr;
  const NearObstacle* right = nullptr;
  const auto off = [&](const NearObstacle& o) { return wrap(o.bearing - bearing(direction_)); };
  for (const NearObstacle& o : obstacles) {
    if (o.distance_m > obstacles.front().distance_m + beside_band_m) continue;
    const NearObstacle*& side = off(o) > Angle{} ? left : right;
    if (!side || abs(off(o)) < abs(off(*side))) side = &o;
  }
  return left && right ? std::optional(Pair{*left, *right}) : next_pair(obstacles);
}

/// In the middle of an edge: the nearest obstacle, which every edge belongs to, and the next one that is no part of the
/// same wall; if something closes the way right ahead, what flanks it.
std::optional<VoronoiTracer::Pair> VoronoiTracer::next_pair(std::span<const NearObstacle> obstacles) const {
  const auto is_apart = [&](const NearObstacle& a, const NearObstacle& b) {
    return is_gap(a, b) || abs(wrap(a.bearing - b.bearing)) > degrees(60.0);
  };
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    for (std::size_t k = i + 1; k < obstacles.size(); ++k)
      if (is_apart(obstacles[i], obstacles[k])) return Pair{obstacles[i], obstacles[k]};
  if (obstacles.size() < 2) return {};
  return Pair{obstacles[0], obstacles[1]};
}

/// Finds the pair of before among the obstacles of now, or chooses another one.
bool VoronoiTracer::track(std::span<const NearObstacle> obstacles) {
  if (pair_) {
    std::array<const NearObstacle*, 2> now{};
    for (std::size_t k = 0; k < 2; ++k) {
      for (const NearObstacle& o : obstacles) {
        const double apart_m = norm(o.closest - (*pair_)[k].closest);
        if (apart_m < track_radius_m && (!now[k] || apart_m < norm(now[k]->closest - (*pair_)[k].closest))) now[k] = &o;
      }
    }
    if (now[0] && now[1] && now[0] != now[1]) {
      pair_ = Pair{*now[0], *now[1]};
      hand_over(obstacles);
      return true;
    }
  }
  const std::optional<Pair> fresh = is_new_ ? first_pair(obstacles) : next_pair(obstacles);
  is_new_ = is_new_ && !fresh;
  if (fresh) pair_ = fresh;
  return fresh.has_value();
}

void VoronoiTracer::hand_over(std::span<const NearObstacle> obstacles) {
  constexpr double hysteresis_m = 0.02;
  for (const NearObstacle& o : obstacles) {
    NearObstacle& a = (*pair_)[0];
    NearObstacle& b = (*pair_)[1];
    if (is_gap(o, a) == is_gap(o, b)) continue;  // its own way on both sides, or what closes the way ahead
    NearObstacle& replaced = is_gap(o, a) ? b : a;
    if (o.distance_m < replaced.distance_m - hysteresis_m) replaced = o;
  }
}

/// The nearest obstacle besides the pair that leaves a gap for the body to both of it.
const NearObstacle* VoronoiTracer::third(std::span<const NearObstacle> obstacles) const {
  for (const NearObstacle& o : obstacles)
    if (is_gap(o, (*pair_)[0]) && is_gap(o, (*pair_)[1])) return &o;
  return nullptr;
}

/// Far from where two obstacles are equally far: what stands ahead does not end an edge.
bool VoronoiTracer::is_off_edge(std::span<const NearObstacle> obstacles) const {
  constexpr double off_m = 0.35;
  return std::max((*pair_)[0].distance_m, (*pair_)[1].distance_m) > obstacles.front().distance_m + off_m;
}

/// The pair comes too near to each other for the body, or closes in from ahead.
bool VoronoiTracer::is_narrow(Vec2 place) const {
  const auto [a, b] = *pair_;
  const double far_m = std::max(a.distance_m, b.distance_m);
  if (armed_for_boundary_ && far_m < least_distance_m_ + options_.equidistance_m &&
      std::min(a.distance_m, b.distance_m) < least_distance_m_ + slack_m)
    return true;
  const auto ahead = [&](const NearObstacle& o) { return dot(direction_, (o.closest - place) / o.distance_m); };
  return ahead(a) > cos(degrees(20.0)) && ahead(b) > cos(degrees(20.0));
}

bool VoronoiTracer::is_closed_ahead(std::span<const NearObstacle> obstacles, Vec2 place) const {
  return std::any_of(obstacles.begin(), obstacles.end(), [&](const NearObstacle& o) {
    return o.distance_m < least_distance_m_ + slack_m &&
           dot(direction_, o.closest - place) > cos(degrees(40.0)) * o.distance_m;
  });
}

/// Without a pair: straight on for a while. Close to an obstacle its neighbours melt into it, so this may be the end.
TraceStep VoronoiTracer::go_blind(std::span<const NearObstacle> obstacles, Vec2 place, double passed_s) {
  blind_s_ += passed_s;
  TraceStep step{(0.5 * speed_m_s(obstacles, place, slow_band_m)) * direction_,
                 count(false, is_closed_ahead(obstacles, place))};
  if (step.event == TraceEvent::none && blind_s_ > options_.patience_s) step = {Vec2{}, TraceEvent::lost};
  return step;
}

TraceEvent VoronoiTracer::count(bool meets, bool ends) {
  meets_ = meets ? meets_ + 1 : 0;
  ends_ = ends ? ends_ + 1 : 0;
  if (ends_ >= options_.confirmations) return TraceEvent::boundary;
  if (meets_ >= options_.confirmations) return TraceEvent::meet;
  return TraceEvent::none;
}

TraceStep VoronoiTracer::update(Vec2 place, double passed_s, std::span<const Vec2> points) {
  const double moved_m = norm(place - last_place_);
  record(place);
  const std::vector<NearObstacle> obstacles = obstacle_distances(points, place, obstacle_options_);
  if (!obstacles.empty()) min_clearance_m_ = std::min(min_clearance_m_, obstacles.front().distance_m);
  if (!track(obstacles)) return go_blind(obstacles, place, passed_s);
  blind_s_ = 0.0;
  const auto& [a, b] = *pair_;
  const double nearest_m = std::min(a.distance_m, b.distance_m);
  const TraceControl control = trace_control(place, a.closest, b.closest, direction_, options_);
  // The direction follows the way that is driven, so that neither noise nor a turn on the spot swings it round.
  const double share = std::min(1.0, moved_m / options_.smoothing_m);
  direction_ = normalised(direction_ + share * (control.tangent - direction_), direction_);

  const NearObstacle* c = third(obstacles);
  const double gap_m = c ? c->distance_m - nearest_m : std::numeric_limits<double>::infinity();
  armed_for_meet_ = armed_for_meet_ || since_node_m_ >= options_.leave_m ||
                    (since_node_m_ >= 0.5 * options_.leave_m && gap_m > 3.0 * options_.meet_m);
  armed_for_boundary_ = armed_for_boundary_ || since_node_m_ >= options_.leave_m ||
                        nearest_m > least_distance_m_ + options_.equidistance_m;
  // A third one that is nearer than the pair means that the meet point lies behind already.
  const bool meets = armed_for_meet_ && gap_m < options_.meet_m;
  const bool closed = is_closed_ahead(obstacles, place);
  const bool off_edge = is_off_edge(obstacles);
  if (closed && off_edge) pair_ = next_pair(obstacles);
  const TraceEvent event = count(meets, is_narrow(place) || (closed && !off_edge));
  const double back_first = std::clamp(1.0 - (std::abs(control.difference_m) - 0.1) / 0.3, 0.1, 1.0);
  return {(back_first * speed_m_s(obstacles, place, gap_m)) * direction_ + control.correction_m_s, event};
}

/// Slower where a meet point is near, and where the way gets narrow.
double VoronoiTracer::speed_m_s(std::span<const NearObstacle> obstacles, Vec2 place, double third_gap_m) const {
  double speed = options_.speed_m_s;
  if (armed_for_meet_) speed *= std::clamp(third_gap_m / slow_band_m, slowest, 1.0);
  for (const NearObstacle& o : obstacles) {
    const double closing = dot(direction_, o.closest - place) / o.distance_m;
    const double left_m = std::max(0.0, o.distance_m - least_distance_m_);
    if (closing > 0.2) speed = std::min(speed, (creep_m_s + approach_per_s * left_m) / closing);
  }
  return speed;
}

AccessStep VoronoiTracer::access(Vec2 place, Angle heading, std::span<const Vec2> points) const {
  const std::vector<NearObstacle> obstacles = obstacle_distances(points, place, obstacle_options_);
  AccessStep step;
  if (obstacles.empty()) return step;
  const NearObstacle& nearest = obstacles.front();
  step.distance_m = nearest.distance_m;
  const auto second =
      std::find_if(obstacles.begin(), obstacles.end(), [&](const NearObstacle& o) { return is_gap(o, nearest); });
  if (second != obstacles.end() && second->distance_m - nearest.distance_m < options_.equidistance_m) {
    step.reached = true;
    step.direction = bearing(trace_control(place, nearest.closest, second->closest, unit(heading), options_).tangent);
    return step;
  }
  step.velocity_m_s = (place - nearest.closest) * (options_.speed_m_s / nearest.distance_m);
  return step;
}

}  // namespace echoarc::nav
