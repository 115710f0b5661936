// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "echoarc/core/bytes.hpp"
#include "echoarc/mapping/numakura.hpp"
#include "echoarc/maps/ray_raster.hpp"

namespace echoarc {

/// Values of cells before the present scan, in `numakura_unit`.
using ValueBefore = std::function<std::int32_t(Cell)>;

/// What the tests say of one reading.
struct OutlierVerdict {
  bool geometry = false;
  bool consistency = false;
  double surface_angle_rad = std::numeric_limits<double>::quiet_NaN();  ///< theta of test 1; NaN: not applicable

  [[nodiscard]] bool outlier() const { return geometry || consistency; }
};

/// Where the surface was if the echo came from the middle of the arc.
struct SurfacePoint {
  Vec2 sensor;
  Vec2 axis;  ///< unit vector
  double range_m = 0.0;
  [[nodiscard]] Vec2 position() const { return sensor + range_m * axis; }
};
[[nodiscard]] SurfacePoint surface_point(const Arc& arc);

/// Angle between beam and surface estimated from two successive ranges, in [0, pi]: acos(u . v / |v|), v from the
/// surface point before to the present one ([Numakura] 5.1, Fig. 5). NaN where they are closer than `min_baseline_m`.
[[nodiscard]] double surface_angle(const SurfacePoint& before, const SurfacePoint& now, double min_baseline_m);

/// u(d) = min(1, D_H / d).
[[nodiscard]] inline double range_weight(double range_m, double reliable_range_m) {
  return range_m <= reliable_range_m ? 1.0 : reliable_range_m / range_m;
}

/// The outlier tests, with what they need of each sensor's last reading.
class Numakura::Judge {
 public:
  explicit Judge(const NumakuraOptions& options);

  void begin_scan(std::uint32_t scan);
  [[nodiscard]] bool knows_scan(std::uint32_t scan) const { return scans_ > 0 && scan == scan_; }
  [[nodiscard]] OutlierVerdict judge(const Reading& reading, const Arc& arc, const ValueBefore& before) const;
  void remember(const Reading& reading, const Arc& arc, const OutlierVerdict& verdict);
  [[nodiscard]] const OutlierCounters& outliers() const { return outliers_; }

  void save(ByteWriter& out) const;
  /// False when the bytes are no memory of sensors.
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  struct Seen {
    Vec2 sensor;
    Vec2 axis;
    double range_m = 0.0;
    std::uint32_t scan = 0;
    std::uint32_t outlier = 0;
  };
  using Sensors = std::pair<SensorId, SensorId>;

  [[nodiscard]] const Seen* scan_before(const Reading& reading) const;
  [[nodiscard]] bool passes_obstacle(const SurfacePoint& now, const ValueBefore& before) const;

  NumakuraOptions options_;
  std::map<Sensors, Seen> seen_;
  OutlierCounters outliers_;
  std::uint64_t scans_ = 0;  ///< begun so far, the present one included
  std::uint32_t scan_ = 0;
};

}  // namespace echoarc
