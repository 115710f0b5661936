// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "echoarc/live/inquiry.hpp"
#include "echoarc/live/mapper.hpp"
#include "echoarc/live/scores.hpp"
#include "server/frame_encoder.hpp"

namespace echoarc::server {

/// What changed of one method's map between two sequence numbers; null frames: nothing.
struct MapDelta {
  std::string method;  ///< its id
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  SharedFrame tiles;
  SharedFrame points;
};

/// Everything about the maps that viewers are told, as it was at one moment. Texts are whole messages.
struct Publication {
  live::ReadingLog readings;
  std::shared_ptr<const std::vector<Vec2>> path;
  std::uint64_t run = 0;  ///< grows when all starts anew: pings and path before it are void
  std::uint64_t methods_version = 0;
  SharedFrame methods;
  std::vector<MapDelta> deltas;  ///< against the publication before
  SharedFrame laser;             ///< null: no new scan
  std::uint64_t second = 0;      ///< grows with the texts below
  std::string counters;          ///< open at its end: the viewer's own count and "}" follow
  SharedFrame scores;
  SharedFrame timeline;
  std::vector<SharedFrame> recompute;
};
using SharedPublication = std::shared_ptr<const Publication>;

/// Maps records on a thread of its own and publishes what changed: pings thirty times a second, maps ten times or less
/// often, so that looking at them costs no more than a fifth of the time.
class MappingLoop {
 public:
  struct Host {
    std::function<void(SharedPublication)> published;  ///< on the loop's thread
    std::function<std::string()> log_status;           ///< JSON object: the `log` of `counters`
  };

  MappingLoop(live::Mapper mapper, live::ScoreKeeper scores, Host host);
  MappingLoop(const MappingLoop&) = delete;
  MappingLoop& operator=(const MappingLoop&) = delete;
  ~MappingLoop();

  void add(std::vector<live::Record>&& records);
  void restart();
  /// Nothing follows what was added, unless all starts anew: pings that wait for more are decided.
  void end_of_records();
  [[nodiscard]] bool crowded();
  /// Does something with the mapper on its thread, between records. After `changed` the methods are told anew.
  struct Access {
    live::Mapper& mapper;
    live::ScoreKeeper& scores;
    bool changed = false;
  };
  void post(std::function<void(Access&)> job);
  /// Deltas from older numbers than the last publication's, and the methods' message they belong to.
  struct CatchUp {
    std::uint64_t methods_version = 0;
    SharedFrame methods;
    std::vector<MapDelta> deltas;
  };
  void catch_up(std::map<std::string, std::uint32_t> since, std::function<void(CatchUp)> answer);
  /// What questions are asked about: copies.
  [[nodiscard]] static live::Evidence evidence_of(const live::Mapper& mapper, const live::SourceDescription& source);

 private:
  struct Inbox {
    std::vector<std::vector<live::Record>> records;
    std::size_t waiting = 0;
    bool restart = false;  ///< before `records`
    bool ended = false;    ///< after them
    std::vector<std::function<void(Access&)>> jobs;
  };

  void work();
  void take(Inbox& inbox);
  void publish(double now_s);
  void refresh_maps(Publication& publication);
  void tell_each_second(Publication& publication, double now_s);
  [[nodiscard]] MapDelta delta(const live::RunningMethod& method, std::size_t index, std::uint32_t since) const;
  void extend_path();
  void note_methods();

  Host host_;
  std::mutex mutex_;
  std::condition_variable wake_;
  Inbox inbox_;
  bool closing_ = false;
  // Of the thread alone:
  live::Mapper mapper_;
  live::ScoreKeeper scores_;
  std::map<std::string, std::uint32_t> published_;  // sequence numbers
  std::vector<MapDelta> deltas_;                    // of the newest refreshed maps
  double next_maps_s_ = 0.0;
  std::shared_ptr<const std::vector<Vec2>> path_ = std::make_shared<std::vector<Vec2>>();
  std::size_t path_taken_ = 0;  // odometry records that are in it
  std::uint64_t run_ = 1;
  std::uint64_t methods_version_ = 0;
  std::string methods_text_;
  SharedFrame methods_;
  std::uint64_t second_ = 0;
  double next_second_s_ = 0.0;
  std::vector<live::TimelineBin> told_bins_;
  SharedFrame scores_message_;
  std::string counters_;
  SharedFrame timeline_;
  std::thread thread_;
};

}  // namespace echoarc::server
