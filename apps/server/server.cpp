// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/server.hpp"

#include <chrono>
#include <utility>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>

#include "host/clocks.hpp"
#include "server/http_session.hpp"
#include "server/server_core.hpp"
#include "server/viewer_session.hpp"

namespace echoarc::server {
namespace {

using Tcp = boost::asio::ip::tcp;
using boost::system::error_code;

constexpr int ports_tried = 100;
constexpr std::chrono::milliseconds ask_interval{50};
constexpr std::chrono::milliseconds goodbye_time{300};

class BeastServer final : public Server {
 public:
  BeastServer(ServerOptions options, RoomOpeners openers)
      : core_(std::move(options), std::move(openers)), acceptor_(core_.io), timer_(core_.io) {}
  ~BeastServer() override { core_.io.stop(); }

  Result<void> bind() {
    const ServerOptions& options = core_.options;
    error_code failed;
    const auto address = boost::asio::ip::make_address(options.address, failed);
    if (failed)
      return Error{ErrorCode::bad_value, fmt::format("\"{}\" is no address", options.address), "",
                   "give one of this machine's, such as 127.0.0.1, or 0.0.0.0 for all of them"};
    for (int i = 0; i < (options.any_port ? ports_tried : 1); ++i) {
      const int port = options.port == 0 ? 0 : options.port + i;
      if (port > 65535) break;
      failed = try_port({address, static_cast<std::uint16_t>(port)});
      if (!failed) return {};
    }
    return Error{ErrorCode::unwritable,
                 fmt::format("cannot listen on {}:{}: {}", options.address, options.port, failed.message()), "",
                 "end what listens there, or choose another with --port"};
  }

  [[nodiscard]] std::uint16_t port() const override { return acceptor_.local_endpoint().port(); }
  std::shared_ptr<Room> open_main(RoomSetup setup) override { return core_.add_room(std::move(setup)); }

  void run(const std::function<bool()>& ended) override {
    accept();
    watch(ended);
    core_.io.run();
    // Everything that was posted by rooms until now is void; goodbyes are written.
    for (ViewerSession* session : std::set(core_.sessions)) session->dismiss("shutdown");
    core_.io.restart();
    core_.io.run_for(goodbye_time);
  }

 private:
  error_code try_port(const Tcp::endpoint& endpoint) {
    error_code failed;
    acceptor_ = Tcp::acceptor(core_.io);
    acceptor_.open(endpoint.protocol(), failed);
    if (!failed) acceptor_.set_option(boost::asio::socket_base::reuse_address(true), failed);
    if (!failed) acceptor_.bind(endpoint, failed);
    if (!failed) acceptor_.listen(boost::asio::socket_base::max_listen_connections, failed);
    return failed;
  }

  void accept() {
    acceptor_.async_accept([this](error_code failed, Tcp::socket socket) {
      if (failed == boost::asio::error::operation_aborted) return;
      if (!failed) take(std::move(socket));
      accept();
    });
  }

  void take(Tcp::socket socket) {
    error_code failed;
    const auto peer = socket.remote_endpoint(failed);
    if (failed) return;
    std::shared_ptr<ServerCore::Ticket> ticket = core_.admit(peer.address().to_string());
    if (ticket) std::make_shared<HttpSession>(core_, std::move(ticket), std::move(socket))->run();
  }

  void watch(const std::function<bool()>& ended) {
    timer_.expires_after(ask_interval);
    timer_.async_wait([this, &ended](error_code failed) {
      if (failed) return;
      if (ended()) return core_.io.stop();
      core_.close_empty_rooms(host::wall_time_s());
      watch(ended);
    });
  }

  ServerCore core_;
  Tcp::acceptor acceptor_;
  boost::asio::steady_timer timer_;
};

}  // namespace

Result<std::unique_ptr<Server>> Server::listen(ServerOptions options, RoomOpeners openers) {
  auto server = std::make_unique<BeastServer>(std::move(options), std::move(openers));
  if (const Result<void> bound = server->bind(); !bound) return bound.error();
  return std::unique_ptr<Server>(std::move(server));
}

}  // namespace echoarc::server
