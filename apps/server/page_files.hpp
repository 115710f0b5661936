// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>

namespace echoarc::server {

/// A file of the page, compressed by gzip when the command was built.
struct PageFile {
  std::string_view path;  ///< "/", "/main.js", ...
  std::string_view type;  ///< of its content
  std::string_view gzip;
  std::string_view etag;  ///< quoted
};

/// Made by cmake/EmbedPage.cmake.
[[nodiscard]] std::span<const PageFile> page_files();

}  // namespace echoarc::server
