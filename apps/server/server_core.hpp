// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include "server/limits.hpp"
#include "server/server.hpp"

namespace echoarc::server {

class ViewerSession;

/// What the sessions of one server share. Of the thread of input and output alone.
class ServerCore {
 public:
  using Tcp = boost::asio::ip::tcp;

  ServerCore(ServerOptions options, RoomOpeners openers);

  /// A connection's share of the limits; gives it back when it is destroyed.
  class Ticket {
   public:
    Ticket(ServerCore& core, std::string address) : core_(core), address_(std::move(address)) {}
    Ticket(const Ticket&) = delete;
    Ticket& operator=(const Ticket&) = delete;
    ~Ticket() { core_.give_back(address_); }

   private:
    ServerCore& core_;
    std::string address_;
  };
  /// Null when there are too many connections.
  [[nodiscard]] std::shared_ptr<Ticket> admit(const std::string& address);

  [[nodiscard]] std::shared_ptr<Room> room(std::string_view name) const;  ///< null: there is none; "": the main one
  std::shared_ptr<Room> add_room(RoomSetup setup);
  [[nodiscard]] Result<std::string> open_scene(const std::string& scene);  ///< name of its room
  [[nodiscard]] Result<std::string> open_log(std::string log);
  void close_empty_rooms(double now_s);
  [[nodiscard]] bool is_token(std::string_view token);
  [[nodiscard]] ViewerId next_viewer() { return ++last_viewer_; }

  boost::asio::io_context io{1};
  const ServerOptions options;
  const RoomOpeners openers;
  RefusalCounters refused;
  std::set<ViewerSession*> sessions;

 private:
  void give_back(const std::string& address);
  [[nodiscard]] Result<std::string> next_room();

  std::map<std::string, std::shared_ptr<Room>, std::less<>> rooms_;
  std::map<std::string, double> empty_since_s_;
  std::map<std::string, std::size_t> connections_;
  std::size_t all_connections_ = 0;
  std::uint64_t rooms_opened_ = 0;
  ViewerId last_viewer_ = 0;
};

}  // namespace echoarc::server
