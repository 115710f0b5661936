// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/scene_curve.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "io/toml_points.hpp"

namespace echoarc::io {
namespace {

constexpr double sample_step_m = 0.002;
constexpr double max_length_m = 400.0;  // 200 000 samples
constexpr std::size_t max_terms = 64;
constexpr std::size_t max_knots = 10'000;
constexpr double farthest_m = 1e5;

std::vector<Vec2> too_long(TomlFields& fields, double length_m) {
  fields.fail(nullptr, fmt::format("the curve would be {:.6g} m long", length_m),
              fmt::format("keep it below {} m, or divide it", max_length_m));
  return {};
}

/// amplitude cos(rad_per_m x + phase)
struct Wave {
  double amplitude_m = 0.0;
  double rad_per_m = 0.0;
  double phase_rad = 0.0;
};

std::vector<Wave> read_waves(TomlFields& fields, std::string_view key, double shift_rad) {
  const toml::array* list = fields.array(key);
  if (list == nullptr) return {};
  if (list->size() > max_terms)
    fields.fail(list, fmt::format("{} has more than {} terms", key, max_terms), "drop some");
  std::vector<Wave> waves;
  for (const toml::node& element : *list) {
    const auto term = toml_numbers(fields, element, 3, fmt::format("a term of {}", key),
                                   "[0.16, 2.6, 0.5]: amplitude in m, radians per metre of x, phase in radians");
    if (!term) return {};
    waves.push_back({(*term)[0], (*term)[1], (*term)[2] + shift_rad});
  }
  return waves;
}

std::vector<double> read_polynomial(TomlFields& fields) {
  const toml::array* list = fields.array("polynomial");
  if (list == nullptr) return {};
  return toml_numbers(fields, *list, std::min(list->size(), max_terms), "polynomial",
                      "polynomial = [1.0, 0.0, 0.2], the factors of 1, x, x^2, ...")
      .value_or(std::vector<double>{});
}

/// y(x) as a sum of waves and a polynomial.
struct Profile {
  std::vector<Wave> waves;
  std::vector<double> polynomial;

  [[nodiscard]] double at(double x) const {
    double y = 0.0;
    for (const Wave& wave : waves) y += wave.amplitude_m * std::cos(wave.rad_per_m * x + wave.phase_rad);
    double power = 1.0;
    for (const double factor : polynomial) {
      y += factor * power;
      power *= x;
    }
    return y;
  }

  /// No slope of the profile for |x| <= reach exceeds this.
  [[nodiscard]] double steepest(double reach) const {
    double slope = 0.0;
    for (const Wave& wave : waves) slope += std::abs(wave.amplitude_m * wave.rad_per_m);
    double power = 1.0;
    for (std::size_t i = 1; i < polynomial.size(); ++i) {
      slope += static_cast<double>(i) * std::abs(polynomial[i]) * power;
      power *= reach;
    }
    return slope;
  }
};

std::vector<Vec2> read_profile(TomlFields& fields) {
  const toml::node* interval_node = fields.node("x");
  const auto interval =
      interval_node != nullptr ? toml_numbers(fields, *interval_node, 2, "x", "x = [-1.0, 1.0]") : std::nullopt;
  Profile profile{read_waves(fields, "cosines", 0.0), read_polynomial(fields)};
  for (const Wave& wave : read_waves(fields, "sines", -std::acos(0.0))) profile.waves.push_back(wave);
  profile.polynomial.resize(std::max<std::size_t>(profile.polynomial.size(), 1));
  profile.polynomial[0] += fields.length_m("y", -farthest_m, farthest_m).value_or(0.0);
  if (!interval) return {};
  const double from = (*interval)[0];
  const double to = (*interval)[1];
  if (!(from < to)) {
    fields.fail(interval_node, "x does not go from left to right", "write x = [-1.0, 1.0], the smaller first");
    return {};
  }
  const double length_m = (to - from) * std::hypot(1.0, profile.steepest(std::max(std::abs(from), std::abs(to))));
  if (!(length_m <= max_length_m)) return too_long(fields, length_m);
  const int steps = std::max(2, static_cast<int>(std::ceil(length_m / sample_step_m * (1.0 + 1e-9))));
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) {
    const double x = from + (to - from) * i / steps;
    points.push_back({x, profile.at(x)});
  }
  return points;
}

std::vector<Vec2> read_circle_part(TomlFields& fields) {
  const std::optional<Vec2> centre = read_point(fields, "centre");
  const double radius_m = required_length_m(fields, "radius", 0.001, farthest_m);
  const double from_deg = required_number(fields, "from_deg", -3600.0, 3600.0);
  const double to_deg = required_number(fields, "to_deg", -3600.0, 3600.0);
  if (!centre) return {};
  if (!(std::abs(to_deg - from_deg) < 360.0)) {
    fields.fail(nullptr, "a curve cannot go all around a circle", "use [[disc]]");
    return {};
  }
  const double length_m = radius_m * std::abs((degrees(to_deg) - degrees(from_deg)).rad());
  if (!(length_m <= max_length_m)) return too_long(fields, length_m);
  const int steps = std::max(2, static_cast<int>(std::ceil(length_m / sample_step_m)));
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i)
    points.push_back(*centre + radius_m * unit(degrees(from_deg + (to_deg - from_deg) * i / steps)));
  return points;
}

