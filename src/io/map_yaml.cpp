// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/map_yaml.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace echoarc::io {
namespace {

constexpr double max_resolution_m = 1000.0;
constexpr double max_origin_m = 1e7;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r";
  const std::size_t first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(space) - first + 1);
}

/// A comment starts at the beginning of a line or after a space, and not inside quotes.
std::string_view without_comment(std::string_view line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != '\0')
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t'))
      return line.substr(0, i);
  }
  return line;
}

std::string_view unquoted(std::string_view text) {
  const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

std::optional<double> number_of(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// "[a, b, c]"
std::optional<std::array<double, 3>> triple_of(std::string_view text) {
  if (!text.starts_with('[') || !text.ends_with(']')) return std::nullopt;
  text = text.substr(1, text.size() - 2);
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == values.size())) return std::nullopt;
    const auto value = number_of(text.substr(0, comma));
    if (!value) return std::nullopt;
    values[i] = *value;
    if (comma != std::string_view::npos) text.remove_prefix(comma + 1);
  }
  return values;
}

/// The lines of a map.yaml by key.
class YamlLines {
 public:
  explicit YamlLines(std::string_view source) : source_(source) {}

  Result<void> split(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    for (std::size_t number = 1; !text.empty(); ++number) {
      const std::size_t end = text.find('\n');
      const std::string_view line = trimmed(without_comment(text.substr(0, end)));
      text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
      if (line.empty() || line == "---" || line == "...") continue;
      if (const Result<void> added = add(line, number); !added) return added;
    }
    return {};
  }

  [[nodiscard]] std::optional<std::string_view> value(std::string_view key) const {
    const auto found = lines_.find(key);
    return found != lines_.end() ? std::optional{found->second.value} : std::nullopt;
  }
  [[nodiscard]] Error error(std::string_view key, std::string message, std::string remedy) const {
    const auto found = lines_.find(key);
    return {ErrorCode::bad_value, std::move(message),
            found != lines_.end() ? fmt::format("{}:{}", source_, found->second.number) : source_, std::move(remedy)};
  }

 private:
  struct Line {
    std::string_view value;
    std::size_t number = 0;
  };

  Result<void> add(std::string_view line, std::size_t number) {
    const std::size_t colon = line.find(':');
    const std::string where = fmt::format("{}:{}", source_, number);
    if (colon == std::string_view::npos || colon == 0)
      return Error{ErrorCode::bad_format, "is no line of a map.yaml", where, "write one `key: value` a line"};
    const std::string_view key = trimmed(line.substr(0, colon));
    const bool fresh = lines_.emplace(key, Line{trimmed(line.substr(colon + 1)), number}).second;
    if (fresh) return {};
    return Error{ErrorCode::bad_format, fmt::format("{} is given twice", key), where, "keep one of the lines"};
  }

  std::string source_;
  std::map<std::string_view, Line> lines_;
};

/// Takes the values out of the lines; the first error stays.
class MapYamlReader {
 public:
  explicit MapYamlReader(const YamlLines& lines) : lines_(lines) {}

  Result<MapYaml> read() {
    yaml_.image = unquoted(required("image"));
    if (yaml_.image.empty()) fail("image", "image names no file", "write image: map.pgm");
    yaml_.resolution_m = number("resolution", required("resolution"), 1e-6, max_resolution_m);
    read_origin(required("origin"));
    read_negate(lines_.value("negate").value_or("0"));
    if (const auto text = lines_.value("occupied_thresh"))
      yaml_.occupied_threshold = number("occupied_thresh", *text, 0.0, 1.0);
    if (const auto text = lines_.value("free_thresh")) yaml_.free_threshold = number("free_thresh", *text, 0.0, 1.0);
    if (yaml_.free_threshold > yaml_.occupied_threshold)
      fail("free_thresh", "free_thresh lies above occupied_thresh", "use 0.196 and 0.65");
    const std::string_view mode = unquoted(lines_.value("mode").value_or("trinary"));
    if (mode != "trinary" && mode != "scale")
      fail("mode", fmt::format("mode {} is not supported", mode), "write the map with mode: trinary");
    return error_ ? Result<MapYaml>(*error_) : Result<MapYaml>(yaml_);
  }

 private:
  std::string_view required(std::string_view key) {
    const auto text = lines_.value(key);
    if (!text) fail(key, fmt::format("{} is missing", key), "a map.yaml needs image, resolution and origin");
    return text.value_or("");
  }

  double number(std::string_view key, std::string_view text, double min, double max) {
    const auto value = number_of(text);
    if (value && *value >= min && *value <= max) return *value;
    fail(key, fmt::format("{} is no number from {} to {}", key, min, max), fmt::format("correct {}", key));
    return min;
  }

  void read_origin(std::string_view text) {
    const auto origin = triple_of(text);
    if (!origin || std::abs((*origin)[0]) > max_origin_m || std::abs((*origin)[1]) > max_origin_m)
      return fail("origin", "origin is no list of three numbers in reach", "write origin: [x, y, 0.0], in metres");
    if ((*origin)[2] != 0.0)
      return fail("origin", fmt::format("origin has yaw {}: turned maps are not supported", (*origin)[2]),
                  "turn the picture itself and write yaw 0");
    yaml_.origin = {(*origin)[0], (*origin)[1]};
  }

  void read_negate(std::string_view text) {
    yaml_.negate = text == "1" || text == "true";
    if (!yaml_.negate && text != "0" && text != "false") fail("negate", "negate is neither 0 nor 1", "write negate: 0");
  }

  void fail(std::string_view key, std::string message, std::string remedy) {
    if (!error_) error_ = lines_.error(key, std::move(message), std::move(remedy));
  }

  const YamlLines& lines_;
  MapYaml yaml_;
  std::optional<Error> error_;
};

/// YAML 1.1 takes "1e-05" for a string: an exponent needs a decimal point before it.
std::string yaml_number(double value) {
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return text;
}

}  // namespace

Result<MapYaml> parse_map_yaml(std::string_view text, std::string_view source) {
  YamlLines lines(source);
  if (const Result<void> split = lines.split(text); !split) return split.error();
  return MapYamlReader(lines).read();
}

std::string map_yaml_text(const MapYaml& yaml) {
  return fmt::format(
      "image: {}\nmode: trinary\nresolution: {}\norigin: [{}, {}, 0.0]\nnegate: {}\noccupied_thresh: {}\nfree_thresh: "
      "{}\n",
      yaml.image, yaml_number(yaml.resolution_m), yaml_number(yaml.origin.x), yaml_number(yaml.origin.y),
      yaml.negate ? 1 : 0, yaml.occupied_threshold, yaml.free_threshold);
}

DenseGrid<CellState> states_of(const GrayImage& image, const MapYaml& yaml) {
  std::array<CellState, 256> state_of_gray{};
  for (std::size_t gray = 0; gray < state_of_gray.size(); ++gray) {
    const double darkness = static_cast<double>(yaml.negate ? gray : 255 - gray) / 255.0;
    state_of_gray[gray] = darkness > yaml.occupied_threshold ? CellState::occupied
                          : darkness < yaml.free_threshold   ? CellState::free
                                                             : CellState::unknown;
  }
  DenseGrid<CellState> grid({yaml.resolution_m, yaml.origin}, image.width, image.height);
  std::size_t pixel = 0;
  for (std::int32_t j = image.height - 1; j >= 0; --j)
    for (std::int32_t i = 0; i < image.width; ++i, ++pixel)
      if (image.alpha.empty() || image.alpha[pixel] == 255) grid.at({i, j}) = state_of_gray[image.gray[pixel]];
  return grid;
}

}  // namespace echoarc::io
