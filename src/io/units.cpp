// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/units.hpp"

#include <array>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace echoarc::io {
namespace {

struct Unit {
  std::string_view name;
  Dimension dimension;
  double si;
};
constexpr double degree = std::numbers::pi / 180.0;
constexpr std::array units = {
    Unit{"s", Dimension::time, 1.0},
    Unit{"ms", Dimension::time, 1e-3},
    Unit{"us", Dimension::time, 1e-6},
    Unit{"ns", Dimension::time, 1e-9},
    Unit{"m", Dimension::length, 1.0},
    Unit{"dm", Dimension::length, 0.1},
    Unit{"cm", Dimension::length, 0.01},
    Unit{"mm", Dimension::length, 1e-3},
    Unit{"km", Dimension::length, 1e3},
    Unit{"in", Dimension::length, 0.0254},
    Unit{"ft", Dimension::length, 0.3048},
    Unit{"rad", Dimension::angle, 1.0},
    Unit{"mrad", Dimension::angle, 1e-3},
    Unit{"deg", Dimension::angle, degree},
    Unit{"0.1deg", Dimension::angle, 0.1 * degree},
    Unit{"0.01deg", Dimension::angle, 0.01 * degree},
};

}  // namespace

Dimension dimension_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::time: return Dimension::time;
    case Quantity::yaw: return Dimension::angle;
    case Quantity::sensor: return Dimension::none;
    case Quantity::x:
    case Quantity::y:
    case Quantity::left_wheel:
    case Quantity::right_wheel:
    case Quantity::range:
    case Quantity::scan: return Dimension::length;
  }
  return Dimension::none;
}

std::optional<double> si_scale(Dimension dimension, std::string_view unit) {
  for (const Unit& known : units)
    if (known.dimension == dimension && known.name == unit) return known.si;
  return std::nullopt;
}

std::string units_of(Dimension dimension) {
  std::vector<std::string_view> names;
  for (const Unit& known : units)
    if (known.dimension == dimension) names.push_back(known.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace echoarc::io
