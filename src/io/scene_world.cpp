// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/scene_world.hpp"

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "io/scene_curve.hpp"
#include "io/scene_materials.hpp"
#include "io/toml_points.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t max_objects = sim::World::max_walls;
constexpr std::size_t max_curve_samples = 2'000'000;
constexpr double farthest_m = sim::World::max_coordinate_m;

class WorldReader {
 public:
  explicit WorldReader(TomlFields& scene) : scene_(scene) { world_.materials = read_materials(scene); }

  sim::WorldDescription read() {
    for_each("wall", [this](TomlFields& fields, std::uint64_t /*line*/) { add_wall(fields); });
    for_each("box", [this](TomlFields& fields, std::uint64_t line) { add_box(fields, line); });
    for_each("slats", [this](TomlFields& fields, std::uint64_t line) { add_slats(fields, line); });
    for_each("disc", [this](TomlFields& fields, std::uint64_t line) { add_disc(fields, line); });
    for_each("curve", [this](TomlFields& fields, std::uint64_t line) { add_curve(fields, line); });
    for_each("moving", [this](TomlFields& fields, std::uint64_t line) { add_moving(fields, line); });
    if (const toml::table* table = scene_.table("world")) {
      TomlFields fields(*table, scene_.source(), "world");
      world_.seed = static_cast<std::uint64_t>(fields.integer("seed", 0, INT64_MAX).value_or(1));
      if (const Result<void> done = fields.finish(); !done) scene_.fail(done.error());
    }
    return std::move(world_);
  }

 private:
  void for_each(std::string_view key, const std::function<void(TomlFields&, std::uint64_t)>& add) {
    for (const toml::table* table : scene_.tables(key, max_objects)) {
      TomlFields fields(*table, scene_.source(), key);
      add(fields, toml_line(*table));
      check_sizes(fields);
      if (const Result<void> done = fields.finish(); !done) {
        scene_.fail(done.error());
        return;
      }
    }
  }

  void check_sizes(TomlFields& fields) {
    if (world_.walls.size() > sim::World::max_walls)
      fields.fail(nullptr, fmt::format("the world has more than {} walls", sim::World::max_walls),
                  "divide it, or leave small things out");
    if (curve_samples_ > max_curve_samples)
      fields.fail(nullptr,
                  fmt::format("all curves together have more than {} samples, one every 2 mm", max_curve_samples),
                  "leave some out");
  }

  sim::MaterialId material_of(TomlFields& fields) {
    return read_material_name(fields, "material", "wood", world_.materials);
  }

  /// A polyline: a wall between every two neighbouring points.
  void add_wall(TomlFields& fields) {
    const sim::MaterialId material = material_of(fields);
    const bool one_sided = fields.boolean("one_sided").value_or(false);
    const bool closed = fields.boolean("closed").value_or(false);
    const std::vector<TomlPoint> points = read_points(fields, "points", 2);
    if (points.size() < 2) return;
    for (std::size_t i = 1; i < points.size(); ++i)
      world_.walls.push_back({points[i - 1].point, points[i].point, material, one_sided, points[i].line});
    if (closed)
      world_.walls.push_back({points.back().point, points.front().point, material, one_sided, points.back().line});
  }

  /// A rectangle that stands on the floor, seen from outside.
  void add_box(TomlFields& fields, std::uint64_t line) {
    const sim::MaterialId material = material_of(fields);
    const std::optional<Vec2> centre = read_point(fields, "centre");
    const std::optional<Vec2> size = read_point(fields, "size");
    const Angle turn = fields.angle("turn").value_or(Angle{});
    if (!centre || !size) return;
    if (!(size->x > 0.0 && size->y > 0.0))
      fields.fail(fields.node("size"), "the box has no area", "write size = [0.8, 0.4], both above 0");
    const Vec2 half_x = size->x / 2.0 * unit(turn);
    const Vec2 half_y = size->y / 2.0 * perpendicular(unit(turn));
    const Vec2 corners[] = {*centre - half_x - half_y, *centre + half_x - half_y, *centre + half_x + half_y,
                            *centre - half_x + half_y};
    for (std::size_t i = 0; i < 4; ++i)
      world_.walls.push_back({corners[i], corners[(i + 1) % 4], material, false, line});
  }

