// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/report.hpp"

#include <cstdio>

#include <fmt/core.h>

namespace echoarc::cli {
namespace {

void print_error(const Error& error) {
  const std::string where = error.where.empty() ? "" : error.where + ": ";
  fmt::print(stderr, "echoarc: error: {}{}\n", where, error.message);
  if (!error.remedy.empty()) fmt::print(stderr, "echoarc: remedy: {}\n", error.remedy);
}

}  // namespace

ExitStatus fail(const Error& error) {
  print_error(error);
  return error.code == ErrorCode::interrupted ? interrupted : failed;
}

ExitStatus misuse(const Error& error) {
  print_error(error);
  return wrong_usage;
}

void warn(std::string_view message) {
  fmt::print(stderr, "echoarc: warning: {}\n", message);
}

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

}  // namespace echoarc::cli
