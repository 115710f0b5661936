// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name. Every operation is exact or correctly rounded in
// all instruction sets, so that all give the same bytes.

#include "mapping/cell_blocks_isa.hpp"
#include "mapping/evidence_kernels.hpp"

#define ECHOARC_TEXT_OF(x) #x
#define ECHOARC_TEXT(x) ECHOARC_TEXT_OF(x)

namespace echoarc::kernels::ECHOARC_ISA {

void split_rows(const SplitShape&, const Runs&, const RowEdges&);
void bounds(const Runs&, std::int32_t*, std::int32_t*);

namespace {

void add_constant(const TileRow& row, const Runs& runs, std::int16_t increment) {
  const Block change = repeated(increment);
  for_each_segment(row, runs,
                   [&](std::int16_t* cells, std::int32_t, std::int32_t, std::int32_t begin, std::int32_t end) {
                     // All of the tile's row, masked: four blocks cost less than a branch that is mispredicted.
                     const Inside inside(begin, end);
                     for (std::int32_t l = 0; l < tile_size; l += block_size)
                       store(saturating_sum(load<Block>(cells + l), change & inside.block(l)), cells + l);
                   });
}

/// Where cells lie in a beam, in cells: distance from the axis, squared distance from the apex.
struct Place {
  Floats across;
  Floats squared;
};

/// Finds the places of cells. In cells, the distances of columns and rows from the apex are one offset and a whole
/// number each: exact until they meet. So a cell's change does not depend on where in its tile or in a block it lies,
/// and turning the grid by 90 degrees gives the same bits.
class BeamView {
 public:
  /// `across_scale` multiplies the distances from the axis.
  BeamView(const BeamFrame& beam, float across_scale)
      : apex_i_(beam.apex_i),
        apex_j_(beam.apex_j),
        offset_x_(beam.offset_x_m / beam.cell_m),
        offset_y_(beam.offset_y_m / beam.cell_m),
        axis_x_(beam.axis_x * across_scale),
        axis_y_(beam.axis_y * across_scale) {}

  [[nodiscard]] float dy(std::int32_t j) const { return offset_y_ + static_cast<float>(j - apex_j_); }
  [[nodiscard]] Floats dy(const Ints& j) const { return offset_y_ + __builtin_convertvector(j - apex_j_, Floats); }
  [[nodiscard]] Floats dx(const Ints& i) const { return offset_x_ + __builtin_convertvector(i - apex_i_, Floats); }
  /// Of the columns i ... i + 7.
  [[nodiscard]] Floats dx(std::int32_t i) const {
    constexpr Floats lanes = {0, 1, 2, 3, 4, 5, 6, 7};
    return offset_x_ + (static_cast<float>(i - apex_i_) + lanes);
  }
  template <class Dy>  // float: all in one row
  [[nodiscard]] Place place(const Floats& dx, const Dy& dy) const {
    return {axis_x_ * dy - axis_y_ * dx, dx * dx + dy * dy};
  }
  /// The same in two parts: the place is {row.across - column.across, column.squared + row.squared}.
  [[nodiscard]] Place row_part(float dy) const { return {repeated(axis_x_ * dy), repeated(dy * dy)}; }
  [[nodiscard]] Place column_part(const Floats& dx) const { return {axis_y_ * dx, dx * dx}; }

