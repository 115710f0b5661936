// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/findings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace echoarc::studies {
namespace {

StudyRow row_without_paper(RowText text, std::span<const double> ours) {
  StudyRow row;
  row.quantity = std::move(text.quantity);
  row.condition = std::move(text.condition);
  row.unit = std::move(text.unit);
  row.decimals = text.decimals;
  row.ours = spread_of(ours);
  return row;
}

Claim claim_of(ClaimText text) {
  Claim claim;
  claim.id = std::move(text.id);
  claim.text = std::move(text.text);
  claim.source = std::move(text.source);
  return claim;
}

std::string written(double value, const FigureFormat& format) {
  return figure_text(value * format.factor, format.decimals, format.unit);
}

}  // namespace

std::string figure_text(double value, int decimals, std::string_view unit) {
  if (!std::isfinite(value)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(decimals, 0, 9), value);
  return std::string(text) + (unit.empty() ? "" : " ") + std::string(unit);
}

StudyRow row_of(RowText text, double paper, std::span<const double> ours) {
  StudyRow row = row_without_paper(std::move(text), ours);
  row.paper = paper;
  return row;
}

StudyRow row_of(RowText text, std::string paper, std::span<const double> ours) {
  StudyRow row = row_without_paper(std::move(text), ours);
  row.paper_text = std::move(paper);
  return row;
}

Claim claim_less(ClaimText text, std::span<const double> a, std::span<const double> b, const FigureFormat& format) {
  Claim claim = claim_of(std::move(text));
  std::vector<double> left, right;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    if (!std::isfinite(a[k]) || !std::isfinite(b[k])) continue;
    left.push_back(a[k]);
    right.push_back(b[k]);
    ++claim.seeds;
    if (a[k] < b[k]) ++claim.holds_on;
  }
  if (claim.seeds == 0) return claim;
  const double low = spread_of(left).mean;
  const double high = spread_of(right).mean;
  claim.verdict = low < high ? Verdict::holds : Verdict::fails;
  claim.evidence = written(low, format) + " against " + written(high, format);
  return claim;
}

Claim claim_at_least(ClaimText text, std::span<const double> values, double limit, const FigureFormat& format) {
  Claim claim = claim_of(std::move(text));
  const Spread spread = spread_of(values);
  claim.seeds = spread.values;
  claim.holds_on = std::uint64_t(
      std::count_if(values.begin(), values.end(), [&](double v) { return std::isfinite(v) && v >= limit; }));
  if (spread.values == 0) return claim;
  claim.verdict = spread.mean >= limit ? Verdict::holds : Verdict::fails;
  claim.evidence = written(spread.mean, format) + " on the mean, " + written(spread.min, format) + " to " +
                   written(spread.max, format) + "; limit " + written(limit, format);
  return claim;
}

}  // namespace echoarc::studies
