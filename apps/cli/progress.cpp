// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <fmt/core.h>
#include <unistd.h>

namespace echoarc::cli {

ProgressBar::ProgressBar(std::string label) : label_(std::move(label)), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (percent_ < 0) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

void ProgressBar::show(double fraction) {
  if (!terminal_) return;
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (percent == percent_) return;
  percent_ = percent;
  constexpr int width = 40;
  const std::string filled(static_cast<std::size_t>(percent * width / 100), '#');
  fmt::print(stderr, "\r{} [{:<{}}] {:3} %", label_, filled, width, percent);
  std::fflush(stderr);
}

}  // namespace echoarc::cli
