// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "server/rate_limit.hpp"
#include "server/server_core.hpp"
#include "server/viewer.hpp"

namespace echoarc::server {

/// The WebSocket of one viewer.
class ViewerSession final : public Viewer, public std::enable_shared_from_this<ViewerSession> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::string_body>;

  ViewerSession(ServerCore& core, std::shared_ptr<ServerCore::Ticket> ticket, boost::beast::tcp_stream&& stream,
                std::shared_ptr<Room> room);
  ViewerSession(const ViewerSession&) = delete;
  ViewerSession& operator=(const ViewerSession&) = delete;
  ~ViewerSession() override;

  /// Answers the upgrade, whose origin was checked, and goes on.
  void run(Request request);

  void offer() override;
  void send(std::string text) override;
  void send(std::vector<SharedFrame> frames) override;
  void dismiss(std::string_view reason) override;

 private:
  void read();
  void on_read(std::size_t bytes);
  void on_text(std::string_view text);
  void greet(const Hello& hello);
  void open_scene(const OpenScene& message);
  void refuse(std::optional<MessageId> id, const Error& error);
  void write_next();
  void close(boost::beast::websocket::close_code code);
  void gone();

  ServerCore& core_;
  std::shared_ptr<ServerCore::Ticket> ticket_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  std::shared_ptr<Room> room_;
  Request request_;
  boost::beast::flat_buffer buffer_;
  std::deque<SharedFrame> out_;
  double writing_since_s_ = 0.0;
  bool writing_ = false;
  bool due_ = false;  // something new came while it was busy
  bool joined_ = false;
  bool closing_ = false;
  RateLimit rate_{messages_per_s, message_burst};
  boost::asio::steady_timer hello_timer_;
};

}  // namespace echoarc::server
