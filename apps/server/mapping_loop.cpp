// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/mapping_loop.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "host/clocks.hpp"
#include "server/map_messages.hpp"

namespace echoarc::server {
namespace {

constexpr std::size_t crowd = 20'000;          // records
constexpr std::size_t slice_readings = 1'000;  // of a recomputation, between records
constexpr double publish_interval_s = 0.035;
constexpr double map_interval_s = 0.1;
constexpr double looking_share = 0.2;  // of the time, at the most
constexpr double path_step_m = 0.02;

SharedFrame text_frame(std::string text) {
  return std::make_shared<const Frame>(Frame{std::move(text), false});
}

}  // namespace

MappingLoop::MappingLoop(live::Mapper mapper, live::ScoreKeeper scores, Host host)
    : host_(std::move(host)), mapper_(std::move(mapper)), scores_(std::move(scores)), thread_([this] { work(); }) {}

MappingLoop::~MappingLoop() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void MappingLoop::add(std::vector<live::Record>&& records) {
  {
    const std::lock_guard lock(mutex_);
    inbox_.waiting += records.size();
    inbox_.records.push_back(std::move(records));
  }
  wake_.notify_one();
}

void MappingLoop::restart() {
  const std::lock_guard lock(mutex_);
  inbox_.records.clear();
  inbox_.waiting = 0;
  inbox_.ended = false;
  inbox_.restart = true;
}

void MappingLoop::end_of_records() {
  {
    const std::lock_guard lock(mutex_);
    inbox_.ended = true;
  }
  wake_.notify_one();
}

bool MappingLoop::crowded() {
  const std::lock_guard lock(mutex_);
  return inbox_.waiting > crowd;
}

void MappingLoop::post(std::function<void(Access&)> job) {
  {
    const std::lock_guard lock(mutex_);
    inbox_.jobs.push_back(std::move(job));
  }
  wake_.notify_one();
}

void MappingLoop::catch_up(std::map<std::string, std::uint32_t> since, std::function<void(CatchUp)> answer) {
  post([this, since = std::move(since), answer = std::move(answer)](Access& access) {
    note_methods();
    CatchUp caught{methods_version_, methods_, {}};
    const auto methods = access.mapper.methods();
    for (std::size_t i = 0; i < methods.size(); ++i)
      if (const auto found = since.find(methods[i].id()); found != since.end())
        caught.deltas.push_back(delta(methods[i], i, found->second));
    answer(std::move(caught));
  });
}

live::Evidence MappingLoop::evidence_of(const live::Mapper& mapper, const live::SourceDescription& source) {
  live::Evidence evidence;
  evidence.readings = mapper.readings();
  evidence.walls = source.walls;
  evidence.truth = mapper.truth();
  evidence.sensors_off = mapper.sensors_off();
  for (const live::RunningMethod& method : mapper.methods()) {
    evidence.methods.push_back(method.choice);
    evidence.maps.push_back(method.map);
  }
  return evidence;
}

void MappingLoop::work() {
  double next_publication_s = host::wall_time_s();
  bool more = false;
  for (;;) {
    Inbox inbox;
    {
      std::unique_lock lock(mutex_);
      const auto ready = [&] {
        return closing_ || !inbox_.records.empty() || !inbox_.jobs.empty() || inbox_.restart || inbox_.ended;
      };
      if (!more) wake_.wait_for(lock, std::chrono::milliseconds(20), ready);
      if (closing_) return;
      inbox = std::exchange(inbox_, {});
    }
    take(inbox);
    more = mapper_.work(slice_readings);
    const double now_s = host::wall_time_s();
    if (now_s < next_publication_s) continue;
    next_publication_s = now_s + publish_interval_s;
    publish(now_s);
  }
}

void MappingLoop::take(Inbox& inbox) {
  if (inbox.restart) {
    mapper_.restart();
    scores_.restart();
    path_ = std::make_shared<std::vector<Vec2>>();
    path_taken_ = 0;
    told_bins_.clear();
    ++run_;
  }
  for (const std::vector<live::Record>& records : inbox.records)
    for (const live::Record& record : records) {
      mapper_.push(record);
      scores_.push(record);
    }
  if (inbox.ended) mapper_.end_of_records();
  for (const auto& job : inbox.jobs) {
    Access access{mapper_, scores_};
    job(access);
    if (access.changed) next_second_s_ = next_maps_s_ = 0.0;
  }
}

void MappingLoop::publish(double now_s) {
  auto publication = std::make_shared<Publication>();
  if (now_s >= next_maps_s_) {
    refresh_maps(*publication);
    const double end_s = host::wall_time_s();
    next_maps_s_ = std::max(now_s + map_interval_s, end_s + (end_s - now_s) / looking_share) - publish_interval_s / 2.0;
  }
  note_methods();
  extend_path();
  publication->readings = mapper_.readings();
  publication->path = path_;
  publication->run = run_;
  publication->methods_version = methods_version_;
  publication->methods = methods_;
  publication->deltas = deltas_;
  tell_each_second(*publication, now_s);
  host_.published(std::move(publication));
}

void MappingLoop::refresh_maps(Publication& publication) {
  mapper_.refresh();
  note_methods();
  deltas_.clear();
  const auto methods = mapper_.methods();
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::uint32_t& from = published_[methods[i].id()];
    deltas_.push_back(delta(methods[i], i, from));
    from = deltas_.back().to;
    if (methods[i].state == live::RunningMethod::State::recomputing)
      publication.recompute.push_back(text_frame(recompute_message(methods[i])));
  }
  if (!mapper_.laser().empty())
    publication.laser = encode_positions({.kind = FrameKind::laser, .flags = frame_forgets}, mapper_.laser());
}

