// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "sim/ping_search.hpp"

namespace echoarc::sim {

namespace {

/// The point of a disc's rim that mirrors one ear into the other, as a bearing from the centre.
///
/// Between the bearings of both ears the length of the way over the rim has its minimum; its derivative changes sign
/// there once. Newton's method, held inside that bracket.
double mirror_bearing(Vec2 sender, Vec2 listener, double radius_m) {
  const double start = bearing(sender).rad();
  const double turn = std::atan2(cross(sender, listener), dot(sender, listener));
  double low = 0.0;  // of the share of `turn`, where the length still falls
  double high = 1.0;
  double share = 0.5;
  for (int step = 0; step < 60; ++step) {
    const double phi = start + share * turn;
    const Vec2 out{std::cos(phi), std::sin(phi)};
    const Vec2 tangent = perpendicular(out);
    double slope = 0.0;
    double bend = 0.0;
    for (const Vec2 ear : {sender, listener}) {
      const Vec2 way = radius_m * out - ear;
      const double distance_m = norm(way);
      const double along = dot(way, tangent) / distance_m;
      slope += radius_m * along;
      bend += radius_m * (radius_m * (1.0 - along * along) / distance_m - dot(way, out) / distance_m);
    }
    slope *= turn;
    bend *= turn * turn;
    (slope < 0.0 ? low : high) = share;
    double next = bend > 0.0 ? share - slope / bend : 0.5 * (low + high);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - share) * std::abs(turn) < 1e-14) return start + next * turn;
    share = next;
  }
  return start + share * turn;
}

/// The echo of one disc, if it has one.
void find_disc_path(PingSearch& ping, const Disc& disc) {
  const Vec2 sender = ping.sender.position - disc.centre;
  const Vec2 listener = ping.listener.position - disc.centre;
  const double r = disc.radius_m;
  if (squared_norm(sender) <= r * r || squared_norm(listener) <= r * r) return;
  const double phi = sender == listener ? bearing(sender).rad() : mirror_bearing(sender, listener, r);
  const Vec2 out{std::cos(phi), std::sin(phi)};
  const Vec2 point = disc.centre + r * out;
  // Where the disc stands between both, the shortest way leads through it.
  if (dot(sender - r * out, out) <= 0.0 || dot(listener - r * out, out) <= 0.0) return;
  const double length_m = norm(sender - r * out) + norm(listener - r * out);
  if (length_m > ping.limits.max_length_m || !ping.sender.hears(point) || !ping.listener.hears(point)) return;
  if (!ping.sees(ping.sender.position, point) || !(ping.one_place || ping.sees(point, ping.listener.position))) return;
  const double gain_db = 10.0 * std::log10(r / (r + length_m / 2.0)) - ping.world.loss_db(disc.material);
  ping.add(point, point, length_m, gain_db, EchoCause::disc, 1);
}

}  // namespace

void find_disc_paths(PingSearch& ping) {
  ping.for_each_lit(ping.sender_view(), [&](std::uint32_t item) {
    if (item >= ping.world.index.first_disc())
      find_disc_path(ping, ping.world.description.discs[item - ping.world.index.first_disc()]);
  });
  for (const Disc& disc : ping.moving) find_disc_path(ping, disc);
}

}  // namespace echoarc::sim
