// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/bundle.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace echoarc::server {
namespace {

void add(std::vector<SharedFrame>& frames, const SharedFrame& frame) {
  if (frame) frames.push_back(frame);
}

}  // namespace

void Bundler::set(SharedPublication publication) {
  publication_ = std::move(publication);
  pings_from_.clear();
  path_from_.clear();
}

std::vector<SharedFrame> Bundler::take(Viewer& viewer, const SharedFrame& state,
                                       std::map<std::string, std::uint32_t>& behind) {
  std::vector<SharedFrame> frames;
  add(frames, state);
  if (!publication_ || !viewer.cursor.greeted) return frames;
  if (viewer.cursor.run != publication_->run) {
    viewer.cursor.run = publication_->run;
    viewer.cursor.pings = viewer.cursor.path = 0;
  }
  add_pings(viewer, frames);
  add_path(viewer, frames);
  add_maps(viewer, frames, behind);
  add(frames, publication_->laser);
  add_second(viewer, frames);
  return frames;
}

std::size_t Bundler::first_ping() const {
  const live::ReadingLog& readings = publication_->readings;
  std::size_t first = readings.size();
  if (first == 0) return 0;
  const double since_s = readings[first - 1].reading.time_s - first_pings_s;
  while (first > 0 && publication_->readings.size() - first < most_pings &&
         readings[first - 1].reading.time_s > since_s)
    --first;
  return first;
}

void Bundler::add_pings(Viewer& viewer, std::vector<SharedFrame>& frames) {
  const std::size_t end = publication_->readings.size();
  std::size_t begin = viewer.cursor.pings;
  if (begin >= end) return;
  // A newcomer, and who was away for too long, starts with the newest.
  const bool anew = begin == 0 || end - begin > most_pings;
  if (anew) begin = first_ping();
  SharedFrame& frame = pings_from_[{begin, anew}];
  if (!frame) {
    const FrameHead head{.kind = FrameKind::pings, .flags = anew ? frame_forgets : std::uint16_t{0}};
    frame = encode_pings(head, publication_->readings, begin, end);
  }
  add(frames, frame);
  viewer.cursor.pings = end;
}

void Bundler::add_path(Viewer& viewer, std::vector<SharedFrame>& frames) {
  const std::vector<Vec2>& path = *publication_->path;
  const std::size_t begin = viewer.cursor.path;
  if (begin >= path.size()) return;
  SharedFrame& frame = path_from_[begin];
  if (!frame) {
    const FrameHead head{.kind = FrameKind::path, .flags = begin == 0 ? frame_forgets : std::uint16_t{0}};
    frame = encode_positions(head, std::span(path).subspan(begin));
  }
  add(frames, frame);
  viewer.cursor.path = path.size();
}

void Bundler::add_maps(Viewer& viewer, std::vector<SharedFrame>& frames,
                       std::map<std::string, std::uint32_t>& behind) const {
  ViewerCursor& cursor = viewer.cursor;
  const auto tell_methods = [&](std::uint64_t version, const SharedFrame& methods) {
    if (version <= cursor.methods_version) return;
    cursor.methods_version = version;
    add(frames, methods);
  };
  if (const auto caught = std::exchange(cursor.caught, std::nullopt)) {
    // Indices in these frames are those of their own list of methods; an older list is void by now.
    if (caught->methods_version >= cursor.methods_version) {
      tell_methods(caught->methods_version, caught->methods);
      for (const MapDelta& delta : caught->deltas) {
        add(frames, delta.tiles);
        add(frames, delta.points);
        cursor.maps[delta.method] = delta.to;
      }
    }
  }
  if (publication_->methods_version < cursor.methods_version) return;  // the next publication will be newer
  tell_methods(publication_->methods_version, publication_->methods);
  std::erase_if(cursor.maps, [&](const auto& map) {
    return std::ranges::find(publication_->deltas, map.first, &MapDelta::method) == publication_->deltas.end();
  });
  for (const MapDelta& delta : publication_->deltas) {
    if (!viewer.wants(delta.method)) continue;
    std::uint32_t& has = cursor.maps[delta.method];
    if (has >= delta.to && has != 0) continue;
    if (has < delta.from || has == 0) {
      if (delta.to != 0) behind.emplace(delta.method, has);
      continue;
    }
    add(frames, delta.tiles);
    add(frames, delta.points);
    has = delta.to;
  }
}

void Bundler::add_second(Viewer& viewer, std::vector<SharedFrame>& frames) const {
  for (const SharedFrame& recompute : publication_->recompute) add(frames, recompute);
  if (viewer.cursor.second == publication_->second) return;
  viewer.cursor.second = publication_->second;
  add(frames,
      std::make_shared<const Frame>(Frame{publication_->counters + std::to_string(viewer.dropped) + "}", false}));
  add(frames, publication_->scores);
  add(frames, publication_->timeline);
}

}  // namespace echoarc::server
