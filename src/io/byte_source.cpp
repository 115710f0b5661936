// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/byte_source.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

namespace echoarc::io {
namespace {

Error unreadable(const std::string& name, int system_error) {
  return {ErrorCode::unreadable, "cannot read: " + std::generic_category().message(system_error), name,
          "check that it is a file you may read"};
}

}  // namespace

Result<std::size_t> MemorySource::read(std::span<char> buffer) {
  const std::size_t count = std::min(buffer.size(), bytes_.size());
  if (count > 0) std::memcpy(buffer.data(), bytes_.data(), count);
  bytes_.remove_prefix(count);
  return count;
}

Result<std::unique_ptr<ByteSource>> FileSource::open(const std::filesystem::path& path) {
  std::error_code ignored;  // what cannot be examined cannot be opened either, and fopen says why
  if (std::filesystem::is_directory(path, ignored))
    return Error{ErrorCode::unreadable, "this is a folder, not a file", path.string(), "name a file in it"};
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr && errno == ENOENT)
    return Error{ErrorCode::not_found, "there is no such file", path.string(), "check the spelling of the path"};
  if (file == nullptr) return unreadable(path.string(), errno);
  std::setvbuf(file, nullptr, _IONBF, 0);  // readers ask for large blocks; a second buffer would only copy
  return std::unique_ptr<ByteSource>(new FileSource(file, path.string()));
}

Result<std::size_t> FileSource::read(std::span<char> buffer) {
  errno = 0;
  const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file_.get());
  if (count == 0 && std::ferror(file_.get()) != 0) return unreadable(name_, errno);
  return count;
}

Result<std::string> read_all(ByteSource& source, std::size_t max_bytes) {
  constexpr std::size_t block = std::size_t{1} << 16U;
  std::string text;
  while (true) {
    const std::size_t size = text.size();
    text.resize(size + block);
    const Result<std::size_t> count = source.read(std::span(text).subspan(size));
    if (!count) return count.error();
    text.resize(size + *count);
    if (*count == 0) return text;
    if (text.size() > max_bytes)
      return Error{ErrorCode::too_large, fmt::format("longer than {} bytes", max_bytes), source.name(),
                   "check that this is the right file"};
  }
}

}  // namespace echoarc::io
