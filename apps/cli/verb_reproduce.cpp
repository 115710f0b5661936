// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>

#include "cli/progress.hpp"
#include "cli/report.hpp"
#include "cli/table.hpp"
#include "cli/verb.hpp"
#include "echoarc/io/builtin.hpp"
#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/scene_toml.hpp"
#include "echoarc/studies/reproductions.hpp"
#include "host/clocks.hpp"
#include "host/interrupt.hpp"
#include "host/thread_pool.hpp"
#include "report/report_document.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;

struct ReproduceArguments {
  std::vector<std::string> papers;
  fs::path output = "reproductions";
  int seeds = 10;
  std::size_t threads = host::hardware_threads();
  bool json = false;
};

/// A scene that the program carries along.
Result<studies::StudyScene> carried_scene(std::string_view name) {
  const std::optional<std::string_view> text = io::builtin_scene(name);
  if (!text)
    return Error{ErrorCode::not_found, fmt::format("no scene is called {}", name), "",
                 "please report this as a defect"};
  Result<io::SceneFile> file = io::read_scene(*text, name);
  if (!file) return file.error();
  return studies::StudyScene{std::move(file->scene), file->scoring.value_or(SceneScoring{})};
}

/// In the order of the list, whatever the order of the command line, each once.
Result<std::vector<const studies::Reproduction*>> chosen_papers(const std::vector<std::string>& names) {
  std::string known;
  for (const studies::Reproduction& paper : studies::reproductions()) known += fmt::format("{}, ", paper.name);
  for (const std::string& name : names)
    if (name != "all" && studies::find_reproduction(name) == nullptr)
      return Error{ErrorCode::bad_value, fmt::format("{} is no paper that can be run again", name), "PAPER",
                   fmt::format("choose from {}all", known)};
  std::vector<const studies::Reproduction*> chosen;
  for (const studies::Reproduction& paper : studies::reproductions())
    if (std::ranges::any_of(names, [&](const std::string& name) { return name == "all" || name == paper.name; }))
      chosen.push_back(&paper);
  return chosen;
}

Result<report::ReportDocument> run_studies(const ReproduceArguments& arguments,
                                           const std::vector<const studies::Reproduction*>& papers) {
  host::ThreadPool pool(arguments.threads);
  report::ReportDocument document{.version = ECHOARC_VERSION, .command = "echoarc reproduce", .studies = {}};
  for (const studies::Reproduction* paper : papers) document.command += fmt::format(" {}", paper->name);
  document.command += fmt::format(" --seeds {}", arguments.seeds);
  for (const studies::Reproduction* paper : papers) {
    ProgressBar bar{std::string(paper->name)};
    const studies::StudyHost host{.executor = &pool,
                                  .scene = &carried_scene,
                                  .seeds = arguments.seeds,
                                  .progress = [&](double fraction) { bar.show(fraction); },
                                  .cancelled = &host::InterruptGuard::interrupted,
                                  .thread_cpu_s = &host::thread_cpu_time_s};
    Result<studies::StudyReport> study = paper->run(host);
    if (!study) return study.error();
    document.studies.push_back(std::move(*study));
  }
  return document;
}

Result<void> write_file(const fs::path& path, const std::string& text) {
  const Result<std::unique_ptr<io::FileSink>> sink = io::FileSink::create(path);
  if (!sink) return sink.error();
  if (Result<void> written = (*sink)->write(text); !written) return written;
  return (*sink)->commit();
}

Result<void> write_report(const fs::path& folder, const report::ReportDocument& document) {
  const Result<std::string> page = report::html_page(document);
  if (!page) return page.error();
  if (Result<void> written = write_file(folder / "report.html", *page); !written) return written;
  return write_file(folder / "report.json", report::json_report(document));
}

void print_summary(const report::ReportDocument& document, const fs::path& folder) {
  Table table({"paper", "claims", "hold", "do not", "open"});
  for (const studies::StudyReport& study : document.studies) {
    std::size_t holds = 0;
    std::size_t fails = 0;
    std::size_t open = 0;
    for (const studies::StudySection& section : study.sections)
      for (const studies::Claim& claim : section.claims)
        ++(claim.verdict == studies::Verdict::holds ? holds : claim.verdict == studies::Verdict::fails ? fails : open);
    table.add({study.name, std::to_string(holds + fails + open), std::to_string(holds), std::to_string(fails),
               std::to_string(open)});
  }
  fmt::print("{}\nThe report: {}\n", table.text(), (folder / "report.html").string());
}

Result<ExitStatus> reproduce(const ReproduceArguments& arguments,
                             const std::vector<const studies::Reproduction*>& papers) {
  std::error_code fault;
  fs::create_directories(arguments.output, fault);
  if (fault)
    return Error{ErrorCode::unwritable, fault.message(), arguments.output.string(), "choose another folder with -o"};
  const host::InterruptGuard guard;
  const Result<report::ReportDocument> document = run_studies(arguments, papers);
  if (!document) return document.error();
  if (const Result<void> written = write_report(arguments.output, *document); !written) return written.error();
  if (arguments.json)
    fmt::print("{}", report::json_report(*document));
  else
    print_summary(*document, arguments.output);
  return done;
}

ExitStatus run(const ReproduceArguments& arguments) {
  const Result<std::vector<const studies::Reproduction*>> papers = chosen_papers(arguments.papers);
  if (!papers) return misuse(papers.error());
  const Result<ExitStatus> status = reproduce(arguments, *papers);
  return status ? *status : fail(status.error());
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<ReproduceArguments>();
  std::string papers = "all";
  for (const studies::Reproduction& paper : studies::reproductions())
    papers += fmt::format(", {}: {}", paper.name, paper.summary);
  app.add_option("PAPER", arguments->papers, papers)->required()->type_name("NAME");
  app.add_option("-o,--output", arguments->output, "folder for report.html and report.json")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--seeds", arguments->seeds, "how often every scene is simulated; the spread is over them")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--threads", arguments->threads, "how many threads work; nothing but times depends on it")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("--json", arguments->json, "print report.json, too");
  return [arguments] { return run(*arguments); };
}

}  // namespace

Verb reproduce_verb() {
  return {"reproduce",
          "a paper's experiments on simulated scenes, its figures beside ours",
          {{"echoarc reproduce yamauchi --seeds 1", "one paper, quickly; the report is in ./reproductions"},
           {"echoarc reproduce choset2003 numakura --seeds 2 -o two", "two papers, into a folder of your choice"},
           {"echoarc reproduce all -o reproductions", "every paper over ten seeds: a few minutes"}},
          &declare};
}

}  // namespace echoarc::cli
