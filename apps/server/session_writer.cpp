// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/session_writer.hpp"

#include <chrono>
#include <cmath>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace echoarc::server {
namespace {

constexpr std::chrono::milliseconds group_interval{50};
constexpr std::size_t max_waiting_bytes = std::size_t{64} << 20U;

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

std::string command_json(const live::CommandNote& note) {
  return fmt::format(R"({{"type":"command","t":{},"mode":"{}","v":{},"w":{}}})", note.time_s, note.mode,
                     note.wanted.forward_m_s, note.wanted.turn_per_s.rad());
}

}  // namespace

io::SessionLine line_of(const live::Record& record) {
  return std::visit(
      Overloaded{[](const live::Truth& truth) -> io::SessionLine { return io::TruthLine{truth.pose}; },
                 [](const live::CommandNote& note) -> io::SessionLine { return io::OtherLine{command_json(note)}; },
                 [](const auto& other) -> io::SessionLine { return other; }},
      record);
}

std::optional<live::Record> record_of(const io::SessionLine& line) {
  return std::visit(
      Overloaded{[](const io::TruthLine& truth) -> std::optional<live::Record> { return live::Truth{truth.pose}; },
                 [](const io::OtherLine&) -> std::optional<live::Record> { return std::nullopt; },
                 [](const auto& other) -> std::optional<live::Record> { return other; }},
      line);
}

SessionWriter::SessionWriter(io::SessionLog log)
    : status_{log.state(), log.bytes(), log.message()}, log_(std::move(log)), thread_([this] { work(); }) {}

SessionWriter::~SessionWriter() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void SessionWriter::add(const live::Record& record) {
  add_line(line_of(record));
}

void SessionWriter::add_setup(std::string json) {
  add_line(io::OtherLine{std::move(json)});
}

void SessionWriter::add_line(const io::SessionLine& line) {
  const std::lock_guard lock(mutex_);
  if (status_.state != io::SessionLog::State::on) return;
  (void)io::append_line(line, waiting_);  // what is not finite has no line; sensing counts it
  if (waiting_.size() <= max_waiting_bytes) return;
  status_ = {io::SessionLog::State::full, status_.bytes, "the disk does not keep up"};
  given_up_ = true;
}

SessionWriter::Status SessionWriter::status() {
  const std::lock_guard lock(mutex_);
  return status_;
}

void SessionWriter::work() {
  std::unique_lock lock(mutex_);
  bool last = false;
  while (!last) {
    wake_.wait_for(lock, group_interval, [&] { return closing_; });
    last = closing_;
    const std::string group = std::exchange(waiting_, {});
    lock.unlock();
    if (!group.empty()) {
      log_.write(group);
      log_.sync();
    }
    lock.lock();
    if (!given_up_) status_ = {log_.state(), log_.bytes(), log_.message()};
  }
}

}  // namespace echoarc::server
