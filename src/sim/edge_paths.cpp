// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/edge_paths.hpp"

#include <algorithm>

namespace echoarc::sim {

void EdgeSearch::run(PingSearch& ping) {
  see_vertices(ping, ping.sender, ping.sender_view(), true, from_sender_);
  if (!ping.one_place) see_vertices(ping, ping.listener, ping.listener_view(), false, from_listener_);
  find_edges(ping);
  if (ping.limits.max_order < 2) return;
  find_wall_edges(ping, true);
  if (!ping.one_place) find_wall_edges(ping, false);
}

/// Vertices at the ends of what an ear's view lights.
void EdgeSearch::see_vertices(PingSearch& ping, const Ear& ear, const View& view, bool outward,
                              std::vector<std::uint32_t>& seen) {
  seen.clear();
  ping.vertex_marks.forget();
  const Topology& topology = ping.world.topology;
  const SpatialIndex& index = ping.world.index;
  const auto look_at = [&](std::uint32_t v) {
    if (!ping.vertex_marks.mark(v)) return;
    const Vertex& vertex = topology.vertices[v];
    if (!vertex.echoes_to(ear.position) || !ear.hears(vertex.point) || !view.may_see(vertex.point)) return;
    if (outward ? ping.sees(ear.position, vertex.point) : ping.sees(vertex.point, ear.position)) seen.push_back(v);
  };
  ping.for_each_lit(view, [&](std::uint32_t item) {
    if (item < index.first_chunk())
      for (const std::uint32_t v : topology.ends_of_wall[item]) look_at(v);
    else if (item < index.first_disc())
      for (const std::uint32_t v : topology.ends_of_curve[index.chunks()[item - index.first_chunk()].curve]) look_at(v);
  });
}

void EdgeSearch::find_edges(PingSearch& ping) {
  ping.vertex_marks.forget();
  if (!ping.one_place)
    for (const std::uint32_t v : from_listener_) ping.vertex_marks.mark(v);
  for (const std::uint32_t v : from_sender_) {
    if (!ping.one_place && ping.vertex_marks.mark(v)) continue;
    const Vec2 point = ping.world.topology.vertices[v].point;
    const double length_m = norm(point - ping.sender.position) + norm(point - ping.listener.position);
    if (length_m <= ping.limits.max_length_m)
      ping.add(point, point, length_m, ping.limits.edge_gain_db, EchoCause::edge, 1);
  }
}

void EdgeSearch::find_wall_edges(PingSearch& ping, bool wall_first) {
  walls_.clear();
  const Ear& near_wall = wall_first ? ping.sender : ping.listener;
  ping.for_each_lit(wall_first ? ping.sender_view() : ping.listener_view(), [&](std::uint32_t item) {
    if (item < ping.world.index.first_chunk() && ping.world.mirrors[item].reflects(near_wall.position))
      walls_.push_back(item);
  });
  const bool sender_sees = !wall_first || ping.one_place;
  for (const std::uint32_t wall : walls_)
    for (const std::uint32_t v : sender_sees ? from_sender_ : from_listener_) {
      if (!ping.count_image()) return;
      find_wall_edge(ping, wall, ping.world.topology.vertices[v], wall_first);
    }
}

void EdgeSearch::find_wall_edge(PingSearch& ping, std::uint32_t wall, const Vertex& vertex, bool wall_first) {
  const Ear& near_wall = wall_first ? ping.sender : ping.listener;
  const Ear& near_edge = wall_first ? ping.listener : ping.sender;
  const Mirror& mirror = ping.world.mirrors[wall];
  Vec2 bounce;
  const Vec2 image = mirror.image(near_wall.position);
  if (!mirror.reflects(vertex.point) || !mirror.bounce(vertex.point, image, bounce)) return;
  const double length_m = norm(image - vertex.point) + norm(vertex.point - near_edge.position);
  if (length_m > ping.limits.max_length_m || !near_wall.hears(bounce) || !vertex.echoes_to(bounce)) return;
  const Vec2 first = wall_first ? bounce : vertex.point;
  const Vec2 last = wall_first ? vertex.point : bounce;
  if (wall_first ? !ping.sees(ping.sender.position, bounce) : !ping.sees(bounce, ping.listener.position)) return;
  if (!ping.sees(first, last)) return;
  const double gain_db = ping.limits.edge_gain_db - ping.world.loss_db(ping.world.description.walls[wall].material);
  ping.add(first, last, length_m, gain_db, EchoCause::wall_edge, 2);
  if (ping.one_place) ping.add(last, first, length_m, gain_db, EchoCause::wall_edge, 2);
}

}  // namespace echoarc::sim
