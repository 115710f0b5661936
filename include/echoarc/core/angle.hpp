// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace echoarc {

/// A plane angle. Made by `radians()` or `degrees()` alone, so that no call site can mistake the unit.
/// Counter-clockwise is positive. Values are not normalised; see `wrap`.
class Angle {
 public:
  constexpr Angle() = default;

  [[nodiscard]] constexpr double rad() const { return rad_; }
  [[nodiscard]] constexpr double deg() const { return rad_ * (180.0 / std::numbers::pi); }

  friend constexpr auto operator<=>(Angle, Angle) = default;
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle{a.rad_ + b.rad_}; }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle{a.rad_ - b.rad_}; }
  friend constexpr Angle operator-(Angle a) { return Angle{-a.rad_}; }
  friend constexpr Angle operator*(Angle a, double k) { return Angle{a.rad_ * k}; }
  friend constexpr Angle operator*(double k, Angle a) { return Angle{a.rad_ * k}; }
  friend constexpr Angle operator/(Angle a, double k) { return Angle{a.rad_ / k}; }
  friend constexpr double operator/(Angle a, Angle b) { return a.rad_ / b.rad_; }
  constexpr Angle& operator+=(Angle b) { return *this = *this + b; }
  constexpr Angle& operator-=(Angle b) { return *this = *this - b; }

  friend constexpr Angle radians(double value);
  friend constexpr Angle degrees(double value);

 private:
  explicit constexpr Angle(double rad) : rad_(rad) {}
  double rad_ = 0.0;
};

[[nodiscard]] constexpr Angle radians(double value) {
  return Angle{value};
}
[[nodiscard]] constexpr Angle degrees(double value) {
  return Angle{value * (std::numbers::pi / 180.0)};
}

/// The same direction in (-pi, pi]. Directions are compared only through this function, so wrap-around needs no special
/// cases anywhere else.
[[nodiscard]] inline Angle wrap(Angle a) {
  const double r = std::remainder(a.rad(), 2.0 * std::numbers::pi);  // in [-pi, pi]
  return radians(r <= -std::numbers::pi ? std::numbers::pi : r);
}

[[nodiscard]] inline double sin(Angle a) {
  return std::sin(a.rad());
}
[[nodiscard]] inline double cos(Angle a) {
  return std::cos(a.rad());
}
[[nodiscard]] inline double tan(Angle a) {
  return std::tan(a.rad());
}
[[nodiscard]] inline Angle abs(Angle a) {
  return radians(std::abs(a.rad()));
}
[[nodiscard]] inline bool is_finite(Angle a) {
  return std::isfinite(a.rad());
}

}  // namespace echoarc
