// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace echoarc::host {

/// Seconds of processor time this process has used, all its threads together.
[[nodiscard]] double process_cpu_time_s();
/// Seconds of processor time the calling thread has used.
[[nodiscard]] double thread_cpu_time_s();
/// Seconds since an arbitrary start; never goes back.
[[nodiscard]] double wall_time_s();

}  // namespace echoarc::host
