// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "echoarc/io/session_log.hpp"
#include "echoarc/live/record.hpp"

namespace echoarc::server {

/// Writes a session log on a thread of its own, in groups at most 50 ms apart, so that a slow disk delays nobody.
class SessionWriter {
 public:
  struct Status {
    io::SessionLog::State state = io::SessionLog::State::on;
    std::uint64_t bytes = 0;
    std::string message;
  };

  explicit SessionWriter(io::SessionLog log);
  SessionWriter(const SessionWriter&) = delete;
  SessionWriter& operator=(const SessionWriter&) = delete;
  /// Writes and syncs what is left.
  ~SessionWriter();

  void add(const live::Record& record);
  /// What was changed of the maps, one JSON object without line feed: {"type":"setup",...}.
  void add_setup(std::string json);
  [[nodiscard]] Status status();

 private:
  void add_line(const io::SessionLine& line);
  void work();

  std::mutex mutex_;
  std::condition_variable wake_;
  std::string waiting_;
  Status status_;
  bool closing_ = false;
  bool given_up_ = false;  // more waited than the disk took
  io::SessionLog log_;     // of the thread alone
  std::thread thread_;
};

/// The record as the session log keeps it, and back; a line of neither kind gives none.
[[nodiscard]] io::SessionLine line_of(const live::Record& record);
[[nodiscard]] std::optional<live::Record> record_of(const io::SessionLine& line);

}  // namespace echoarc::server
