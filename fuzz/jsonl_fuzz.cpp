// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "check_log.hpp"
#include "echoarc/io/jsonl.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace echoarc::io;
  MemorySource source(std::string_view(reinterpret_cast<const char*>(data), size), "log.jsonl");
  check_log(read_jsonl(source));
  return 0;
}
