// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/byte_sink.hpp"

#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

namespace echoarc::io {

Result<void> StringSink::write(std::string_view bytes) {
  text_ += bytes;
  return {};
}

Result<std::unique_ptr<FileSink>> FileSink::create(const std::filesystem::path& path) {
  std::filesystem::path part = path;
  part += ".part";
  std::FILE* file = std::fopen(part.c_str(), "wb");
  const int system_error = errno;
  std::unique_ptr<FileSink> sink(new FileSink(file, path, std::move(part)));
  if (file == nullptr) return sink->failed(system_error);
  return sink;
}

FileSink::~FileSink() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::error_code ignored;  // a destructor has nobody to tell
  std::filesystem::remove(part_, ignored);
}

Result<void> FileSink::write(std::string_view bytes) {
  assert(file_ != nullptr);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) return failed(errno);
  return {};
}

Result<void> FileSink::commit() {
  assert(file_ != nullptr);
  const bool flushed = std::fflush(file_) == 0;
  if (!flushed) return failed(errno);
  std::fclose(std::exchange(file_, nullptr));
  std::error_code error;
  std::filesystem::rename(part_, path_, error);
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    return failed(error.value());
  }
  return {};
}

Error FileSink::failed(int system_error) const {
  return {ErrorCode::unwritable, "cannot write: " + std::generic_category().message(system_error), path_.string(),
          "check that the folder exists, that you may write there and that the disk is not full"};
}

}  // namespace echoarc::io
