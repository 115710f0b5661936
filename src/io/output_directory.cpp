// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/output_directory.hpp"

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "echoarc/io/run_report.hpp"
#include "io/files.hpp"

namespace echoarc::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_report_bytes = std::size_t{64} << 20;
constexpr int max_partial_folders = 1000;

bool written_by_echoarc(const fs::path& directory) {
  const Result<std::string> text = read_file(directory / run_report_name, max_report_bytes);
  if (!text) return false;
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  return json.is_object() && json.value("written_by", nlohmann::json()) == "echoarc";
}

/// Whether something stands under the name that must not be replaced.
Result<void> check_replaceable(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::symlink_status(path, code);
  if (!fs::exists(status)) return {};
  if (!fs::is_directory(status))
    return Error{ErrorCode::unwritable, "exists and is not a folder", path.string(), "choose another name (-o DIR)"};
  if (fs::is_empty(path, code) || written_by_echoarc(path)) return {};
  return Error{ErrorCode::unwritable, "exists and was not written by echoarc", path.string(),
               "choose another name (-o DIR), or move the folder away"};
}

/// The folder's name without links, "." and a trailing slash.
Result<fs::path> resolved(const fs::path& given) {
  std::error_code code;
  const fs::path absolute = fs::absolute(given, code);
  fs::path path = code ? fs::path() : fs::weakly_canonical(absolute, code).lexically_normal();
  if (code && !given.empty()) return unwritable(given, code.message());
  if (!path.has_filename()) path = path.parent_path();
  if (!path.has_filename())
    return Error{ErrorCode::bad_value, "is no name for a folder", given.string(), "name a folder (-o DIR)"};
  return path;
}

Result<fs::path> make_partial_folder(const fs::path& final_path) {
  std::error_code code;
  fs::create_directories(final_path.parent_path(), code);
  if (code) return unwritable(final_path.parent_path(), code.message());
  for (int i = 1; i <= max_partial_folders; ++i) {
    fs::path partial = final_path.parent_path() / fmt::format(".{}.partial-{}", final_path.filename().string(), i);
    if (fs::create_directory(partial, code)) return partial;
    if (code && code != std::errc::file_exists) return unwritable(final_path, code.message());
  }
  return unwritable(final_path, fmt::format("{} unfinished folders lie beside it", max_partial_folders));
}

/// Puts `partial` under the name `final_path` and leaves what stood there, if anything, under the name `partial`.
std::error_code exchange(const fs::path& partial, const fs::path& final_path) {
  if (renameat2(AT_FDCWD, partial.c_str(), AT_FDCWD, final_path.c_str(), RENAME_EXCHANGE) == 0) return {};
  if (errno != EINVAL && errno != ENOSYS) return {errno, std::generic_category()};
  // The file system cannot exchange: two steps, with a moment in which the name is free.
  const fs::path aside = partial.string() + "-old";
  std::error_code code;
  fs::rename(final_path, aside, code);
  if (code) return code;
  fs::rename(partial, final_path, code);
  std::error_code back;
  fs::rename(aside, code ? final_path : partial, back);
  return code;
}

}  // namespace

OutputDirectory::OutputDirectory(fs::path partial, fs::path final_path)
    : partial_(std::move(partial)), final_(std::move(final_path)) {}

OutputDirectory::OutputDirectory(OutputDirectory&& other) noexcept
    : partial_(std::exchange(other.partial_, {})), final_(std::move(other.final_)) {}

OutputDirectory& OutputDirectory::operator=(OutputDirectory&& other) noexcept {
  if (this != &other) {
    discard();
    partial_ = std::exchange(other.partial_, {});
    final_ = std::move(other.final_);
  }
  return *this;
}

OutputDirectory::~OutputDirectory() {
  discard();
}

void OutputDirectory::discard() noexcept {
  if (partial_.empty()) return;
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
  partial_.clear();
}

Result<OutputDirectory> OutputDirectory::create(const fs::path& final_path) {
  const Result<fs::path> path = resolved(final_path);
  if (!path) return path.error();
  if (const Result<void> free = check_replaceable(*path); !free) return free.error();
  Result<fs::path> partial = make_partial_folder(*path);
  if (!partial) return partial.error();
  return OutputDirectory(std::move(*partial), *path);
}

Result<void> OutputDirectory::commit() {
  assert(!partial_.empty());
  // Somebody may have put something there since `create`.
  if (const Result<void> free = check_replaceable(final_); !free) {
    discard();
    return free;
  }
  std::error_code code;
  if (fs::exists(fs::symlink_status(final_, code)))
    code = exchange(partial_, final_);
  else
    fs::rename(partial_, final_, code);
  if (!code) {
    discard();  // the old folder, after an exchange
    return {};
  }
  discard();
  return unwritable(final_, code.message());
}

}  // namespace echoarc::io
