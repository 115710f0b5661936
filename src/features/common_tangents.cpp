// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/common_tangents.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "echoarc/features/fitted_line.hpp"

namespace echoarc {
namespace {

/// How far a bearing lies from the middle of what is left of an arc.
double off_middle_rad(const Arc& arc, Angle at) {
  return abs(wrap(at - arc.axis() - 0.5 * (arc.t_begin() + arc.t_end()))).rad();
}

/// A monostatic echo that is a circular arc one can reckon with.
bool has_circle(const Reading& reading, double range_m) {
  return std::isfinite(range_m) && range_m > 0.0 && reading.beam_width > Angle{} &&
         reading.beam_width < degrees(180.0) && is_finite(reading.T_world_tx);
}

}  // namespace

std::optional<CommonTangent> common_tangent(const Arc& first, const Arc& second, double baseline_min_m) {
  if (!first.is_circular() || !second.is_circular()) return std::nullopt;
  const Vec2 baseline = second.centre() - first.centre();
  const double distance_m = norm(baseline);
  if (distance_m < std::max(baseline_min_m, eps_length_m)) return std::nullopt;
  // r_k = H - n.S_k for both arcs, so d cos(gamma) = r1 - r2 with gamma from the baseline to n.
  const double cosine = (first.range_m() - second.range_m()) / distance_m;
  if (std::abs(cosine) > 1.0) return std::nullopt;
  const Angle gamma = radians(std::acos(cosine));
  std::optional<Angle> best;
  const auto off = [&](Angle at) { return off_middle_rad(first, at) + off_middle_rad(second, at); };
  for (const Angle at : {bearing(baseline) + gamma, bearing(baseline) - gamma}) {
    if (!first.contains_bearing(at) || !second.contains_bearing(at)) continue;
    if (!best || off(at) < off(*best)) best = at;
  }
  if (!best) return std::nullopt;
  const Vec2 normal = unit(*best);
  return CommonTangent{normal, first.centre() + first.range_m() * normal, second.centre() + second.range_m() * normal};
}

void CommonTangents::insert(std::span<const Reading> readings) {
  for (const Reading& reading : readings) {
    const auto range_m = echo_range_m(reading.outcome);
    if (!range_m) continue;
    if (!reading.monostatic()) {
      ++counters_.bistatic;
    } else if (!has_circle(reading, *range_m) || *range_m > options_.range_max_m) {
      ++counters_.passed_over;
    } else {
      insert(*arc_of(reading), reading.rx, reading.ping);
    }
  }
}

void CommonTangents::insert(const Arc& arc, SensorId sensor, PingId ping) {
  if (!arc.is_circular()) {
    ++counters_.bistatic;
    return;
  }
  const auto found = tracks_.find(sensor);
  if (found == tracks_.end()) {
    ++counters_.arcs;
    tracks_.emplace(sensor, Track{arc, ping, {}});
    return;
  }
  Track& track = found->second;
  if (norm(arc.centre() - track.arc.centre()) < std::max(options_.baseline_min_m, eps_length_m)) {
    ++counters_.passed_over;
    return;
  }
  ++counters_.arcs;
  ++counters_.pairs;
  const auto tangent = common_tangent(track.arc, arc);
  Chain& chain = track.chain;
  if (!tangent || norm(tangent->second - tangent->first) >= options_.gap_m) {
    close(chain);
  } else {
    ++counters_.tangents;
    if (!chain.points.empty()) {
      const Angle turned = radians(std::acos(std::clamp(dot(chain.normal, tangent->normal), -1.0, 1.0)));
      const double gap_m = norm(tangent->first - chain.points.back());
      if (turned > options_.turn || gap_m >= options_.gap_m) close(chain);
    }
    if (chain.points.empty()) chain.pings.push_back(track.ping);
    chain.points.insert(chain.points.end(), {tangent->first, tangent->second});
    chain.pings.push_back(ping);
    chain.normal = tangent->normal;
  }
  track.arc = arc;
  track.ping = ping;
}

std::optional<Feature> CommonTangents::segment_of(const Chain& chain) const {
  if (chain.points.empty() || chain.pings.size() < std::size_t(options_.arcs_min)) return std::nullopt;
  PointMoments moments;
  for (const Vec2 p : chain.points) moments.add(p);
  FittedLine line = FittedLine::of(moments);
  // Drawn in the direction of the drive.
  if (dot(line.direction, chain.points.back() - chain.points.front()) < 0.0) line.direction = -line.direction;
  double low_m = 0.0;
  double high_m = 0.0;
  for (const Vec2 p : chain.points) {
    low_m = std::min(low_m, line.along_m(p));
    high_m = std::max(high_m, line.along_m(p));
  }
  return Feature{
      FeatureKind::tangent, line.at(low_m), line.at(high_m), line.rms_m, static_cast<std::uint32_t>(chain.pings.size()),
      chain.pings};
}

void CommonTangents::close(Chain& chain) {
  if (auto segment = segment_of(chain)) finished_.push_back(std::move(*segment));
  chain = {};
}

std::vector<Feature> CommonTangents::features() const {
  std::vector<Feature> all = finished_;
  for (const auto& [sensor, track] : tracks_)
    if (auto segment = segment_of(track.chain)) all.push_back(std::move(*segment));
  return all;
}

}  // namespace echoarc
