// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "server/client_message.hpp"

namespace {

using namespace echoarc::server;

void require(bool good) {
  if (!good) std::abort();
}
void require_within(const std::optional<double>& number, double limit) {
  require(!number || std::abs(*number) <= limit);  // false for NaN, too
}
void require_names(const std::vector<std::string>& names, std::size_t most) {
  require(names.size() <= most);
}

// What the rest of the server takes for granted.
void check(const Hello& hello) {
  if (hello.methods) require_names(*hello.methods, 32);
}
void check(const PingMessage& ping) {
  require(ping.id > 0);
}
void check(const Subscribe& subscribe) {
  require_names(subscribe.methods, 32);
}
void check(const DriveMessage& drive) {
  require_within(drive.v_m_s, 10.0);
  require_within(drive.w_rad_s, 20.0);
}
void check(const ModeMessage& mode) {
  require(mode.x_m.has_value() == mode.y_m.has_value());
  require_within(mode.x_m, 1e5);
  require_within(mode.y_m, 1e5);
}
void check(const OptionsMessage& message) {
  require(message.options.size() <= 64);
  for (const auto& [name, value] : message.options)
    if (const auto* number = std::get_if<double>(&value)) require(std::isfinite(*number));
}
void check(const Playback& playback) {
  require(!playback.speed || (*playback.speed >= 0.1 && *playback.speed <= 100.0));
  require_within(playback.seek_s, 1e12);
}
void check(const OpenScene& open) {
  require(open.id > 0);
}
void check(const Explain& explain) {
  require(explain.id > 0 && explain.x_m.has_value() == explain.y_m.has_value());
  require(explain.slot.has_value() != explain.x_m.has_value());
  require_within(explain.x_m, 1e5);
  require_within(explain.y_m, 1e5);
}
void check(const StepMessage& step) {
  require(step.id > 0);
}
void check(const PingsMessage& pings) {
  require(pings.id > 0 && pings.count >= 1 && pings.count <= 10'000);
}
void check(const Snapshot& snapshot) {
  require(snapshot.id > 0);
  require_within(snapshot.time_s, 1e12);
  require_names(snapshot.methods, 8);
}
template <class Plain>
void check(const Plain& /*any value will do*/) {}

}  // namespace

/// What is accepted keeps to the schema's bounds; what is refused says why.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto message = parse_message(text))
    std::visit([](const auto& m) { check(m); }, *message);
  else
    require(!message.error().message.empty() && !message.error().remedy.empty());
  if (const auto id = id_of(text)) require(*id > 0);
  return 0;
}
