// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/ping_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace echoarc::sim {

namespace {

constexpr double touch_m = 1e-9;

bool same_path(const EchoPath& a, const EchoPath& b) {
  const auto near = [](Angle x, Angle y) { return abs(wrap(x - y)).rad() <= 1e-9; };
  return a.cause == b.cause && near(a.departure, b.departure) && near(a.arrival, b.arrival);
}

bool same_eye(const Transducer& a, const Transducer& b) {
  return a.position == b.position && a.axis == b.axis && a.half_window == b.half_window;
}

}  // namespace

Ear::Ear(const Transducer& transducer)
    : position(transducer.position),
      axis(unit(transducer.axis)),
      cos_window(transducer.half_window.rad() >= std::numbers::pi ? -2.0 : cos(transducer.half_window)) {}

bool Ear::hears(Vec2 point) const {
  const Vec2 way = point - position;
  const double distance_m = std::sqrt(squared_norm(way));
  return distance_m > touch_m && dot(way, axis) >= cos_window * distance_m;
}

void Marks::forget() {
  if (++round_ == 0) {  // the count wrapped around
    std::ranges::fill(marked_in_, 0);
    round_ = 1;
  }
}

PingSearch::PingSearch(const WorldModel& model, std::vector<EchoPath>& found)
    : world(model),
      paths(found),
      sweep(model),
      vertex_marks(model.topology.vertices.size()),
      curve_marks(model.description.curves.size()),
      item_marks_(model.index.count()) {}

void PingSearch::start(const Transducer& transmitter, const Transducer& receiver, const PathLimits& path_limits,
                       std::span<const Disc> discs) {
  sender = Ear(transmitter);
  listener = Ear(receiver);
  limits = path_limits;
  limits.max_order = std::clamp(limits.max_order, 1, PathLimits::highest_order);
  moving = discs;
  images = 0;
  paths.clear();
  one_place = !world.has_one_sided && same_eye(transmitter, receiver);
  // After one transmission all listen: what the sender sees stays as it was. In whole metres, so that neither its view
  // nor the work it counts depends on who listened before.
  const double reach = 0.5 * (limits.max_length_m + std::ceil(norm(sender.position - listener.position)));
  if (!same_eye(seen_from_, transmitter) || reach != seen_to_m_) {
    seen_from_ = transmitter;
    seen_to_m_ = reach;
    seen_work_ = 0;
    sender_view_.look(transmitter, false, reach, sweep, seen_work_);
  }
  work = seen_work_;
  if (!one_place) listener_view_.look(receiver, true, reach, sweep, work);
}

void PingSearch::add(Vec2 first, Vec2 last, double length_m, double gain_db, EchoCause cause, std::size_t reflections) {
  paths.push_back({length_m, bearing(first - sender.position), bearing(last - listener.position), gain_db, cause,
                   static_cast<std::uint8_t>(reflections)});
}

void order_paths(std::vector<EchoPath>& paths) {
  std::ranges::sort(paths, {}, [](const EchoPath& p) {
    return std::tuple(p.length_m, p.cause, p.departure.rad(), p.arrival.rad(), -p.gain_db);
  });
  std::size_t kept = 0;
  for (const EchoPath& path : paths) {
    std::size_t other = kept;
    while (other > 0 && path.length_m - paths[other - 1].length_m <= touch_m && !same_path(path, paths[other - 1]))
      --other;
    if (other > 0 && path.length_m - paths[other - 1].length_m <= touch_m)
      paths[other - 1].gain_db = std::max(paths[other - 1].gain_db, path.gain_db);
    else
      paths[kept++] = path;
  }
  paths.resize(kept);
}

}  // namespace echoarc::sim
