// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The inner loops of the evidence grid, compiled once per instruction set (cmake/EchoarcKernels.cmake). This header and
// the kernel source include nothing that holds inline functions: two copies of one, compiled with different flags, must
// never meet in the linker.

#include <cstddef>
#include <cstdint>

namespace echoarc::kernels {

/// One run of cells in each of consecutive rows: begin[k] <= i < end[k] of row j_first + k; empty where end <= begin.
/// The rows of one call of a kernel that adds lie in one row of tiles.
struct Runs {
  std::int32_t j_first;
  const std::int32_t* begin;
  const std::int32_t* end;
  std::int32_t count;
};

/// Two circles about the apex of a sector, in cells with cell centres at whole numbers: the far one ends what is free,
/// the near one what is too close to say. A squared radius below 0 is no circle.
struct SplitShape {
  double apex_j;
  double free_squared;
  double near_squared;
  double outside;          ///< no cell of the sector is as far from the apex
  std::int32_t i_below;    ///< a column left of all of them; columns are counted from it, so that truncation is floor
  std::int32_t i_above;    ///< a column right of all of them; counted down from it, truncation is ceil
  double apex_from_below;  ///< apex_i - i_below
  double apex_from_above;  ///< i_above - apex_i
};

/// The columns of a sector's rows, and those at which they change from band to free to too near to free to band.
struct RowEdges {
  std::int32_t* begin;
  std::int32_t* free_begin;
  std::int32_t* near_begin;
  std::int32_t* near_end;
  std::int32_t* free_end;
  std::int32_t* end;
};

/// The tiles of one row of tiles: `tiles[k]` holds the columns from (first_column + k) * 64 on. Tiles no run meets may
/// be null.
struct TileRow {
  std::int16_t* const* tiles;
  std::int32_t first_column;
  std::int32_t count;
};

/// Room for what depends on a cell's column alone: two floats for each column of the tiles, and `margin` more.
struct ColumnScratch {
  static constexpr std::size_t margin = 128;
  float* values;
};

/// Where a beam stands in the grid. Cell (i, j) has its centre at offset_m + (i - apex_i, j - apex_j) * cell_m from the
/// apex; counting from the apex keeps single precision exact enough wherever in the world the robot is.
struct BeamFrame {
  std::int32_t apex_i;
  std::int32_t apex_j;
  float offset_x_m;
  float offset_y_m;
  float cell_m;
  float axis_x;  ///< unit vector of the acoustic axis
  float axis_y;
  float range_m;  ///< of the echo
};

inline constexpr int max_terms = 12;

/// c[0] + c[1] y + ... + c[terms - 1] y^(terms - 1); coefficients above are 0. The argument of an angular polynomial is
/// y = s / (1 + bend s), s = sin^2 theta: bent rightly, log-odds need a third fewer terms, at the price of a
/// multiplication and an addition. Elsewhere `bend` is 0.
struct Polynomial {
  float c[max_terms];
  int terms;
  float bend;
};

inline constexpr int max_fixed_terms = 8;
inline constexpr float fixed_begin = -32767.0F;
inline constexpr float fixed_end = 32767.0F * 31 / 32;  ///< short of the last, so that rounding cannot leave 16 bits

/// A polynomial in 16-bit fixed point. Its argument z, and every product, has 15 binary places:
///
///     increment = unit (c[0] + z (c[1] + z (...))),   2^15 z = fixed_begin + across_scale^2 y,
///
/// with y = s / (1 + across_scale^2 bend s), s = sin^2 theta. In the sector fixed_begin <= 2^15 z <= fixed_end.
struct FixedPolynomial {
  std::int16_t c[max_fixed_terms];
  std::int16_t unit;
  int terms;
  float across_scale;
  float bend;
};

/// The occupied band as a chain of polynomials: with h = angular(sin^2 theta) * radial(error^2) the increment is
/// h * logit(h^2).
struct BandModel {
  Polynomial angular;
  Polynomial radial;
  Polynomial logit;
};

/// All log-odds are in units of the grid (see log_odds_per_unit) and saturate as 16-bit integers do.
struct EvidenceKernels {
  const char* instruction_set;
  /// begin <= free_begin <= near_begin <= near_end <= free_end <= end in every row; all the same in empty ones.
  void (*split_rows)(const SplitShape& shape, const Runs& sector, const RowEdges& edges);
  /// All columns of the runs lie in *begin <= i < *end, and both ends are reached; *begin > *end without any.
  void (*bounds)(const Runs& runs, std::int32_t* begin, std::int32_t* end);
  void (*add_constant)(const TileRow& row, const Runs& runs, std::int16_t increment);
  void (*add_fixed)(const TileRow& row, const Runs& runs, const BeamFrame& beam, const FixedPolynomial& increment,
                    ColumnScratch scratch);
  void (*add_angular)(const TileRow& row, const Runs& runs, const BeamFrame& beam, const Polynomial& increment);
  /// The band left of what is free and right of it at once: the runs of both are mostly short.
  void (*add_band)(const TileRow& row, const Runs& left, const Runs& right, const BeamFrame& beam,
                   const BandModel& band);
};

/// The kernels for this processor, chosen once. All of them give the same bytes.
const EvidenceKernels& evidence_kernels();
/// Every set of kernels this processor can run; the first is the plain one.
std::size_t available_evidence_kernels(const EvidenceKernels** list, std::size_t room);

}  // namespace echoarc::kernels
