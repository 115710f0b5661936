// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

/// What the server takes from strangers, and how long it waits for them.
namespace echoarc::server {

inline constexpr std::size_t max_connections = 160;              ///< in all
inline constexpr std::size_t max_connections_per_address = 128;  ///< behind a proxy all come from one
inline constexpr std::uint32_t max_header_bytes = 8U << 10U;
inline constexpr std::size_t max_path_bytes = 512;
inline constexpr std::chrono::seconds header_timeout{10};
inline constexpr std::chrono::seconds upload_timeout{120};
inline constexpr std::chrono::seconds answer_timeout{60};
inline constexpr std::chrono::seconds hello_timeout{10};
inline constexpr std::chrono::seconds slow_viewer_timeout{10};  ///< a bundle that is not taken for so long
inline constexpr double messages_per_s = 100.0;                 ///< of one viewer, on average
inline constexpr double message_burst = 300.0;
inline constexpr std::size_t max_waiting_answers = 256;        ///< of one viewer
inline constexpr std::size_t max_downloads = 4;                ///< maps and logs on their way out at once
inline constexpr std::size_t max_rooms = 5;                    ///< the main one and four opened from the page
inline constexpr std::chrono::seconds empty_room_timeout{60};  ///< then an opened room is closed

}  // namespace echoarc::server
