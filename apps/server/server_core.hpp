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
#include "server/worker.hpp"

namespace echoarc::server {

class ViewerSession;

/// What the sessions of one server share. Of the thread of input and output alone.
class ServerCore {
 public:
  using Tcp = boost::asio::ip::tcp;

  ServerCore(ServerOptions options, RoomOpeners openers);
  ServerCore(const ServerCore&) = delete;
  ServerCore& operator=(const ServerCore&) = delete;
  ~ServerCore();

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
  /// The name of the new room, or why there is none. Worlds and logs are read on a thread of their own.
  using Opened = std::function<void(Result<std::string>)>;
  void open_scene(const std::string& scene, const Opened& opened);
  void open_log(std::string log, std::string title, const Opened& opened);
  /// Held by an answer that costs memory or time while it is made and sent; null when too many are.
  [[nodiscard]] std::shared_ptr<int> admit_download();
  void close_empty_rooms(double now_s);
  [[nodiscard]] bool is_token(std::string_view token);
  [[nodiscard]] ViewerId next_viewer() { return ++last_viewer_; }

 private:
  std::unique_ptr<boost::asio::io_context> io_owner_ = std::make_unique<boost::asio::io_context>(1);

 public:
  boost::asio::io_context& io = *io_owner_;
  const ServerOptions options;
  const RoomOpeners openers;
  RefusalCounters refused;
  std::set<ViewerSession*> sessions;

 private:
  void give_back(const std::string& address);
  void open(std::function<Result<RoomSetup>(const std::string& room)> make, const Opened& opened);

  std::map<std::string, std::shared_ptr<Room>, std::less<>> rooms_;
  std::map<std::string, double> empty_since_s_;
  std::map<std::string, std::size_t> connections_;
  std::size_t all_connections_ = 0;
  std::size_t rooms_opening_ = 0;
  std::uint64_t rooms_opened_ = 0;
  std::shared_ptr<int> downloads_ = std::make_shared<int>(0);  // as many as hold it besides us
  ViewerId last_viewer_ = 0;
  std::unique_ptr<Worker> opener_ = std::make_unique<Worker>(max_rooms * 4);
};

}  // namespace echoarc::server
