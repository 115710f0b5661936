// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

namespace echoarc::nav {

struct WholePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend auto operator<=>(const WholePoint&, const WholePoint&) = default;
};

/// With begin <= end; a point if they are equal.
struct WholeSegment {
  WholePoint begin;
  WholePoint end;
  friend auto operator<=>(const WholeSegment&, const WholeSegment&) = default;
};

/// Splits segments (|coordinate| < 2^29) where they cross, overlap or touch, so that they share nothing but ends, which
/// the sweep over them takes for granted. Crossings are rounded to whole coordinates, which may make new ones: they are
/// split in turn. Empty segments that lie on others and doubles go away. Returns false if it does not come to an end.
[[nodiscard]] bool split_at_crossings(std::vector<WholeSegment>& segments);

}  // namespace echoarc::nav
