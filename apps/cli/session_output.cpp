// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/session_output.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "cli/map_output.hpp"
#include "cli/report.hpp"
#include "echoarc/io/method_output.hpp"
#include "echoarc/io/run_report.hpp"

namespace echoarc::cli {
namespace {

std::size_t count_cells(const MapExport& map, CellState wanted) {
  return static_cast<std::size_t>(std::ranges::count(map.states.values(), wanted));
}

io::RunReport report_of(const live::Mapper& mapper) {
  io::RunReport report{.version = ECHOARC_VERSION, .command = "echoarc serve", .inputs = {}};
  count_pings(mapper.report(), report);
  return report;
}

io::MethodReport method_report(const live::RunningMethod& method, const MapExport& map) {
  return {.name = method.id(),
          .method = method.choice.name,
          .options = method.options,
          .counters = method.counters,
          .tallies = {},
          .points = map.points.size(),
          .cells_free = count_cells(map, CellState::free),
          .cells_occupied = count_cells(map, CellState::occupied)};
}

}  // namespace

std::string session_report(const live::Mapper& mapper) {
  io::RunReport report = report_of(mapper);
  for (const live::RunningMethod& method : mapper.methods())
    if (method.map) report.methods.push_back(method_report(method, *method.map));
  return io::run_report_json(report);
}

Result<void> write_session_maps(const std::filesystem::path& folder, const live::Mapper& mapper) {
  std::vector<Vec2> path;
  for (const Odometry& pose : mapper.path()) path.push_back(pose.T_world_robot.position);
  io::RunReport report = report_of(mapper);
  for (const live::RunningMethod& method : mapper.methods()) {
    const Result<MapExport> map = mapper.final_map(method.id());
    if (!map) {
      warn(fmt::format("{}: {}", method.id(), map.error().message));
      continue;
    }
    const std::string title = fmt::format("{}: {}", folder.filename().string(), find_method(method.choice.name)->title);
    if (const Result<void> written =
            io::write_method_output(folder / method.id(), *map, {.title = title, .path = path});
        !written)
      return written;
    report.methods.push_back(method_report(method, *map));
  }
  if (const Result<void> written = io::write_run_report(folder, report); !written) return written;
  fmt::print("saved {} of {} in {}\n", counted(report.methods.size(), "map"), counted(mapper.report().pings, "ping"),
             folder.string());
  return {};
}

}  // namespace echoarc::cli
