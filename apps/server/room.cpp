// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/room.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "host/clocks.hpp"
#include "server/json_values.hpp"
#include "server/map_messages.hpp"
#include "server/plan_message.hpp"
#include "server/room_messages.hpp"

namespace echoarc::server {
namespace {

constexpr std::size_t most_questions = 64;

std::string log_json(SessionWriter* log) {
  if (log == nullptr) return R"({"state":"off","bytes":0,"message":""})";
  const SessionWriter::Status status = log->status();
  constexpr std::array states{"on", "full", "limit"};
  return text_of({{"state", states.at(static_cast<std::size_t>(status.state))},
                  {"bytes", status.bytes},
                  {"message", status.message}});
}

}  // namespace

std::shared_ptr<Room> Room::open(RoomSetup setup, Post post) {
  std::shared_ptr<Room> room(new Room(std::move(post)));
  room->start(std::move(setup));
  return room;
}

Room::~Room() = default;

void Room::start(RoomSetup setup) {
  name_ = std::move(setup.name);
  kind_ = std::move(setup.kind);
  attended_ = setup.attended;
  source_ = setup.source->description();
  drivable_ = setup.source->drivable() != nullptr;
  navigates_ = drivable_ && setup.navigation.has_value();
  planned_rate_hz_ = setup.planned_rate_hz;
  log_ = std::move(setup.log);
  questions_ = std::make_unique<Worker>(most_questions);
  const std::weak_ptr<Room> self = weak_from_this();
  const auto told = [this, self](auto member) {
    return [post = post_, self, member](auto value) {
      post([self, member, value = std::move(value)]() mutable {
        if (const auto room = self.lock()) ((*room).*member)(std::move(value));
      });
    };
  };
  mapping_ = std::make_unique<MappingLoop>(
      std::move(setup.mapper), std::move(setup.scores),
      MappingLoop::Host{told(&Room::on_published), [log = log_] { return log_json(log.get()); }});
  const auto ended = std::make_shared<bool>(false);  // of the loop's thread alone
  ControlLoop::Host host{[log = log_, mapping = mapping_.get()](std::vector<live::Record>&& records) {
                           if (log)
                             for (const live::Record& record : records) log->add(record);
                           mapping->add(std::move(records));
                         },
                         [mapping = mapping_.get(), ended] {
                           *ended = false;
                           mapping->restart();
                         },
                         [mapping = mapping_.get(), ended, tell = told(&Room::on_tick)](auto status) {
                           const bool ends = status->ended || !status->broken.empty();
                           if (ends && !std::exchange(*ended, ends)) mapping->end_of_records();
                           tell(std::move(status));
                         },
                         [mapping = mapping_.get()] { return mapping->crowded(); }};
  control_ = std::make_unique<ControlLoop>(std::move(setup.source), live::ControlOptions{}, setup.speed,
                                           std::move(host), std::move(setup.navigation));
  if (setup.starts_tour && !source_.tour.empty() && !attended_)
    control_->control([](live::RobotControl& control) { control.tour(); });
}

// ---- viewers

void Room::join(Viewer& viewer) {
  viewers_.insert(&viewer);
  greet(viewer);
  tell_viewers();
}

void Room::leave(Viewer& viewer) {
  if (viewers_.erase(&viewer) == 0) return;
  const std::optional<ViewerId> before = rights_.driver();
  if (rights_.leave(viewer.id)) {
    if (control_) control_->control([](live::RobotControl& control) { control.driver_gone(); });
    driver_changed(before, "handed_over");
  }
  if (attended_ && viewers_.empty() && control_)
    control_->control([](live::RobotControl& control) { control.unattended(); });
  tell_viewers();
}

Viewer* Room::find(ViewerId id) const {
  const auto found = std::ranges::find(viewers_, id, [](const Viewer* viewer) { return viewer->id; });
  return found == viewers_.end() ? nullptr : *found;
}

void Room::tell_viewers() {
  const std::string text = viewers_message(viewers_, rights_);
  for (Viewer* viewer : viewers_)
    if (viewer->cursor.greeted) viewer->send(text);
}

void Room::greet(Viewer& viewer) {
  mapping_->post([this, id = viewer.id](MappingLoop::Access& access) {
    later(id, [history = history_message(access.mapper, access.scores)](Room& room, Viewer& newcomer) {
      newcomer.send(history);
      newcomer.send(viewers_message(room.viewers_, room.rights_));
      newcomer.cursor.greeted = true;
    });
  });
}

std::vector<SharedFrame> Room::take(Viewer& viewer) {
  if (!mapping_) return {};
  std::map<std::string, std::uint32_t> behind;
  const bool new_state = status_ && viewer.cursor.tick != status_->tick;
  if (new_state) viewer.cursor.tick = status_->tick;
  std::vector<SharedFrame> frames = bundler_.take(viewer, new_state ? state_ : nullptr, behind);
  if (viewer.cursor.greeted && viewer.cursor.plan != plan_version_) {
    viewer.cursor.plan = plan_version_;
    frames.push_back(plan_frame_);
  }
  if (!behind.empty() && !viewer.cursor.catching_up) catch_up(viewer, std::move(behind));
  return frames;
}

void Room::catch_up(Viewer& viewer, std::map<std::string, std::uint32_t> behind) {
  viewer.cursor.catching_up = true;
  mapping_->catch_up(std::move(behind), [this, id = viewer.id](MappingLoop::CatchUp caught) {
    later(id, [caught = std::move(caught)](Room&, Viewer& late) mutable {
      late.cursor.caught = std::move(caught);
      late.cursor.catching_up = false;
    });
  });
}

// ---- what robot and maps say

void Room::on_tick(std::shared_ptr<const RobotStatus> status) {
  status_ = std::move(status);
  if (const auto expired = rights_.expired(host::wall_time_s())) {
    if (Viewer* viewer = find(*expired)) viewer->send(drive_lost_message("kept"));
    tell_viewers();
  }
  note_stop(*status_);
  note_plan(*status_);
  const std::uint64_t pings = bundler_.publication() ? bundler_.publication()->readings.size() : 0;
  state_ = std::make_shared<const Frame>(
      Frame{state_message(*status_, rights_, viewers_.size(), stopped_by_, pings), false});
  for (Viewer* viewer : viewers_) viewer->offer();
}

void Room::note_plan(const RobotStatus& status) {
  if (status.plan == plan_) return;
  plan_ = status.plan;
  std::string text = plan_ ? plan_message(plan_->strategy, plan_->sketch) : no_plan_message();
  if (plan_frame_ && plan_frame_->bytes == text) return;
  plan_frame_ = std::make_shared<const Frame>(Frame{std::move(text), false});
  ++plan_version_;
}

void Room::note_stop(const RobotStatus& status) {
  using live::Reason;
  constexpr std::int64_t on_the_way_us = 50'000;
  if (stopped_by_ && status.mono_us < stopped_us_ + on_the_way_us) return;  // from before the stop, perhaps
  const Reason before = std::exchange(reason_, status.control.reason);
  switch (status.control.reason) {
    case Reason::obstacle:
      if (status.control.mode == live::Mode::navigate) return stopped_by_.reset();  // it finds a way round
      stopped_by_ = StopNote{"obstacle", std::nullopt, ""};
      return;
    case Reason::dead_man:
      stopped_by_ = StopNote{"dead_man", std::nullopt, ""};
      // Who came to the right since then has let go of nothing.
      if (const auto driver = rights_.driver();
          before != Reason::dead_man && driver && driver == driven_by_ && rights_.leave(*driver)) {
        if (Viewer* viewer = find(*driver)) viewer->send(drive_lost_message("dead_man"));
        tell_viewers();
      }
      return;
    case Reason::stopped:
      if (!stopped_by_) stopped_by_ = StopNote{"host", std::nullopt, ""};
      return;
    default: stopped_by_.reset();
  }
}

void Room::on_published(SharedPublication publication) {
  bundler_.set(std::move(publication));
  for (Viewer* viewer : viewers_) viewer->offer();
}

// ---- what viewers say

void Room::hear(Viewer& viewer, const ClientMessage& message) {
  std::visit([&](const auto& m) { on(viewer, m); }, message);
}

void Room::refuse(Viewer& viewer, std::optional<MessageId> id, const Error& error) {
  viewer.send(error_message(id, error));
}

bool Room::may(Viewer& viewer, std::optional<MessageId> id) {
  if (!viewer.may_drive)
    refuse(viewer, id,
           {ErrorCode::unsupported, "this needs the token", "",
            "open the drive link that was printed where echoarc was started"});
  return viewer.may_drive;
}

void Room::on(Viewer& viewer, const Hello& /*message*/) {
  refuse(viewer, std::nullopt, {ErrorCode::bad_format, "hello was said already", "", "say it once, first"});
}

void Room::on(Viewer& viewer, const PingMessage& message) {
  viewer.send(pong_message(message.id));
}

void Room::on(Viewer& viewer, const Subscribe& message) {
  viewer.subscribed.emplace(message.methods.begin(), message.methods.end());
}

void Room::change_map(Viewer& viewer, std::function<Result<void>(live::Mapper&)> change, std::string setup) {
  if (!may(viewer)) return;
  mapping_->post([this, change = std::move(change), setup = std::move(setup),
                  id = viewer.id](MappingLoop::Access& access) mutable {
    const Result<void> changed = change(access.mapper);
    access.changed = true;
    if (!changed)
      later(id, [error = changed.error()](Room& room, Viewer& asker) { room.refuse(asker, std::nullopt, error); });
    else if (log_)
      log_->add_setup(std::move(setup));
  });
}

void Room::on(Viewer& viewer, const MethodAdd& message) {
  live::MethodChoice choice{message.name.value_or(message.method), message.options.value_or(OptionMap{}),
                            message.method};
  Json setup{{"type", "setup"}, {"add", choice.id}};
  if (choice.id != choice.name) setup["name"] = choice.name;
  if (!choice.options.empty()) setup["options"] = json_of(choice.options);
  change_map(
      viewer, [choice = std::move(choice)](live::Mapper& mapper) { return mapper.add_method(choice); }, text_of(setup));
}

void Room::on(Viewer& viewer, const MethodRemove& message) {
  change_map(
      viewer, [id = message.method](live::Mapper& mapper) { return mapper.remove_method(id); },
      text_of({{"type", "setup"}, {"remove", message.method}}));
}

void Room::on(Viewer& viewer, const OptionsMessage& message) {
  change_map(
      viewer, [message](live::Mapper& mapper) { return mapper.set_options(message.method, message.options); },
      text_of({{"type", "setup"}, {"method", message.method}, {"options", json_of(message.options)}}));
}

void Room::on(Viewer& viewer, const SensorMessage& message) {
  change_map(
      viewer, [message](live::Mapper& mapper) { return mapper.use_sensor(message.sensor, message.on); },
      text_of({{"type", "setup"}, {"sensor", message.sensor}, {"on", message.on}}));
}

void Room::on(Viewer& viewer, const Playback& message) {
  if (!may(viewer)) return;
  if (!control_ || kind_ != "log")
    return refuse(viewer, std::nullopt,
                  {ErrorCode::unsupported, "a running robot cannot be played", "", "hold the view instead"});
  // Who pauses and seeks wants to be there, not where playing goes on to in between.
  if (message.playing == false) control_->play(false);
  if (message.speed) control_->set_speed(*message.speed);
  if (message.seek_s) control_->seek(*message.seek_s);
  if (message.playing == true) control_->play(true);
}

void Room::on(Viewer& viewer, const OpenScene& message) {
  refuse(viewer, message.id, {ErrorCode::unsupported, "this room opens no scenes", "", "ask the server"});
}

}  // namespace echoarc::server
