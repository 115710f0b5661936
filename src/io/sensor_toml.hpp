// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "io/toml_fields.hpp"

namespace echoarc::io {

/// What every description of sensors shares: robot.toml and the `[robot]` table of a delimited-text description.
///
/// Model keys, legal in `[sensor_defaults]` and in every sensor, ring and row (a nearer one wins):
///   preset = "hc-sr04"            numbers of a transducer one can buy; the keys below override single numbers
///   beam_width | beam_width_deg   full angle
///   range_min, range_max, trusted_range          metres (also spelled with `_m`)
///   no_echo = "auto" | "inf" | "nan" | "zero" | "max" | { above = 5.0 }
///
/// Where the sensors are, one or several of these, taken in this order; ids that are not given count on:
///   array = "nomad200"            a whole array of the literature
///   ring = { count, radius_m, start_deg, first_id }     one table, or a list of tables
///   row = { count, spacing_m, x_m, first_id }
///   [[sensors]]   id, x, y, z in metres, roll, pitch, yaw (radians, or `_deg`)

/// Reads the model keys of a table over `defaults`. Errors stay in `fields`.
[[nodiscard]] SensorModel read_sensor_model(TomlFields& fields, const SensorModel& defaults);

/// A whole robot: `name`, `radius`, the sensors as above, `[[lasers]]` (id, x, y, z, yaw, range_min, range_max). No
/// sensor at all is legal here; a robot.toml refuses it. Every other key is an error, so a description that holds more
/// than the robot keeps it in a table of its own.
[[nodiscard]] Result<RobotDescription> read_robot_table(const toml::table& table, std::string_view source);

}  // namespace echoarc::io
