// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/carved_cells.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {

std::optional<CarvedBeam> carved_beam(const Reading& reading, const CarvedGridOptions& options) {
  CarvedBeam beam;
  beam.near_m = reading.range_min_m;
  beam.echo_m = echo_range_m(reading.outcome);
  double outer_m = std::min(reading.trusted_range_m, reading.range_max_m);
  if (beam.echo_m) {
    const double band_m = band_sigmas * options.range_sigma_m;
    beam.free_to_m = *beam.echo_m - band_m;
    outer_m = *beam.echo_m + band_m;
  } else {
    beam.free_to_m = outer_m;
    beam.free_weight = options.no_echo_weight;
    if (!is_no_echo(reading.outcome) || !(outer_m > beam.near_m)) return std::nullopt;
  }
  Reading at_rim = reading;
  at_rim.outcome = Echo{outer_m};
  InsertCounters ignored;
  const auto rim = carvable_arc(at_rim, options.beam_policy, outer_m, ignored);
  if (!rim) return std::nullopt;
  beam.rim = *rim;
  return beam;
}

InverseSonarModel sonar_model(const CarvedGridOptions& options, Angle half_width) {
  return {.half_width = half_width,
          .angular_sigma = options.angular_sigma,
          .range_sigma_m = options.range_sigma_m,
          .occupied_peak = options.occupied_peak,
          .free_floor = options.free_floor};
}

double carved_increment(const CarvedBeam& beam, const InverseSonarModel& model, const BandAmplitude& amplitude,
                        Vec2 centre) {
  const double distance_m = beam.rim.half_path_m(centre);
  const Angle theta = wrap(bearing(centre - beam.rim.centre()) - beam.rim.axis());
  if (beam.echo_m && distance_m >= beam.free_to_m) {
    const double z = (distance_m - *beam.echo_m) / model.range_sigma_m;
    return std::abs(z) > band_sigmas ? 0.0 : log_odds(0.5 + amplitude(theta) * std::exp(-0.5 * z * z));
  }
  if (distance_m < beam.near_m || distance_m >= beam.free_to_m) return 0.0;
  return beam.free_weight * log_odds(model.free_probability(theta));
}

BandAmplitude gaussian_band(const InverseSonarModel& model) {
  return [model](Angle theta) { return (model.occupied_peak - 0.5) * model.angular_factor(theta); };
}

BandAmplitude remaining_band(const Remains& remains, const CarvedGridOptions& options) {
  if (remains.dead) return [](Angle) { return 0.0; };
  constexpr double certain = 0.45;
  const double uncarved = options.occupied_peak - 0.5;
  const Angle begin = remains.arc().t_begin();
  const Angle end = remains.arc().t_end();
  const double sharpness = 2.0 * remains.arc().half_width() / (4.0 * std::max(end - begin, min_arc));
  const double amplitude = uncarved + (certain - uncarved) * std::min(1.0, sharpness);
  return [=](Angle theta) { return theta >= begin && theta <= end ? amplitude : 0.0; };
}

}  // namespace echoarc
