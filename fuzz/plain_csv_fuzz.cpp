// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "check_log.hpp"
#include "echoarc/io/plain_csv.hpp"

/// The input is the ranges, and behind a line "%%" the odometry, if there is one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace echoarc;
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  constexpr std::string_view separator = "\n%%\n";
  const std::size_t end = std::min(input.find(separator), input.size());
  const std::string_view poses = input.substr(std::min(end + separator.size(), input.size()));
  const auto open = [&](const std::string& file) -> Result<std::unique_ptr<io::ByteSource>> {
    return std::unique_ptr<io::ByteSource>(new io::MemorySource(file == "poses" ? poses : input.substr(0, end), file));
  };
  const std::optional<std::string> odometry = poses.empty() ? std::nullopt : std::optional<std::string>("poses");
  io::check_log(io::read_plain_csv("ranges", odometry, RobotDescription{}, open));
  return 0;
}
