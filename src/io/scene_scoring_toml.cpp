// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/scene_scoring_toml.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "io/option_toml.hpp"
#include "io/toml_points.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t max_spans = 100'000;
constexpr double max_cells = 1e8;

void read_region(TomlFields& fields, SceneScoring& scoring) {
  const std::vector<TomlPoint> corners = read_points(fields, "region", 2);
  if (corners.size() < 2) return;
  scoring.region = {corners[0].point, corners[1].point};
  const Vec2 size = scoring.region.high - scoring.region.low;
  const double cells = size.x / scoring.cell_m * (size.y / scoring.cell_m);
  if (corners.size() > 2 || !(size.x > 0.0 && size.y > 0.0))
    fields.fail(fields.node("region"), "region is no rectangle",
                "write region = [[0.0, 0.0], [5.25, 5.25]], lower left and upper right corner");
  else if (!(cells <= max_cells))
    fields.fail(fields.node("region"), fmt::format("region has {:.4g} cells", cells),
                fmt::format("keep it below {:.0f}, or make cell_m larger", max_cells));
}

void read_spans(TomlFields& fields, SceneScoring& scoring) {
  for (const toml::table* table : fields.tables("span", max_spans)) {
    TomlFields span(*table, fields.source(), "span");
    const std::optional<Vec2> from = read_point(span, "from");
    const std::optional<Vec2> to = read_point(span, "to");
    const double depth_m = required_length_m(span, "depth", 0.0, 1e5);
    if (from && to) scoring.walls.push_back({*from, *to, depth_m});
    if (const Result<void> done = span.finish(); !done) {
      fields.fail(done.error());
      return;
    }
  }
}

}  // namespace

std::optional<SceneScoring> read_scoring(TomlFields& scene) {
  const toml::table* table = scene.table("scoring");
  if (table == nullptr) return std::nullopt;
  SceneScoring scoring;
  TomlFields fields(*table, scene.source(), "scoring");
  read_options(fields, scoring);
  read_region(fields, scoring);
  read_spans(fields, scoring);
  scoring.axis = fields.angle("axis");
  scoring.polar_centre = read_point(fields, "polar_centre", false);
  const int kinds = static_cast<int>(!scoring.walls.empty()) + static_cast<int>(scoring.axis.has_value()) +
                    static_cast<int>(scoring.polar_centre.has_value());
  if (kinds != 1)
    fields.fail(nullptr, kinds == 0 ? "scoring has no directions of interest" : "scoring has two kinds of directions",
                "give one of [[scoring.span]], axis_deg or polar_centre");
  if (const Result<void> done = fields.finish(); !done) scene.fail(done.error());
  return scoring;
}

}  // namespace echoarc::io
