// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/choset/mouth.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "echoarc/mapping/atm.hpp"
#include "echoarc/mapping/centerline.hpp"
#include "echoarc/studies/local_maps.hpp"
#include "echoarc/studies/openings.hpp"
#include "studies/simulated_drive.hpp"

namespace echoarc::studies::choset {
namespace {

// How far a point may be from the line of a wall to stand in its opening: about half of what a robot needs.
constexpr double depth_m = 0.2;

MouthView view_of(std::span<const MapPoint> points, const Mouth& mouth, const Gap& opening, bool keep) {
  const double length_m = norm(mouth.b - mouth.a);
  const std::vector<Vec2> places = positions(points);
  const auto gap_m = [&](const Gap& stretch) {
    if (stretch.width_m() <= 0.0) return 0.0;
    return widest_gap(places, strip_over(mouth.a, mouth.b, stretch, depth_m)).width_m();
  };
  MouthView view;
  view.gap_m = gap_m(opening);
  view.beside_m = std::max(gap_m({0.0, opening.begin_m}), gap_m({opening.end_m, length_m}));
  if (keep) view.points.assign(points.begin(), points.end());
  return view;
}

template <class Method>
Method mapped(std::span<const Reading> readings, typename Method::Options options = {}) {
  InlineExecutor executor;
  Method method(options);
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

}  // namespace

Gap mouth_opening(const sim::WorldDescription& world, const Mouth& mouth) {
  const std::vector<Gap> open = open_stretches(world, mouth.a, mouth.b);
  return open.empty() ? Gap{} : open.front();
}

Result<MouthRun> look_at_mouth(const StudyScene& scene, const Mouth& mouth, std::uint64_t seed, bool keep) {
  Result<SimulatedDrive> drive = simulate_drive(scene.scene, seed);
  if (!drive) return drive.error();
  const Gap opening = mouth_opening(scene.scene.world, mouth);
  const Centerline centers = mapped<Centerline>(drive->readings);
  const AtmOrg atm = mapped<AtmOrg>(drive->readings);
  AtmOrg::Options all_arcs;
  all_arcs.history = HistoryScope::all;
  const AtmOrg atm_all = mapped<AtmOrg>(drive->readings, all_arcs);
  MouthRun run;
  run.centerline = view_of(centers.map().points(), mouth, opening, keep);
  run.atm = view_of(labelled(atm.map().points(), {PointLabel::atm}), mouth, opening, keep);
  run.atm_all = view_of(labelled(atm_all.map().points(), {PointLabel::atm}), mouth, opening, keep);
  run.atm_centerline = view_of(atm.map().points(), mouth, opening, keep);
  if (keep) run.readings = std::move(drive->readings);
  return run;
}

Image mouth_picture(const StudyScene& scene, std::span<const MapPoint> points) {
  MapPicture picture(scene.scoring.region);
  picture.add_surfaces(scene.scene.world);
  picture.add_points(points, 4);
  return picture.image();
}

Image arcs_picture(const StudyScene& scene, std::span<const Reading> readings) {
  constexpr int steps = 12;
  MapPicture picture(scene.scoring.region);
  for (const Reading& reading : readings) {
    const auto range_m = echo_range_m(reading.outcome);
    if (!range_m || !(*range_m > 0.0)) continue;
    const Arc arc =
        Arc::circular(reading.T_world_tx.position, reading.T_world_tx.heading, *range_m, reading.beam_width);
    std::vector<Vec2> line;
    for (int k = 0; k <= steps; ++k)
      line.push_back(arc.point_at(arc.t_begin() + (arc.t_end() - arc.t_begin()) * (double(k) / steps)));
    picture.add_line(line, {86, 180, 233}, 1);
  }
  picture.add_surfaces(scene.scene.world);
  return picture.image();
}

}  // namespace echoarc::studies::choset
