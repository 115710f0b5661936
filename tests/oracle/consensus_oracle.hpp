// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "echoarc/mapping/consensus_options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/point_map.hpp"

/// Tangent consensus as docs/methods/consensus.md writes it: circular arcs, doubles, every arc against every other, no
/// table, no kernel, no search structure. The one thing it shares with `Consensus` is where ties go.
namespace echoarc::oracle {

using Row = std::vector<double>;
constexpr double tie = 1e-6;

struct OracleArc {
  Vec2 s;  // sensor
  double r = 0.0;
  double phi = 0.0;
  PingId ping = 0;
  SensorId sensor = 0;
  double beam_rad = 0.0;
};

struct OraclePoint {
  Vec2 p;
  PointLabel label = PointLabel::wall;
  double bound_m = 0.0;
  double probability = 0.0;
  PingId ping = 0;  // of walls, points, weak points and zones
};

inline double wrapped(double a) {
  return std::remainder(a, 2.0 * std::numbers::pi);
}
inline double bell(double x, double sigma) {
  return std::exp(-0.5 * (x / sigma) * (x / sigma));
}

class ConsensusOracle {
 public:
  ConsensusOracle(const ConsensusOptions& options, std::span<const Reading> readings) : o_(options) {
    for (const Reading& reading : readings) take(reading);
    for (const OracleArc& a : arcs_) half_.push_back(int(std::lround(o_.search_beams * a.beam_rad / step())));
  }

  [[nodiscard]] std::vector<OraclePoint> map() {
    sweep();
    read_out();
    const bool complete = o_.mode == ConsensusMode::complete;
    const double least = o_.mode == ConsensusMode::strict ? o_.strict_p : o_.accept_p;
    Row ok;
    for (std::size_t i = 0; i < arcs_.size(); ++i)
      ok.push_back(mass_[i] > least && ev_[i] > o_.evidence && arcs_[i].r < o_.map_range_m ? 1.0 : 0.0);
    kept_ = validate(ok);
    const Row w = occupied(kept_);
    std::vector<OraclePoint> map;
    for (std::size_t i = 0; i < arcs_.size(); ++i)
      if (w[i] > 0.0) map.push_back(point(i, pw_[i] > 0.5 ? PointLabel::wall : PointLabel::point));
    link(w, complete ? o_.complete_link_m : o_.link_m, map);
    if (o_.mode != ConsensusMode::strict) add_zones(w, complete ? o_.strict_p : o_.zone_p, map);
    if (complete) add_weak(map);
    return map;
  }
  [[nodiscard]] std::size_t arc_count() const { return arcs_.size(); }

  /// What is known of an arc after `map`: W by bin, and whether the vote kept it.
  struct Belief {
    OracleArc arc;
    int half = 0;
    Row w;
    bool kept = false;
  };
  [[nodiscard]] std::vector<Belief> beliefs() const {
    std::vector<Belief> beliefs;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      beliefs.push_back({arcs_[i], half_[i], {}, kept_[i] > 0.0});
      for (std::size_t m = 0; m < qw_[i].size(); ++m)
        beliefs.back().w.push_back(pw_[i] * qw_[i][m] + (1.0 - pw_[i]) * qp_[i][m]);
    }
    return beliefs;
  }

 private:
  [[nodiscard]] double step() const { return o_.step.rad(); }
  [[nodiscard]] double sigma_b(std::size_t i) const { return o_.sigma_beams * arcs_[i].beam_rad; }
  [[nodiscard]] double search(std::size_t i) const { return half_[i] * step(); }
  [[nodiscard]] Vec2 at(std::size_t i, double t) const {
    return arcs_[i].s + arcs_[i].r * unit(radians(arcs_[i].phi + t));
  }
  [[nodiscard]] Vec2 normal(std::size_t i) const { return unit(radians(arcs_[i].phi + t_[i])); }
  [[nodiscard]] OraclePoint point(std::size_t i, PointLabel label) const {
    return {at(i, t_[i]), label, bound_[i], mass_[i], arcs_[i].ping};
  }

