// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/frame_encoder.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <utility>

namespace echoarc::server {
namespace {

static_assert(std::endian::native == std::endian::little, "frames are copied from memory");

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// Appends numbers as they lie in memory.
class FrameWriter {
 public:
  FrameWriter(const FrameHead& head, std::size_t records, std::size_t record_bytes) {
    frame_->binary = true;
    frame_->bytes.reserve(frame_head_bytes + records * record_bytes);
    put(head.kind), put(head.method), put(head.flags), put(std::uint32_t{0}), put(head.sequence), put(head.question);
  }
  template <class T>
  void put(T value) {
    frame_->bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put_float(double value) { put(static_cast<float>(value)); }
  void put_pose(const Pose2& pose) {
    put_float(pose.position.x), put_float(pose.position.y), put_float(pose.heading.rad());
  }
  void bytes(const void* data, std::size_t size) { frame_->bytes.append(static_cast<const char*>(data), size); }
  void count_record() { ++records_; }

  [[nodiscard]] std::uint32_t records() const { return records_; }
  [[nodiscard]] SharedFrame take() {
    std::memcpy(frame_->bytes.data() + 4, &records_, sizeof records_);
    return std::move(frame_);
  }

 private:
  std::shared_ptr<Frame> frame_ = std::make_shared<Frame>();
  std::uint32_t records_ = 0;
};

std::uint8_t outcome_code(const live::JudgedPing& ping) {
  if (ping.rejected) return 3;
  return static_cast<std::uint8_t>(ping.reading.outcome.index());  // no echo 0, echo 1, too close 2
}

void put_ping(FrameWriter& out, const live::JudgedPing& ping) {
  const Reading& reading = ping.reading;
  const std::optional<double> heard_m = echo_range_m(reading.outcome);
  const double range_m = ping.rejected ? ping.raw_range_m : heard_m.value_or(none);
  out.put(reading.time_s);
  out.put(static_cast<std::uint32_t>(reading.ping));
  out.put(static_cast<std::uint16_t>(reading.rx)), out.put(static_cast<std::uint16_t>(reading.tx));
  out.put_float(range_m >= 0.0 && range_m < 1e6 ? range_m : none);
  out.put_pose(reading.T_world_tx), out.put_pose(reading.T_world_rx), out.put_pose(reading.T_world_robot);
  out.put_float(reading.trusted_range_m);
  out.put(outcome_code(ping));
  out.put(static_cast<std::uint8_t>(ping.rejected ? static_cast<int>(*ping.rejected) : 0));
  out.put(std::uint16_t{0});
  out.count_record();
}

void put_point(FrameWriter& out, std::uint32_t slot, const live::DrawnPoint& drawn) {
  const MapPoint& point = drawn.point;
  const Vec2 centre = drawn.arc_centre.value_or(Vec2{none, none});
  out.put(slot);
  out.put_float(point.position.x), out.put_float(point.position.y), out.put_float(point.bound_m);
  out.put_float(centre.x), out.put_float(centre.y), out.put_float(drawn.probability), out.put_float(point.time_s);
  out.put(static_cast<std::uint32_t>(point.ping)), out.put(static_cast<std::uint16_t>(point.sensor));
  out.put(static_cast<std::uint8_t>(point.label));
  out.put(static_cast<std::uint8_t>((drawn.gone ? 1 : 0) | (drawn.provisional ? 2 : 0)));
  out.put(point.support_count);
  out.count_record();
}

/// A map that was reset since starts anew.
FrameHead with_flags(FrameHead head, const live::MapStore& store, std::uint32_t since) {
  if (since < store.reset_at() || since == 0) head.flags |= frame_forgets;
  return head;
}

}  // namespace

SharedFrame encode_pings(const FrameHead& head, const live::ReadingLog& readings, std::size_t begin, std::size_t end) {
  FrameWriter out(head, end - begin, 64);
  for (std::size_t i = begin; i < end; ++i) put_ping(out, readings[i]);
  return out.take();
}

SharedFrame encode_tiles(const FrameHead& head, const live::MapStore& store, std::uint32_t since) {
  const FrameHead flagged = with_flags(head, store, since);
  FrameWriter out(flagged, 0, 0);
  store.visit_tiles(since, [&](live::MapStore::TileIndex index, const live::TileBytes& tile) {
    out.put(index.column), out.put(index.row);
    out.bytes(tile.data(), tile.size());
    out.count_record();
  });
  return out.records() > 0 || flagged.flags != 0 ? out.take() : nullptr;
}

SharedFrame encode_points(const FrameHead& head, const live::MapStore& store, std::uint32_t since) {
  const FrameHead flagged = with_flags(head, store, since);
  FrameWriter out(flagged, 0, 0);
  store.visit_points(since, [&](std::uint32_t slot, const live::DrawnPoint& point) { put_point(out, slot, point); });
  return out.records() > 0 || flagged.flags != 0 ? out.take() : nullptr;
}

SharedFrame encode_positions(const FrameHead& head, std::span<const Vec2> positions) {
  FrameWriter out(head, positions.size(), 8);
  for (const Vec2 position : positions) {
    out.put_float(position.x), out.put_float(position.y);
    out.count_record();
  }
  return out.take();
}

}  // namespace echoarc::server
