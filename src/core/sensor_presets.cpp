// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>

#include "echoarc/core/sensor_array.hpp"

namespace echoarc {
namespace {

constexpr NoEchoRule automatic{};
constexpr NoEchoRule at_maximum{NoEchoRule::Kind::max, 0.0};

// Ranges are the makers'. Beam widths are full angles, and there the makers disagree or are silent, so each line says
// what its number is. The trusted range is ours throughout: beyond it a smooth wall, hit at a slant, sends nothing
// back, so silence there is no evidence of free space.
constexpr std::array<SensorPreset, 7> sensor_table{{
    {"polaroid-6500", "Polaroid 6500 ranging module with the 600 series transducer, 49.4 kHz",
     "[Barshan07] 2 and 4.1: half beam 12.5 deg (nominal; first null of the piston at 12.23 deg), 0.15 to 10.7 m",
     degrees(25.0), 0.15, 10.7, 3.0, automatic},
    {"polaroid-600", "Polaroid 600 series transducer with the narrower beam of the arc papers",
     "[Silver04] 2, [Choset03] II: full arc 22.5 deg; 0.15 to 10.7 m as polaroid-6500. At -6 dB one way its beam is 14 "
     "deg wide",
     degrees(22.5), 0.15, 10.7, 3.0, automatic},
    {"hc-sr04", "HC-SR04 hobby module, separate transmitter and receiver, 40 kHz",
     "module sheet: 2 to 400 cm, 'measuring angle' 15 deg; resellers also print 450 and 500 cm, and < 15 deg. Nothing "
     "heard: a 38 ms pulse, which common drivers turn into 0",
     degrees(15.0), 0.02, 4.0, 2.0, automatic},
    {"jsn-sr04t", "JSN-SR04T waterproof module, one transducer, 40 kHz; blind below its minimum and often wrong there",
     "makers disagree: 20 to 600 cm (V3.0), 23 to 500 cm (V3.3), blind below 25 cm (early boards); angle < 50, 75 "
     "deg. "
     "Taken: 25 cm, the safe minimum; 450 cm; 75 deg",
     degrees(75.0), 0.25, 4.5, 2.0, automatic},
    {"mb1043", "MaxBotix HRLV-MaxSonar-EZ4, narrow beam, millimetre output, 42 kHz",
     "HRLV/HRUSB-MaxSonar-EZ sheets: 300 to 5000 mm, 5000 when nothing is heard, 300 for anything nearer. The beam is "
     "given as plots, no angle; 20 deg is our reading for large targets",
     degrees(20.0), 0.3, 5.0, 2.5, at_maximum},
    {"urm37", "DFRobot URM37 V5.0 (SEN0001) with temperature compensation",
     "maker's page: 2 to 800 cm (ultimate 1000 cm), 1 %; invalid readings are 65535 cm (serial) or 1000 cm (pulse). "
     "The beam is given as a plot; 60 deg is our reading of it",
     degrees(60.0), 0.02, 8.0, 2.5, automatic},
    {"icu-20201", "TDK InvenSense ICU-20201 MEMS transceiver; the beam is that of its acoustic housing",
     "maker's brief, not checked against a data sheet: 0.2 to 5 m, field of view up to 180 deg, set by the horn; 45 "
     "deg is a common horn. "
     "State the beam of yours",
     degrees(45.0), 0.2, 5.0, 2.0, automatic},
}};

constexpr std::array<ArrayPreset, 6> array_table{{
    {"nomad200", "Nomad 200: 16 sonars every 22.5 deg on a ring of radius 0.23 m, full beam 25 deg", "[Barshan07] 4.1"},
    {"nomad200_front3", "the three front sonars of a Nomad 200, at -22.5, 0 and 22.5 deg", "[Barshan07] 4.2"},
    {"nomad200_front5", "the five front sonars of a Nomad 200, from -45 to 45 deg", "[Barshan07] 4.2"},
    {"scout2", "Nomad Scout II: 16 sonars, 0.26035 m above the floor, full beam 22.5 deg, steps of one inch",
     "[Silver04] 2 and appendix B; ring radius 0.19 m is ours"},
    {"nomad_choset", "the Nomad 200 with a full beam of 22.5 deg and steps of one inch", "[Choset03] II and IV-B"},
    {"b14r", "RWI B14r: 16 sonars equally spaced at one height, full beam 25 deg",
     "[Numakura] 3; ring radius 0.17 m and beam width are ours"},
}};

constexpr Angle nomad_spacing = degrees(22.5);
constexpr double nomad_radius_m = 0.23;

/// `count` neighbours on the Nomad's ring, centred on its front; sensor 0 is the rightmost.
std::vector<Sensor> nomad_front(int count, const SensorModel& model) {
  std::vector<Sensor> sensors = ring(16, nomad_radius_m, -((count - 1) / 2.0) * nomad_spacing, model);
  sensors.resize(static_cast<std::size_t>(count));
  return sensors;
}

std::vector<Sensor> at_height(std::vector<Sensor> sensors, double z_m) {
  for (Sensor& sensor : sensors) sensor.mount.z_m = z_m;
  return sensors;
}

std::vector<Sensor> sensors_of(std::string_view array) {
  const SensorModel wide = *sensor_preset("polaroid-6500");
  const SensorModel narrow = *sensor_preset("polaroid-600");
  if (array == "nomad200") return ring(16, nomad_radius_m, Angle{}, wide);
  if (array == "nomad200_front3") return nomad_front(3, wide);
  if (array == "nomad200_front5") return nomad_front(5, wide);
  if (array == "scout2") return at_height(ring(16, 0.19, Angle{}, narrow), 0.26035);
  if (array == "nomad_choset") return ring(16, nomad_radius_m, Angle{}, narrow);
  if (array == "b14r") return ring(16, 0.17, Angle{}, wide);
  return {};
}

}  // namespace

std::span<const SensorPreset> sensor_presets() {
  return sensor_table;
}

std::optional<SensorModel> sensor_preset(std::string_view name) {
  const auto found = std::ranges::find(sensor_table, name, &SensorPreset::name);
  if (found == sensor_table.end()) return std::nullopt;
  return SensorModel{.preset = std::string(found->name),
                     .beam_width = found->beam_width,
                     .range_min_m = found->range_min_m,
                     .range_max_m = found->range_max_m,
                     .trusted_range_m = found->trusted_range_m,
                     .no_echo = found->no_echo};
}

std::span<const ArrayPreset> array_presets() {
  return array_table;
}

std::optional<SensorArray> array_preset(std::string_view name) {
  if (std::ranges::find(array_table, name, &ArrayPreset::name) == array_table.end()) return std::nullopt;
  return SensorArray::make(sensors_of(name)).value();
}

}  // namespace echoarc
