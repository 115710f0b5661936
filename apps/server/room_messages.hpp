// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <set>
#include <string>

#include "echoarc/core/result.hpp"
#include "server/room.hpp"

/// Messages about the robot and those who watch it, as schema/messages.schema.json has them.
namespace echoarc::server {

/// What all rooms of a server share.
struct ServerFacts {
  std::string version;
  std::string session;
  std::vector<std::pair<std::string, std::string>> scenes;  ///< name and title
  std::uint64_t upload_bytes = 0;
};

[[nodiscard]] std::string welcome_message(const ServerFacts& facts, const Room& room, const Viewer& viewer);
[[nodiscard]] std::string state_message(const RobotStatus& status, const DrivingRights& rights, std::size_t watchers,
                                        const std::optional<StopNote>& stopped_by, std::uint64_t pings);
[[nodiscard]] std::string viewers_message(const std::set<Viewer*>& viewers, const DrivingRights& rights);
[[nodiscard]] std::string error_message(std::optional<MessageId> id, const Error& error);
[[nodiscard]] std::string drive_request_message(const Viewer& asking);
[[nodiscard]] std::string drive_lost_message(std::string_view reason);
[[nodiscard]] std::string bye_message(std::string_view reason);
[[nodiscard]] std::string pong_message(MessageId id);
[[nodiscard]] std::string opened_message(MessageId id, std::string_view room);
[[nodiscard]] std::string pings_end_message(MessageId id);
[[nodiscard]] std::string snapshot_end_message(MessageId id, double time_s, std::size_t pings,
                                               const std::optional<Pose2>& pose);

}  // namespace echoarc::server
