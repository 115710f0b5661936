// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "echoarc/live/inquiry.hpp"
#include "echoarc/live/mapper.hpp"
#include "echoarc/live/scores.hpp"
#include "server/client_message.hpp"

/// Messages about the maps, as schema/messages.schema.json has them.
namespace echoarc::server {

[[nodiscard]] std::string methods_message(const live::Mapper& mapper);
[[nodiscard]] std::string recompute_message(const live::RunningMethod& method);
[[nodiscard]] std::string scores_message(const live::Scores& scores);
/// `counters` without its end: `"dropped":` is last, the viewer's number and "}" follow. `log`: its field as JSON.
[[nodiscard]] std::string counters_message(const live::Mapper& mapper, const std::string& log);
/// The bins from the first that differs.
[[nodiscard]] std::string timeline_message(std::span<const live::TimelineBin> before,
                                           std::span<const live::TimelineBin> now);
[[nodiscard]] std::string history_message(const live::Mapper& mapper, const live::ScoreKeeper& scores);
/// `slot`: that was asked about; none: a place was.
[[nodiscard]] std::string explanation_message(MessageId id, std::optional<std::uint32_t> slot,
                                              const live::Explanation& explanation);
/// `true_pose`: of the robot when the ping was fired, where it is known.
[[nodiscard]] std::string stepped_message(MessageId id, const live::Step& step, double temperature_k);

}  // namespace echoarc::server
