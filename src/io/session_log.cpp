// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/session_log.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "io/files.hpp"
#include "io/jsonl_header.hpp"
#include "io/record_text.hpp"

namespace fs = std::filesystem;

namespace echoarc::io {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

fs::path part_path(const fs::path& folder, int number) {
  return folder / (number == 1 ? std::string("session.jsonl") : fmt::format("session-{}.jsonl", number));
}

/// Behind the last line feed of a file; what follows was cut short.
Result<std::uint64_t> end_of_lines(int file, const fs::path& path) {
  std::uint64_t end = static_cast<std::uint64_t>(std::max<off_t>(0, lseek(file, 0, SEEK_END)));
  std::array<char, 4096> block{};
  while (end > 0) {
    const std::size_t size = std::min<std::uint64_t>(block.size(), end);
    const std::uint64_t begin = end - size;
    if (pread(file, block.data(), size, static_cast<off_t>(begin)) != static_cast<ssize_t>(size))
      return Error{ErrorCode::unreadable, std::strerror(errno), path.string(), "check the disk"};
    const std::string_view bytes(block.data(), size);
    if (const std::size_t at = bytes.rfind('\n'); at != std::string_view::npos) return begin + at + 1;
    end = begin;
  }
  return end;
}

Result<std::string> header_line(const Log& robot) {
  Result<std::string> header = jsonl_header(robot);
  if (header) *header += '\n';
  return header;
}

}  // namespace

Result<void> append_line(const SessionLine& line, std::string& text) {
  RecordText out;
  std::visit(
      Overloaded{[&](const Odometry& pose) { write_pose(out, "odom", pose); },
                 [&](const TruthLine& truth) { write_pose(out, "truth", truth.pose); },
                 [&](const Ping& ping) { write_ping(out, ping); }, [&](const Scan& scan) { write_scan(out, scan); },
                 [&](const Poll& poll) { write_poll(out, poll); }, [&](const WallNote& note) { write_wall(out, note); },
                 [&](const OtherLine& other) { out.text(other.json); }},
      line);
  if (!out.all_finite())
    return Error{ErrorCode::bad_value, "a time, pose or angle is not finite", "",
                 "JSON has no word for it; look at what the source says"};
  text += out.buffer();
  text += '\n';
  return {};
}

std::vector<fs::path> session_parts(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code ignored;
  for (int number = 1; fs::exists(part_path(folder, number), ignored); ++number)
    parts.push_back(part_path(folder, number));
  return parts;
}

SessionLog::SessionLog(fs::path folder, std::string header, const SessionLogLimits& limits)
    : folder_(std::move(folder)), header_(std::move(header)), limits_(limits) {}

SessionLog::SessionLog(SessionLog&& other) noexcept
    : folder_(std::move(other.folder_)),
      header_(std::move(other.header_)),
      limits_(other.limits_),
      file_(std::exchange(other.file_, -1)),
      part_(other.part_),
      part_bytes_(other.part_bytes_),
      total_bytes_(other.total_bytes_),
      state_(other.state_),
      message_(std::move(other.message_)) {}

SessionLog& SessionLog::operator=(SessionLog&& other) noexcept {
  if (this == &other) return *this;
  std::destroy_at(this);
  return *std::construct_at(this, std::move(other));
}

SessionLog::~SessionLog() {
  if (file_ >= 0) ::close(file_);
}

Result<SessionLog> SessionLog::create(const fs::path& folder, const Log& robot, const SessionLogLimits& limits) {
  Result<std::string> header = header_line(robot);
  if (!header) return header.error();
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return unwritable(folder, failed.message());
  if (!session_parts(folder).empty())
    return Error{ErrorCode::unwritable, "a session lies there already", folder.string(),
                 "continue it with --resume, or choose another folder with -o"};
  SessionLog log(folder, std::move(*header), limits);
  if (const Result<void> opened = log.open_part(1, true); !opened) return opened.error();
  return log;
}

Result<SessionLog> SessionLog::resume(const fs::path& folder, const Log& robot, const SessionLogLimits& limits) {
  Result<std::string> header = header_line(robot);
  if (!header) return header.error();
  const std::vector<fs::path> parts = session_parts(folder);
  if (parts.empty())
    return Error{ErrorCode::not_found, "there is no session.jsonl", folder.string(),
                 "name the folder that `echoarc serve -o` was given"};
  SessionLog log(folder, std::move(*header), limits);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) log.total_bytes_ += fs::file_size(parts[i]);
  if (const Result<void> opened = log.open_part(static_cast<int>(parts.size()), false); !opened) return opened.error();
  return log;
}

Result<void> SessionLog::open_part(int number, bool anew) {
  const fs::path path = part_path(folder_, number);
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_APPEND | (anew ? O_CREAT | O_EXCL : 0), 0666);
  if (file < 0) return unwritable(path, std::strerror(errno));
  if (file_ >= 0) ::close(file_);
  file_ = file;
  part_ = number;
  part_bytes_ = 0;
  if (!anew) {
    const Result<std::uint64_t> end = end_of_lines(file_, path);
    if (!end) return end.error();
    if (ftruncate(file_, static_cast<off_t>(*end)) != 0) return unwritable(path, std::strerror(errno));
    part_bytes_ = *end;
    total_bytes_ += *end;
  }
  if (part_bytes_ == 0) write(header_);
  return state_ == State::on ? Result<void>{} : unwritable(path, message_);
}

void SessionLog::write(std::string_view lines) {
  if (state_ != State::on || lines.empty()) return;
  const bool next_part = part_bytes_ > header_.size() && part_bytes_ + lines.size() > limits_.part_bytes;
  if (total_bytes_ + lines.size() + (next_part ? header_.size() : 0) > limits_.total_bytes)
    return give_up(State::limit, fmt::format("the limit of {} bytes is reached", limits_.total_bytes));
  if (next_part)
    if (const Result<void> opened = open_part(part_ + 1, true); !opened) {
      if (state_ == State::on) give_up(State::full, opened.error().message);
      return;
    }
  std::string_view rest = lines;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const std::string reason = std::strerror(errno);
      // Half a line would be read as a bad one.
      if (ftruncate(file_, static_cast<off_t>(part_bytes_)) == 0) rest = {};
      return give_up(State::full, reason);
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  part_bytes_ += lines.size();
  total_bytes_ += lines.size();
}

void SessionLog::sync() {
  if (file_ >= 0) (void)fdatasync(file_);
}

void SessionLog::give_up(State state, std::string message) {
  state_ = state;
  message_ = std::move(message);
}

}  // namespace echoarc::io
