// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/parameter_choice.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {
namespace {

/// Shares are quotients of counts: what differs by less is the same share.
constexpr double same_share = 1e-12;

bool is_better(const ParameterScore& a, const ParameterScore& b) {
  if (std::abs(a.gap() - b.gap()) > same_share) return a.gap() < b.gap();
  if (std::abs(a.cdr_overall - b.cdr_overall) > same_share) return a.cdr_overall > b.cdr_overall;
  return a.mae_m < b.mae_m;
}

}  // namespace

double ParameterScore::gap() const {
  return std::abs(cdr_full - cdr_empty);
}

std::optional<ParameterChoice> choose_parameter(std::span<const ParameterScore> values) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isnan(values[k].gap())) order.push_back(k);
  if (order.empty()) return std::nullopt;
  // Picked one after the other: "equal to 1e-12" is no order that a sort could rely on.
  ParameterChoice choice;
  while (!order.empty()) {
    const auto best =
        std::ranges::min_element(order, [&](std::size_t a, std::size_t b) { return is_better(values[a], values[b]); });
    if (choice.candidates.empty()) choice.best = *best;
    if (values[*best].gap() - values[choice.best].gap() > near_gap + same_share) break;
    choice.candidates.push_back(*best);
    order.erase(best);
  }
  return choice;
}

}  // namespace echoarc
