// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// Where a writer puts its bytes.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  [[nodiscard]] virtual Result<void> write(std::string_view bytes) = 0;
};

/// Collects the bytes in memory.
class StringSink final : public ByteSink {
 public:
  [[nodiscard]] Result<void> write(std::string_view bytes) override;
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// A file that appears under its name only when it is complete: bytes go to `PATH.part`, which `commit` renames.
/// Without `commit` nothing is left behind.
class FileSink final : public ByteSink {
 public:
  /// Error: unwritable, with the system's reason.
  [[nodiscard]] static Result<std::unique_ptr<FileSink>> create(const std::filesystem::path& path);
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;
  ~FileSink() override;

  [[nodiscard]] Result<void> write(std::string_view bytes) override;
  /// Flushes and renames, replacing a file of that name. Call it once, after the last `write`.
  [[nodiscard]] Result<void> commit();

 private:
  FileSink(std::FILE* file, std::filesystem::path path, std::filesystem::path part)
      : file_(file), path_(std::move(path)), part_(std::move(part)) {}
  [[nodiscard]] Error failed(int system_error) const;

  std::FILE* file_;  ///< null once committed
  std::filesystem::path path_;
  std::filesystem::path part_;
};

}  // namespace echoarc::io
