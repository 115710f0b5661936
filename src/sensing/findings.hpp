// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <string>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/sensing/diagnosis.hpp"
#include "echoarc/sensing/sensing_report.hpp"

namespace echoarc {

using Findings = std::vector<Finding>;

/// The pings of each described receiver, in the order of the log.
using PingsBySensor = std::map<SensorId, std::vector<Ping>>;

void find_odd_clocks(const Log& log, const PingsBySensor& pings, Findings& findings);
void find_odd_odometry(const Log& log, Findings& findings);
void find_odd_units(const Log& log, const SensingReport& report, Findings& findings);
void find_odd_sensors(const Log& log, const SensingReport& report, const PingsBySensor& pings, Findings& findings);

/// Range along the lower edge of the beam at which it meets the floor, m; infinity when it looks up or its height is
/// not given.
[[nodiscard]] double floor_range_m(const Sensor& sensor);

/// `value` with so many digits behind the point, trailing zeros dropped.
[[nodiscard]] std::string number_text(double value, int digits);
/// "sensor 3", "sensors 0-3,5". `ids` ascending, at least one.
[[nodiscard]] std::string sensor_text(const std::vector<SensorId>& ids);

}  // namespace echoarc
