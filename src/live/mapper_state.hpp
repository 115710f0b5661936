// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "echoarc/live/mapper.hpp"
#include "echoarc/sensing/sensing.hpp"
#include "live/method_run.hpp"

namespace echoarc::live {

/// Judged pings of one kind (as they are, or laser-limited) and where along them the methods finish.
///
/// Holds on to its own address: the sensing tells it of rejections.
class JudgedStream {
 public:
  JudgedStream(const SourceDescription& source, const SensingOptions& options, bool limited);
  JudgedStream(const JudgedStream&) = delete;
  JudgedStream& operator=(const JudgedStream&) = delete;

  template <class R>
  void push(const R& record) {
    sensing_.push(record);
    take_accepted();
  }
  void push(const Ping& ping);
  void end();
  /// Methods finish here, if pings came since the last mark.
  void mark();

  [[nodiscard]] const Sensing& sensing() const { return sensing_; }
  [[nodiscard]] const ReadingLog& log() const { return log_; }
  [[nodiscard]] std::span<const std::size_t> marks() const { return marks_; }

 private:
  void take_accepted();
  void take_rejected(const Ping& ping, PingId id, Rejection reason);
  [[nodiscard]] Pose2 pose_near(double time_s) const;
  [[nodiscard]] std::optional<double> take_raw_range(PingId ping);

  SensorArray sensors_;
  Sensing sensing_;
  bool limited_;
  std::size_t taken_ = 0;  ///< of the sensing's readings
  std::deque<std::pair<PingId, double>> raw_m_;
  ReadingLog log_;
  std::vector<std::size_t> marks_;
};

/// The pings judged so far by the second, for the timeline.
class TimelineBins {
 public:
  void add(const JudgedPing& ping, double begin_s, double newest_s);
  void clear() { bins_.clear(); }
  [[nodiscard]] std::span<const TimelineBin> bins() const { return bins_; }

 private:
  std::vector<TimelineBin> bins_;
};

/// Returns of the newest scan, in the world.
class NewestScan {
 public:
  void push(const Scan& scan) { waiting_ = scan; }
  /// Places the scan once odometry reaches it.
  void place(const PoseTrack& track, std::span<const LaserMount> lasers);
  void clear() { *this = {}; }
  [[nodiscard]] std::span<const Vec2> returns() const { return returns_; }

 private:
  std::optional<Scan> waiting_;
  std::vector<Vec2> returns_;
};

class Mapper::State {
 public:
  struct Entry {
    MethodRun run;
    std::optional<MethodRun> next;        ///< with other options or sensors, on its way
    std::optional<std::size_t> exported;  ///< finishes of `run` when its map was last taken
  };

  State(const SourceDescription& source, const SensingOptions& sensing, Executor& executor,
        std::function<double()> thread_cpu_s);

  void open_streams();
  void after_push();
  void mark();
  void advance_methods();
  void recompute(std::size_t k);
  [[nodiscard]] bool recompute_slice(std::size_t k, std::size_t readings);
  bool export_method(std::size_t k);
  [[nodiscard]] Result<MethodRun> fresh_run(const MethodChoice& choice) const;
  [[nodiscard]] std::optional<std::size_t> find(std::string_view id) const;
  [[nodiscard]] const JudgedStream& stream_of(const AnyMethod& method) const;
  void advance_run(std::size_t k, MethodRun& run, std::size_t limit, Executor& executor);

  SourceDescription source;
  SensingOptions sensing_options;
  Executor* executor;
  std::function<double()> thread_cpu_s;
  std::unique_ptr<JudgedStream> plain;
  std::unique_ptr<JudgedStream> limited;  ///< where the robot has lasers, and readings are not limited anyway
  std::vector<RunningMethod> methods;
  std::vector<Entry> entries;  ///< in the order of `methods`
  std::set<SensorId> off;
  std::uint32_t removed_at = 0;  ///< newest sequence number of the maps that were removed
  TimelineBins timeline;
  std::size_t timed = 0;  ///< pings in the timeline
  NewestScan scan;
  TruthLog truth;
  double next_mark_s = -std::numeric_limits<double>::infinity();
};

}  // namespace echoarc::live
