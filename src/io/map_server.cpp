// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/map_server.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include "io/files.hpp"
#include "io/gray_image.hpp"
#include "io/map_yaml.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t max_image_bytes = static_cast<std::size_t>(max_map_pixels) + (1U << 16);

char gray_of(CellState state) {
  constexpr std::array<unsigned char, 3> grays = {map_unknown, map_free, map_occupied};
  return static_cast<char>(grays[static_cast<std::size_t>(state)]);
}

std::string pgm_bytes(const DenseGrid<CellState>& grid) {
  std::string bytes = fmt::format("P5\n{} {}\n255\n", grid.width(), grid.height());
  bytes.reserve(bytes.size() + grid.values().size());
  for (std::int32_t j = grid.height() - 1; j >= 0; --j)
    for (const CellState state : grid.row(j)) bytes += gray_of(state);
  return bytes;
}

Result<DenseGrid<CellState>> decode(const MapYaml& yaml, std::string_view bytes, std::string_view image_name) {
  const Result<GrayImage> image = decode_gray_image(bytes, image_name);
  if (!image) return image.error();
  return states_of(*image, yaml);
}

}  // namespace

Result<void> write_map(const std::filesystem::path& directory, const DenseGrid<CellState>& grid) {
  // No picture format has an empty picture.
  if (grid.empty()) return write_map(directory, DenseGrid<CellState>(grid.geometry(), 1, 1));
  const MapYaml yaml{.image = "map.pgm", .resolution_m = grid.geometry().cell_m, .origin = grid.geometry().origin};
  if (const Result<void> written = write_file(directory / yaml.image, pgm_bytes(grid)); !written) return written;
  return write_file(directory / "map.yaml", map_yaml_text(yaml));
}

Result<DenseGrid<CellState>> read_map_yaml(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, max_description_bytes);
  if (!text) return text.error();
  const Result<MapYaml> yaml = parse_map_yaml(*text, path.string());
  if (!yaml) return yaml.error();
  const std::filesystem::path image_path = path.parent_path() / yaml->image;
  const Result<std::string> bytes = read_file(image_path, max_image_bytes);
  if (!bytes) return bytes.error();
  return decode(*yaml, *bytes, image_path.string());
}

Result<DenseGrid<CellState>> parse_map(std::string_view yaml, std::string_view image, std::string_view source) {
  const Result<MapYaml> description = parse_map_yaml(yaml, source);
  if (!description) return description.error();
  return decode(*description, image, description->image);
}

}  // namespace echoarc::io
