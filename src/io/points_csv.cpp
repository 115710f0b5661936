// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/points_csv.hpp"

#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "io/files.hpp"

namespace echoarc::io {
namespace {

void append_point(std::string& text, const PointMap& points, std::size_t k) {
  const MapPoint& point = points.points()[k];
  auto out = std::back_inserter(text);
  fmt::format_to(out, "{},{},{},{},", point.position.x, point.position.y, name(point.label), point.bound_m);
  if (std::isnan(point.time_s))
    text += ",,,";
  else
    fmt::format_to(out, "{},{},{},", point.time_s, point.sensor, point.ping);
  std::string_view separator;
  for (const PingId ping : points.support(point)) {
    fmt::format_to(out, "{}{}", separator, ping);
    separator = ";";
  }
  if (!points.beliefs().empty()) {
    const PointBelief& belief = points.beliefs()[k];
    fmt::format_to(out, ",{},{},{},{}", belief.normal.x, belief.normal.y, belief.probability,
                   belief.provisional ? 1 : 0);
  }
  text += '\n';
}

}  // namespace

std::string points_csv(const PointMap& points) {
  std::string text = "x,y,label,bound,t,sensor,ping,support";
  text += points.beliefs().empty() ? "\n" : ",nx,ny,p,provisional\n";
  for (std::size_t k = 0; k < points.size(); ++k) append_point(text, points, k);
  return text;
}

Result<void> write_points_csv(const std::filesystem::path& path, const PointMap& points) {
  return write_file(path, points_csv(points));
}

std::string segments_csv(const PointMap& points) {
  std::string text = "x1,y1,x2,y2,label\n";
  for (const MapSegment& segment : points.segments())
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", segment.begin.x, segment.begin.y, segment.end.x,
                   segment.end.y, name(segment.label));
  return text;
}

Result<void> write_segments_csv(const std::filesystem::path& path, const PointMap& points) {
  return write_file(path, segments_csv(points));
}

}  // namespace echoarc::io