  /// A row of vertical slats, each turned about its middle, to one side and the other in turn. The last is cut where
  /// the row ends.
  void add_slats(TomlFields& fields, std::uint64_t line) {
    const sim::MaterialId material = material_of(fields);
    const std::optional<Vec2> from = read_point(fields, "from");
    const std::optional<Vec2> to = read_point(fields, "to");
    const double width_m = required_length_m(fields, "width", 0.001, 1000.0);
    const double pitch_m = fields.length_m("pitch", 0.001, 1000.0).value_or(width_m);
    const Angle angle = fields.angle("angle").value_or(Angle{});
    if (!from || !to || !(width_m > 0.0) || !(pitch_m > 0.0)) return;
    const double row_m = norm(*to - *from);
    if (!(row_m > 1e-6)) fields.fail(fields.node("to"), "the row of slats has no length", "give two different ends");
    if (!(row_m / pitch_m <= static_cast<double>(max_objects))) {
      fields.fail(nullptr, "there are too many slats", fmt::format("at most {} are allowed", max_objects));
      return;
    }
    const Vec2 along = (*to - *from) / row_m;
    for (int k = 0; k * pitch_m < row_m - 1e-6; ++k) {
      const double length_m = std::min(width_m, row_m - k * pitch_m);
      const Vec2 middle = *from + (k * pitch_m + length_m / 2.0) * along;
      const Angle turned = bearing(along) + (k % 2 == 0 ? angle : -angle);
      const Vec2 half = length_m / 2.0 * unit(turned);
      world_.walls.push_back({middle - half, middle + half, material, false, line});
    }
  }

  void add_disc(TomlFields& fields, std::uint64_t line) {
    const sim::MaterialId material = material_of(fields);
    const std::optional<Vec2> centre = read_point(fields, "centre");
    const double radius_m = required_length_m(fields, "radius", 0.001, farthest_m);
    if (centre) world_.discs.push_back({*centre, radius_m, material, line});
  }

  void add_curve(TomlFields& fields, std::uint64_t line) {
    const sim::MaterialId material = material_of(fields);
    world_.curves.push_back({read_curve(fields), material, line});
    curve_samples_ += world_.curves.back().points.size();
  }

  void add_moving(TomlFields& fields, std::uint64_t line) {
    sim::MovingDisc disc{.material = material_of(fields), .line = line};
    disc.radius_m = fields.length_m("radius", 0.001, 100.0).value_or(disc.radius_m);
    const bool given = fields.has("path");
    const toml::array* path = fields.array("path");
    if (!given || (path != nullptr && path->empty()))
      fields.fail(path, "the moving disc has no path", "write path = [[0, 1.0, 2.0], [5, 3.0, 2.0]]: time, x, y");
    if (path == nullptr) return;
    for (const toml::node& element : *path) {
      const auto station =
          toml_numbers(fields, element, 3, "a station of path", "[2.5, 1.0, 3.0]: time in s, x and y in metres");
      if (!station) return;
      if (!disc.path.empty() && (*station)[0] <= disc.path.back().time_s)
        fields.fail(&element, "the times of path do not grow", "give every station a later time than the one before");
      disc.path.push_back({(*station)[0], {(*station)[1], (*station)[2]}});
    }
    world_.moving.push_back(std::move(disc));
  }

  TomlFields& scene_;
  sim::WorldDescription world_;
  std::size_t curve_samples_ = 0;
};

}  // namespace

sim::WorldDescription read_world(TomlFields& scene) {
  return WorldReader(scene).read();
}

}  // namespace echoarc::io
