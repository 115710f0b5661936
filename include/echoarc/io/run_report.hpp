// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc::io {

/// 64-bit FNV-1a, fed in pieces: tells files apart, does not withstand an adversary. Offset and prime are those of
/// draft-eastlake-fnv.
class Fnv1a64 {
 public:
  void add(std::string_view bytes) {
    for (const char c : bytes) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

/// A file that went into a run.
struct InputFile {
  std::string path;  ///< as the user gave it
  std::uint64_t bytes = 0;
  std::uint64_t fnv1a64 = 0;
};
/// Reads the file once, in pieces.
[[nodiscard]] Result<InputFile> describe_input(const std::filesystem::path& path);

/// One method's share of a run.
struct MethodReport {
  std::string name;         ///< of its folder
  std::string method = {};  ///< in the catalogue; empty: that is its name, too
  OptionMap options;        ///< in full, defaults included
  InsertCounters counters;
  std::vector<Tally> tallies;  ///< counts that only this method keeps
  std::size_t points = 0;
  std::size_t cells_free = 0;
  std::size_t cells_occupied = 0;
};

/// Everything that decides what a run computes and what became of its input. Neither times nor thread counts are in
/// here, so that the same run gives the same bytes.
struct RunReport {
  std::string version;            ///< of echoarc
  std::string command;            ///< as typed
  std::vector<InputFile> inputs;  ///< log, description, robot, config: in the order in which they were read
  std::uint64_t seed = 0;
  bool interrupted = false;                       ///< the input was not read to its end
  OptionMap sensing;                              ///< options of the cleaning stage, in full
  std::map<std::string, std::uint64_t> pings;     ///< counters of outcomes ("echo", "no_echo", ...)
  std::map<std::string, std::uint64_t> rejected;  ///< counter of every rejection reason by name, zeros included
  std::vector<std::string> notes;                 ///< what was decided on the way ("5.11 m is no echo")
  std::vector<MethodReport> methods;
};

/// Name under which a report lies in its folder, and the marker by which echoarc knows its own output again.
inline constexpr std::string_view run_report_name = "run.json";
inline constexpr std::string_view timings_name = "timings.json";

/// The report as JSON text, keys in a fixed order, ending with a newline.
[[nodiscard]] std::string run_report_json(const RunReport& report);
[[nodiscard]] Result<void> write_run_report(const std::filesystem::path& directory, const RunReport& report);

/// How long a run took: names as "read", "map", "dm.cpu", and the number of threads.
struct Timings {
  std::size_t threads = 1;
  std::vector<std::pair<std::string, double>> seconds;
};
[[nodiscard]] Result<void> write_timings(const std::filesystem::path& directory, const Timings& timings);

}  // namespace echoarc::io
