// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace echoarc::live {

/// A list that only grows, in chunks that never change once they are full. A copy is cheap and stays as it was, even
/// while another thread appends to the list that it was made from.
template <class T>
class ChunkedLog {
 public:
  static constexpr std::size_t chunk_size = 1024;

  void append(const T& item) {
    const std::size_t within = size_ % chunk_size;
    if (within == 0) {
      chunks_.push_back(std::make_shared<std::vector<T>>());
      chunks_.back()->reserve(chunk_size);
    } else if (chunks_.back()->size() != within) {
      // Another copy has gone on in this chunk: from here on each has its own.
      auto own = std::make_shared<std::vector<T>>();
      own->reserve(chunk_size);
      own->assign(chunks_.back()->data(), chunks_.back()->data() + within);
      chunks_.back() = std::move(own);
    }
    chunks_.back()->push_back(item);
    ++size_;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const T& operator[](std::size_t index) const {
    // Not by the vector's operator[]: a checked one reads the size, which the thread that appends writes.
    return chunks_[index / chunk_size]->data()[index % chunk_size];
  }
  void clear() {
    chunks_.clear();
    size_ = 0;
  }

 private:
  std::vector<std::shared_ptr<std::vector<T>>> chunks_;
  std::size_t size_ = 0;
};

}  // namespace echoarc::live
