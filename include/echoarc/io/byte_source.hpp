// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// Where a reader gets its bytes from: a file, a pipe, memory. Read once, front to back.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// What messages call it: a path, usually.
  [[nodiscard]] virtual const std::string& name() const = 0;
  /// Puts the next bytes at the front of `buffer` and says how many; 0 means the end (of a buffer that is not empty).
  [[nodiscard]] virtual Result<std::size_t> read(std::span<char> buffer) = 0;
};

/// Bytes that the caller keeps alive.
class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::string_view bytes, std::string name = "memory") : bytes_(bytes), name_(std::move(name)) {}

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Result<std::size_t> read(std::span<char> buffer) override;

 private:
  std::string_view bytes_;
  std::string name_;
};

/// A file or a pipe.
class FileSource final : public ByteSource {
 public:
  /// Errors: not_found; unreadable for a folder or a file without permission.
  [[nodiscard]] static Result<std::unique_ptr<ByteSource>> open(const std::filesystem::path& path);

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Result<std::size_t> read(std::span<char> buffer) override;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  FileSource(std::FILE* file, std::string name) : file_(file), name_(std::move(name)) {}

  std::unique_ptr<std::FILE, Close> file_;
  std::string name_;
};

/// Everything a source holds, as text. Error: too_large when it holds more than `max_bytes`.
[[nodiscard]] Result<std::string> read_all(ByteSource& source, std::size_t max_bytes);

}  // namespace echoarc::io