void MappingLoop::tell_each_second(Publication& publication, double now_s) {
  if (now_s >= next_second_s_) {
    next_second_s_ = now_s + 1.0;
    ++second_;
    scores_message_ = text_frame(scores_message(scores_.update(mapper_)));
    counters_ = counters_message(mapper_, host_.log_status());
    timeline_ = text_frame(timeline_message(told_bins_, mapper_.timeline()));
    told_bins_.assign(mapper_.timeline().begin(), mapper_.timeline().end());
  }
  publication.second = second_;
  publication.counters = counters_;
  publication.scores = scores_message_;
  publication.timeline = timeline_;
}

MapDelta MappingLoop::delta(const live::RunningMethod& method, std::size_t index, std::uint32_t since) const {
  const live::MapStore& store = method.store;
  MapDelta delta{method.id(), since, store.sequence(), nullptr, nullptr};
  if (since == delta.to && since != 0) return delta;
  FrameHead head{.method = static_cast<std::uint8_t>(index), .sequence = delta.to};
  head.kind = FrameKind::tiles;
  delta.tiles = encode_tiles(head, store, since);
  head.kind = FrameKind::points;
  delta.points = encode_points(head, store, since);
  return delta;
}

void MappingLoop::extend_path() {
  const auto odometry = mapper_.path();
  if (odometry.size() == path_taken_) return;
  std::shared_ptr<std::vector<Vec2>> longer;
  for (; path_taken_ < odometry.size(); ++path_taken_) {
    const Vec2 position = odometry[path_taken_].T_world_robot.position;
    const std::vector<Vec2>& so_far = longer ? *longer : *path_;
    if (!so_far.empty() && norm(position - so_far.back()) < path_step_m) continue;
    if (!longer) longer = std::make_shared<std::vector<Vec2>>(*path_);
    longer->push_back(position);
  }
  if (longer) path_ = std::move(longer);
}

void MappingLoop::note_methods() {
  std::string text = methods_message(mapper_);
  if (text == methods_text_) return;
  for (auto it = published_.begin(); it != published_.end();) {
    const auto runs = [&](const live::RunningMethod& method) { return method.id() == it->first; };
    it = std::ranges::any_of(mapper_.methods(), runs) ? std::next(it) : published_.erase(it);
  }
  methods_text_ = std::move(text);
  methods_ = text_frame(methods_text_);
  ++methods_version_;
}

}  // namespace echoarc::server
