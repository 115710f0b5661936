// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/record_text.hpp"

#include <cstddef>

#include "io/range_words.hpp"

namespace echoarc::io {
namespace {

template <class Ranges, class Write>
void write_ranges(RecordText& out, const Ranges& ranges_m, const Write& write) {
  out.text(R"(,"ranges":[)");
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    if (i > 0) out.text(",");
    write(ranges_m[i]);
  }
  out.text("]}");
}

}  // namespace

RecordText& RecordText::range(double range_m) {
  if (std::isfinite(range_m)) return number(range_m);
  return text("\"").text(word_of_range(range_m)).text("\"");
}

void write_pose(RecordText& out, std::string_view type, const Odometry& pose) {
  out.text(R"({"type":")").text(type).text(R"(","t":)").finite(pose.time_s);
  out.text(R"(,"x":)").finite(pose.T_world_robot.position.x);
  out.text(R"(,"y":)").finite(pose.T_world_robot.position.y);
  out.text(R"(,"yaw":)").finite(pose.T_world_robot.heading.rad()).text("}");
}

void write_ping(RecordText& out, const Ping& ping) {
  out.text(R"({"type":"ping","t":)").finite(ping.time_s);
  out.text(R"(,"tx":)").number(ping.tx).text(R"(,"rx":)").number(ping.rx);
  out.text(R"(,"range":)").range(ping.range_m);
  if (!std::isnan(ping.time_of_flight_s)) out.text(R"(,"tof":)").finite(ping.time_of_flight_s);
  if (ping.echo_index != 0) out.text(R"(,"echo":)").number(ping.echo_index);
  if (ping.cause != EchoCause::unknown) out.text(R"(,"cause":")").text(name(ping.cause)).text("\"");
  out.text("}");
}

void write_scan(RecordText& out, const Scan& scan) {
  out.text(R"({"type":"scan","t":)").finite(scan.time_s).text(R"(,"laser":)").number(scan.laser);
  out.text(R"(,"angle_min":)").finite(scan.angle_min.rad());
  out.text(R"(,"angle_step":)").finite(scan.angle_step.rad());
  write_ranges(out, scan.ranges_m,
               [&](float range_m) { std::isfinite(range_m) ? out.number(range_m) : out.text("null"); });
}

void write_poll(RecordText& out, const Poll& poll) {
  out.text(R"({"type":"poll","t":)").finite(poll.time_s);
  write_ranges(out, poll.ranges_m, [&](double range_m) { out.range(range_m); });
}

void write_wall(RecordText& out, const WallNote& note) {
  constexpr std::array<std::string_view, 3> sides = {"unknown", "left", "right"};
  out.text(R"({"type":"wall","t":)").finite(note.time_s);
  out.text(R"(,"side":")").text(sides.at(static_cast<std::size_t>(note.side))).text("\"}");
}

}  // namespace echoarc::io
