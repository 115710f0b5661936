// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace echoarc::server {

/// What a target asks for: "/api/map/dm.png?room=main" cut into path and one parameter. No decoding: nothing that is
/// served has a name that needs it.
struct Target {
  std::string_view path;
  std::string_view query;
};
[[nodiscard]] Target split_target(std::string_view target);
/// The value of a parameter of a query, or empty.
[[nodiscard]] std::string_view parameter(std::string_view query, std::string_view name);

/// Whether a Host header names this server: an address, localhost, or one of `names`. Everything else is another site's
/// name that was made to point here.
[[nodiscard]] bool is_own_host(std::string_view host, const std::vector<std::string>& names);
/// Whether a page of `origin` may open a socket on `host`: the page that was served there, or no page at all.
[[nodiscard]] bool is_own_origin(std::string_view origin, std::string_view host);
/// The token of "Bearer TOKEN", or empty.
[[nodiscard]] std::string_view bearer(std::string_view authorization);

/// A file's name that a client sent percent-encoded, as it may be shown: without folders and control characters, at the
/// most 80 bytes. Not a name to open.
[[nodiscard]] std::string shown_name(std::string_view encoded);

}  // namespace echoarc::server
