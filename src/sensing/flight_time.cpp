// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/flight_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace echoarc {
namespace {

/// The part of an envelope after the blanking. Negative samples, which no envelope has, count as 0.
class Heard {
 public:
  Heard(const Envelope& envelope, const FlightTimeOptions& options) : envelope_(envelope) {
    const double blanking_s = flight_time_of_range_s(options.range_min_m, options.temperature_k);
    const double skipped = std::ceil((blanking_s - envelope.start_s) / envelope.period_s);
    begin_ = skipped <= 0.0                              ? 0
             : skipped < double(envelope.samples.size()) ? std::size_t(skipped)
                                                         : envelope.samples.size();
    const std::size_t count = std::min(std::size_t(options.noise_samples), end() - begin_);
    double sum = 0.0;
    for (std::size_t k = begin_; k < begin_ + count; ++k) sum += at(k) / double(count) * at(k);
    noise_ = count > 0 ? std::sqrt(sum) : 0.0;
  }
  [[nodiscard]] std::size_t begin() const { return begin_; }
  [[nodiscard]] std::size_t end() const { return envelope_.samples.size(); }
  [[nodiscard]] double at(std::size_t k) const { return std::max(envelope_.samples[k], 0.0); }
  [[nodiscard]] double time_s(double k) const { return envelope_.start_s + k * envelope_.period_s; }
  [[nodiscard]] double noise() const { return noise_; }

