// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"

/// What a client may say: `FromClient` of schema/messages.schema.json.
namespace echoarc::server {

using MessageId = std::uint32_t;  ///< given by the client, from 1; its answer carries it

struct Hello {
  std::string token;                                ///< empty: none
  std::string name;                                 ///< empty: none
  std::optional<std::vector<std::string>> methods;  ///< none: all
};
struct PingMessage {
  MessageId id = 0;
};
struct Subscribe {
  std::vector<std::string> methods;
};
struct Stop {};
struct Take {};
struct Release {
  std::optional<std::uint32_t> to;
};
struct Answer {
  bool accept = false;
};
struct DriveMessage {
  double v_m_s = 0.0;
  double w_rad_s = 0.0;
  std::optional<std::uint32_t> seq;
};
struct ModeMessage {
  std::string mode;
  std::optional<double> x_m;
  std::optional<double> y_m;
};
struct MethodAdd {
  std::string method;                ///< id that it shall have
  std::optional<std::string> name;   ///< in the catalogue; none: that is its id, too
  std::optional<OptionMap> options;  ///< what differs from the defaults
};
struct MethodRemove {
  std::string method;
};
struct OptionsMessage {
  std::string method;
  OptionMap options;
};
struct SensorMessage {
  std::uint32_t sensor = 0;
  bool on = true;
};
struct Playback {
  std::optional<bool> playing;
  std::optional<double> speed;
  std::optional<double> seek_s;
};
struct OpenScene {
  MessageId id = 0;
  std::string scene;
};
struct Explain {
  MessageId id = 0;
  std::string method;
  std::optional<std::uint32_t> slot;
  std::optional<double> x_m;
  std::optional<double> y_m;
};
struct StepMessage {
  MessageId id = 0;
  std::string method;
  std::uint32_t ping = 0;
};
struct PingsMessage {
  MessageId id = 0;
  std::uint32_t from = 0;
  std::uint32_t count = 0;
};
struct Snapshot {
  MessageId id = 0;
  double time_s = 0.0;
  std::vector<std::string> methods;
};

using ClientMessage = std::variant<Hello, PingMessage, Subscribe, Stop, Take, Release, Answer, DriveMessage,
                                   ModeMessage, MethodAdd, MethodRemove, OptionsMessage, SensorMessage, Playback,
                                   OpenScene, Explain, StepMessage, PingsMessage, Snapshot>;

/// Longer messages are refused unread.
inline constexpr std::size_t max_message_bytes = std::size_t{16} << 10U;

/// Reads one message. Numbers are finite and within the schema's bounds afterwards, lists and names no longer than it
/// allows. Error: what is wrong, with the key; `where` is the message's type where that is known.
[[nodiscard]] Result<ClientMessage> parse_message(std::string_view text);

/// The `id` of a text that `parse_message` refused, if it has one, so that the refusal can be matched.
[[nodiscard]] std::optional<MessageId> id_of(std::string_view text);

}  // namespace echoarc::server
