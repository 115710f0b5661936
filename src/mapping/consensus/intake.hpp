// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "echoarc/core/reading.hpp"
#include "echoarc/mapping/method.hpp"
#include "mapping/consensus/arc_table.hpp"

namespace echoarc::consensus {

/// The reading as step A takes it; counts why it does not.
[[nodiscard]] std::optional<EchoArc> echo_of(const Reading& reading, const ConsensusOptions& options,
                                             InsertCounters& counters);

}  // namespace echoarc::consensus
