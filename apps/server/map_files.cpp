// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/map_files.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "echoarc/io/method_output.hpp"
#include "server/scratch_folder.hpp"

namespace echoarc::server {
Result<std::string> map_file(const MapExport& map, const std::string& method, std::string_view kind,
                             const std::vector<Vec2>& path) {
  const ScratchFolder folder;
  if (folder.path().empty())
    return Error{ErrorCode::unwritable, "no temporary folder can be made", "", "free some space in the system's"};
  const io::MethodPicture picture{.title = method, .path = path};
  const std::filesystem::path files = folder.path() / "map";
  if (const Result<void> written = io::write_method_output(files, map, picture); !written) return written.error();
  const std::string name = kind == "csv" ? "points.csv" : "map." + std::string(kind);
  const std::ifstream file(files / name, std::ios::binary);
  if (!file) return Error{ErrorCode::not_found, "the map is empty", "", "wait for the first echoes"};
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return std::move(bytes).str();
}

}  // namespace echoarc::server
