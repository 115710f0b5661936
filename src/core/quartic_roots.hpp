// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>

namespace echoarc {

/// c[0] + c[1] u + ... + c[4] u^4.
using Quartic = std::array<double, 5>;

struct QuarticRoots {
  std::array<double, 4> u{};
  std::size_t count = 0;
};

/// The simple roots in [begin, end], ascending, to rounding. Pairs of roots closer than 1e-9 of the interval count as
/// none: there the polynomial touches zero. `noise` bounds the error of the coefficients: a polynomial that nowhere
/// exceeds it is zero and has no roots.
[[nodiscard]] QuarticRoots roots_between(const Quartic& c, double begin, double end, double noise);

}  // namespace echoarc
