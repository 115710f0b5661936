// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace echoarc::cli {

/// A bar on stderr, drawn only where stderr is a terminal; wiped when it goes out of scope.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Redraws when a whole percent was gained.
  /// \param fraction 0 to 1
  void show(double fraction);

 private:
  std::string label_;
  bool terminal_;
  int percent_ = -1;
};

}  // namespace echoarc::cli
