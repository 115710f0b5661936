// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "server/driving_rights.hpp"
#include "server/mapping_loop.hpp"

namespace echoarc::server {

/// What a viewer has already been sent; what it lacks is computed from here (docs/adr/0010).
struct ViewerCursor {
  std::uint64_t tick = 0;  ///< of the newest state
  bool greeted = false;    ///< it has the history; before, it gets nothing but answers
  std::uint64_t run = 0;
  std::size_t pings = 0;
  std::size_t path = 0;
  std::uint64_t methods_version = 0;
  std::map<std::string, std::uint32_t> maps;  ///< sequence number by method
  std::uint64_t second = 0;
  std::uint64_t plan = 0;  ///< version of the newest
  bool catching_up = false;
  std::optional<MappingLoop::CatchUp> caught;  ///< to be sent first
};

/// Someone who watches a room, as the room sees them. All is called on the thread of input and output.
class Viewer {
 public:
  virtual ~Viewer() = default;
  /// Something new is there: takes what it lacks, unless it is still busy with the last bundle.
  virtual void offer() = 0;
  /// An answer, or something said to this viewer alone.
  virtual void send(std::string text) = 0;
  virtual void send(std::vector<SharedFrame> frames) = 0;
  /// Says `bye` and closes. `reason` as in the schema.
  virtual void dismiss(std::string_view reason) = 0;

  ViewerId id = 0;
  std::string name;
  bool may_drive = false;
  std::optional<std::set<std::string, std::less<>>> subscribed;  ///< none: all methods
  std::uint64_t dropped = 0;                                     ///< bundles it was spared
  ViewerCursor cursor;

  [[nodiscard]] bool wants(const std::string& method) const { return !subscribed || subscribed->contains(method); }
};

}  // namespace echoarc::server
