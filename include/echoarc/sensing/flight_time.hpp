// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/core/speed_of_sound.hpp"

/// From the envelope of what a receiver heard to the time of flight of the first echo in it. [Barshan07] 2 names the
/// methods without formulas; those here are written down in docs/flight-time.md.
namespace echoarc {

enum class FlightTimeMethod : std::uint8_t {
  simple,            ///< where the envelope first reaches a constant level
  adaptive,          ///< where it first stands out from the samples before it
  variable,          ///< where it first reaches a level that falls with spreading and absorption
  double_threshold,  ///< the rising edge through two levels, extrapolated to zero
  curve_fit,         ///< a parabola fitted to the rising edge, extrapolated to zero
};
constexpr std::array<Choice<FlightTimeMethod>, 5> choices(FlightTimeMethod /*tag*/) {
  using M = FlightTimeMethod;
  return {{{M::simple, "simple"},
           {M::adaptive, "adaptive"},
           {M::variable, "variable"},
           {M::double_threshold, "double"},
           {M::curve_fit, "curvefit"}}};
}

struct FlightTimeOptions {
  FlightTimeMethod method = FlightTimeMethod::simple;
  double threshold = 0.0;
  double threshold_sigmas = 5.0;
  double double_sigmas = 4.0;
  int noise_samples = 64;
  double range_min_m = 0.057;
  double temperature_k = default_temperature_k;
  int window = 64;
  int guard = 8;
  double reference_range_m = 0.5;
  double absorption_db_m = 1.6;
  double gain_min = 0.02;
  double rise_max_s = 0.5e-3;

  static constexpr auto fields() {
    using F = FlightTimeOptions;
    return std::tuple{
        field("method", &F::method, {.doc = "how the start of an echo is found", .source = "[Barshan07] 2"}),
        field("threshold", &F::threshold,
              {.min = 0.0, .max = 1e300, .doc = "level in the unit of the envelope; 0: a multiple of the noise"}),
        field("threshold_sigmas", &F::threshold_sigmas,
              {.unit = "sigma", .min = 0.0, .max = 1e6, .doc = "threshold 0: this multiple of the noise"}),
        field("double_sigmas", &F::double_sigmas,
              {.unit = "sigma", .min = 0.0, .max = 1e6, .doc = "threshold 0, double: the lower level"}),
        field("noise_samples", &F::noise_samples,
              {.unit = "samples", .min = 1, .max = 1 << 20, .doc = "after the blanking: their RMS is the noise"}),
        field("range_min_m", &F::range_min_m,
              {.unit = "m", .min = 0.0, .max = 1000.0, .doc = "blanking: echoes from nearer are not looked for"}),
        field("temperature_k", &F::temperature_k,
              {.unit = "K", .min = 100.0, .max = 400.0, .doc = "of the air", .source = "[Barshan07] 2, footnote 1"}),
        field("window", &F::window,
              {.unit = "samples", .min = 2, .max = 1 << 20, .doc = "adaptive: samples that the level is taken from"}),
        field(
            "guard", &F::guard,
            {.unit = "samples", .min = 0, .max = 1 << 20, .doc = "adaptive: samples left out before the present one"}),
        field("reference_range_m", &F::reference_range_m,
              {.unit = "m", .min = 0.001, .max = 1000.0, .doc = "variable: where the level is the threshold itself"}),
        field("absorption_db_m", &F::absorption_db_m,
              {.unit = "dB/m", .min = 0.0, .max = 100.0, .doc = "variable: what air takes away per metre of path"}),
        field("gain_min", &F::gain_min,
              {.min = 1e-6, .max = 1.0, .doc = "variable: the level falls to this share of the threshold at most"}),
        field("rise_max_s", &F::rise_max_s,
              {.unit = "s", .min = 0.0, .max = 1.0, .doc = "double: an edge that takes longer to double is no echo"})};
  }
};

/// A sampled envelope: sample k was taken `start_s` + k `period_s` after the transmission. Any unit, not negative.
struct Envelope {
  std::span<const double> samples;
  double period_s = 0.0;
  double start_s = 0.0;
};

/// Time of flight of the first echo in seconds; no value when there is none. O(samples).
/// Errors: a sample or time that is not finite, a period that is not positive.
[[nodiscard]] Result<std::optional<double>> flight_time_s(const Envelope& envelope,
                                                          const FlightTimeOptions& options = {});

}  // namespace echoarc
