// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace echoarc {

/// Appends plain values to a byte buffer: what `save()` of a method writes. Native byte order: a saved state is a
/// checkpoint of this machine, not an exchange format.
class ByteWriter {
 public:
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void put(const T& value) {
    put_all(std::span<const T>(&value, 1));
  }
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void put_all(std::span<const T> values) {
    const auto raw = std::as_bytes(values);
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
  }
  /// Element count, then the elements.
  template <class T>
  void put_vector(const std::vector<T>& values) {
    put<std::uint64_t>(values.size());
    put_all(std::span<const T>(values));
  }
  [[nodiscard]] std::vector<std::byte> take() && { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Reads back what `ByteWriter` wrote. After the first short read every further read fails, so one check at the end of
/// a block suffices. Never allocates more than the buffer can hold.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class T>
    requires std::is_trivially_copyable_v<T>
  [[nodiscard]] T get() {
    T value{};
    (void)get_all(std::span<T>(&value, 1));
    return value;
  }
  template <class T>
    requires std::is_trivially_copyable_v<T>
  bool get_all(std::span<T> values) {
    if (failed_ || bytes_.size() < values.size_bytes()) {
      failed_ = true;
      return false;
    }
    if (!values.empty()) std::memcpy(values.data(), bytes_.data(), values.size_bytes());
    bytes_ = bytes_.subspan(values.size_bytes());
    return true;
  }
  template <class T>
  [[nodiscard]] std::vector<T> get_vector() {
    const auto count = get<std::uint64_t>();
    if (failed_ || count > bytes_.size() / sizeof(T)) {
      failed_ = true;
      return {};
    }
    std::vector<T> values(count);
    (void)get_all(std::span<T>(values));
    return values;
  }
  /// True when every read succeeded and nothing is left over.
  [[nodiscard]] bool done() const { return !failed_ && bytes_.empty(); }
  [[nodiscard]] bool ok() const { return !failed_; }

 private:
  std::span<const std::byte> bytes_;
  bool failed_ = false;
};

}  // namespace echoarc
