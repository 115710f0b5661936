// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "check_log.hpp"
#include "echoarc/io/delimited.hpp"

/// The input is a description, a line "%%", and the rows that every table of the description reads.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace echoarc;
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  constexpr std::string_view separator = "\n%%\n";
  const std::size_t end = std::min(input.find(separator), input.size());
  const std::string_view rows = input.substr(std::min(end + separator.size(), input.size()));
  const Result<io::DelimitedDescription> description = io::parse_description(input.substr(0, end), "description.toml");
  if (!description) {
    io::check_log(description.error());
    return 0;
  }
  const auto open = [&](const std::string& file) -> Result<std::unique_ptr<io::ByteSource>> {
    return std::unique_ptr<io::ByteSource>(new io::MemorySource(rows, "table " + file));
  };
  io::check_log(io::read_delimited(*description, open));
  return 0;
}
