// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/files.hpp"

#include <memory>

#include <fmt/format.h>

#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/byte_source.hpp"

namespace echoarc::io {

Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  const Result<std::unique_ptr<ByteSource>> source = FileSource::open(path);
  if (!source) return source.error();
  return read_all(**source, max_bytes);
}

Result<void> write_file(const std::filesystem::path& path, std::initializer_list<std::string_view> pieces) {
  const Result<std::unique_ptr<FileSink>> sink = FileSink::create(path);
  if (!sink) return sink.error();
  for (const std::string_view piece : pieces)
    if (const Result<void> written = (*sink)->write(piece); !written) return written;
  return (*sink)->commit();
}

Error unwritable(const std::filesystem::path& path, std::string_view reason) {
  return {ErrorCode::unwritable, fmt::format("cannot be written: {}", reason), path.string(),
          "choose a folder you may write to, on a disk with free space (-o DIR)"};
}

}  // namespace echoarc::io
