// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/contestant.hpp"
#include "bench/floor_kernels.hpp"
#include "bench/workload.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/maps/sector_raster.hpp"

namespace echoarc::bench {

namespace plain {
extern const FloorKernels floor_table;
}
#ifdef ECHOARC_HAVE_AVX2
namespace avx2 {
extern const FloorKernels floor_table;
}
#endif

const FloorKernels& floor_kernels() {
#ifdef ECHOARC_HAVE_AVX2
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  if (has_avx2) return avx2::floor_table;
#endif
  return plain::floor_table;
}

namespace {

constexpr double band_m = 0.04;  // as far beyond an echo as the evidence grid's band reaches: two range sigmas

class FloorGrid final : public Contestant {
 public:
  explicit FloorGrid(double cell_m)
      : area_(workload_area(cell_m)), raster_(area_.geometry), grid_(area_.geometry, area_.width, area_.height) {}

  std::string name() const override { return "floor"; }
  void prepare(std::span<const Reading> readings) override { readings_ = readings; }

  void insert() override {
    const FloorKernels& kernels = floor_kernels();
    const auto width = std::size_t(area_.width);
    float* const cells = grid_.values().data();
    for (const Reading& reading : readings_)
      for (const RowSpan& span : raster_.spans(rim_of(reading, band_m)))
        kernels.add(cells + std::size_t(span.j) * width + std::size_t(span.i_begin),
                    std::size_t(span.i_end - span.i_begin), 0.5F);
  }

  double cells_per_reading(std::span<const Reading> readings) const override {
    SectorRaster raster(area_.geometry);
    double cells = 0.0;
    for (const Reading& reading : readings)
      for (const RowSpan& span : raster.spans(rim_of(reading, band_m))) cells += span.i_end - span.i_begin;
    return cells / double(readings.size());
  }

 private:
  DenseArea area_;
  SectorRaster raster_;
  DenseGrid<float> grid_;
  std::span<const Reading> readings_;
};

}  // namespace

std::unique_ptr<Contestant> make_floor(double cell_m) {
  return std::make_unique<FloorGrid>(cell_m);
}

}  // namespace echoarc::bench