  // A
  void take(const Reading& reading) {
    const auto range = echo_range_m(reading.outcome);
    if (!range || !reading.monostatic() || *range >= o_.range_max_m) return;
    const Pose2& T = reading.T_world_tx;
    path_.push_back(reading.T_world_robot.position);
    const auto found = last_.find(reading.rx);
    if (found != last_.end()) {
      const OracleArc& l = arcs_[found->second];
      if (norm(T.position - l.s) < o_.thin_move_m - 1e-9 &&
          std::abs(wrapped(T.heading.rad() - l.phi)) < o_.thin_turn.rad() - 1e-9 &&
          std::abs(*range - l.r) <= o_.thin_range_m)
        return;
    }
    last_[reading.rx] = arcs_.size();
    arcs_.push_back({T.position, *range, T.heading.rad(), reading.ping, reading.rx, reading.beam_width.rad()});
  }

  [[nodiscard]] std::pair<std::vector<std::size_t>, double> neighbours(std::size_t i) const {
    std::vector<std::size_t> near;
    for (std::size_t j = 0; j < arcs_.size(); ++j) {
      const std::size_t apart = i > j ? i - j : j - i;
      const double reach =
          std::min(o_.reach_m, search(i) * arcs_[i].r + search(j) * arcs_[j].r + 2.0 * o_.wall_length_m);
      if (j != i && apart <= std::size_t(o_.history) && norm(at(j, 0.0) - at(i, 0.0)) <= reach) near.push_back(j);
    }
    if (near.size() <= std::size_t(o_.neighbours)) return {near, 1.0};
    std::vector<std::size_t> chosen;
    const double every = double(near.size() - 1) / double(o_.neighbours - 1);
    for (int k = 0; k < o_.neighbours; ++k) chosen.push_back(near[std::size_t(std::nearbyint(k * every))]);
    return {chosen, double(near.size()) / double(o_.neighbours)};
  }

