// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/method_output.hpp"

#include <algorithm>
#include <system_error>
#include <variant>

#include "echoarc/io/map_server.hpp"
#include "echoarc/io/npy.hpp"
#include "echoarc/io/picture.hpp"
#include "echoarc/io/points_csv.hpp"
#include "io/files.hpp"

namespace echoarc::io {
namespace {

bool clears_space(const DenseGrid<CellState>& states) {
  return std::ranges::find(states.values(), CellState::free) != states.values().end();
}

/// A method that clears space shows its walls as cells. One that only marks has single small cells among nothing known:
/// its points are drawn instead.
Result<void> write_map_picture(const std::filesystem::path& path, const MapExport& map, const MethodPicture& picture) {
  PictureContent content;
  content.title = picture.title;
  content.path = picture.path;
  content.features = picture.features;
  if (clears_space(map.states)) {
    content.states = &map.states;
    content.probability = picture.probability;
  } else {
    content.points = map.points.points();
  }
  const bool nothing = content.states == nullptr && content.points.empty() && content.path.empty();
  return nothing ? Result<void>{} : write_picture(path, content);
}

/// Writes the cell values of whichever type the method has.
struct WriteValues {
  const std::filesystem::path& directory;

  Result<void> operator()(std::monostate) const { return {}; }
  template <class T>
  Result<void> operator()(const DenseGrid<T>& grid) const {
    if (const Result<void> written = write_npy(directory / "grid.npy", grid); !written) return written;
    return write_grid_json(directory / "grid.json", grid.geometry(), grid.width(), grid.height());
  }
};

}  // namespace

Result<void> write_method_output(const std::filesystem::path& directory, const MapExport& map,
                                 const MethodPicture& picture) {
  std::error_code code;
  std::filesystem::create_directories(directory, code);
  if (code) return unwritable(directory, code.message());
  if (const Result<void> written = write_map(directory, map.states); !written) return written;
  if (const Result<void> written = write_points_csv(directory / "points.csv", map.points); !written) return written;
  if (!map.points.segments().empty())
    if (const Result<void> written = write_segments_csv(directory / "segments.csv", map.points); !written)
      return written;
  if (const Result<void> written = std::visit(WriteValues{directory}, map.values); !written) return written;
  return write_map_picture(directory / "map.png", map, picture);
}

}  // namespace echoarc::io
