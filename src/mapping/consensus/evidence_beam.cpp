// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/evidence_beam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mapping/fitted_beam.hpp"

namespace echoarc::consensus {
namespace {

constexpr Angle widest_rim = degrees(89.0);  // from the axis; wider sectors have no raster

/// Bearing from the arc's centre of the point whose normal is `t` off the axis; `t` itself on a circle.
Angle bearing_of_normal(const Arc& arc, Angle t) {
  if (arc.is_circular()) return t;
  return wrap(bearing(touch_point(arc, unit(arc.axis() + t)) - arc.centre()) - arc.axis());
}

/// The bin of a bearing, given its sine and a bin near it.
std::size_t bin_of(const std::vector<double>& edges, double sine, std::size_t near) {
  while (near + 2 < edges.size() && sine >= edges[near + 1]) ++near;
  while (near > 0 && sine < edges[near]) --near;
  return near;
}

std::int16_t free_units(double amplitude, double weight) {
  return static_cast<std::int16_t>(to_units(weight * log_odds(0.5 - amplitude)));
}

int band_units(const EvidenceBeam& beam, double distance_m, std::size_t bin) {
  const double z = (distance_m - *beam.echo_m) / beam.band_sigma_m;
  if (std::abs(z) > band_sigmas) return 0;
  return to_units(log_odds(0.5 + beam.amplitudes[bin] * std::exp(-0.5 * z * z)));
}

/// As `increment`; `bin` is a bin near the cell's, and becomes the cell's.
int increment_near(const EvidenceBeam& beam, Vec2 axis, Vec2 cell_centre, std::size_t& bin) {
  const Vec2 d = cell_centre - beam.rim.centre();
  const double from_centre_m = norm(d);
  const double sine = cross(axis, d) / from_centre_m;
  if (!(sine >= beam.edges.front() && sine <= beam.edges.back()) || dot(axis, d) <= 0.0) return 0;
  const double distance_m = beam.rim.is_circular() ? from_centre_m : beam.rim.half_path_m(cell_centre);
  bin = bin_of(beam.edges, sine, bin);
  if (distance_m >= beam.free_to_m) return beam.echo_m ? band_units(beam, distance_m, bin) : 0;
  return distance_m < beam.near_m ? 0 : beam.free_units[bin];
}

}  // namespace

std::vector<float> mixture(const Posterior& posterior) {
  const float wall = posterior.wall_share;
  std::vector<float> mixed(posterior.wall.size());
  for (std::size_t k = 0; k < mixed.size(); ++k)
    mixed[k] = wall * posterior.wall[k] + (1.0F - wall) * posterior.point[k];
  return mixed;
}

std::vector<double> spread(std::span<const float> posterior, const EchoArc& echo,
                           const ConsensusEvidenceOptions& options) {
  const auto count = std::ptrdiff_t(posterior.size());
  const double reach = options.spread_m / (echo.arc.range_m() * options.step.rad());
  const auto bins = std::ptrdiff_t(std::min(reach, double(count)));
  std::vector<double> sums{0.0};
  for (const float w : posterior) sums.push_back(sums.back() + double(w));
  std::vector<double> mass;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const double within =
        sums[std::size_t(std::min(count, k + bins + 1))] - sums[std::size_t(std::max<std::ptrdiff_t>(0, k - bins))];
    mass.push_back(std::clamp(within, 0.0, 1.0));
  }
  return mass;
}

std::optional<Arc> rim_of(const EchoArc& echo, const BeamBins& bins, const ConsensusEvidenceOptions& options) {
  const Angle search = (bins.half + 0.5) * options.step;
  const Angle widest = std::max(abs(bearing_of_normal(echo.arc, search)), abs(bearing_of_normal(echo.arc, -search)));
  const Angle half_width = std::min(widest, widest_rim);
  const double outer_m = echo.arc.range_m() + band_sigmas * options.band_sigma_m;
  const Angle axis = echo.arc.axis();
  if (echo.arc.is_circular()) return Arc::circular(echo.arc.centre(), axis, outer_m, 2.0 * half_width);
  return Arc::elliptical({echo.arc.transmitter(), axis}, {echo.arc.receiver(), axis}, outer_m, 2.0 * half_width);
}

