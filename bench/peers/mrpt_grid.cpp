// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/peers/mrpt_grid.hpp"

#include <algorithm>
#include <utility>

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservationRange.h>
#include <mrpt/poses/CPose3D.h>

#include "bench/workload.hpp"

namespace echoarc::bench {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

/// MRPT treats a distance of at least `maxDistanceInsertion` as silence and clears half of that distance.
mrpt::obs::CObservationRange observation_of(const Reading& reading) {
  mrpt::obs::CObservationRange observation;
  observation.minSensorDistance = float(reading.range_min_m);
  observation.maxSensorDistance = float(reading.range_max_m);
  observation.sensorConeApperture = float(reading.beam_width.rad());
  observation.sensedData.resize(1);  // a ring in one observation would collapse to its first sensor
  observation.sensedData[0].sensorID = std::uint16_t(reading.rx);
  observation.sensedData[0].sensedDistance = float(echo_range_m(reading.outcome).value_or(reading.range_max_m));
  return observation;
}

class MrptGrid final : public Contestant {
 public:
  explicit MrptGrid(double cell_m) : cell_m_(cell_m), grid_(make_grid()) {}

  std::string name() const override { return "mrpt"; }

  void prepare(std::span<const Reading> readings) override {
    observations_.clear();
    for (const Reading& reading : readings) observations_.push_back(prepared(reading));
    if (!readings.empty()) grid_.insertionOptions.maxDistanceInsertion = float(readings.front().range_max_m);
  }

  void insert() override {
    for (const auto& [observation, T_world_sensor] : observations_)
      grid_.insertObservation(observation, T_world_sensor);
  }

  double cells_per_reading(std::span<const Reading> readings) const override {
    Grid grid = make_grid();
    double cells = 0.0;
    for (const Reading& reading : readings) {
      grid.fill(0.5f);
      grid.insertionOptions.maxDistanceInsertion = float(reading.range_max_m);
      const auto [observation, T_world_sensor] = prepared(reading);
      grid.insertObservation(observation, T_world_sensor);
      const auto& values = grid.getRawMap();
      cells += double(values.size() - std::size_t(std::count(values.begin(), values.end(), Grid::p2l(0.5f))));
    }
    return cells / double(readings.size());
  }

 private:
  using Prepared = std::pair<mrpt::obs::CObservationRange, mrpt::poses::CPose3D>;

  static Prepared prepared(const Reading& reading) {
    const Pose2& T = reading.T_world_rx;
    return {observation_of(reading), mrpt::poses::CPose3D(T.position.x, T.position.y, 0.0, T.heading.rad(), 0.0, 0.0)};
  }

  [[nodiscard]] Grid make_grid() const {
    const DenseArea area = workload_area(cell_m_);
    const Vec2 low = area.geometry.origin;
    const Vec2 high = area.geometry.corner({area.width, area.height});
    return Grid(float(low.x), float(high.x), float(low.y), float(high.y), float(cell_m_));
  }

  double cell_m_;
  Grid grid_;
  std::vector<Prepared> observations_;
};

}  // namespace

std::unique_ptr<Contestant> make_mrpt(double cell_m) {
  return std::make_unique<MrptGrid>(cell_m);
}

}  // namespace echoarc::bench