 private:
  std::int32_t apex_i_;
  std::int32_t apex_j_;
  float offset_x_;
  float offset_y_;
  float axis_x_;
  float axis_y_;
};

/// Adds `change(low, high)` to the cells of the runs, of the places of the lower and the upper half of a block.
template <class Change>
inline void add_cells(const TileRow& row, const Runs& runs, const BeamView& view, Change&& change) {
  for_each_segment(row, runs,
                   [&](std::int16_t* cells, std::int32_t i, std::int32_t j, std::int32_t begin, std::int32_t end) {
                     const float dy = view.dy(j);
                     add_blocks(cells, begin, end, [&](std::int32_t l) {
                       return change(view.place(view.dx(i + l), dy), view.place(view.dx(i + l + block_size / 2), dy));
                     });
                   });
}

/// y = s / (1 + bend s) of s = sin^2 theta.
inline Floats bent_sine_squared(const Place& place, const Floats& bend) {
  const Floats across_squared = place.across * place.across;
  return across_squared / (place.squared + bend * across_squared);
}

template <int terms>
inline Floats value(const Polynomial& polynomial, const Floats& x) {
  Floats sum = repeated(polynomial.c[terms - 1]);
  for (int k = terms - 2; k >= 0; --k) sum = sum * x + polynomial.c[k];
  return sum;
}

void add_angular(const TileRow& row, const Runs& runs, const BeamFrame& beam, const Polynomial& increment) {
  const Floats bend = repeated(increment.bend);
  const auto of = [&](const Place& place) { return value<max_terms>(increment, bent_sine_squared(place, bend)); };
  add_cells(row, runs, BeamView(beam, 1.0F),
            [&](const Place& low, const Place& high) { return rounded(of(low), of(high)); });
}

/// What each column that runs span gives to the places of its cells. Blocks may begin before a run and end after it.
class ColumnParts {
 public:
  ColumnParts(const Runs& runs, const BeamView& view, ColumnScratch scratch) {
    std::int32_t begin = 0;
    std::int32_t end = 0;
    bounds(runs, &begin, &end);
    const std::int32_t count = end > begin ? (end - begin + 3 * block_size) & ~(block_size - 1) : 0;
    first_ = begin - block_size;
    across_ = scratch.values;
    squared_ = scratch.values + count;
    for (std::int32_t k = 0; k < count; k += block_size / 2) {
      const Place part = view.column_part(view.dx(first_ + k));
      store(part.across, across_ + k);
      store(part.squared, squared_ + k);
    }
  }
  /// Of the columns i ... i + 7 in a row.
  [[nodiscard]] Place place(std::int32_t i, const Place& row_part) const {
    return {row_part.across - load<Floats>(across_ + (i - first_)),
            load<Floats>(squared_ + (i - first_)) + row_part.squared};
  }

 private:
  std::int32_t first_;
  float* across_;
  float* squared_;
};

template <int terms>
void add_fixed_terms(const TileRow& row, const Runs& runs, const BeamFrame& beam, const FixedPolynomial& increment,
                     ColumnScratch scratch) {
  const BeamView view(beam, increment.across_scale);
  const ColumnParts columns(runs, view, scratch);
  const Floats bend = repeated(increment.bend);
  const auto argument = [&](const Place& place) { return bent_sine_squared(place, bend) + fixed_begin; };
  Block c[terms];
  for (int k = 0; k < terms; ++k) c[k] = repeated(increment.c[k]);
  const Block unit = repeated(increment.unit);
  for_each_segment(row, runs,
                   [&](std::int16_t* cells, std::int32_t i, std::int32_t j, std::int32_t begin, std::int32_t end) {
                     const Place row_part = view.row_part(view.dy(j));
                     add_blocks(cells, begin, end, [&](std::int32_t l) {
                       const Place low = columns.place(i + l, row_part);
                       const Place high = columns.place(i + l + block_size / 2, row_part);
                       const Block z = rounded(argument(low), argument(high));
                       Block sum = c[terms - 1];
                       for (int k = terms - 2; k >= 0; --k) sum = fixed_product(sum, z) + c[k];
                       return fixed_product(sum, unit);
                     });
                   });
}

void add_fixed(const TileRow& row, const Runs& runs, const BeamFrame& beam, const FixedPolynomial& increment,
               ColumnScratch scratch) {
  if (runs.count == 0) return;
  if (increment.terms <= 5)  // the default beam
    add_fixed_terms<5>(row, runs, beam, increment, scratch);
  else
    add_fixed_terms<max_fixed_terms>(row, runs, beam, increment, scratch);
}

/// Cells of many short runs side by side, so that the model is worked out for full vectors of them.
struct ScatteredCells {
  static constexpr std::int32_t capacity = 512;
  static constexpr std::int32_t slack = block_size;

  /// Of the block at `cells`, the lanes begin <= l < end; lane l changes by change[from + l].
  struct Piece {
    std::int16_t* cells;
    std::int16_t from;
    std::int16_t begin;
    std::int16_t end;
  };

