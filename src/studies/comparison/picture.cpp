// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <utility>

#include "echoarc/core/arc.hpp"
#include "echoarc/eval/nearest_points.hpp"
#include "studies/comparison/chapters.hpp"
#include "studies/comparison/judge.hpp"

namespace echoarc::studies::comparison {
namespace {

constexpr std::array<std::string_view, 4> shown{default_consensus, careful_median, "centerline < 3 m", "carve < 3 m"};
constexpr double margin_m = 0.6;
constexpr std::int32_t panel_px = 560;
constexpr std::int32_t gap_px = 10;
constexpr Rgb reference_gray{185, 185, 185};
constexpr Rgb path_blue{86, 180, 233};
constexpr Rgb right_dark{20, 60, 110};
constexpr Rgb wrong_red{213, 94, 0};

Box around(std::span<const Vec2> points, std::span<const Vec2> path) {
  Box box{points.front(), points.front()};
  for (const std::span<const Vec2> part : {points, path})
    for (const Vec2 p : part) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  return {box.low - margin_m * Vec2{1.0, 1.0}, box.high + margin_m * Vec2{1.0, 1.0}};
}

Image panel(const Box& region, const Yardstick& yardstick, const NearestPoints& nearest, const PointSet& map) {
  MapPicture picture(region, panel_px);
  picture.add_points(yardstick.reference.points.points(), reference_gray, 4);
  picture.add_line(yardstick.path.points(), path_blue);
  std::array<std::vector<Vec2>, 2> points;  // right, wrong
  for (const Vec2 p : map.points()) points[nearest.distance_m(p) <= right_within_m + eps_length_m ? 0 : 1].push_back(p);
  picture.add_points(points[1], wrong_red, 3);
  picture.add_points(points[0], right_dark, 3);
  return picture.image();
}

void paste(const Image& part, std::int32_t left, std::int32_t top, Image& whole) {
  for (std::int32_t row = 0; row < part.height; ++row) {
    const auto from = part.rgb.begin() + std::ptrdiff_t(row) * part.width * 3;
    std::copy_n(from, std::ptrdiff_t(part.width) * 3,
                whole.rgb.begin() + (std::ptrdiff_t(top + row) * whole.width + left) * 3);
  }
}

/// Panels of one size in rows, on a ground as dark as the gaps between them.
Image side_by_side(std::span<const Image> panels, std::int32_t columns) {
  const std::int32_t rows = (std::int32_t(panels.size()) + columns - 1) / columns;
  Image whole;
  whole.width = columns * (panels.front().width + gap_px) - gap_px;
  whole.height = rows * (panels.front().height + gap_px) - gap_px;
  whole.rgb.assign(std::size_t(whole.width) * std::size_t(whole.height) * 3, 120);
  for (std::int32_t k = 0; k < std::int32_t(panels.size()); ++k)
    paste(panels[std::size_t(k)], k % columns * (panels.front().width + gap_px),
          k / columns * (panels.front().height + gap_px), whole);
  return whole;
}

std::int32_t columns_for(const Image& panel, std::size_t panels) {
  const double aspect = double(panel.width) / panel.height;
  const std::int32_t best = aspect > 1.8 ? 1 : aspect < 0.6 ? 4 : 2;
  return std::min(best, std::int32_t(panels));
}

}  // namespace

std::optional<PictureFigure> picture_of(const std::string& place, const Yardstick& yardstick,
                                        std::span<const ComparedMethod> methods, std::span<const PointSet> points) {
  const Box region = around(yardstick.reference.points.points(), yardstick.path.points());
  const NearestPoints nearest(yardstick.reference.points);
  std::vector<Image> panels;
  std::string names;
  for (const std::string_view label : shown) {
    const auto found = std::ranges::find(methods, label, &ComparedMethod::label);
    if (found == methods.end()) continue;
    panels.push_back(panel(region, yardstick, nearest, points[std::size_t(found - methods.begin())]));
    names += (names.empty() ? "" : ", ") + std::string(label);
  }
  if (panels.empty()) return std::nullopt;
  const std::int32_t columns = columns_for(panels.front(), panels.size());
  return PictureFigure{anchor_of(place), place + ": " + names + ", row by row from the upper left",
                       side_by_side(panels, columns)};
}

}  // namespace echoarc::studies::comparison
