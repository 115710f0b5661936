// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "echoarc/core/sensor_array.hpp"
#include "echoarc/io/robot_toml.hpp"

namespace echoarc::io {
namespace {

constexpr std::string_view head = R"(# robot.toml: where the ultrasonic sensors of a robot sit and what they can do.
# Metres, radians and seconds; a key that ends in _deg is in degrees. x points forward, y to the left, z up; yaw turns
# counter-clockwise, 0 is straight ahead. The origin is the point that the odometry describes.

name = "my robot"
radius_m = 0.15            # of the circle around the origin that the robot covers

)";

constexpr std::string_view model_text =
    R"([sensor_defaults]          # holds for every sensor that does not say otherwise
preset = "{preset}"        # {description}
                           # others: {others}
# The preset's numbers; take the "# " away to change one.
# beam_width_deg = {beam:.4g}    # full angle of the cone
# range_min = {min:.4g}
# range_max = {max:.4g}
# trusted_range = {trusted:.4g}  # to this range silence counts as free space (a slanted wall is silent, too)
no_echo = "auto"           # how the log spells "heard nothing": "auto" looks at the recorded values and says what it
                           # decided; or "inf", "nan", "zero", "max", {{ above = 5.0 }}

)";

constexpr std::string_view ring_text =
    R"([ring]                     # sensors on a circle around the origin, looking outward
count = {count}
radius_m = 0.15            # of the circle
start_deg = 0              # where sensor 0 looks; the next ones follow counter-clockwise

)";

constexpr std::string_view row_text = R"([row]                      # sensors side by side, looking ahead
count = {count}
spacing_m = 0.05           # from one to the next; sensor 0 is the rightmost
x_m = 0.15                 # of the row, ahead of the origin

)";

constexpr std::string_view tail =
    R"(# Sensors one by one, instead or besides. An id that is left out counts on from the one before.
# [[sensors]]
# id = {next}
# x = 0.10
# y = 0.05
# z = 0.20
# yaw_deg = 30
# pitch_deg = 0              # negative looks up
# preset = "{preset}"

# A laser scanner, for comparison.
# [[lasers]]
# id = 0
# x = 0.125
# range_max = 8.0
)";

}  // namespace

Result<std::string> robot_toml_template(std::string_view preset, int count, SensorLayout layout) {
  const auto presets = sensor_presets();
  const auto found = std::ranges::find(presets, preset, &SensorPreset::name);
  std::vector<std::string_view> others;
  for (const SensorPreset& other : presets)
    if (other.name != preset) others.push_back(other.name);
  if (found == presets.end())
    return Error{ErrorCode::bad_value, fmt::format("there is no sensor preset \"{}\"", preset), "--preset",
                 fmt::format("use one of {}", fmt::join(others, ", "))};
  if (count < 1 || count > static_cast<int>(SensorArray::max_sensors))
    return Error{ErrorCode::bad_value, fmt::format("{} sensors are not supported", count), "--count",
                 fmt::format("use 1 to {}", std::size_t{SensorArray::max_sensors})};
  using fmt::arg;
  return std::string(head) +
         fmt::format(model_text, arg("preset", preset), arg("description", found->description),
                     arg("others", fmt::join(others, ", ")), arg("beam", found->beam_width.deg()),
                     arg("min", found->range_min_m), arg("max", found->range_max_m),
                     arg("trusted", found->trusted_range_m)) +
         (layout == SensorLayout::ring ? fmt::format(ring_text, arg("count", count))
                                       : fmt::format(row_text, arg("count", count))) +
         fmt::format(tail, arg("next", count), arg("preset", preset));
}

}  // namespace echoarc::io
