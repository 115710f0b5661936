// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/io/picture.hpp"
#include "io/picture/canvas.hpp"
#include "io/picture/view.hpp"

namespace echoarc::io {

/// The finished picture: title above, the map in a frame, scale bar and legend below.
[[nodiscard]] Canvas draw_page(const PictureContent& content, const View& view);

}  // namespace echoarc::io