 private:
  Envelope envelope_;
  std::size_t begin_ = 0;
  double noise_ = 0.0;
};

struct Crossing {
  std::size_t sample = 0;  ///< the first at or above the level
  double time_s = 0.0;     ///< between it and the one before, linearly
};

/// Where `level(k)` is first reached from `begin` on. A silent sample reaches nothing, whatever the level.
template <class Level>
std::optional<Crossing> first_crossing(const Heard& heard, std::size_t begin, Level&& level) {
  for (std::size_t k = begin; k < heard.end(); ++k) {
    const double above = heard.at(k) - level(k);
    if (above < 0.0 || heard.at(k) <= 0.0) continue;
    if (k == begin) return Crossing{k, heard.time_s(double(k))};
    const double below = level(k - 1) - heard.at(k - 1);
    const double back = below > 0.0 ? above / (above + below) : 0.0;
    return Crossing{k, heard.time_s(double(k) - back)};
  }
  return std::nullopt;
}

double level_of(const Heard& heard, const FlightTimeOptions& options, double sigmas) {
  return options.threshold > 0.0 ? options.threshold : sigmas * heard.noise();
}

std::optional<Crossing> simple(const Heard& heard, const FlightTimeOptions& options) {
  const double level = level_of(heard, options, options.threshold_sigmas);
  return first_crossing(heard, heard.begin(), [&](std::size_t) { return level; });
}

/// tau[k] = mean + kappa std of `window` samples that end `guard` before k.
std::optional<Crossing> adaptive(const Heard& heard, const FlightTimeOptions& options) {
  const std::size_t window = std::size_t(options.window);
  const std::size_t first = heard.begin() + window + std::size_t(options.guard);
  double largest = 0.0;
  for (std::size_t k = heard.begin(); k < heard.end(); ++k) largest = std::max(largest, heard.at(k));
  if (first >= heard.end() || largest <= 0.0) return std::nullopt;
  // Sums of shares of the largest sample: nothing overflows.
  std::vector<double> sum(heard.end() - heard.begin() + 1);
  std::vector<double> squares(sum.size());
  for (std::size_t k = 0; k + 1 < sum.size(); ++k) {
    const double share = heard.at(heard.begin() + k) / largest;
    sum[k + 1] = sum[k] + share;
    squares[k + 1] = squares[k] + share * share;
  }
  constexpr double least_spread = 1e-9;  // rounding of the sums: a constant signal does not stand out from itself
  const auto level = [&](std::size_t k) {
    const std::size_t end = k - std::size_t(options.guard) - heard.begin();
    const double mean = (sum[end] - sum[end - window]) / double(window);
    const double variance = (squares[end] - squares[end - window]) / double(window) - mean * mean;
    return largest * (mean + options.threshold_sigmas * std::max(std::sqrt(std::max(variance, 0.0)), least_spread));
  };
  // The level of the sample before the first one is not known: its own serves.
  return first_crossing(heard, first, [&](std::size_t k) { return level(std::max(k, first)); });
}

/// tau(t) = tau0 max(g_min, (t_ref / t) 10^(-alpha c (t - t_ref) / 20)).
std::optional<Crossing> variable(const Heard& heard, const FlightTimeOptions& options) {
  const double reference_s = flight_time_of_range_s(options.reference_range_m, options.temperature_k);
  // Without a level of its own the lowest one is what simple thresholding would take, so that noise stays below.
  const double start =
      options.threshold > 0.0 ? options.threshold : options.threshold_sigmas * heard.noise() / options.gain_min;
  const double decay = options.absorption_db_m * speed_of_sound_m_s(options.temperature_k) / 20.0;
  return first_crossing(heard, heard.begin(), [&](std::size_t k) {
    const double t = heard.time_s(double(k));
    if (t <= 0.0) return std::numeric_limits<double>::infinity();
    return start * std::max(options.gain_min, reference_s / t * std::pow(10.0, -decay * (t - reference_s)));
  });
}

/// t0 = t1 - tau1 (t2 - t1) / (tau2 - tau1), tau2 = 2 tau1. Edges that rise too slowly are no echoes.
std::optional<double> double_threshold(const Heard& heard, const FlightTimeOptions& options) {
  const double lower = level_of(heard, options, options.double_sigmas);
  std::size_t begin = heard.begin();
  while (const auto first = first_crossing(heard, begin, [&](std::size_t) { return lower; })) {
    std::size_t k = first->sample;
    while (k < heard.end() && heard.at(k) >= lower && heard.at(k) < 2.0 * lower &&
           heard.time_s(double(k)) - first->time_s <= options.rise_max_s)
      ++k;
    if (k < heard.end() && heard.at(k) >= 2.0 * lower) {
      const auto second = first_crossing(heard, first->sample, [&](std::size_t) { return 2.0 * lower; });
      if (second->time_s - first->time_s <= options.rise_max_s) return 2.0 * first->time_s - second->time_s;
    }
    while (k < heard.end() && heard.at(k) >= lower) ++k;  // past this edge
    begin = k;
    if (lower <= 0.0) break;
  }
  return std::nullopt;
}

/// e = a (t - t0)^2 has a square root linear in t: a line is fitted to it, from the noise to the first maximum.
std::optional<double> curve_fit(const Heard& heard, const FlightTimeOptions& options) {
  constexpr std::size_t least_samples = 4;
  const auto crossing = simple(heard, options);
  if (!crossing) return std::nullopt;
  std::size_t begin = crossing->sample;
  while (begin > heard.begin() && heard.at(begin - 1) > heard.noise() && heard.at(begin - 1) < heard.at(begin)) --begin;
  std::size_t end = crossing->sample + 1;
  while (end < heard.end() && heard.at(end) > heard.at(end - 1)) ++end;
  if (end - begin < least_samples) return crossing->time_s;
  // Times relative to the crossing, in samples; roots relative to the largest.
  const double scale = std::sqrt(heard.at(end - 1));
  const auto count = double(end - begin);
  double mean_t = 0.0;
  double mean_root = 0.0;
  for (std::size_t k = begin; k < end; ++k) {
    mean_t += (double(k) - double(crossing->sample)) / count;
    mean_root += std::sqrt(heard.at(k)) / scale / count;
  }
  double spread = 0.0;
  double common = 0.0;
  for (std::size_t k = begin; k < end; ++k) {
    const double t = double(k) - double(crossing->sample) - mean_t;
    spread += t * t;
    common += t * (std::sqrt(heard.at(k)) / scale - mean_root);
  }
  const double slope = common / spread;
  if (!(slope > 0.0)) return crossing->time_s;
  const double t0_s = heard.time_s(double(crossing->sample) + mean_t - mean_root / slope);
  return t0_s >= 0.0 && t0_s <= crossing->time_s ? t0_s : crossing->time_s;
}

std::optional<double> time_of(const std::optional<Crossing>& crossing) {
  return crossing ? std::optional(crossing->time_s) : std::nullopt;
}

Result<void> check(const Envelope& envelope) {
  const auto fault = [](std::string what, std::string where) {
    return Error{ErrorCode::bad_value, std::move(what), std::move(where), "check what the receiver delivered"};
  };
  const double end_s = envelope.start_s + double(envelope.samples.size()) * envelope.period_s;
  if (!(envelope.period_s > 0.0) || !std::isfinite(envelope.start_s) || !std::isfinite(end_s))
    return fault("an envelope needs a finite start and end and a positive period", "envelope");
  const auto bad = std::ranges::find_if_not(envelope.samples, [](double e) { return std::isfinite(e); });
  if (bad != envelope.samples.end())
    return fault("a sample is not finite", "sample " + std::to_string(bad - envelope.samples.begin()));
  return {};
}

}  // namespace

Result<std::optional<double>> flight_time_s(const Envelope& envelope, const FlightTimeOptions& options) {
  if (const Result<void> sound = check(envelope); !sound) return sound.error();
  const Heard heard(envelope, options);
  switch (options.method) {
    case FlightTimeMethod::adaptive: return time_of(adaptive(heard, options));
    case FlightTimeMethod::variable: return time_of(variable(heard, options));
    case FlightTimeMethod::double_threshold: return double_threshold(heard, options);
    case FlightTimeMethod::curve_fit: return curve_fit(heard, options);
    case FlightTimeMethod::simple: break;
  }
  return time_of(simple(heard, options));
}

}  // namespace echoarc
