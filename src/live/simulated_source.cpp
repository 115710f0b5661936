// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/simulated_source.hpp"

#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

namespace echoarc::live {
namespace {

Polyline outline(const sim::Disc& disc) {
  constexpr int sides = 48;
  Polyline line;
  for (int k = 0; k <= sides; ++k)
    line.push_back(disc.centre + disc.radius_m * unit(radians(2.0 * std::numbers::pi * (k % sides) / sides)));
  return line;
}

std::vector<Polyline> surfaces(const sim::WorldDescription& world) {
  std::vector<Polyline> lines;
  for (const sim::Wall& wall : world.walls) lines.push_back({wall.a, wall.b});
  for (const sim::Disc& disc : world.discs) lines.push_back(outline(disc));
  for (const sim::SmoothCurve& curve : world.curves) lines.push_back(curve.points);
  return lines;
}

/// Where the scripted drive goes; empty where it goes nowhere.
std::vector<Vec2> stations(const sim::Drive& drive) {
  std::vector<Vec2> places{drive.start.position};
  for (const sim::DriveLeg& leg : drive.legs)
    if (leg.to) places.push_back(*leg.to);
  if (places.size() < 2) places.clear();
  return places;
}

SourceDescription describe(const sim::SteppedSimulation& simulation) {
  const sim::Scene& scene = simulation.scene();
  SourceDescription is;
  is.name = scene.name;
  is.title = scene.title;
  is.temperature_k = scene.sonar.assumed_temperature_k;
  is.robot = scene.robot;
  is.walls = surfaces(scene.world);
  is.world = simulation.world();
  is.has_truth = true;
  is.tour = stations(scene.drive);
  return is;
}

Record record_of(sim::SteppedRecord&& said) {
  return std::visit(
      [](auto&& record) -> Record {
        using Kind = std::decay_t<decltype(record)>;
        if constexpr (std::is_same_v<Kind, sim::TruePose>)
          return Truth{record.pose};
        else
          return std::forward<decltype(record)>(record);
      },
      std::move(said));
}

}  // namespace

SimulatedSource::SimulatedSource(sim::SteppedSimulation simulation, const RobotLimits& limits)
    : simulation_(std::move(simulation)), limits_(limits), description_(describe(simulation_)) {}

Result<std::unique_ptr<SimulatedSource>> SimulatedSource::make(sim::Scene scene, std::uint64_t seed,
                                                               const RobotLimits& limits,
                                                               const std::optional<Continuation>& continued) {
  const std::vector<Vec2> tour = stations(scene.drive);
  if (continued) {
    const Pose2& T_world_robot = continued->T_world_true;
    const Angle heading =
        scene.drive.keep_heading ? scene.drive.start.heading : wrap(T_world_robot.heading - scene.drive.facing);
    scene.drive.start = {T_world_robot.position, heading};
  }
  Result<sim::SteppedSimulation> made = sim::SteppedSimulation::make(std::move(scene), seed, limits);
  if (!made) return made.error();
  std::unique_ptr<SimulatedSource> source(new SimulatedSource(std::move(made).value(), limits));
  source->description_.tour = tour;
  if (continued) {
    source->begin_s_ = continued->time_s;
    source->description_.begin_s = continued->time_s;
    source->T_odometry_simulated_ = continued->T_world_odometry * inverse(continued->T_world_true);
  }
  return source;
}

/// Into time and frame of the run that is continued.
void SimulatedSource::shift(Record& record) const {
  std::visit(
      [&](auto& said) {
        using Kind = std::decay_t<decltype(said)>;
        if constexpr (std::is_same_v<Kind, Truth>) {
          said.pose.time_s += begin_s_;
        } else {
          said.time_s += begin_s_;
          if constexpr (std::is_same_v<Kind, Odometry>) said.T_world_robot = T_odometry_simulated_ * said.T_world_robot;
        }
      },
      record);
}

Result<void> SimulatedSource::advance(double until_s, std::vector<Record>& records) {
  said_.clear();
  simulation_.advance(until_s - begin_s_, said_);
  for (sim::SteppedRecord& record : said_) {
    records.push_back(record_of(std::move(record)));
    shift(records.back());
  }
  return {};
}

void SimulatedSource::command(const MotorCommand& command) {
  simulation_.command(command.wanted, command.deceleration_m_s2);
}

}  // namespace echoarc::live
