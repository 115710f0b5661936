// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "echoarc/core/executor.hpp"
#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/session_log.hpp"
#include "echoarc/live/mapper.hpp"
#include "echoarc/sensing/sensing_options.hpp"
#include "echoarc/sim/scene.hpp"
#include "server/room.hpp"

namespace echoarc::server {

/// What all rooms of one server map with.
struct MappingChoice {
  std::vector<live::MethodChoice> methods;
  SensingOptions sensing;
};

/// A simulated robot in a scene. With a folder everything that is received is kept there.
struct SceneRoom {
  std::string name = "main";
  sim::Scene scene;
  std::string scene_name;  ///< by which it is found again, for --resume
  std::uint64_t seed = 1;
  double speed = 1.0;
  bool attended = false;
  std::filesystem::path session;  ///< empty: nothing is kept
  io::SessionLogLimits limits;
};
[[nodiscard]] Result<RoomSetup> make_scene_room(const SceneRoom& room, const MappingChoice& mapping,
                                                Executor& executor);

/// A log that is played.
[[nodiscard]] Result<RoomSetup> make_log_room(const std::string& name, Log log, double speed,
                                              const MappingChoice& mapping, Executor& executor);

/// What a session that is to be continued was started with: its first setup record.
struct SessionStart {
  std::string scene;
  std::uint64_t seed = 1;
  double speed = 1.0;
  MappingChoice mapping;
};
[[nodiscard]] Result<SessionStart> read_session_start(const std::filesystem::path& session);

/// Continues a session: its records are mapped again, the robot starts where it was.
[[nodiscard]] Result<RoomSetup> resume_scene_room(const SceneRoom& room, const MappingChoice& mapping,
                                                  Executor& executor);

}  // namespace echoarc::server
