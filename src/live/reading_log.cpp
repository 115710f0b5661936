// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/reading_log.hpp"

namespace echoarc::live {

void ReadingLog::append(const JudgedPing& ping) {
  const std::size_t within = size_ % chunk_size;
  if (within == 0) {
    chunks_.push_back(std::make_shared<std::vector<JudgedPing>>());
    chunks_.back()->reserve(chunk_size);
  } else if (chunks_.back()->size() != within) {
    // Another copy has gone on in this chunk: from here on each has its own.
    auto own = std::make_shared<std::vector<JudgedPing>>();
    own->reserve(chunk_size);
    own->assign(chunks_.back()->data(), chunks_.back()->data() + within);
    chunks_.back() = std::move(own);
  }
  chunks_.back()->push_back(ping);
  ++size_;
}

std::size_t ReadingLog::size() const {
  return size_;
}

const JudgedPing& ReadingLog::operator[](std::size_t index) const {
  // Not by the vector's operator[]: a checked one reads the size, which the thread that appends writes.
  return chunks_[index / chunk_size]->data()[index % chunk_size];
}

std::optional<std::size_t> ReadingLog::find(PingId ping) const {
  const auto is = [&](std::size_t k) { return (*this)[k].reading.ping == ping; };
  if (ping < size_ && is(ping)) return std::size_t(ping);
  for (std::size_t k = size_; k-- > 0;)
    if (is(k)) return k;
  return std::nullopt;
}

void ReadingLog::clear() {
  chunks_.clear();
  size_ = 0;
}

}  // namespace echoarc::live
