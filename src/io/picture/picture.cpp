// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/picture.hpp"

#include "echoarc/io/png_file.hpp"
#include "io/files.hpp"
#include "io/picture/page.hpp"
#include "io/picture/view.hpp"

namespace echoarc::io {

Result<void> write_picture(const std::filesystem::path& path, const PictureContent& content) {
  const Result<View> view = fit_view(content);
  if (!view) return view.error();
  const Canvas page = draw_page(content, *view);
  const Result<std::string> png = encode_png(page.width(), page.height(), page.rgb_bytes());
  if (!png) return png.error();
  return write_file(path, *png);
}

}  // namespace echoarc::io
