// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace echoarc::server {

/// 128 bits of the system's generator, as 32 hexadecimal digits: who has it may drive.
[[nodiscard]] std::string make_token();

/// Whether both are equal, in a time that depends on the length of `given` alone.
[[nodiscard]] bool equal_tokens(std::string_view given, std::string_view wanted);

}  // namespace echoarc::server
