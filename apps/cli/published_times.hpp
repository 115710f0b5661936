// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string_view>

namespace echoarc::cli {

/// CPU seconds per arc that a paper gives for a method of ours; none where it gives no figure.
///
/// [Barshan07] Table 7, room (a): t_CPU of the whole map, over the 738 arcs it was made of. Written in C, run on a
/// Pentium 4 of 3.00 GHz; "most of the CPU time is consumed by file operations" (4.3).
[[nodiscard]] std::optional<double> published_cpu_s(std::string_view method);

}  // namespace echoarc::cli
