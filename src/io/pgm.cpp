// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <charconv>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "echoarc/io/map_server.hpp"
#include "io/gray_image.hpp"

namespace echoarc::io {
namespace {

Error bad_image(std::string_view source, std::string message, std::string remedy) {
  return {ErrorCode::bad_format, std::move(message), std::string(source), std::move(remedy)};
}

/// Walks over the whitespace-separated numbers of a PGM; "#" starts a comment to the end of the line.
class PgmScanner {
 public:
  explicit PgmScanner(std::string_view bytes) : rest_(bytes) {}

  std::optional<std::uint32_t> next_number() {
    skip_space();
    std::uint32_t value = 0;
    const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (code != std::errc{}) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  /// What follows the one whitespace character after the last number of a binary header.
  std::string_view after_header() {
    if (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
    return rest_;
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_space() {
    while (!rest_.empty()) {
      if (rest_.front() == '#')
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      else if (is_space(rest_.front()))
        rest_.remove_prefix(1);
      else
        return;
    }
  }

  std::string_view rest_;
};

struct PgmHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t levels = 0;  ///< the value of white

  [[nodiscard]] std::size_t pixels() const { return std::size_t{width} * height; }
};

Result<PgmHeader> read_header(PgmScanner& scanner, std::string_view source) {
  const auto width = scanner.next_number();
  const auto height = width ? scanner.next_number() : std::nullopt;
  const auto levels = height ? scanner.next_number() : std::nullopt;
  if (!levels)
    return bad_image(source, "PGM header is incomplete", "write the picture again; it needs width, height and white");
  if (const Result<void> legal = check_image_size(*width, *height, source); !legal) return legal.error();
  if (*levels < 1 || *levels > 255)
    return bad_image(source, fmt::format("PGM with white = {} is not supported", *levels),
                     "save the picture with 8 bits a pixel");
  return PgmHeader{*width, *height, *levels};
}

Error truncated(std::string_view source, std::size_t found, std::size_t wanted) {
  return bad_image(source, fmt::format("picture is truncated: {} of {} pixels", found, wanted),
                   "write or copy the picture again");
}

std::uint8_t stretched(std::uint32_t value, std::uint32_t levels) {
  return static_cast<std::uint8_t>((std::min(value, levels) * 255 + levels / 2) / levels);
}

Result<std::vector<std::uint8_t>> binary_pixels(PgmScanner& scanner, const PgmHeader& header, std::string_view source) {
  const std::string_view data = scanner.after_header();
  if (data.size() < header.pixels()) return truncated(source, data.size(), header.pixels());
  std::vector<std::uint8_t> pixels(header.pixels());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = stretched(static_cast<unsigned char>(data[i]), header.levels);
  return pixels;
}

Result<std::vector<std::uint8_t>> plain_pixels(PgmScanner& scanner, const PgmHeader& header, std::string_view source) {
  std::vector<std::uint8_t> pixels;  // grows with what is really there
  while (pixels.size() < header.pixels()) {
    const auto value = scanner.next_number();
    if (!value) return truncated(source, pixels.size(), header.pixels());
    pixels.push_back(stretched(*value, header.levels));
  }
  return pixels;
}

}  // namespace

Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::string_view source) {
  // Either side is compared first, so that the product cannot overflow.
  constexpr auto limit = static_cast<std::uint64_t>(max_map_pixels);
  if (width >= 1 && height >= 1 && width <= limit && height <= limit && width * height <= limit) return {};
  return Error{ErrorCode::too_large, fmt::format("a picture of {} x {} pixels is not supported", width, height),
               std::string(source), fmt::format("use 1 to {} pixels", max_map_pixels)};
}

Result<GrayImage> decode_pgm(std::string_view bytes, std::string_view source) {
  const bool plain = bytes.starts_with("P2");
  if (!plain && !bytes.starts_with("P5")) return bad_image(source, "is no PGM picture", "use PGM (P5 or P2) or PNG");
  PgmScanner scanner(bytes.substr(2));
  const Result<PgmHeader> header = read_header(scanner, source);
  if (!header) return header.error();
  Result<std::vector<std::uint8_t>> pixels =
      plain ? plain_pixels(scanner, *header, source) : binary_pixels(scanner, *header, source);
  if (!pixels) return pixels.error();
  return GrayImage{
      static_cast<std::int32_t>(header->width), static_cast<std::int32_t>(header->height), std::move(*pixels), {}};
}

Result<GrayImage> decode_gray_image(std::string_view bytes, std::string_view source) {
  return bytes.starts_with("\x89PNG") ? decode_png(bytes, source) : decode_pgm(bytes, source);
}

}  // namespace echoarc::io
