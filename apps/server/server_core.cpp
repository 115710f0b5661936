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

// Whoever posts ends first; then the sessions, which are held by what they wait for; then what both use.
ServerCore::~ServerCore() {
  for (const auto& [name, room] : rooms_) room->close();
  rooms_.clear();
  opener_.reset();
  io_owner_.reset();
}

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

void ServerCore::open(std::function<Result<RoomSetup>(const std::string& room)> make, const Opened& opened) {
  if (rooms_.size() + rooms_opening_ >= max_rooms)
    return opened(Error{ErrorCode::too_large, fmt::format("{} sources are open already", rooms_.size()), "",
                        "close the pages of one; it is given up a minute later"});
  ++rooms_opening_;
  const std::string name = fmt::format("r{}", ++rooms_opened_);
  const bool taken = opener_->post([this, make = std::move(make), opened, name] {
    auto setup = std::make_shared<Result<RoomSetup>>(make(name));
    boost::asio::post(io, [this, setup, opened, name] {
      --rooms_opening_;
      if (!*setup) return opened(setup->error());
      add_room(std::move(**setup));
      opened(name);
    });
  });
  if (taken) return;
  --rooms_opening_;
  opened(Error{ErrorCode::too_large, "too many sources are being opened", "", "try again in a moment"});
}

void ServerCore::open_scene(const std::string& scene, const Opened& opened) {
  open([this, scene](const std::string& room) { return openers.scene(scene, room); }, opened);
}

void ServerCore::open_log(std::string log, std::string title, const Opened& opened) {
  open([this, log = std::move(log),
        title = std::move(title)](const std::string& room) { return openers.log(log, title, room); },
       opened);
}

std::shared_ptr<int> ServerCore::admit_download() {
  if (downloads_.use_count() > static_cast<long>(max_downloads)) return nullptr;
  return downloads_;
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
    // Its threads end where nobody waits for them.
    (void)opener_->post([closing = std::move(it->second)]() mutable { closing.reset(); });
    it = rooms_.erase(it);
  }
}

bool ServerCore::is_token(std::string_view token) {
  if (equal_tokens(token, options.token)) return true;
  if (!token.empty()) ++refused.tokens;
  return false;
}

}  // namespace echoarc::server
