// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "echoarc/core/bytes.hpp"
#include "echoarc/maps/arc_history.hpp"
#include "mapping/consensus/beam_bins.hpp"

namespace echoarc::consensus {

/// An echo of step A: its arc, and the reading it came from.
struct EchoArc {
  Arc arc;
  ArcSource source;
  SensorId tx = 0;
  Angle beam_width;
  std::uint32_t bins = 0;  ///< of `ArcTable::bins`
};

/// The point of an arc with the outward normal n, in the world: where a wall of that direction touches it.
[[nodiscard]] Vec2 touch_point(const Arc& arc, Vec2 n);
/// The outward normal of the arc, or of the one of its family that passes through `p`: away from both sensors.
[[nodiscard]] Vec2 normal_through(const Arc& arc, Vec2 p);

/// The arcs that a consensus is sought of, thinned (step A), in the order of time.
class ArcTable {
 public:
  explicit ArcTable(const ConsensusOptions& options)
      : options_(options), prior_{options.sigma_beams, options.search_beams} {}

  /// What is assumed of every beam: at first what the options say.
  [[nodiscard]] const BeamPrior& prior() const { return prior_; }
  /// Posteriors found before are of no use with another prior.
  void assume(const BeamPrior& prior);

  /// Whether a reading says the same as the last one kept of its sensors.
  [[nodiscard]] bool repeats(const Arc& arc, SensorId tx, SensorId rx) const;
  void add(EchoArc echo);
  /// The arcs from `from` on, on their own.
  [[nodiscard]] ArcTable since(std::size_t from) const;
  /// The first `count` arcs, on their own.
  [[nodiscard]] ArcTable first(std::size_t count) const;
  /// Forgets the first `count` arcs; those after them move up.
  void forget(std::size_t count);

  [[nodiscard]] std::size_t size() const { return echoes_.size(); }
  [[nodiscard]] const EchoArc& operator[](std::size_t i) const { return echoes_[i]; }
  [[nodiscard]] const BeamBins& bins(std::size_t i) const { return bins_[echoes_[i].bins]; }
  [[nodiscard]] const std::vector<BeamBins>& all_bins() const { return bins_; }
  /// Middle of the arc.
  [[nodiscard]] Vec2 middle(std::size_t i) const { return middles_[i]; }
  /// Unit vector along the axis.
  [[nodiscard]] Vec2 axis(std::size_t i) const { return axes_[i]; }
  /// From the axis of arc `j` to that of arc `i`, in [-pi, pi].
  [[nodiscard]] double turn_rad(std::size_t i, std::size_t j) const {
    const double turn = headings_rad_[i] - headings_rad_[j];
    constexpr double pi = std::numbers::pi;
    return turn > pi ? turn - 2.0 * pi : turn < -pi ? turn + 2.0 * pi : turn;
  }
  /// From the middle to either end of what is searched, along the arc.
  [[nodiscard]] double half_length_m(std::size_t i) const { return half_lengths_m_[i]; }

  void save(ByteWriter& out) const;
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  [[nodiscard]] ArcTable part(std::size_t begin, std::size_t end) const;

  ConsensusOptions options_;
  BeamPrior prior_;
  std::vector<EchoArc> echoes_;
  std::vector<double> headings_rad_;  // of the axes, in (-pi, pi]
  std::vector<Vec2> axes_;
  std::vector<Vec2> middles_;
  std::vector<double> half_lengths_m_;
  std::vector<BeamBins> bins_;
  std::map<std::pair<SensorId, SensorId>, std::size_t> last_;  // kept of a pair of sensors
};

}  // namespace echoarc::consensus
