// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/chart_axis.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace echoarc::studies {
namespace {

constexpr int most_ticks = 50;
/// Ends of axes beyond this are cut: nothing measured is so large, and texts must stay short.
constexpr double largest = 1e12;

/// 1, 2, 2.5 or 5 times a power of ten, about `span / wanted`.
double step_of(double span, int wanted) {
  const double rough = span / std::max(wanted, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0})
    if (factor * power >= 0.999 * rough) return factor * power;
  return 10.0 * power;
}

int decimals_of(double step) {
  for (int decimals = 0; decimals < 9; ++decimals) {
    const double scaled = step * std::pow(10.0, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled) return decimals;
  }
  return 9;
}

void mark_evenly(AxisScale& scale, int wanted, bool widen_low, bool widen_high) {
  const double step = step_of(scale.high - scale.low, wanted);
  if (widen_low) scale.low = step * std::floor(scale.low / step + 1e-9);
  if (widen_high) scale.high = step * std::ceil(scale.high / step - 1e-9);
  const int decimals = decimals_of(step);
  const double first = std::ceil(scale.low / step - 1e-9);
  for (int k = 0; k < most_ticks && (first + k) * step <= scale.high + 1e-9 * step; ++k)
    scale.ticks.push_back({(first + k) * step, fixed((first + k) * step, decimals)});
}

void mark_decades(AxisScale& scale, bool widen_low, bool widen_high) {
  if (widen_low) scale.low = std::pow(10.0, std::floor(std::log10(scale.low) + 1e-9));
  if (widen_high) scale.high = std::pow(10.0, std::ceil(std::log10(scale.high) - 1e-9));
  const int first = int(std::floor(std::log10(scale.low) + 1e-9));
  const int last = int(std::floor(std::log10(scale.high) + 1e-9));
  const std::array<double, 3> factors{1.0, 2.0, 5.0};
  const std::size_t used = last - first < 2 ? factors.size() : 1;
  for (int decade = first; decade <= last && decade - first < most_ticks; ++decade)
    for (std::size_t k = 0; k < used; ++k) {
      const double value = factors[k] * std::pow(10.0, decade);
      if (value < scale.low * (1.0 - 1e-9) || value > scale.high * (1.0 + 1e-9)) continue;
      scale.ticks.push_back({value, fixed(value, std::max(0, -decade))});
    }
}

/// The ends, made into a stretch that can be drawn.
void settle(AxisScale& scale, bool any_value, const ChartAxis& axis) {
  if (!any_value) {
    scale.low = axis.low.value_or(scale.logarithmic ? 0.1 : 0.0);
    scale.high = axis.high.value_or(scale.logarithmic ? 1.0 : scale.low + 1.0);
  }
  if (scale.logarithmic) scale.low = std::max(scale.low, 1e-9);
  scale.low = std::clamp(scale.low, -largest, largest);
  scale.high = std::clamp(scale.high, -largest, largest);
  // Less than this and ticks could not be told apart in a double.
  const double least = 1e-9 * std::max({1.0, std::abs(scale.low), std::abs(scale.high)});
  if (scale.high - scale.low >= least) return;
  if (scale.logarithmic) {
    scale.high = scale.low * 10.0;
    return;
  }
  const double margin = scale.low == 0.0 ? 0.5 : 0.1 * std::abs(scale.low);
  const double middle = scale.low;
  scale.low = middle - margin;
  scale.high = middle + margin;
}

}  // namespace

std::string fixed(double value, int decimals) {
  std::array<char, 64> text{};
  const double shown = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), shown, std::chars_format::fixed, decimals);
  return end.ec == std::errc{} ? std::string(text.data(), end.ptr) : "?";
}

double AxisScale::share(double value) const {
  if (logarithmic) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

AxisScale scale_for(const ChartAxis& axis, double low, double high, int wanted, bool widen) {
  const bool any_value = std::isfinite(low) && std::isfinite(high) && low <= high;
  AxisScale scale{.low = axis.low.value_or(low), .high = axis.high.value_or(high), .logarithmic = axis.logarithmic};
  settle(scale, any_value && std::isfinite(scale.low) && std::isfinite(scale.high), axis);
  const bool widen_low = widen && !axis.low;
  const bool widen_high = widen && !axis.high;
  if (scale.logarithmic)
    mark_decades(scale, widen_low, widen_high);
  else
    mark_evenly(scale, wanted, widen_low, widen_high);
  return scale;
}

}  // namespace echoarc::studies
