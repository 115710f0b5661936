// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/png_file.hpp"

#include <cassert>

#include <fmt/format.h>
#include <png.h>

#include "io/gray_image.hpp"

namespace echoarc::io {
namespace {

/// Deflate packs at most 1032 bytes into one, and a PNG pixel is at least one bit: what is claimed beyond that is not
/// there.
constexpr std::uint64_t most_pixels_a_byte = std::uint64_t{1032} * 8;

/// libpng's simplified interface; it reports errors by return value and keeps the message.
class PngImage {
 public:
  PngImage() { image_.version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(&image_); }
  png_image* get() { return &image_; }
  png_image* operator->() { return &image_; }

 private:
  png_image image_{};
};

Error bad_png(PngImage& image, std::string_view source) {
  return {ErrorCode::bad_format, fmt::format("PNG picture is damaged: {}", image->message), std::string(source),
          "write or copy the picture again"};
}

}  // namespace

Result<GrayImage> decode_png(std::string_view bytes, std::string_view source) {
  PngImage image;
  if (png_image_begin_read_from_memory(image.get(), bytes.data(), bytes.size()) == 0) return bad_png(image, source);
  if (const Result<void> legal = check_image_size(image->width, image->height, source); !legal) return legal.error();
  const std::size_t pixels = std::size_t{image->width} * image->height;
  if (pixels / most_pixels_a_byte > bytes.size())
    return Error{ErrorCode::bad_format,
                 fmt::format("PNG picture is truncated: {} pixels in {} bytes", pixels, bytes.size()),
                 std::string(source), "write or copy the picture again"};
  image->format = PNG_FORMAT_GA;
  std::vector<std::uint8_t> pairs(PNG_IMAGE_SIZE(*image.get()));
  GrayImage gray{static_cast<std::int32_t>(image->width), static_cast<std::int32_t>(image->height), {}, {}};
  if (png_image_finish_read(image.get(), nullptr, pairs.data(), 0, nullptr) == 0) return bad_png(image, source);
  gray.gray.resize(pixels);
  gray.alpha.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    gray.gray[i] = pairs[2 * i];
    gray.alpha[i] = pairs[2 * i + 1];
  }
  return gray;
}

Result<std::string> encode_png(std::int32_t width, std::int32_t height, std::span<const std::uint8_t> rgb) {
  assert(rgb.size() == std::size_t(width) * std::size_t(height) * 3);
  PngImage image;
  image->width = static_cast<png_uint_32>(width);
  image->height = static_cast<png_uint_32>(height);
  image->format = PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(*image.get()), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(image.get(), bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0)
    return Error{ErrorCode::unwritable, fmt::format("cannot make the PNG: {}", image->message), "", "free some memory"};
  bytes.resize(size);
  return bytes;
}

}  // namespace echoarc::io