  // B
  [[nodiscard]] Row prior(std::size_t i) const {
    Row q;
    for (int k = -half_[i]; k <= half_[i]; ++k) q.push_back(bell(k * step(), sigma_b(i)));
    double sum = 0.0;
    for (const double x : q) sum += x;
    for (double& x : q) x /= sum;
    return q;
  }
  [[nodiscard]] double weight(const Row& q, double share, std::size_t j, double t) const {
    const int k = int(std::floor(t / step() + 0.5 + 1e-4)) + half_[j];
    if (k < 0 || k >= int(q.size())) return 0.0;
    return std::min(1.0, q[std::size_t(k)] * share / *std::ranges::max_element(prior_[j]));
  }
  [[nodiscard]] double looked_through(std::size_t j, double e, double t, double g) const {
    if (e >= -o_.free_margin_m || std::abs(t) > o_.facing_angle.rad() + tie) return 0.0;
    return std::log(1.0 - o_.facing * bell(t, sigma_b(j)) * g * g);
  }
  /// What arc j adds to L_W and to L_P of arc i at t.
  [[nodiscard]] std::pair<double, double> says(std::size_t i, std::size_t j, double t, double f) const {
    const double kappa = o_.clutter_m / (o_.range_sigma_m * std::sqrt(2.0 * std::numbers::pi));
    const auto support = [&](double u, double e) {
      return o_.independence * f * std::log1p(o_.detection * u * kappa * bell(e, o_.range_sigma_m));
    };
    const OracleArc& a = arcs_[i];
    const OracleArc& b = arcs_[j];
    const Vec2 n = unit(radians(a.phi + t));
    const double e_wall = (a.r - b.r) - dot(n, b.s - a.s);
    const double g = bell(cross(n, b.s - a.s), o_.wall_length_m);
    const double t_wall = wrapped(a.phi + t - b.phi);
    const Vec2 sight = a.s + a.r * n - b.s;
    const double e_point = norm(sight) - b.r;
    const double t_point = wrapped(bearing(sight).rad() - b.phi);
    return {support(g * weight(qw_[j], pw_[j], j, t_wall), e_wall) + f * looked_through(j, e_wall, t_wall, g),
            support(weight(qp_[j], 1.0 - pw_[j], j, t_point), e_point) + f * looked_through(j, e_point, t_point, 1.0)};
  }
  void sweep() {
    for (std::size_t i = 0; i < arcs_.size(); ++i) prior_.push_back(prior(i));
    qw_ = qp_ = prior_;
    pw_.assign(arcs_.size(), 0.5);
    ev_.assign(arcs_.size(), 0.0);
    for (int k = 0; k < o_.sweeps; ++k) {
      auto qw = qw_, qp = qp_;
      Row pw = pw_;
      for (std::size_t i = 0; i < arcs_.size(); ++i) update(i, qw[i], qp[i], pw[i]);
      qw_ = qw;
      qp_ = qp;
      pw_ = pw;
    }
  }
  void update(std::size_t i, Row& qw, Row& qp, double& pw) {
    const auto [near, f] = neighbours(i);
    double top = -1e300;
    for (int k = -half_[i]; k <= half_[i]; ++k) {
      const auto m = std::size_t(k + half_[i]);
      qw[m] = qp[m] = -0.5 * std::pow(k * step() / sigma_b(i), 2);
      for (const std::size_t j : near) {
        const auto [wall, point] = says(i, j, k * step(), f);
        qw[m] += wall;
        qp[m] += point;
      }
      top = std::max({top, qw[m], qp[m]});
    }
    double wall = 0.0, point = 0.0;
    for (double& l : qw) wall += l = std::exp(l - top);
    for (double& l : qp) point += l = std::exp(l - top);
    for (double& q : qw) q /= wall;
    for (double& q : qp) q /= point;
    pw = std::clamp(wall / (wall + point), 0.05, 0.95);
    ev_[i] = top;
  }

