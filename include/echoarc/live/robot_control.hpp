// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/pose2.hpp"
#include "echoarc/live/obstacles.hpp"
#include "echoarc/live/source.hpp"
#include "echoarc/live/waypoints.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::live {

enum class Mode : std::uint8_t { stand, drive, tour, go_to, navigate };

/// Why the robot does what it does, where that is not plain from the mode.
enum class Reason : std::uint8_t { none, arrived, blocked, obstacle, dead_man, stopped, finished, failed };
/// "", "arrived", "blocked", "obstacle", "dead man", "stopped", "finished", "failed"
[[nodiscard]] std::string_view name(Reason reason);

struct ControlOptions {
  double dead_man_s = 0.5;              ///< without a command of the driver for so long the robot brakes
  double stop_deceleration_m_s2 = 1.5;  ///< of dead-man, Stop and obstacle stop
  double deceleration_m_s2 = 0.3;       ///< of everything else, and in the speed cap
  double clearance_m = 0.10;            ///< d_stop: kept between hull and obstacle
  double cruise_m_s = 0.25;             ///< of tour and go to
};

/// What the control says of itself for people.
struct ControlState {
  Mode mode = Mode::stand;
  Reason reason = Reason::none;
  std::string strategy;  ///< of mode `navigate`: its name; of another mode: of the one that has ended here
  std::string detail;    ///< what the strategy does, or why it ended
  std::optional<Vec2> goal;
  double limit_m_s = 0.0;              ///< the speed cap of this moment
  bool limited_by_obstacle = false;    ///< the cap lies below what was wanted
  std::optional<double> free_ahead_m;  ///< along the motion arc, from the hull; none: nothing seen
};

/// "stand", "drive", "tour", "goto", or the name of the strategy.
[[nodiscard]] std::string_view mode_name(const ControlState& state);

/// From modes and a driver's wishes to motor commands: speed cap from the free way along the motion arc
/// v <= sqrt(2 a max(0, d_free - d_stop)), obstacle stop, dead-man, tour and go to. Knows no clock: `host_s` is the
/// host's monotonic time, by which alone the dead-man counts.
class RobotControl {
 public:
  RobotControl(const ControlOptions& options, double hull_radius_m, std::vector<Vec2> tour);

  /// A command of the driver; not finite counts as zero. Starts mode `drive`.
  void drive(const RobotVelocity& wanted, double host_s);
  /// The driver is gone, whatever the cause: as if the last command were `dead_man_s` old.
  void driver_gone();
  void stand();
  void tour();
  void go_to(Vec2 goal);
  /// Obeys a strategy: what it wants is said by `obey`, as often as it likes.
  void navigate(std::string strategy);
  /// Heeded in mode `navigate` alone. A strategy that has ended ends the mode.
  void obey(const nav::Steering& steering);
  /// Brakes at the stopping deceleration and stands until a mode starts or someone drives.
  void stop();
  /// For a robot that must not go on unattended (`--attended`): as `stop`, with the reason of the dead-man.
  void unattended();

  /// The command of this moment.
  [[nodiscard]] MotorCommand update(const Drivable& robot, const Obstacles& obstacles, double host_s);
  [[nodiscard]] const ControlState& state() const { return state_; }
  /// What the driver or the strategy wants; zero in other modes.
  [[nodiscard]] const RobotVelocity& wanted() const { return wanted_; }

 private:
  /// How fast the robot may go along an arc.
  struct Cap {
    double speed_m_s = 0.0;
    std::optional<double> free_m;
  };

  void start(Mode mode, Reason reason = Reason::none);
  void brake(Reason reason);
  void watch_blockade(double host_s);
  [[nodiscard]] RobotVelocity steer(const Drivable& robot, double host_s);
  [[nodiscard]] Cap cap_along(const Drivable& robot, const Obstacles& obstacles, const RobotVelocity& velocity) const;
  [[nodiscard]] MotorCommand limited(const RobotVelocity& wanted, const Drivable& robot, const Obstacles& obstacles);

  ControlOptions options_;
  double hull_radius_m_;
  Route route_;
  Homing homing_;
  ControlState state_;
  RobotVelocity wanted_;
  std::optional<double> driven_s_;         // host's time of the driver's last command; none: gone
  std::optional<double> held_s_;           // host's time since when an obstacle holds the robot
  std::optional<double> backing_until_s_;  // on a tour, after an obstacle
  bool held_ = false;                      // in the last update
  bool hard_ = false;                      // brakes at the stopping deceleration
};

}  // namespace echoarc::live
