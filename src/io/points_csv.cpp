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

void append_point(std::string& text, const PointMap& points, const MapPoint& point) {
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
  text += '\n';
}

}  // namespace

std::string points_csv(const PointMap& points) {
  std::string text = "x,y,label,bound,t,sensor,ping,support\n";
  for (const MapPoint& point : points.points()) append_point(text, points, point);
  return text;
}

Result<void> write_points_csv(const std::filesystem::path& path, const PointMap& points) {
  return write_file(path, points_csv(points));
}

}  // namespace echoarc::io