EvidenceBeam echo_beam(const EchoArc& echo, const BeamBins& bins, std::span<const float> posterior, double near_m,
                       const ConsensusEvidenceOptions& options) {
  EvidenceBeam beam;
  beam.rim = *rim_of(echo, bins, options);
  beam.near_m = near_m;
  beam.echo_m = echo.arc.range_m();
  beam.free_to_m = *beam.echo_m - std::max(options.free_margin_m, band_sigmas * options.band_sigma_m);
  beam.band_sigma_m = options.band_sigma_m;
  const InverseSonarModel model{
      .profile = options.profile, .half_width = 0.5 * echo.beam_width, .angular_sigma = options.angular_sigma};
  const std::vector<double> mass = spread(posterior, echo, options);
  for (int k = 0; k < bins.count(); ++k) {
    const Angle t = (k - bins.half) * options.step;
    const double m = mass[std::size_t(k)];
    beam.edges.push_back(sin(bearing_of_normal(echo.arc, t - 0.5 * options.step)));
    beam.amplitudes.push_back((options.occupied_peak - 0.5) * m);
    const double free = std::max(m, options.free_beam * model.angular_factor(t));
    beam.free_units.push_back(free_units((0.5 - options.free_floor) * free, 1.0));
  }
  beam.edges.push_back(sin(bearing_of_normal(echo.arc, (bins.half + 0.5) * options.step)));
  return beam;
}

std::optional<EvidenceBeam> silence_beam(const Reading& reading, const ConsensusEvidenceOptions& options) {
  EvidenceBeam beam;
  beam.near_m = reading.range_min_m;
  beam.free_to_m = std::min(reading.trusted_range_m, reading.range_max_m);
  if (!is_no_echo(reading.outcome) || options.no_echo_weight <= 0.0) return std::nullopt;
  if (!(beam.free_to_m > std::max(0.0, beam.near_m))) return std::nullopt;  // trusted nowhere
  if (!(reading.beam_width > Angle{} && reading.beam_width < degrees(180.0))) return std::nullopt;
  Reading at_rim = reading;
  at_rim.outcome = Echo{beam.free_to_m};
  const auto rim = arc_of(at_rim);
  if (!rim) return std::nullopt;
  beam.rim = *rim;
  const InverseSonarModel model{.profile = options.profile,
                                .half_width = 0.5 * reading.beam_width,
                                .angular_sigma = options.angular_sigma,
                                .free_floor = options.free_floor};
  const int half = std::max(1, int(std::lround(model.half_width / options.step)));
  const Angle step = model.half_width / (half + 0.5);  // whole bins from edge to edge
  for (int k = -half; k <= half; ++k) {
    beam.edges.push_back(sin((k - 0.5) * step));
    const double amplitude = (0.5 - options.free_floor) * model.angular_factor(k * step);
    beam.free_units.push_back(free_units(amplitude, options.no_echo_weight));
  }
  beam.edges.push_back(1.0);  // the sector ends where the beam does
  beam.edges.front() = -1.0;
  return beam;
}

int increment(const EvidenceBeam& beam, Vec2 cell_centre) {
  std::size_t bin = beam.free_units.size() / 2;
  return increment_near(beam, unit(beam.rim.axis()), cell_centre, bin);
}

std::int16_t saturated(int units) {
  using Limits = std::numeric_limits<std::int16_t>;
  return static_cast<std::int16_t>(std::clamp<int>(units, Limits::min(), Limits::max()));
}

void apply(const EvidenceBeam& beam, SectorRaster& raster, TiledGrid<std::int16_t>& grid) {
  const Vec2 axis = unit(beam.rim.axis());
  for (const RowSpan& row : raster.spans(beam.rim)) {
    std::size_t bin = beam.free_units.size() / 2;
    for (Cell cell{row.i_begin, row.j}; cell.i < row.i_end; ++cell.i) {
      const int change = increment_near(beam, axis, grid.geometry().centre(cell), bin);
      if (change == 0) continue;
      std::int16_t& value = grid.at(cell);
      value = saturated(value + change);
    }
  }
}

}  // namespace echoarc::consensus
