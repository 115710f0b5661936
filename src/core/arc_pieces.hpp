// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "echoarc/core/arc_carving.hpp"

/// The pieces into which a free sector cuts an arc, from one end to the other. A mark is a place on the arc: an angle,
/// or a direction; `counts(a, b)` tells whether a piece between two marks is as long as `min_arc`.
namespace echoarc::detail {

[[nodiscard]] inline bool counts(Angle begin, Angle end) {
  return end - begin >= min_arc;
}

/// A stretch of the arc that lies inside F, or outside.
template <class Mark>
struct Piece {
  Mark begin;
  Mark end;
  bool kept = false;
};

template <class Mark>
class Pieces {
 public:
  /// Joins the piece to the last one if both have the same fate.
  void add(const Piece<Mark>& piece) {
    if (count_ > 0 && pieces_[count_ - 1].kept == piece.kept)
      pieces_[count_ - 1].end = piece.end;
    else
      pieces_[count_++] = piece;
  }
  [[nodiscard]] std::span<const Piece<Mark>> all() const { return {pieces_.data(), count_}; }

 private:
  std::array<Piece<Mark>, 32> pieces_;
  std::size_t count_ = 0;
};

/// What carving makes of the arc; `kept` is the one piece that is left when it is `carved`.
template <class Mark>
struct Verdict {
  CarveOutcome outcome = CarveOutcome::unchanged;
  Piece<Mark> kept;
};

template <class Mark>
[[nodiscard]] Verdict<Mark> judge(const Pieces<Mark>& cut) {
  Pieces<Mark> pieces;  // a cut too short to count takes nothing away
  for (Piece<Mark> piece : cut.all()) {
    if (!piece.kept && !counts(piece.begin, piece.end)) piece.kept = true;
    pieces.add(piece);
  }
  Verdict<Mark> verdict;
  if (pieces.all().size() == 1 && pieces.all()[0].kept) return verdict;
  int kept = 0;
  for (const Piece<Mark>& piece : pieces.all()) {
    if (!piece.kept || !counts(piece.begin, piece.end)) continue;
    ++kept;
    verdict.kept = piece;
  }
  verdict.outcome = kept == 1   ? CarveOutcome::carved
                    : kept == 0 ? CarveOutcome::removed_full
                                : CarveOutcome::removed_split;
  return verdict;
}

/// The same between two circles, without trigonometric functions but for the new ends.
[[nodiscard]] Carving carve_circle(const CarvableArc& older, const FreeSector& newer);

}  // namespace echoarc::detail
