// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "core/quartic_roots.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {
namespace {

/// Coefficients over a piece of the interval in Bernstein form: the polynomial lies in the hull of its coefficients, so
/// without a change of sign among them there is no root, with one change there is exactly one (Descartes).
struct Piece {
  Quartic b;
  double begin;
  double end;
};

/// Zero counts as positive throughout: a root on a border belongs to exactly one of the pieces.
bool negative(double value) {
  return value < 0.0;
}

int sign_changes(const Quartic& b) {
  int changes = 0;
  for (std::size_t k = 1; k < b.size(); ++k) changes += negative(b[k]) != negative(b[k - 1]) ? 1 : 0;
  return changes;
}

Piece bernstein(const Quartic& c, double begin, double end) {
  // Taylor shift to `begin` by repeated Horner steps, scaling to [0, 1], then b_i = sum_j C(i,j) / C(4,j) c_j.
  Quartic s = c;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 3; j + 1 > k; --j) s[j] += begin * s[j + 1];
  const double h = end - begin;
  const double c1 = s[1] * h / 4.0;
  const double c2 = s[2] * (h * h) / 6.0;
  const double c3 = s[3] * (h * h * h) / 4.0;
  const double c4 = s[4] * (h * h * h * h);
  const double c0 = s[0];
  return {{c0, c0 + c1, c0 + 2.0 * c1 + c2, c0 + 3.0 * c1 + 3.0 * c2 + c3, c0 + 4.0 * c1 + 6.0 * c2 + 4.0 * c3 + c4},
          begin,
          end};
}

/// Both halves of a piece (de Casteljau).
std::array<Piece, 2> halves(const Piece& piece) {
  const double middle = 0.5 * (piece.begin + piece.end);
  Piece low{piece.b, piece.begin, middle};
  Piece high{piece.b, middle, piece.end};
  for (std::size_t level = 1; level < 5; ++level) {
    for (std::size_t k = 0; k + level < 5; ++k) high.b[k] = 0.5 * (high.b[k] + high.b[k + 1]);
    low.b[level] = high.b[0];
  }
  return {low, high};
}

struct Value {
  double f;
  double slope;
};

Value evaluate(const Quartic& c, double u) {
  Value v{c[4], 0.0};
  for (int k = 3; k >= 0; --k) {
    v.slope = v.slope * u + v.f;
    v.f = v.f * u + c[std::size_t(k)];
  }
  return v;
}

/// The only root of the piece: Newton's steps, held inside a bracket by bisection.
double refine(const Quartic& c, const Piece& piece) {
  double low = piece.begin;
  double high = piece.end;
  const bool low_negative = negative(piece.b[0]);
  double u = low + (high - low) * (piece.b[0] / (piece.b[0] - piece.b[4]));
  constexpr int enough = 80;
  constexpr double converging = 1e-10;  // a step this small has doubled its digits: what is left is rounding
  for (int k = 0; k < enough; ++k) {
    if (!(u > low && u < high)) u = 0.5 * (low + high);
    const auto [f, slope] = evaluate(c, u);
    (negative(f) == low_negative ? low : high) = u;
    const double step = f / slope;
    u -= step;
    if (std::abs(step) < converging) return u;
  }
  return u;
}

}  // namespace

QuarticRoots roots_between(const Quartic& c, double begin, double end, double noise) {
  QuarticRoots roots;
  const Piece whole = bernstein(c, begin, end);
  const int changes = sign_changes(whole.b);
  if (changes == 0) return roots;
  if (std::ranges::all_of(whole.b, [&](double b) { return std::abs(b) <= noise; })) return roots;
  if (changes == 1) {
    roots.u[roots.count++] = refine(c, whole);
    return roots;
  }
  const double narrowest = 1e-9 * (end - begin);
  // Depth first, lower half first: the stack never holds more than one piece per halving and one more.
  std::array<Piece, 64> stack;
  std::size_t depth = 0;
  stack[depth++] = whole;
  while (depth > 0 && roots.count < roots.u.size()) {
    const Piece piece = stack[--depth];
    const int inside = sign_changes(piece.b);
    if (inside == 0) continue;
    const bool narrow = piece.end - piece.begin < narrowest;
    if (inside == 1 || (narrow && inside == 3)) {
      roots.u[roots.count++] = refine(c, piece);
    } else if (!narrow) {
      const auto [low, high] = halves(piece);
      stack[depth++] = high;
      stack[depth++] = low;
    }
  }
  return roots;
}

}  // namespace echoarc