/// The piece b..c of a centripetal Catmull-Rom spline (Barry and Goldman 1988), at share t in [0, 1].
Vec2 catmull_rom(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double t) {
  const auto knot = [](Vec2 p, Vec2 q) { return std::sqrt(norm(q - p)); };
  const double t1 = knot(a, b);
  const double t2 = t1 + knot(b, c);
  const double t3 = t2 + knot(c, d);
  const double u = t1 + (t2 - t1) * t;
  const auto mix = [u](Vec2 p, Vec2 q, double p_at, double q_at) {
    return (q_at - u) / (q_at - p_at) * p + (u - p_at) / (q_at - p_at) * q;
  };
  const Vec2 ab = mix(a, b, 0.0, t1);
  const Vec2 bc = mix(b, c, t1, t2);
  const Vec2 cd = mix(c, d, t2, t3);
  return mix(mix(ab, bc, 0.0, t2), mix(bc, cd, t1, t3), t1, t2);
}

/// Samples a piece at most 2 mm apart: as many as needed, doubled until they are.
void append_piece(std::vector<Vec2>& points, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  int steps = std::max(1, static_cast<int>(std::ceil(norm(c - b) / sample_step_m * 1.1)));
  std::vector<Vec2> piece;
  for (bool fine = false; !fine; steps *= 2) {
    piece.assign(1, b);
    fine = true;
    for (int i = 1; i <= steps; ++i) {
      piece.push_back(i == steps ? c : catmull_rom(a, b, c, d, static_cast<double>(i) / steps));
      fine = fine && norm(piece.back() - piece[piece.size() - 2]) <= sample_step_m;
    }
  }
  points.insert(points.end(), piece.begin() + 1, piece.end());
}

std::vector<Vec2> read_spline(TomlFields& fields) {
  const std::vector<TomlPoint> knots = read_points(fields, "points", 3);
  if (knots.size() < 3) return {};
  if (knots.size() > max_knots) fields.fail(nullptr, fmt::format("more than {} points", max_knots), "use fewer");
  double length_m = 0.0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double step_m = norm(knots[i].point - knots[i - 1].point);
    if (!(step_m > 1e-6)) {
      fields.fail(nullptr, fmt::format("points {} and {} of the curve are the same", i, i + 1), "drop one of them");
      return {};
    }
    length_m += step_m;
  }
  if (!(length_m <= max_length_m)) return too_long(fields, length_m);
  const std::size_t last = knots.size() - 1;
  std::vector<Vec2> points{knots.front().point};
  for (std::size_t i = 0; i < last; ++i) {
    const Vec2 b = knots[i].point;
    const Vec2 c = knots[i + 1].point;
    // Beyond the ends the curve goes straight on.
    append_piece(points, i > 0 ? knots[i - 1].point : 2.0 * b - c, b, c,
                 i + 1 < last ? knots[i + 2].point : 2.0 * c - b);
  }
  return points;
}

}  // namespace

std::vector<Vec2> read_curve(TomlFields& fields) {
  const int forms = static_cast<int>(fields.has("x")) + static_cast<int>(fields.has("centre")) +
                    static_cast<int>(fields.has("points"));
  if (forms != 1) {
    fields.fail(nullptr, forms == 0 ? "the curve has no shape" : "the curve has more than one shape",
                "give one of x = [from, to] with cosines, sines or polynomial; centre and radius; points");
    return {};
  }
  if (fields.has("x")) return read_profile(fields);
  return fields.has("centre") ? read_circle_part(fields) : read_spline(fields);
}

}  // namespace echoarc::io
