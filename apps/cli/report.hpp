// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

#include "cli/verb.hpp"
#include "echoarc/core/result.hpp"

namespace echoarc::cli {

/// One line of cause and one of remedy on stderr; returns `failed`, or `interrupted` for an interrupted job.
ExitStatus fail(const Error& error);
/// The same for a command line that cannot be meant; returns `wrong_usage`.
ExitStatus misuse(const Error& error);
/// One line on stderr that does not stop anything.
void warn(std::string_view message);

/// "1 ping", "2 pings".
[[nodiscard]] std::string counted(std::size_t count, std::string_view thing);

}  // namespace echoarc::cli
