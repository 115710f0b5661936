// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/live/source.hpp"

namespace echoarc::live {

/// A log as if it happened now: its records in the order of time.
class ReplaySource final : public Source, public Seekable {
 public:
  /// Error: a log without any record that has a time.
  [[nodiscard]] static Result<std::unique_ptr<ReplaySource>> make(Log log);

  [[nodiscard]] const SourceDescription& description() const override { return description_; }
  [[nodiscard]] double time_s() const override { return time_s_; }
  [[nodiscard]] Result<void> advance(double until_s, std::vector<Record>& records) override;
  [[nodiscard]] bool ended() const override { return next_ == order_.size(); }
  [[nodiscard]] Seekable* seekable() override { return this; }
  void seek(double time_s) override;

 private:
  /// Kinds in the order in which they are said where times are equal: poses before what is heard from them.
  enum class Kind : std::uint8_t { odometry, truth, wall, scan, ping, poll };
  struct Entry {
    double time_s = 0.0;
    Kind kind = Kind::odometry;
    std::size_t index = 0;
  };

  explicit ReplaySource(Log log);
  template <class Of>
  void list(Kind kind, const std::vector<Of>& records);
  [[nodiscard]] Record record_of(const Entry& entry) const;

  Log log_;
  SourceDescription description_;
  std::vector<Entry> order_;
  std::size_t next_ = 0;
  double time_s_ = 0.0;
};

}  // namespace echoarc::live
