// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/study_host.hpp"

namespace echoarc::studies {

Error interrupted_study() {
  return {ErrorCode::interrupted, "interrupted before the study was complete", "", "run it again"};
}

void StudyProgress::step() {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (host_->progress && tasks_ > 0) host_->progress(double(done_) / double(tasks_));
}

}  // namespace echoarc::studies
