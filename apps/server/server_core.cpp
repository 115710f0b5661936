// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/server_core.hpp"

#include <utility>

#include <boost/asio/post.hpp>
#include <fmt/format.h>

#include "host/clocks.hpp"
#include "server/token.hpp"

namespace echoarc::server {

ServerCore::ServerCore(ServerOptions given, RoomOpeners openers_given)
    : options(std::move(given)), openers(std::move(openers_given)) {}

std::shared_ptr<ServerCore::Ticket> ServerCore::admit(const std::string& address) {
  if (all_connections_ >= max_connections || connections_[address] >= max_connections_per_address) {
    ++refused.connections;
    return nullptr;
  }
  ++all_connections_;
  ++connections_[address];
  return std::make_shared<Ticket>(*this, address);
}

void ServerCore::give_back(const std::string& address) {
  --all_connections_;
  if (--connections_[address] == 0) connections_.erase(address);
}

std::shared_ptr<Room> ServerCore::room(std::string_view name) const {
  const auto found = rooms_.find(name.empty() ? "main" : name);
  return found == rooms_.end() ? nullptr : found->second;
}

std::shared_ptr<Room> ServerCore::add_room(RoomSetup setup) {
  const std::string name = setup.name;
  return rooms_[name] =
             Room::open(std::move(setup), [this](std::function<void()> job) { boost::asio::post(io, std::move(job)); });
}

Result<std::string> ServerCore::next_room() {
  if (rooms_.size() >= max_rooms)
    return Error{ErrorCode::too_large, fmt::format("{} sources are open already", rooms_.size()), "",
                 "close the pages of one; it is given up a minute later"};
  return fmt::format("r{}", ++rooms_opened_);
}

Result<std::string> ServerCore::open_scene(const std::string& scene) {
  const Result<std::string> name = next_room();
  if (!name) return name;
  Result<RoomSetup> setup = openers.scene(scene, *name);
  if (!setup) return setup.error();
  add_room(std::move(*setup));
  return name;
}

Result<std::string> ServerCore::open_log(std::string log) {
  const Result<std::string> name = next_room();
  if (!name) return name;
  Result<RoomSetup> setup = openers.log(std::move(log), *name);
  if (!setup) return setup.error();
  add_room(std::move(*setup));
  return name;
}

void ServerCore::close_empty_rooms(double now_s) {
  for (auto it = rooms_.begin(); it != rooms_.end();) {
    const auto& [name, room] = *it;
    if (name == "main" || !room->viewers().empty()) {
      empty_since_s_.erase(name);
      ++it;
      continue;
    }
    const double since_s = empty_since_s_.try_emplace(name, now_s).first->second;
    if (now_s - since_s < std::chrono::duration<double>(empty_room_timeout).count()) {
      ++it;
      continue;
    }
    empty_since_s_.erase(name);
    it = rooms_.erase(it);
  }
}

bool ServerCore::is_token(std::string_view token) {
  if (equal_tokens(token, options.token)) return true;
  if (!token.empty()) ++refused.tokens;
  return false;
}

}  // namespace echoarc::server