  Piece pieces[capacity];
  alignas(32) std::int32_t i[capacity + block_size];  // beyond the cells: anything
  alignas(32) std::int32_t j[capacity + block_size];
  alignas(32) std::int16_t change[slack + capacity + block_size];

  void add(std::int32_t piece_count) const {
    for (const Piece* piece = pieces; piece < pieces + piece_count; ++piece) {
      const Block inside = Inside(piece->begin, piece->end).block(0);
      store(saturating_sum(load<Block>(piece->cells), load<Block>(change + piece->from) & inside), piece->cells);
    }
  }
};

/// Adds `change(low, high)`, of the places of the halves of a block, to the cells of runs that are mostly short.
template <class Change>
inline void add_scattered(const TileRow& row, const Runs& left, const Runs& right, const BeamView& view,
                          Change&& change) {
  constexpr std::int32_t chunk = block_size / 2;
  constexpr Ints lanes = {0, 1, 2, 3, 4, 5, 6, 7};
  ScatteredCells s;
  std::int32_t cell_count = 0;
  std::int32_t piece_count = 0;
  const auto add_taken = [&] {
    const auto place = [&](std::int32_t k) {
      return view.place(view.dx(load<Ints>(s.i + k)), view.dy(load<Ints>(s.j + k)));
    };
    for (std::int32_t k = 0; k < cell_count; k += block_size)
      store(change(place(k), place(k + chunk)), s.change + s.slack + k);
    s.add(piece_count);
    cell_count = piece_count = 0;
  };
  const auto take = [&](std::int16_t* cells, std::int32_t i, std::int32_t j, std::int32_t begin, std::int32_t end) {
    for (std::int32_t l = begin; l < end; l += chunk) {
      const std::int32_t first = l < tile_size - block_size ? l : tile_size - block_size;
      const std::int32_t to = end - l < chunk ? end : l + chunk;
      s.pieces[piece_count++] = {cells + first, std::int16_t(s.slack + cell_count + first - l), std::int16_t(l - first),
                                 std::int16_t(to - first)};
      store(i + l + lanes, s.i + cell_count);
      store(j + Ints{}, s.j + cell_count);
      cell_count += to - l;
      if (cell_count > s.capacity - chunk) add_taken();
    }
  };
  const Runs* const both[] = {&left, &right};
  for (const Runs* runs : both) for_each_segment(row, *runs, take);
  add_taken();
}

template <int angular_terms, int radial_terms, int logit_terms>
void add_band_terms(const TileRow& row, const Runs& left, const Runs& right, const BeamFrame& beam,
                    const BandModel& band) {
  const BeamView view(beam, 1.0F);
  const float cell_m = beam.cell_m;
  const float range_m = beam.range_m;
  const Floats bend = repeated(band.angular.bend);
  const auto angular_factor = [&](const Place& place) {
    if constexpr (angular_terms == 1)
      return repeated(band.angular.c[0]);
    else
      return value<angular_terms>(band.angular, bent_sine_squared(place, bend));
  };
  const auto of = [&](const Place& place) {
    const Floats error = square_root(place.squared) * cell_m - range_m;
    const Floats height = value<radial_terms>(band.radial, error * error) * angular_factor(place);
    return height * value<logit_terms>(band.logit, height * height);
  };
  add_scattered(row, left, right, view,
                [&](const Place& low, const Place& high) { return rounded(of(low), of(high)); });
}

void add_band(const TileRow& row, const Runs& left, const Runs& right, const BeamFrame& beam, const BandModel& band) {
  const bool usual = band.radial.terms <= 7 && band.logit.terms <= 5;  // up to the default certainty
  if (usual && band.angular.terms == 1)                                // no profile: the factor is 1
    add_band_terms<1, 7, 5>(row, left, right, beam, band);
  else if (usual && band.angular.terms <= 6)
    add_band_terms<6, 7, 5>(row, left, right, beam, band);
  else
    add_band_terms<max_terms, max_terms, max_terms>(row, left, right, beam, band);
}

}  // namespace

extern const EvidenceKernels table;
const EvidenceKernels table{
    ECHOARC_TEXT(ECHOARC_ISA), split_rows, bounds, add_constant, add_fixed, add_angular, add_band};

}  // namespace echoarc::kernels::ECHOARC_ISA
