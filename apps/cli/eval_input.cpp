// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/eval_input.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "echoarc/io/map_server.hpp"
#include "echoarc/io/positions_csv.hpp"
#include "echoarc/mapping/catalog.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;

bool is_map_file(const fs::path& path) {
  return path.extension() == ".yaml" || path.extension() == ".yml";
}

Result<PointSet> load_occupied(const fs::path& map_yaml) {
  const Result<DenseGrid<CellState>> grid = io::read_map_yaml(map_yaml);
  if (!grid) return grid.error();
  return PointSet::of_occupied(*grid);
}

/// A folder with grid.json belongs to a method of cells; its points.csv only repeats them.
bool has_exact_points(const fs::path& folder) {
  return fs::exists(folder / "points.csv") && !fs::exists(folder / "grid.json");
}

Result<PointSet> load_points(const fs::path& points_csv) {
  Result<std::vector<Vec2>> points = io::read_positions_csv(points_csv);
  if (!points) return points.error();
  return PointSet::make(std::move(*points));
}

std::string name_of(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

/// Methods in the order of the catalogue, everything else after them.
std::size_t catalogue_place(const fs::path& folder) {
  const std::string name = name_of(folder);
  return static_cast<std::size_t>(std::ranges::find(catalog(), name, &MethodEntry::name) - catalog().begin());
}

std::vector<fs::path> method_folders(const fs::path& folder) {
  if (fs::exists(folder / "map.yaml")) return {folder};
  std::vector<fs::path> folders;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (fs::exists(entry.path() / "map.yaml")) folders.push_back(entry.path());
  std::ranges::sort(folders, {}, [](const fs::path& path) { return std::pair(catalogue_place(path), path); });
  return folders;
}

Result<NamedMap> load_method(const fs::path& folder) {
  Result<PointSet> cells = load_occupied(folder / "map.yaml");
  if (!cells) return cells.error();
  if (!has_exact_points(folder)) return NamedMap{name_of(folder), std::move(*cells), std::nullopt};
  Result<PointSet> points = load_points(folder / "points.csv");
  if (!points) return points.error();
  return NamedMap{name_of(folder), std::move(*points), std::move(*cells)};
}

Result<std::vector<NamedMap>> one_map(std::string name, Result<PointSet> points) {
  if (!points) return points.error();
  return std::vector<NamedMap>{{std::move(name), std::move(*points), std::nullopt}};
}

}  // namespace

Result<std::vector<NamedMap>> load_maps(const fs::path& path) {
  if (!fs::exists(path))
    return Error{ErrorCode::not_found, "there is no such map", path.string(), "make one with `echoarc map LOG -o DIR`"};
  if (!fs::is_directory(path)) return one_map(path.stem().string(), load_occupied(path));
  std::vector<NamedMap> maps;
  for (const fs::path& folder : method_folders(path)) {
    Result<NamedMap> map = load_method(folder);
    if (!map) return map.error();
    maps.push_back(std::move(*map));
  }
  if (maps.empty())
    return Error{ErrorCode::not_found, "no map.yaml in this folder or one below it", path.string(),
                 "give a folder that `echoarc map` wrote, or a map.yaml"};
  return maps;
}

Result<Reference> load_reference(const LogArguments& arguments) {
  const fs::path& path = arguments.log;
  const fs::path map_yaml = fs::is_directory(path) ? path / "map.yaml" : path;
  if (is_map_file(map_yaml) && fs::exists(map_yaml)) {
    const Result<DenseGrid<CellState>> grid = io::read_map_yaml(map_yaml);
    if (!grid) return grid.error();
    return map_reference(*grid, path.string());
  }
  if (path.extension() == ".csv" && arguments.description.empty()) {
    const Result<std::vector<Polyline>> polylines = io::read_polylines_csv(path);
    if (!polylines) return polylines.error();
    return polyline_reference(*polylines, path.string());
  }
  const Result<Log> log = load_log(arguments);
  if (!log) return log.error();
  warn_of(log->report);
  return laser_reference(*log);
}

Result<Angle> parse_direction(const std::string& text) {
  constexpr std::string_view prefix = "axis:";
  double value = 0.0;
  const char* begin = text.data() + std::min(prefix.size(), text.size());
  const auto [end, code] = std::from_chars(begin, text.data() + text.size(), value);
  if (!text.starts_with(prefix) || code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return Error{ErrorCode::bad_value, fmt::format("{} is no direction of interest", text), "--doi",
                 "write axis:90, the direction in degrees counter-clockwise from +x"};
  return degrees(value);
}

Result<PointSet> load_path(const fs::path& maps, const fs::path& given) {
  fs::path file = given;
  const fs::path folder = fs::is_directory(maps) ? maps : maps.parent_path();
  for (const fs::path& candidate : {folder / io::path_csv_name, folder / ".." / io::path_csv_name})
    if (file.empty() && fs::exists(candidate)) file = candidate;
  if (file.empty()) return PointSet{};
  Result<std::vector<Vec2>> positions = io::read_positions_csv(file);
  if (!positions) return positions.error();
  return PointSet::make(std::move(*positions));
}

}  // namespace echoarc::cli
