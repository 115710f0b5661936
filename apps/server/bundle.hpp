// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "server/viewer.hpp"

namespace echoarc::server {

/// Encodes what viewers lack; ranges that several of them lack are encoded once.
class Bundler {
 public:
  /// The newest pings that a viewer gets when it comes.
  static constexpr double first_pings_s = 60.0;
  static constexpr std::size_t most_pings = 4096;  ///< in one frame; older ones of a longer range are left to questions

  void set(SharedPublication publication);
  [[nodiscard]] const SharedPublication& publication() const { return publication_; }

  /// All that the viewer lacks, `state` first, and its cursor moved on. Methods whose deltas do not reach back to what
  /// it has are put into `behind`, with the number it has.
  [[nodiscard]] std::vector<SharedFrame> take(Viewer& viewer, const SharedFrame& state,
                                              std::map<std::string, std::uint32_t>& behind);

 private:
  void add_pings(Viewer& viewer, std::vector<SharedFrame>& frames);
  void add_path(Viewer& viewer, std::vector<SharedFrame>& frames);
  void add_maps(Viewer& viewer, std::vector<SharedFrame>& frames, std::map<std::string, std::uint32_t>& behind) const;
  void add_second(Viewer& viewer, std::vector<SharedFrame>& frames) const;
  [[nodiscard]] std::size_t first_ping() const;

  SharedPublication publication_;
  std::map<std::pair<std::size_t, bool>, SharedFrame> pings_from_;  // of this publication, by begin and forgetting
  std::map<std::size_t, SharedFrame> path_from_;
};

}  // namespace echoarc::server
