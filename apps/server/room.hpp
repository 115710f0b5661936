// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "server/bundle.hpp"
#include "server/client_message.hpp"
#include "server/control_loop.hpp"
#include "server/driving_rights.hpp"
#include "server/mapping_loop.hpp"
#include "server/session_writer.hpp"
#include "server/viewer.hpp"
#include "server/worker.hpp"

namespace echoarc::server {

/// What a room is made of.
struct RoomSetup {
  std::string name;
  std::string kind;  ///< "scene" or "log"
  std::unique_ptr<live::Source> source;
  live::Mapper mapper;
  live::ScoreKeeper scores;
  std::unique_ptr<SessionWriter> log;  ///< null: nothing is received that is not kept already
  double speed = 1.0;
  std::optional<double> planned_rate_hz = std::nullopt;  ///< pings of each sensor a second; none: no plan is known
  bool attended = false;                                 ///< the robot stands when nobody watches
  bool starts_tour = true;                               ///< if there is one
  std::optional<Navigation> navigation = std::nullopt;   ///< none: it finds no way by itself
};

/// Who stopped the robot last.
struct StopNote {
  std::string who;  ///< "viewer", "obstacle", "dead_man", "host"
  std::optional<ViewerId> viewer;
  std::string name;
};

/// One source with its maps and those who watch it. All members are called on the thread of input and output; robot,
/// maps and questions have threads of their own, and what they say is posted back there.
class Room : public std::enable_shared_from_this<Room> {
 public:
  /// `post` runs a job on the thread of input and output.
  using Post = std::function<void(std::function<void()>)>;
  [[nodiscard]] static std::shared_ptr<Room> open(RoomSetup setup, Post post);
  ~Room();

  void join(Viewer& viewer);
  void leave(Viewer& viewer);
  /// Answers one message; what is refused is answered by `error`.
  void hear(Viewer& viewer, const ClientMessage& message);
  /// Everything the viewer lacks by now.
  [[nodiscard]] std::vector<SharedFrame> take(Viewer& viewer);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] const live::SourceDescription& source() const { return source_; }
  [[nodiscard]] bool drivable() const { return drivable_; }
  [[nodiscard]] std::optional<double> planned_rate_hz() const { return planned_rate_hz_; }
  [[nodiscard]] std::vector<std::string> modes() const;
  [[nodiscard]] const std::set<Viewer*>& viewers() const { return viewers_; }
  [[nodiscard]] const SharedFrame& state() const { return state_; }
  [[nodiscard]] bool has_log() const { return log_ != nullptr; }
  /// For what needs the mapper itself (saving, downloads): `job` runs on its thread.
  void with_mapper(std::function<void(MappingLoop::Access&)> job) { mapping_->post(std::move(job)); }
  /// Runs on the thread of questions; false when too many wait.
  [[nodiscard]] bool ask(Worker::Job job) { return questions_->post(std::move(job)); }
  [[nodiscard]] const Post& post() const { return post_; }
  /// Ends the robot; maps and questions are still answered.
  void end_control() { control_.reset(); }
  /// Ends all threads. Nothing may be asked afterwards but `leave`.
  void close() {
    viewers_.clear();  // what is posted already reaches nobody
    control_.reset();
    mapping_.reset();
    questions_.reset();
  }

 private:
  explicit Room(Post post) : post_(std::move(post)) {}
  void start(RoomSetup setup);
  void on_tick(std::shared_ptr<const RobotStatus> status);
  void on_published(SharedPublication publication);
  void greet(Viewer& viewer);
  void catch_up(Viewer& viewer, std::map<std::string, std::uint32_t> behind);
  [[nodiscard]] Viewer* find(ViewerId id) const;
  void tell_viewers();
  void driver_changed(std::optional<ViewerId> before, std::string_view reason);
  void note_stop(const RobotStatus& status);
  void note_plan(const RobotStatus& status);
  void refuse(Viewer& viewer, std::optional<MessageId> id, const Error& error);
  [[nodiscard]] bool may(Viewer& viewer, std::optional<MessageId> id = std::nullopt);
  void change_map(Viewer& viewer, std::function<Result<void>(live::Mapper&)> change, std::string setup);
  /// Runs `work(room, viewer)` on the thread of input and output, if both are still there then.
  template <class Work>
  void later(ViewerId id, Work work) {
    post_([self = weak_from_this(), id, work = std::move(work)]() mutable {
      const std::shared_ptr<Room> room = self.lock();
      Viewer* viewer = room ? room->find(id) : nullptr;
      if (viewer != nullptr) work(*room, *viewer);
    });
  }
  /// `prepare(mapper)` gives what is asked about the evidence. Jobs on the other threads may use `this`: they end
  /// before it does.
  template <class Prepare>
  void question(Viewer& viewer, MessageId id, Prepare prepare);

  // One for each kind of message.
  void on(Viewer& viewer, const Hello& message);
  void on(Viewer& viewer, const PingMessage& message);
  void on(Viewer& viewer, const Subscribe& message);
  void on(Viewer& viewer, const Stop& message);
  void on(Viewer& viewer, const Take& message);
  void on(Viewer& viewer, const Release& message);
  void on(Viewer& viewer, const Answer& message);
  void on(Viewer& viewer, const DriveMessage& message);
  void on(Viewer& viewer, const ModeMessage& message);
  void on(Viewer& viewer, const MethodAdd& message);
  void on(Viewer& viewer, const MethodRemove& message);
  void on(Viewer& viewer, const OptionsMessage& message);
  void on(Viewer& viewer, const SensorMessage& message);
  void on(Viewer& viewer, const Playback& message);
  void on(Viewer& viewer, const OpenScene& message);
  void on(Viewer& viewer, const Explain& message);
  void on(Viewer& viewer, const StepMessage& message);
  void on(Viewer& viewer, const PingsMessage& message);
  void on(Viewer& viewer, const Snapshot& message);

  Post post_;
  std::string name_;
  std::string kind_;
  bool attended_ = false;
  bool drivable_ = false;
  bool navigates_ = false;
  std::optional<double> planned_rate_hz_;
  live::SourceDescription source_;
  std::set<Viewer*> viewers_;
  DrivingRights rights_;
  Bundler bundler_;
  std::shared_ptr<const RobotStatus> status_;
  std::optional<StopNote> stopped_by_;
  std::int64_t stopped_us_ = 0;  ///< when a viewer stopped it; by the host's clock
  live::Reason reason_ = live::Reason::none;
  std::optional<ViewerId> driven_by_;  ///< who gave the newest command
  SharedFrame state_;
  std::shared_ptr<const Plan> plan_;  ///< that `plan_frame_` tells of
  SharedFrame plan_frame_;            ///< null: nothing was planned yet
  std::uint64_t plan_version_ = 0;
  std::shared_ptr<SessionWriter> log_;
  std::unique_ptr<Worker> questions_;
  std::unique_ptr<MappingLoop> mapping_;
  std::unique_ptr<ControlLoop> control_;  // last: it feeds the others
};

}  // namespace echoarc::server
