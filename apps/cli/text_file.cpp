// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/text_file.hpp"

#include <memory>

#include "echoarc/io/byte_sink.hpp"

namespace echoarc::cli {

Result<void> write_text(const std::filesystem::path& path, std::string_view text) {
  const Result<std::unique_ptr<io::FileSink>> sink = io::FileSink::create(path);
  if (!sink) return sink.error();
  if (Result<void> written = (*sink)->write(text); !written) return written;
  return (*sink)->commit();
}

}  // namespace echoarc::cli
