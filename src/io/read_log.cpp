// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/read_log.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "echoarc/io/byte_source.hpp"
#include "echoarc/io/carmen.hpp"
#include "echoarc/io/delimited.hpp"
#include "echoarc/io/jsonl.hpp"
#include "echoarc/io/plain_csv.hpp"
#include "io/carmen_messages.hpp"
#include "io/text_cells.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t head_bytes = std::size_t{1} << 16U;

/// A source whose first bytes have been looked at. Works for pipes, which cannot be rewound.
class PeekedSource final : public ByteSource {
 public:
  static Result<PeekedSource> make(std::unique_ptr<ByteSource> source) {
    std::string head(head_bytes, '\0');
    std::size_t size = 0;
    while (size < head.size()) {
      const Result<std::size_t> count = source->read(std::span(head).subspan(size));
      if (!count) return count.error();
      if (*count == 0) break;
      size += *count;
    }
    head.resize(size);
    return PeekedSource(std::move(source), std::move(head));
  }
  [[nodiscard]] std::string_view head() const { return head_; }
  [[nodiscard]] const std::string& name() const override { return source_->name(); }
  [[nodiscard]] Result<std::size_t> read(std::span<char> buffer) override {
    if (given_ == head_.size()) return source_->read(buffer);
    const std::size_t count = std::min(buffer.size(), head_.size() - given_);
    std::memcpy(buffer.data(), head_.data() + given_, count);
    given_ += count;
    return count;
  }

 private:
  PeekedSource(std::unique_ptr<ByteSource> source, std::string head)
      : source_(std::move(source)), head_(std::move(head)) {}

  std::unique_ptr<ByteSource> source_;
  std::string head_;
  std::size_t given_ = 0;
};

struct Magic {
  std::string_view bytes;
  std::string_view name;
  std::string_view remedy;
};
constexpr std::array magics = {
    Magic{"\x1f\x8b", "gzip", "unpack it first: gunzip"},
    Magic{"\x28\xb5\x2f\xfd", "Zstandard", "unpack it first: unzstd"},
    Magic{"PK\x03\x04", "zip", "unpack it first: unzip"},
    Magic{"#ROSBAG", "rosbag", "bags are not read yet; export the ranges and odometry to CSV"},
    Magic{"SQLite format 3", "SQLite (rosbag2)", "bags are not read yet; export the ranges and odometry to CSV"},
    Magic{"\x89MCAP", "MCAP", "bags are not read yet; export the ranges and odometry to CSV"},
};

/// An error for contents that cannot be a log in text.
Result<void> check_text(std::string_view head, const std::string& name) {
  if (head.empty())
    return Error{ErrorCode::bad_format, "the file is empty", name, "check that the recording was written"};
  for (const Magic& magic : magics)
    if (head.starts_with(magic.bytes))
      return Error{ErrorCode::unsupported, fmt::format("this is a {} file", magic.name), name,
                   std::string(magic.remedy)};
  const std::size_t zero = head.find('\0');
  if (zero != std::string_view::npos)
    return Error{ErrorCode::bad_format, fmt::format("this is not text: byte {} is 0", zero),
                 fmt::format("{}:{}", name, 1 + std::ranges::count(head.substr(0, zero), '\n')),
                 "give a log in JSON Lines, CARMEN or CSV"};
  return {};
}

enum class Format { unknown, jsonl, carmen, plain_csv };

/// By the first lines that are not comments; a CARMEN log may start with messages this reader does not use.
Format format_by_content(std::string_view head) {
  constexpr int lines_looked_at = 200;
  bool first = true;
  for (int i = 0; i < lines_looked_at && !head.empty(); ++i) {
    const std::size_t end = std::min(head.find('\n'), head.size());
    std::string_view line = trimmed(head.substr(0, end));
    if (line.ends_with('\r')) line.remove_suffix(1);
    head.remove_prefix(std::min(end + 1, head.size()));
    if (line.empty() || line.starts_with('#')) continue;
    if (first && line.starts_with('{')) return Format::jsonl;
    if (first && is_plain_csv_header(line)) return Format::plain_csv;
    if (is_carmen_message(line)) return Format::carmen;
    first = false;
  }
  return Format::unknown;
}

Format format_by_extension(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".jsonl" || extension == ".ndjson") return Format::jsonl;
  return extension == ".clf" || extension == ".log" ? Format::carmen : Format::unknown;
}

Result<Log> read_by_format(const std::filesystem::path& path, const ReadOptions& options) {
  Result<std::unique_ptr<ByteSource>> file = FileSource::open(path);
  if (!file) return file.error();
  Result<PeekedSource> source = PeekedSource::make(std::move(*file));
  if (!source) return source.error();
  if (const Result<void> text = check_text(source->head(), path.string()); !text) return text.error();
  Format format = format_by_content(source->head());
  if (format == Format::unknown) format = format_by_extension(path);
  switch (format) {
    case Format::jsonl: return read_jsonl(*source, options.limits, options.copy_of_jsonl);
    case Format::carmen: return read_carmen(*source, options.limits);
    case Format::plain_csv: return read_plain_csv(path, {options.robot, options.odometry, options.limits});
    case Format::unknown: break;
  }
  return Error{
      ErrorCode::unsupported,
      "the format is not recognised: not JSON Lines (first line a JSON object), not CARMEN (lines such as ODOM "
      "or SONAR), not CSV with a header line t,sensor_id,range_m",
      path.string() + ":1", "describe its columns in a TOML file: --describe FILE.toml (examples in descriptions/)"};
}

Result<Log> read_described(const std::filesystem::path& path, const ReadOptions& options) {
  Result<DelimitedDescription> description = read_description(*options.description);
  if (!description) return description.error();
  return read_delimited(*description, path, options.limits);
}

}  // namespace

Result<Log> read_log(const std::filesystem::path& path, const ReadOptions& options) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    return Error{ErrorCode::not_found, "there is no such file or folder", path.string(),
                 "check the spelling of the path"};
  if (!options.description && status.type() == std::filesystem::file_type::directory)
    return Error{ErrorCode::unsupported, "a folder is read by a description of its files", path.string(),
                 "add --describe FILE.toml (examples in descriptions/), or name a log file in it"};
  Result<Log> log = options.description ? read_described(path, options) : read_by_format(path, options);
  if (!log) return log;
  log->source = path.string();
  if (options.robot) log->robot = *options.robot;
  return log;
}

}  // namespace echoarc::io
