// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/run_report.hpp"

#include <array>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "echoarc/io/byte_source.hpp"
#include "io/files.hpp"
#include "io/option_json.hpp"

namespace echoarc::io {
namespace {

using Json = nlohmann::ordered_json;

/// JSON is UTF-8; bytes of a path or a command line that are not become U+FFFD.
std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json counters_json(const InsertCounters& counters) {
  return {{"used", counters.used},
          {"no_information", counters.no_information},
          {"no_arc", counters.no_arc},
          {"bistatic", counters.bistatic},
          {"passed_over", counters.passed_over},
          {"memory_limit", counters.memory_limit}};
}

Json tallies_json(const std::vector<Tally>& tallies) {
  Json json = Json::object();
  for (const Tally& tally : tallies) json[std::string(tally.name)] = tally.count;
  return json;
}

Json method_json(const MethodReport& method) {
  Json json = {{"name", method.name}};
  if (!method.method.empty() && method.method != method.name) json["method"] = method.method;
  json["options"] = to_json(method.options);
  json["counters"] = counters_json(method.counters);
  json["points"] = method.points;
  json["cells"] = {{"free", method.cells_free}, {"occupied", method.cells_occupied}};
  if (!method.tallies.empty()) json["tallies"] = tallies_json(method.tallies);
  return json;
}

Json input_json(const InputFile& input) {
  return {{"path", input.path}, {"bytes", input.bytes}, {"fnv1a64", fmt::format("{:016x}", input.fnv1a64)}};
}

template <class Value, class Convert>
Json list_json(const std::vector<Value>& values, const Convert& convert) {
  Json list = Json::array();
  for (const Value& value : values) list.push_back(convert(value));
  return list;
}

}  // namespace

Result<InputFile> describe_input(const std::filesystem::path& path) {
  const Result<std::unique_ptr<ByteSource>> source = FileSource::open(path);
  if (!source) return source.error();
  InputFile input{path.string(), 0, 0};
  Fnv1a64 hash;
  std::array<char, 1 << 16> chunk{};
  while (true) {
    const Result<std::size_t> count = (*source)->read(chunk);
    if (!count) return count.error();
    if (*count == 0) break;
    hash.add({chunk.data(), *count});
    input.bytes += *count;
  }
  input.fnv1a64 = hash.value();
  return input;
}

std::string run_report_json(const RunReport& report) {
  const Json json = {{"written_by", "echoarc"},
                     {"version", report.version},
                     {"command", report.command},
                     {"inputs", list_json(report.inputs, input_json)},
                     {"seed", report.seed},
                     {"interrupted", report.interrupted},
                     {"sensing", to_json(report.sensing)},
                     {"pings", report.pings},
                     {"rejected", report.rejected},
                     {"notes", report.notes},
                     {"methods", list_json(report.methods, method_json)}};
  return dump(json);
}

Result<void> write_run_report(const std::filesystem::path& directory, const RunReport& report) {
  return write_file(directory / run_report_name, run_report_json(report));
}

Result<void> write_timings(const std::filesystem::path& directory, const Timings& timings) {
  Json seconds = Json::object();
  for (const auto& [name, value] : timings.seconds) seconds[name] = value;
  return write_file(directory / timings_name, dump({{"threads", timings.threads}, {"seconds", seconds}}));
}

}  // namespace echoarc::io
