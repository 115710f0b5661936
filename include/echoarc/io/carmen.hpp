// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/byte_source.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {

/// Reads a CARMEN log: ODOM, TRUEPOS, FLASER, RLASER, ROBOTLASER1 and SONAR. Units as in the file: metres, radians,
/// seconds; times are the message's own time stamp, not the logger's.
///
/// - The sensors are those of the first SONAR message (offset x y theta, cone angle taken as full beam width; above pi
///   it is taken as degrees), ids from 0. Its ranges stay as they are: what "no echo" looks like is decided in sensing.
/// - Laser 0 is FLASER or ROBOTLASER1, laser 1 RLASER. The mount is the laser's pose in the robot's at its first
/// message. FLASER and RLASER
///   scan 180 degrees from -90 degrees on, the step following from the number of readings (180/181: 1 degree, 360/361:
///   half a degree, 400/401: a quarter).
/// - A laser message states the robot's pose, too; those are the odometry when there is no ODOM.
///
/// Other messages are skipped and named in one warning. Bad lines: as `read_jsonl`.
[[nodiscard]] Result<Log> read_carmen(ByteSource& source, const ReadLimits& limits = {});

}  // namespace echoarc::io
