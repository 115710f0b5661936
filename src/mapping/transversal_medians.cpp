// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/transversal_medians.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "echoarc/mapping/atm_resolution.hpp"

namespace echoarc {
namespace {

// "30 degrees or more": arcs that cross at exactly theta_t count. Kept angles have been rounded to float.
constexpr double slack = 1e-9;
constexpr double float_slack = 1e-7;
constexpr double unreachable_rad = std::numbers::pi;
constexpr ArcSlot no_slot = std::numeric_limits<ArcSlot>::max();

}  // namespace

std::size_t AngleHistogram::bin(double angle_rad) {
  const double whole = std::floor(radians(angle_rad).deg());
  return std::size_t(std::clamp(whole, 0.0, double(bins - 1)));
}

Angle AngleHistogram::value(HistogramStatistic statistic) const {
  const auto centre = [](std::size_t bin) { return degrees(double(bin) + 0.5); };
  const std::uint64_t total = std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
  if (total == 0) return {};
  if (statistic == HistogramStatistic::mean) {
    double sum = 0.0;
    for (std::size_t k = 0; k < bins; ++k) sum += double(counts_[k]) * centre(k).deg();
    return degrees(sum / double(total));
  }
  if (statistic == HistogramStatistic::median) {
    std::uint64_t below = 0;
    std::size_t k = 0;
    while (2 * (below += counts_[k]) < total) ++k;
    return centre(k);
  }
  const auto smoothed = [&](std::size_t k) {
    return (k > 0 ? counts_[k - 1] : 0) + counts_[k] + (k + 1 < bins ? counts_[k + 1] : 0);
  };
  std::size_t fullest = 0;
  for (std::size_t k = 1; k < bins; ++k)
    if (smoothed(k) > smoothed(fullest)) fullest = k;
  return centre(fullest);
}

Angle TransversalMedians::least_angle(const Arc& arc) const {
  if (rule_.angle == TransversalAngle::given) return rule_.theta_t;
  if (rule_.angle == TransversalAngle::from_histogram) return histogram_.value(rule_.statistic);
  const auto angle = angle_for_gain(rule_.gain, arc.range_m(), arc.t_end() - arc.t_begin(), rule_.range_quantum_m);
  return angle ? *angle : radians(unreachable_rad);
}

/// Of a pair's crossings those are kept that at least one of the two may want, with both, so that they leave together.
double TransversalMedians::least_angle_to_keep(double least_old, double least_new) const {
  if (rule_.angle == TransversalAngle::from_histogram) return 0.0;
  return std::min(least_old, least_new) - slack;
}

void TransversalMedians::collect(const CrossableArc& arc, double least_rad, ArcSlot self,
                                 std::span<const ArcSlot> candidates, std::vector<Found>& found) const {
  for (const ArcSlot old : candidates) {
    if (old == self) continue;
    const double keep_rad = least_angle_to_keep(least_rad_[old], least_rad);
    for (const ArcCrossing& crossing : crossings(arcs_[old], arc))
      if (crossing.angle.rad() >= keep_rad)
        found.push_back({crossing.t_a.rad(), crossing.t_b.rad(), float(crossing.angle.rad()), old});
  }
}

void TransversalMedians::add(ArcSlot slot, const Record& record) {
  std::vector<Record>& list = crossings_[slot];
  const auto place =
      std::upper_bound(list.begin(), list.end(), record, [](const Record& a, const Record& b) { return a.t < b.t; });
  list.insert(place, record);
  ++records_;
}

void TransversalMedians::insert(const ArcHistory& history, ArcSlot slot) {
  history.candidates(history.box(slot), candidates_);
  cross_with_candidates(history, slot);
}

void TransversalMedians::insert(const ArcHistory& history, ArcSlot slot, std::span<const ArcSlot> met) {
  candidates_.clear();
  for (const ArcSlot other : met)
    if (overlap(history.box(slot), history.box(other))) candidates_.push_back(other);
  std::ranges::sort(candidates_, {}, [&](ArcSlot other) { return history.sequence(other); });
  cross_with_candidates(history, slot);
}

void TransversalMedians::cross_with_candidates(const ArcHistory& history, ArcSlot slot) {
  if (slot >= arcs_.size()) {
    arcs_.resize(slot + 1);
    least_rad_.resize(slot + 1);
    crossings_.resize(slot + 1);
  }
  const Arc& arc = history.arc(slot);
  const CrossableArc fresh(arc);
  least_rad_[slot] = rule_.angle == TransversalAngle::from_histogram ? 0.0 : least_angle(arc).rad();
  arcs_[slot] = fresh;
  found_.clear();
  collect(fresh, least_rad_[slot], slot, candidates_, found_);
  for (std::size_t first = 0, last = 0; first < found_.size(); first = last) {
    const ArcSlot old = found_[first].partner;
    while (last < found_.size() && found_[last].partner == old) ++last;
    if (!has_room(old, last - first) || !has_room(slot, last - first)) {
      ++pairs_left_out_;
      continue;
    }
    for (std::size_t k = first; k < last; ++k) {
      add(old, {found_[k].t_old, found_[k].angle_rad, slot});
      add(slot, {found_[k].t_new, found_[k].angle_rad, old});
      histogram_.add(found_[k].angle_rad);
    }
  }
}

void TransversalMedians::erase(ArcSlot slot) {
  for (const Record& record : crossings_[slot]) {
    histogram_.remove(record.angle_rad);
    records_ -= 1 + std::erase_if(crossings_[record.partner], [&](const Record& r) { return r.partner == slot; });
  }
  crossings_[slot].clear();
}

TransversalMedian TransversalMedians::middle_of(std::span<const Record> sorted, double least_rad) const {
  TransversalMedian median;
  const auto transversal = [&](const Record& r) { return r.angle_rad >= least_rad - float_slack; };
  const bool all = rule_.angle == TransversalAngle::given;  // only transversal ones were kept
  median.count = all ? sorted.size() : std::size_t(std::ranges::count_if(sorted, transversal));
  if (median.count == 0) return median;
  const auto nth = [&](std::size_t n) -> const Record& {
    if (all) return sorted[n];
    std::size_t k = 0;
    while (!transversal(sorted[k]) || n-- > 0) ++k;
    return sorted[k];
  };
  const Record& low = nth((median.count - 1) / 2);
  const Record& high = nth(median.count / 2);
  median.t = radians(median.count % 2 == 1 ? low.t : 0.5 * (low.t + high.t));
  median.partners = {low.partner, high.partner};
  return median;
}

TransversalMedian TransversalMedians::median(const ArcHistory& history, ArcSlot slot) const {
  return middle_of(crossings_[slot], least_angle(history.arc(slot)).rad());
}

TransversalMedian TransversalMedians::preview(const ArcHistory& history, const Arc& arc) const {
  const double least_rad = least_angle(arc).rad();
  const CrossableArc fresh(arc);
  std::vector<ArcSlot> candidates;
  std::vector<Found> found;
  history.candidates(arc.bounds(), candidates);
  collect(fresh, least_rad, no_slot, candidates, found);
  std::vector<Record> sorted;
  for (const Found& f : found) sorted.push_back({f.t_new, f.angle_rad, f.partner});
  std::ranges::stable_sort(sorted, {}, &Record::t);
  return middle_of(sorted, least_rad);
}

void TransversalMedians::save(const ArcHistory& history, ByteWriter& out) const {
  const std::vector<ArcSlot> slots = history.in_time_order();
  std::vector<std::uint32_t> rank(history.slot_count());
  for (std::size_t k = 0; k < slots.size(); ++k) rank[slots[k]] = std::uint32_t(k);
  out.put(pairs_left_out_);
  for (const ArcSlot slot : slots) {
    std::vector<Record> list = crossings_[slot];
    for (Record& record : list) record.partner = rank[record.partner];
    out.put_vector(list);
  }
}

bool TransversalMedians::restore(const ArcHistory& history, ByteReader& in) {
  TransversalMedians restored(rule_);
  restored.pairs_left_out_ = in.get<std::uint64_t>();
  const std::size_t count = history.size();
  std::uint64_t balance = 0;  // every crossing must be there from both sides
  for (ArcSlot slot = 0; slot < count; ++slot) {
    const Arc& arc = history.arc(slot);
    restored.arcs_.emplace_back(arc);
    restored.least_rad_.push_back(rule_.angle == TransversalAngle::from_histogram ? 0.0 : least_angle(arc).rad());
    restored.crossings_.push_back(in.get_vector<Record>());
    const std::vector<Record>& list = restored.crossings_.back();
    if (list.size() > max_crossings_per_arc || !std::ranges::is_sorted(list, {}, &Record::t)) return false;
    for (const Record& record : list) {
      if (!(std::abs(record.t) <= 4.0) || !(std::abs(record.angle_rad) <= 2.0) || record.partner >= count ||
          record.partner == slot)
        return false;
      const std::uint64_t pair =
          (std::uint64_t(std::min(slot, record.partner)) << 32U) | std::max(slot, record.partner);
      balance += slot < record.partner ? pair * 0x9E3779B97F4A7C15U : -(pair * 0x9E3779B97F4A7C15U);
      if (slot < record.partner) restored.histogram_.add(record.angle_rad);
    }
    restored.records_ += list.size();
  }
  if (!in.ok() || balance != 0) return false;
  *this = std::move(restored);
  return true;
}

}  // namespace echoarc
