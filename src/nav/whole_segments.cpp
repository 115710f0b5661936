// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "nav/whole_segments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace echoarc::nav {
namespace {

// Coordinates stay below 2^29, their differences below 2^30: sums of two products are exact, as doubles would not be.
using Wide = std::int64_t;

/// > 0: p lies left of the line through a and b.
Wide side(WholePoint a, WholePoint b, WholePoint p) {
  return Wide(b.x - a.x) * Wide(p.y - a.y) - Wide(b.y - a.y) * Wide(p.x - a.x);
}

int sign(Wide value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

bool boxes_meet(const WholeSegment& s, const WholeSegment& t) {
  const auto [s_low, s_high] = std::minmax(s.begin.y, s.end.y);
  const auto [t_low, t_high] = std::minmax(t.begin.y, t.end.y);
  return s.begin.x <= t.end.x && t.begin.x <= s.end.x && s_low <= t_high && t_low <= s_high;
}

/// Strictly between its ends.
bool lies_within(const WholeSegment& s, WholePoint p) {
  return p != s.begin && p != s.end && side(s.begin, s.end, p) == 0 && boxes_meet(s, {p, p});
}

WholePoint crossing(const WholeSegment& s, const WholeSegment& t) {
  const auto from = double(side(t.begin, t.end, s.begin));
  const auto to = double(side(t.begin, t.end, s.end));
  const double share = from / (from - to);
  return {s.begin.x + std::int64_t(std::llround(share * double(s.end.x - s.begin.x))),
          s.begin.y + std::int64_t(std::llround(share * double(s.end.y - s.begin.y)))};
}

/// Notes for both segments where they have to be split.
void note_splits(const WholeSegment& s, const WholeSegment& t, std::vector<WholePoint>& of_s,
                 std::vector<WholePoint>& of_t) {
  for (const WholePoint p : {t.begin, t.end})
    if (lies_within(s, p)) of_s.push_back(p);
  for (const WholePoint p : {s.begin, s.end})
    if (lies_within(t, p)) of_t.push_back(p);
  const bool apart_of_t = sign(side(t.begin, t.end, s.begin)) * sign(side(t.begin, t.end, s.end)) < 0;
  const bool apart_of_s = sign(side(s.begin, s.end, t.begin)) * sign(side(s.begin, s.end, t.end)) < 0;
  if (!apart_of_s || !apart_of_t) return;
  const WholePoint p = crossing(s, t);
  of_s.push_back(p);
  of_t.push_back(p);
}

void tidy(std::vector<WholeSegment>& segments) {
  for (WholeSegment& s : segments)
    if (s.end < s.begin) std::swap(s.begin, s.end);
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  std::vector<WholePoint> ends;  // of segments that are not empty: points on them say nothing new
  for (const WholeSegment& s : segments)
    if (s.begin != s.end) ends.insert(ends.end(), {s.begin, s.end});
  std::sort(ends.begin(), ends.end());
  std::erase_if(segments, [&](const WholeSegment& s) {
    return s.begin == s.end && std::binary_search(ends.begin(), ends.end(), s.begin);
  });
}

/// The pieces of a segment, by way of the points in the order along it.
void append_pieces(const WholeSegment& s, std::vector<WholePoint>& points, std::vector<WholeSegment>& pieces) {
  const auto along = [&](WholePoint p) {
    return Wide(p.x - s.begin.x) * Wide(s.end.x - s.begin.x) + Wide(p.y - s.begin.y) * Wide(s.end.y - s.begin.y);
  };
  std::sort(points.begin(), points.end(), [&](WholePoint a, WholePoint b) { return along(a) < along(b); });
  WholePoint from = s.begin;
  points.push_back(s.end);
  for (const WholePoint p : points) {
    if (p == from) continue;
    pieces.push_back({from, p});
    from = p;
  }
}

}  // namespace

bool split_at_crossings(std::vector<WholeSegment>& segments) {
  constexpr int most_rounds = 10;
  tidy(segments);
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<std::vector<WholePoint>> splits(segments.size());
    bool any = false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      // Sorted by the left end: nothing later begins left of where this one ends.
      for (std::size_t j = i + 1; j < segments.size() && segments[j].begin.x <= segments[i].end.x; ++j)
        if (boxes_meet(segments[i], segments[j])) note_splits(segments[i], segments[j], splits[i], splits[j]);
    }
    std::vector<WholeSegment> pieces;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      any = any || !splits[i].empty();
      if (splits[i].empty())
        pieces.push_back(segments[i]);
      else
        append_pieces(segments[i], splits[i], pieces);
    }
    if (!any) return true;
    segments = std::move(pieces);
    tidy(segments);
  }
  return false;
}

}  // namespace echoarc::nav
