// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace echoarc::report {

/// The style sheet of the page: fonts of the reader's system, light and dark by the reader's choice.
[[nodiscard]] std::string_view style_sheet();

}  // namespace echoarc::report
