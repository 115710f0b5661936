// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/result.hpp"
#include "server/room.hpp"
#include "server/room_messages.hpp"

namespace echoarc::server {

struct ServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;
  bool any_port = true;     ///< the next free one if that is taken
  bool is_private = false;  ///< watching needs the token, too
  std::string token;
  std::vector<std::string> hosts;  ///< names under which it is reached, besides addresses and localhost
  std::string parameters;          ///< JSON Schema of all options: what /api/parameters says
  ServerFacts facts;
};

/// How rooms are made that viewers ask for.
struct RoomOpeners {
  std::function<Result<RoomSetup>(const std::string& scene, const std::string& room)> scene;
  /// `title`: how the log shall be called; empty: nobody said.
  std::function<Result<RoomSetup>(const std::string& log, const std::string& title, const std::string& room)> log;
  /// The final map of a method as one file: "png", "pgm", "yaml" or "csv". Called on the thread of questions.
  std::function<Result<std::string>(const MapExport& map, const std::string& method, std::string_view kind,
                                    const std::vector<Vec2>& path)>
      map_file;
  /// The report of a room's run, JSON; on its mapper's thread.
  std::function<std::string(const live::Mapper& mapper)> run_report;
  /// Where the session log of the main room lies; empty: there is none.
  std::function<std::vector<std::string>()> log_parts;
};

/// What was refused, by cause; for `docs` and the curious: /api/state has them.
struct RefusalCounters {
  std::uint64_t connections = 0;
  std::uint64_t origins = 0;
  std::uint64_t tokens = 0;
  std::uint64_t requests = 0;
  std::uint64_t messages = 0;
  std::uint64_t floods = 0;
  std::uint64_t slow_viewers = 0;
};

/// HTTP and WebSocket on one port, by one thread: the one that calls `run`. Everything that is posted runs there, too,
/// so rooms and viewers need no locks.
class Server {
 public:
  /// Errors: the address is none or not of this machine, the port is taken.
  [[nodiscard]] static Result<std::unique_ptr<Server>> listen(ServerOptions options, RoomOpeners openers);
  virtual ~Server() = default;

  [[nodiscard]] virtual std::uint16_t port() const = 0;
  /// The room that the server was started for.
  virtual std::shared_ptr<Room> open_main(RoomSetup setup) = 0;
  /// Serves until `ended` says so, which is asked twenty times a second; then says goodbye to everybody.
  virtual void run(const std::function<bool()>& ended) = 0;
};

}  // namespace echoarc::server
