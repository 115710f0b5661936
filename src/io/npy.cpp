// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/npy.hpp"

#include <bit>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "io/files.hpp"

namespace echoarc::io {
namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");

/// The header of NumPy's format 1.0: magic, version, length of the dictionary, dictionary padded with spaces so that
/// the values start at a multiple of 64 bytes, newline.
std::string npy_header(std::string_view type, std::int32_t width, std::int32_t height) {
  constexpr std::size_t before_dictionary = 10;
  std::string dictionary =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}), }}", type, height, width);
  const std::size_t unpadded = before_dictionary + dictionary.size() + 1;
  dictionary.append((64 - unpadded % 64) % 64, ' ');
  dictionary += '\n';
  std::string header = "\x93NUMPY";
  header += '\x01';
  header += '\x00';
  header += static_cast<char>(dictionary.size() & 0xff);
  header += static_cast<char>(dictionary.size() >> 8);
  return header + dictionary;
}

template <class T>
Result<void> write_array(const std::filesystem::path& path, const DenseGrid<T>& grid, std::string_view type) {
  const auto values = std::as_bytes(grid.values());
  return write_file(path, {npy_header(type, grid.width(), grid.height()),
                           {reinterpret_cast<const char*>(values.data()), values.size()}});
}

}  // namespace

Result<void> write_npy(const std::filesystem::path& path, const DenseGrid<float>& grid) {
  return write_array(path, grid, "<f4");
}

Result<void> write_npy(const std::filesystem::path& path, const DenseGrid<std::uint16_t>& grid) {
  return write_array(path, grid, "<u2");
}

Result<void> write_grid_json(const std::filesystem::path& path, const GridGeometry& geometry, std::int32_t width,
                             std::int32_t height) {
  const nlohmann::ordered_json json = {{"cell_m", geometry.cell_m},
                                       {"origin", {geometry.origin.x, geometry.origin.y}},
                                       {"width", width},
                                       {"height", height}};
  return write_file(path, json.dump(2) + "\n");
}

}  // namespace echoarc::io
