// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/log_input.hpp"
#include "cli/map_settings.hpp"
#include "cli/published_times.hpp"
#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/verb.hpp"
#include "echoarc/eval/timing.hpp"
#include "echoarc/pipeline/pipeline.hpp"
#include "host/clocks.hpp"
#include "host/thread_pool.hpp"

namespace echoarc::cli {
namespace {

using Json = nlohmann::ordered_json;

struct BenchArguments {
  LogArguments input;
  SettingArguments settings{.methods = {"all"}, .settings = {}, .config = {}};
  std::size_t runs = 5;
  bool json = false;
};

struct MethodTiming {
  std::string name;
  TimingSummary time;
};

/// Every run maps the whole log with all methods, so that what else the machine does falls on all of them alike.
Result<std::vector<MethodTiming>> measure(const Log& log, const MapSettings& settings, const SensingOptions& sensing,
                                          std::size_t runs) {
  std::vector<std::vector<Timing>> timings(settings.methods.size());
  for (std::size_t run = 0; run < runs; ++run) {
    Result<std::vector<AnyMethod>> methods = make_methods(settings);
    if (!methods) return methods.error();
    host::ThreadPool one_thread(1);
    const LogRun result = run_log(log, sensing, *methods, one_thread, {.thread_cpu_s = &host::thread_cpu_time_s});
    if (result.report.accepted() == 0)
      return Error{ErrorCode::bad_value, "none of its pings can be mapped", log.source,
                   "ask `echoarc doctor` for the reasons"};
    for (std::size_t k = 0; k < timings.size(); ++k)
      timings[k].push_back({result.costs[k].insert_cpu_s, result.costs[k].finish_cpu_s, result.report.accepted()});
  }
  std::vector<MethodTiming> measured;
  for (std::size_t k = 0; k < timings.size(); ++k) measured.push_back({settings.methods[k], summarise(timings[k])});
  return measured;
}

std::string microseconds(double seconds) {
  return fmt::format("{:.2f} us", 1e6 * seconds);
}

void print_table(const Log& log, const std::vector<MethodTiming>& measured) {
  Table table({"method", "per ping", "paper, per arc", "in all", "readings", "map"});
  for (const auto& [name, time] : measured) {
    const std::optional<double> published = published_cpu_s(name);
    table.add({name, microseconds(time.per_reading_s), published ? microseconds(*published) : "-",
               fmt::format("{:.1f} ms", 1e3 * time.total_cpu_s), fmt::format("{:.1f} ms", 1e3 * time.insert_cpu_s),
               fmt::format("{:.1f} ms", 1e3 * time.finish_cpu_s)});
  }
  fmt::print("{}: {}, CPU time on one thread, medians of {}; reading the file left out\n\n{}", log.source,
             counted(measured.front().time.readings, "ping"), counted(measured.front().time.runs, "run"), table.text());
  fmt::print("\nPaper: [Barshan07] Table 7, 738 arcs, 1 cm cells, C on a 3 GHz Pentium 4, reading files included.\n");
}

void print_json(const Log& log, const std::vector<MethodTiming>& measured) {
  Json methods = Json::array();
  for (const auto& [name, time] : measured) {
    const std::optional<double> published = published_cpu_s(name);
    methods.push_back({{"name", name},
                       {"per_ping_s", time.per_reading_s},
                       {"paper_per_arc_s", published ? Json(*published) : Json(nullptr)},
                       {"total_cpu_s", time.total_cpu_s},
                       {"insert_cpu_s", time.insert_cpu_s},
                       {"finish_cpu_s", time.finish_cpu_s}});
  }
  const Json json{{"log", log.source},
                  {"pings", measured.front().time.readings},
                  {"runs", measured.front().time.runs},
                  {"methods", std::move(methods)}};
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

Result<ExitStatus> bench(const BenchArguments& arguments, const MapSettings& settings) {
  const Result<SensingOptions> sensing = make_options<SensingOptions>(settings.sensing);
  if (!sensing) return sensing.error();
  const Result<Log> log = load_log(arguments.input);
  if (!log) return log.error();
  warn_of(log->report);
  const Result<std::vector<MethodTiming>> measured = measure(*log, settings, *sensing, arguments.runs);
  if (!measured) return measured.error();
  if (arguments.json) {
    print_json(*log, *measured);
  } else {
    print_table(*log, *measured);
  }
  return done;
}

ExitStatus run(const BenchArguments& arguments) {
  const auto settings = resolve_settings(arguments.settings);
  if (const auto* fault = std::get_if<SettingFault>(&settings))
    return fault->command_line ? misuse(fault->error) : fail(fault->error);
  const Result<ExitStatus> status = bench(arguments, std::get<MapSettings>(settings));
  return status ? *status : fail(status.error());
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<BenchArguments>();
  declare_log(app, arguments->input);
  declare_settings(app, arguments->settings);
  app.add_option("--runs", arguments->runs, "how often the log is mapped; times are medians of the runs")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("--json", arguments->json, "print JSON");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb bench_verb() {
  return {"bench",
          "what each method costs on a log, beside its paper",
          {{"echoarc bench room.jsonl", "CPU time per ping of every method"},
           {"echoarc bench room.jsonl --method vt,dm --runs 20", "of some, measured more often"},
           {"echoarc bench room.jsonl --json", "for programs"}},
          &declare};
}

}  // namespace echoarc::cli
