// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/sim/echo_paths.hpp"
#include "sim/view.hpp"
#include "sim/world_model.hpp"

namespace echoarc::sim {

/// A place of a transducer with the window it hears in.
struct Ear {
  Vec2 position;
  Vec2 axis;
  double cos_window = -1.0;

  Ear() = default;
  explicit Ear(const Transducer& transducer);
  [[nodiscard]] bool hears(Vec2 point) const;
};

/// Marks numbers once per round; forgets all in no time.
class Marks {
 public:
  explicit Marks(std::size_t size) : marked_in_(size, 0) {}
  void forget();
  /// True for the first call with this number since `forget`.
  bool mark(std::uint32_t number) { return std::exchange(marked_in_[number], round_) != round_; }

 private:
  std::vector<std::uint32_t> marked_in_;
  std::uint32_t round_ = 1;
};

/// One ping: who sends, who listens, what is wanted, what was found. Keeps its buffers from ping to ping.
class PingSearch {
 public:
  PingSearch(const WorldModel& model, std::vector<EchoPath>& found);

  /// Looks around from both ends.
  void start(const Transducer& transmitter, const Transducer& receiver, const PathLimits& path_limits,
             std::span<const Disc> discs);

  const WorldModel& world;
  std::vector<EchoPath>& paths;
  Ear sender;
  Ear listener;
  PathLimits limits;
  std::span<const Disc> moving;
  bool one_place = false;  ///< sender and listener share place and window, and every way can be gone backwards

  [[nodiscard]] const View& sender_view() const { return sender_view_; }
  [[nodiscard]] const View& listener_view() const { return one_place ? sender_view_ : listener_view_; }
  /// Visits the items lit from one end, each once.
  template <class Visit>
  void for_each_lit(const View& view, const Visit& visit) {
    item_marks_.forget();
    for (const View::Sector& sector : view.sectors())
      for (const Lit& lit : sector.lit)
        if (item_marks_.mark(lit.item)) visit(lit.item);
  }
  /// Distance from an eye beyond which no path turns back in time.
  [[nodiscard]] double reach_m(Vec2 eye) const { return 0.5 * (limits.max_length_m + norm(eye - listener.position)); }

  [[nodiscard]] bool sees(Vec2 a, Vec2 b) { return world.visible(a, b, moving, work) && within_bounds(); }
  /// Adds sender -> first -> ... -> last -> listener.
  void add(Vec2 first, Vec2 last, double length_m, double gain_db, EchoCause cause, std::size_t reflections);
  /// Counts an image; false when the ping's bound on work is met.
  bool count_image() {
    ++images;
    return within_bounds();
  }
  [[nodiscard]] bool within_bounds() const { return images <= PathFinder::max_images && work <= PathFinder::max_items; }

  std::uint64_t images = 0;
  std::uint64_t work = 0;  ///< items looked at
  BeamSweep sweep;
  Marks vertex_marks;
  Marks curve_marks;

 private:
  View sender_view_;
  Transducer seen_from_;     // what the sender's view was looked for from
  double seen_to_m_ = -1.0;  // how far; nothing yet
  std::uint64_t seen_work_ = 0;
  View listener_view_;
  Marks item_marks_;
};

void find_disc_paths(PingSearch& ping);
void find_curve_paths(PingSearch& ping);
/// Bumps of rough walls and curves.
void find_bump_paths(PingSearch& ping);
/// Sorts by length and keeps one of those that are the same path.
void order_paths(std::vector<EchoPath>& paths);

}  // namespace echoarc::sim
