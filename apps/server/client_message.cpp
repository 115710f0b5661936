// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/client_message.hpp"

#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "server/message_fields.hpp"

namespace echoarc::server {
namespace {

constexpr std::size_t max_name = 64;
constexpr std::size_t max_list = 32;
constexpr std::size_t max_options = 64;
constexpr double max_coordinate_m = 1e5;
constexpr double max_time_s = 1e12;
constexpr int max_depth = 4;

MessageId id(MessageFields& fields) {
  return fields.integer("id", 1);
}
/// The id of a method that runs, or is to.
std::string method(MessageFields& fields) {
  return fields.text("method", max_name);
}
std::optional<double> coordinate(MessageFields& fields, const char* key) {
  return fields.optional_number(key, -max_coordinate_m, max_coordinate_m);
}

ClientMessage hello(MessageFields& f) {
  f.integer("protocol", 1, 1);
  return Hello{f.text_or_empty("token", 128), f.text_or_empty("name", 40),
               f.optional_texts("methods", max_list, max_name)};
}
ClientMessage drive(MessageFields& f) {
  return DriveMessage{f.number("v", -10.0, 10.0), f.number("w", -20.0, 20.0), f.optional_integer("seq")};
}
ClientMessage mode(MessageFields& f) {
  ModeMessage message{f.text("mode", 32), coordinate(f, "x"), coordinate(f, "y")};
  if (message.x_m.has_value() != message.y_m.has_value()) f.fault("of \"x\" and \"y\" it has one alone");
  return message;
}
ClientMessage method_add(MessageFields& f) {
  return MethodAdd{method(f), f.optional_text("name", max_name), f.optional_options("options", max_options)};
}
ClientMessage options(MessageFields& f) {
  return OptionsMessage{method(f), f.options("options", max_options)};
}
ClientMessage playback(MessageFields& f) {
  return Playback{f.optional_boolean("playing"), f.optional_number("speed", 0.1, 100.0),
                  f.optional_number("seek_s", -max_time_s, max_time_s)};
}
ClientMessage explain(MessageFields& f) {
  Explain message{id(f), method(f), f.optional_integer("slot"), coordinate(f, "x"), coordinate(f, "y")};
  const bool place = message.x_m.has_value() || message.y_m.has_value();
  const bool whole = message.x_m.has_value() == message.y_m.has_value();
  if (message.slot.has_value() == place || !whole) f.fault("it names either a \"slot\" or a place, \"x\" and \"y\"");
  return message;
}
ClientMessage pings(MessageFields& f) {
  return PingsMessage{id(f), f.integer("from", 0), f.integer("count", 1, 10'000)};
}
ClientMessage snapshot(MessageFields& f) {
  return Snapshot{id(f), f.number("t", -max_time_s, max_time_s), f.texts("methods", 8, max_name)};
}

struct Reader {
  std::string_view type;
  ClientMessage (*read)(MessageFields&);
};

constexpr std::array<Reader, std::variant_size_v<ClientMessage>> readers{{
    {"hello", &hello},
    {"ping", [](MessageFields& f) -> ClientMessage { return PingMessage{id(f)}; }},
    {"subscribe", [](MessageFields& f) -> ClientMessage { return Subscribe{f.texts("methods", max_list, max_name)}; }},
    {"stop", [](MessageFields&) -> ClientMessage { return Stop{}; }},
    {"take", [](MessageFields&) -> ClientMessage { return Take{}; }},
    {"release", [](MessageFields& f) -> ClientMessage { return Release{f.optional_integer("to")}; }},
    {"answer", [](MessageFields& f) -> ClientMessage { return Answer{f.boolean("accept")}; }},
    {"drive", &drive},
    {"mode", &mode},
    {"method_add", &method_add},
    {"method_remove", [](MessageFields& f) -> ClientMessage { return MethodRemove{method(f)}; }},
    {"options", &options},
    {"sensor",
     [](MessageFields& f) -> ClientMessage { return SensorMessage{f.integer("sensor", 0), f.boolean("on")}; }},
    {"playback", &playback},
    {"open", [](MessageFields& f) -> ClientMessage { return OpenScene{id(f), f.text("scene", max_name)}; }},
    {"explain", &explain},
    {"step", [](MessageFields& f) -> ClientMessage { return StepMessage{id(f), method(f), f.integer("ping", 0)}; }},
    {"pings", &pings},
    {"snapshot", &snapshot},
}};

Error no_message(std::string message) {
  return {ErrorCode::bad_format, std::move(message), "", "send one JSON object with a \"type\" per text frame"};
}

/// The object of a text; a null value where it is none, or nested deeper than any message.
nlohmann::json parse_object(std::string_view text) {
  bool too_deep = false;
  const auto watch = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json&) {
    using Event = nlohmann::json::parse_event_t;
    if ((event == Event::object_start || event == Event::array_start) && depth >= max_depth) too_deep = true;
    return !too_deep;
  };
  const nlohmann::json object = nlohmann::json::parse(text, watch, false);
  return !too_deep && object.is_object() ? object : nlohmann::json();
}

}  // namespace

Result<ClientMessage> parse_message(std::string_view text) {
  if (text.size() > max_message_bytes)
    return no_message(fmt::format("the message is longer than {} bytes", max_message_bytes));
  const nlohmann::json object = parse_object(text);
  if (object.is_null()) return no_message("the message is no JSON object");
  const auto type = object.find("type");
  if (type == object.end() || !type->is_string()) return no_message("the message has no \"type\"");
  const auto& name = type->get_ref<const std::string&>();
  for (const Reader& reader : readers) {
    if (reader.type != name) continue;
    MessageFields fields(object);
    ClientMessage message = reader.read(fields);
    if (const Result<void> good = fields.finish(name); !good) return good.error();
    return message;
  }
  return no_message(fmt::format("messages of type \"{:.40}\" are not known", name));
}

std::optional<MessageId> id_of(std::string_view text) {
  if (text.size() > max_message_bytes) return std::nullopt;
  const nlohmann::json object = parse_object(text);
  if (!object.is_object()) return std::nullopt;
  const auto id = object.find("id");
  if (id == object.end() || !id->is_number_unsigned()) return std::nullopt;
  const auto number = id->get<std::uint64_t>();
  if (number < 1 || number > std::numeric_limits<MessageId>::max()) return std::nullopt;
  return static_cast<MessageId>(number);
}

}  // namespace echoarc::server
