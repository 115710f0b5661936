// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/map_summary.hpp"

#include <fmt/format.h>

#include "cli/report.hpp"
#include "cli/table.hpp"
#include "echoarc/sensing/diagnosis.hpp"

namespace echoarc::cli {
namespace {

void print_rejected(const RejectionCounters& counters, std::string_view kind) {
  for (const RejectionInfo& reason : rejections())
    if (counters[reason.reason].count > 0)
      fmt::print("    {}\n", describe(reason.reason, counters[reason.reason], kind));
}

std::string per_ping(const MethodCost& cost, std::uint64_t pings) {
  if (pings == 0) return "-";
  return fmt::format("{:.2f} us", 1e6 * (cost.insert_cpu_s + cost.finish_cpu_s) / static_cast<double>(pings));
}

/// "  carve: 412 removed_full, 96 removed_split"; nothing for a method without counts of its own.
void print_tallies(const io::MethodReport& report) {
  std::string counts;
  for (const Tally& tally : report.tallies)
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", tally.count, tally.name);
  if (!counts.empty()) fmt::print("  {}: {}\n", report.name, counts);
}

}  // namespace

void print_pings(const Log& log, const SensingReport& sensing) {
  fmt::print("{}: {} of {}, {}\n", log.source, counted(sensing.pings, "ping"),
             counted(sensing.sensors.size(), "sensor"), counted(sensing.odometry, "pose"));
  for (const std::string& note : no_echo_sentences(sensing.no_echo)) fmt::print("  {}\n", note);
  fmt::print("  accepted {}: {} echo, {} no echo, {} too close\n", sensing.accepted(), sensing.echoes,
             sensing.no_echoes, sensing.too_close);
  if (sensing.polls.polls > 0)
    fmt::print("  {} made of {}: {} unusable, {} out of step, {} late\n", counted(sensing.pings, "ping"),
               counted(sensing.polls.polls, "poll"), sensing.polls.bad_polls, sensing.polls.anomalies,
               sensing.polls.late_echoes);
  if (sensing.scans > 0)
    fmt::print("  {} shortened to what {} saw nearer\n", counted(sensing.laser_limited, "reading"),
               counted(sensing.scans, "laser scan"));
  fmt::print("  rejected {}\n", sensing.rejected_pings.total());
  print_rejected(sensing.rejected_pings, "ping");
  if (sensing.rejected_odometry.total() > 0) {
    fmt::print("  rejected poses {}\n", sensing.rejected_odometry.total());
    print_rejected(sensing.rejected_odometry, "odometry record");
  }
  if (sensing.rejected_scans.total() > 0) {
    fmt::print("  rejected laser scans {}\n", sensing.rejected_scans.total());
    print_rejected(sensing.rejected_scans, "laser scan");
  }
}

void print_maps(const MapRun& run, const std::vector<io::MethodReport>& reports, const std::filesystem::path& folder) {
  Table table({"method", "points", "occupied", "free", "CPU/ping"});
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const io::MethodReport& report = reports[k];
    table.add({report.name, std::to_string(report.points), std::to_string(report.cells_occupied),
               std::to_string(report.cells_free), per_ping(run.result.costs[k], run.result.report.accepted())});
  }
  fmt::print("\n{}", table.text());
  for (const io::MethodReport& report : reports) print_tallies(report);
  for (const std::string& line : run.features.summary()) fmt::print("  {}\n", line);
  for (const io::MethodReport& report : reports)
    if (report.counters.memory_limit > 0)
      fmt::print(
          "  {}: {} left out because the map reached its memory limit; allow more or use larger cells "
          "(--set {}.max_memory_mib=4096, --set {}.cell_m=0.1)\n",
          report.name, counted(report.counters.memory_limit, "ping"), report.name, report.name);
  fmt::print("\nscores and counters: {}\npictures:\n", (folder / io::run_report_name).string());
  for (const io::MethodReport& report : reports) fmt::print("  {}\n", (folder / report.name / "map.png").string());
}

}  // namespace echoarc::cli
