// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"

/// The log of a running robot: a JSON Lines log that is written while it happens, and read again in the order in which
/// it was written. It lies in a folder as session.jsonl, session-2.jsonl and so on, each a log of its own with a
/// header.
namespace echoarc::io {

/// A true pose of a simulation.
struct TruthLine {
  Odometry pose;
};
/// A record that a log's reader does not know, such as a command: one JSON object without line feed.
struct OtherLine {
  std::string json;
};
using SessionLine = std::variant<Odometry, TruthLine, Ping, Scan, Poll, WallNote, OtherLine>;

/// Appends the record and a line feed. Error: bad_value for what is not finite; nothing is appended then.
[[nodiscard]] Result<void> append_line(const SessionLine& line, std::string& text);

struct SessionLogLimits {
  std::uint64_t part_bytes = std::uint64_t{1} << 30U;    ///< a part that is larger is followed by another
  std::uint64_t total_bytes = std::uint64_t{16} << 30U;  ///< all parts together; nothing is written beyond
};

/// Writes the parts of one session. What `write` has written is with the system, and survives the end of the process;
/// what was there at the last `sync` also survives the end of the system.
class SessionLog {
 public:
  enum class State : std::uint8_t { on, full, limit };

  /// Begins a session in `folder` (made if absent). `robot` gives the header. Errors: a session lies there already, a
  /// folder that cannot be written to, a header number that is not finite.
  [[nodiscard]] static Result<SessionLog> create(const std::filesystem::path& folder, const Log& robot,
                                                 const SessionLogLimits& limits = {});
  /// Goes on with the session in `folder`; what is left of a line that was being written when it ended is cut off.
  [[nodiscard]] static Result<SessionLog> resume(const std::filesystem::path& folder, const Log& robot,
                                                 const SessionLogLimits& limits = {});
  SessionLog(SessionLog&& other) noexcept;
  SessionLog& operator=(SessionLog&& other) noexcept;
  SessionLog(const SessionLog&) = delete;
  SessionLog& operator=(const SessionLog&) = delete;
  ~SessionLog();

  /// Appends whole lines, all of them or none. Where they do not fit (a full disk, the limit) the log is given up:
  /// `state` says why, and nothing is written from then on.
  void write(std::string_view lines);
  void sync();

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] std::uint64_t bytes() const { return total_bytes_; }     ///< of all parts
  [[nodiscard]] const std::string& message() const { return message_; }  ///< why it was given up; else empty

 private:
  SessionLog(std::filesystem::path folder, std::string header, const SessionLogLimits& limits);
  [[nodiscard]] Result<void> open_part(int number, bool anew);
  void give_up(State state, std::string message);

  std::filesystem::path folder_;
  std::string header_;  // with line feed
  SessionLogLimits limits_;
  int file_ = -1;
  int part_ = 0;
  std::uint64_t part_bytes_ = 0;
  std::uint64_t total_bytes_ = 0;
  State state_ = State::on;
  std::string message_;
};

/// The parts of a session, in order; empty: there is none.
[[nodiscard]] std::vector<std::filesystem::path> session_parts(const std::filesystem::path& folder);

/// Reads a session line by line, in the order in which it was written. The result holds what the header says and what
/// was odd, and no records. A line that was cut short at the end of a part is passed over. Errors: no session there, a
/// bad header, a newer version, parts of different robots, too many bad lines.
[[nodiscard]] Result<Log> read_session(const std::filesystem::path& folder,
                                       const std::function<void(SessionLine)>& take);

}  // namespace echoarc::io