  // C
  void read_out() {
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      Row w;
      for (std::size_t m = 0; m < qw_[i].size(); ++m) w.push_back(pw_[i] * qw_[i][m] + (1.0 - pw_[i]) * qp_[i][m]);
      const int reach = int(o_.tolerance_m / (arcs_[i].r * step()));
      double mass = 0.0, t = 0.0;
      for (int k = 0; k < int(w.size()); ++k) {
        double sum = 0.0, mean = 0.0;
        for (int m = std::max(0, k - reach); m <= std::min(int(w.size()) - 1, k + reach); ++m) {
          sum += w[std::size_t(m)];
          mean += w[std::size_t(m)] * (m - half_[i]) * step();
        }
        if (sum > mass + 1e-12) mass = sum, t = mean / sum;
      }
      std::map<double, double> by_chord;
      for (int m = 0; m < int(w.size()); ++m)
        by_chord[2.0 * arcs_[i].r * std::abs(std::sin(0.5 * ((m - half_[i]) * step() - t)))] += w[std::size_t(m)];
      double bound = 0.0, held = 0.0;
      for (auto c = by_chord.begin(); c != by_chord.end() && held < 0.9; ++c) bound = c->first, held += c->second;
      t_.push_back(t);
      mass_.push_back(mass);
      bound_.push_back(std::max(bound, o_.bound_least_m));
    }
  }

  // D
  [[nodiscard]] bool crosses(std::size_t i, std::size_t e) const {
    const Vec2 apart = at(e, t_[e]) - arcs_[i].s;
    const double facing = dot(normal(e), normal(i));
    if (dot(apart, normal(e)) <= o_.front_m || facing <= 0.2) return false;
    if (dot(at(i, t_[i]) - at(e, t_[e]), normal(e)) <= o_.behind_m) return false;
    const Vec2 hit = arcs_[i].s + (dot(apart, normal(e)) / facing) * normal(i);
    return std::abs(cross(hit - at(e, t_[e]), normal(e))) < o_.element_m;
  }
  [[nodiscard]] Row validate(Row w0) const {
    const std::size_t n = arcs_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (const Vec2 p : path_)
        if (norm(p - at(i, t_[i])) < o_.body_m) w0[i] = 0.0;
    std::vector<std::vector<std::size_t>> beside(n), crossed(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t e = 0; e < n; ++e) {
        if (e == i || w0[i] <= 0.0 || w0[e] <= 0.0) continue;
        if (crosses(i, e)) crossed[i].push_back(e);
        if (norm(at(i, t_[i]) - at(e, t_[e])) <= o_.element_m && dot(normal(i), normal(e)) > 0.5)
          beside[i].push_back(e);
      }
    Row w = w0;
    for (int vote = 0; vote < o_.votes; ++vote) {
      Row sup = w, pas(n, 0.0), blk(n, 0.0);
      for (std::size_t i = 0; i < n; ++i) {
        for (const std::size_t e : beside[i]) sup[i] += w[e];
        for (const std::size_t e : crossed[i]) pas[e] += w[i];
      }
      for (std::size_t i = 0; i < n; ++i)
        for (const std::size_t e : crossed[i]) blk[i] += pas[e] <= o_.passed_ratio * sup[e] ? w[e] : 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        const bool outlier = blk[i] >= o_.blocked && blk[i] > o_.blocked_ratio * sup[i];
        const bool keep = !outlier && !(pas[i] >= o_.passed && pas[i] > o_.passed_ratio * sup[i]);
        const double now = keep ? w0[i] : 0.0;
        w[i] = vote + 1 < o_.votes ? 0.5 * (w[i] + now) : now;
      }
    }
    return w;
  }

  /// Log-odds of a surface at a place, from the echoes that `rays` marks.
  [[nodiscard]] double evidence(const Row& rays, Vec2 place) const {
    const auto log_odds = [](double p) { return std::log(p / (1.0 - p)); };
    double sum = 0.0;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      const Vec2 d = place - arcs_[i].s;
      const double e = norm(d) - arcs_[i].r;
      const double aside = arcs_[i].r * std::sin(wrapped(bearing(d).rad() - arcs_[i].phi - t_[i]));
      if (rays[i] <= 0.0 || dot(d, normal(i)) <= 0.0 || std::abs(aside) > o_.spread_m) continue;
      if (std::abs(e) <= 2.0 * o_.band_sigma_m)
        sum += log_odds(0.5 + (o_.occupied_peak - 0.5) * mass_[i] * bell(e, o_.band_sigma_m));
      else if (e < -o_.free_margin_m)
        sum += log_odds(0.5 - (0.5 - o_.free_floor) * mass_[i]);
    }
    return sum;
  }
  [[nodiscard]] double least_evidence() const {
    return std::log(o_.occupied_threshold / (1.0 - o_.occupied_threshold));
  }
  [[nodiscard]] Row occupied(Row w) const {
    const Row rays = w;
    for (std::size_t i = 0; i < arcs_.size(); ++i)
      if (w[i] > 0.0 && evidence(rays, at(i, t_[i])) < least_evidence()) w[i] = 0.0;
    return w;
  }

  // E
  void link(const Row& w, double gap, std::vector<OraclePoint>& map) const {
    std::set<std::pair<std::size_t, std::size_t>> links;
    for (std::size_t i = 0; i < arcs_.size(); ++i)
      for (const double side : {1.0, -1.0}) {
        double nearest = gap;
        std::size_t found = i;
        for (std::size_t j = 0; j < arcs_.size() && w[i] > 0.0; ++j) {
          const Vec2 apart = at(j, t_[j]) - at(i, t_[i]);
          if (w[j] <= 0.0 || norm(apart) <= o_.link_step_m || side * cross(normal(i), apart) <= 0.0) continue;
          if (norm(apart) < nearest) nearest = norm(apart), found = j;
        }
        if (found != i) links.insert(std::minmax(i, found));
      }
    for (const auto& [a, b] : links) {
      const Vec2 begin = at(a, t_[a]), way = at(b, t_[b]) - begin;
      int through = 0;
      for (std::size_t i = 0; i < arcs_.size(); ++i)
        if (w[i] > 0.0 && arcs_[i].r >= o_.link_ray_m) through += passes(i, begin, way) ? 1 : 0;
      if (through >= o_.link_crossings || std::max(mass_[a], mass_[b]) <= o_.link_p) continue;
      const double p = std::min(mass_[a], mass_[b]) * std::exp(-norm(way) / o_.link_decay_m);
      const int pieces = int(std::ceil(norm(way) / o_.link_step_m));
      for (int m = 1; m < pieces; ++m)
        map.push_back({begin + (double(m) / pieces) * way, PointLabel::link, o_.link_bound_m, p, 0});
    }
  }
  [[nodiscard]] bool passes(std::size_t i, Vec2 begin, Vec2 way) const {
    const Vec2 ray = (1.0 - o_.link_ray_end_m / arcs_[i].r) * (at(i, t_[i]) - arcs_[i].s);
    const double den = cross(way, ray);
    if (den == 0.0) return false;
    const double mu = cross(arcs_[i].s - begin, ray) / den;
    const double lambda = cross(arcs_[i].s - begin, way) / den;
    return lambda > 0.0 && lambda < 1.0 && mu > 0.0 && mu < 1.0;
  }

  // F
  void add_zones(const Row& w, double least_p, std::vector<OraclePoint>& map) const {
    const auto free = [&](Vec2 p) {
      return std::ranges::none_of(map, [&](const OraclePoint& q) { return norm(q.p - p) <= o_.link_step_m; });
    };
    std::vector<std::pair<double, OraclePoint>> zones;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      if (w[i] <= 0.0 || mass_[i] <= least_p) continue;
      const double reach = o_.zone * std::sqrt(o_.wavelength_m * arcs_[i].r / 2.0);
      for (const double along : {reach, -reach}) {
        OraclePoint zone = point(i, PointLabel::zone);
        zone.p = pw_[i] > 0.5 ? zone.p + along * perpendicular(normal(i)) : at(i, t_[i] + along / arcs_[i].r);
        zone.bound_m = std::max(zone.bound_m, o_.zone_bound_m);
        if (const double l = evidence(w, zone.p); l >= least_evidence() && free(zone.p)) zones.emplace_back(l, zone);
      }
    }
    std::ranges::stable_sort(zones, std::greater<>{}, [](const auto& zone) { return zone.first; });
    for (const auto& [l, zone] : zones)
      if (free(zone.p)) map.push_back(zone);
  }

  void add_weak(std::vector<OraclePoint>& map) const {
    Row likely;
    for (std::size_t i = 0; i < arcs_.size(); ++i)
      likely.push_back(mass_[i] > o_.weak_p && arcs_[i].r < o_.map_range_m ? 1.0 : 0.0);
    const Row valid = occupied(validate(likely));
    const std::vector<OraclePoint> shown = map;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      bool covered = valid[i] <= 0.0;
      for (const OraclePoint& s : shown) covered = covered || norm(s.p - at(i, t_[i])) <= o_.tolerance_m;
      if (!covered) map.push_back(point(i, PointLabel::weak));
    }
  }

  ConsensusOptions o_;
  std::vector<OracleArc> arcs_;
  std::vector<Vec2> path_;
  std::map<SensorId, std::size_t> last_;
  std::vector<int> half_;
  std::vector<Row> prior_, qw_, qp_;
  Row pw_, ev_, t_, mass_, bound_, kept_;
};

}  // namespace echoarc::oracle
