# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

# cmake -D PAGE=folder -D OUTPUT=file.cpp -P EmbedPage.cmake: the files of a built page, compressed, as the table behind
# echoarc::server::page_files(). Names of files are fixed by the page's build, so every path is known here.
set(types_html "text/html; charset=utf-8")
set(types_js "text/javascript; charset=utf-8")
set(types_css "text/css; charset=utf-8")
set(types_svg "image/svg+xml")
set(types_webmanifest "application/manifest+json")
set(types_png "image/png")

file(GLOB files RELATIVE "${PAGE}" "${PAGE}/*")
list(SORT files)
set(arrays "")
set(entries "")
set(count 0)
foreach(file IN LISTS files)
  cmake_path(GET file EXTENSION LAST_ONLY extension)
  string(SUBSTRING "${extension}" 1 -1 extension)
  if(NOT DEFINED types_${extension})
    message(FATAL_ERROR "no content type for ${file}")
  endif()
  execute_process(COMMAND gzip -9 -n -c "${PAGE}/${file}" OUTPUT_FILE "${OUTPUT}.gz" COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${OUTPUT}.gz" hex HEX)
  file(SHA256 "${OUTPUT}.gz" hash)
  file(REMOVE "${OUTPUT}.gz")
  string(SUBSTRING "${hash}" 0 16 tag)
  string(LENGTH "${hex}" digits)
  math(EXPR bytes "${digits} / 2")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
  string(APPEND arrays "constexpr unsigned char file_${count}[] = {${hex}};\n")
  set(path "/${file}")
  if(file STREQUAL "index.html")
    set(path "/")
  endif()
  string(APPEND entries "      {\"${path}\", \"${types_${extension}}\", text(file_${count}, ${bytes}), \"\\\"${tag}\\\"\"},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE "${OUTPUT}" "// Made by cmake/EmbedPage.cmake.
#include \"server/page_files.hpp\"

#include <array>
#include <cstddef>

namespace echoarc::server {
namespace {

std::string_view text(const unsigned char* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

${arrays}
}  // namespace

std::span<const PageFile> page_files() {
  static const std::array<PageFile, ${count}> files{{
${entries}  }};
  return files;
}

}  // namespace echoarc::server
")
