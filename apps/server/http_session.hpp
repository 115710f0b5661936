// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <optional>
#include <string>

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include "server/access.hpp"
#include "server/page_files.hpp"
#include "server/server_core.hpp"

namespace echoarc::server {

/// One HTTP connection, until it ends or becomes a WebSocket.
class HttpSession final : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(ServerCore& core, std::shared_ptr<ServerCore::Ticket> ticket, boost::asio::ip::tcp::socket&& socket);
  void run() { read_head(); }

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;
  using Response = boost::beast::http::response<boost::beast::http::string_body>;
  using Status = boost::beast::http::status;

  void read_head();
  void on_head();
  void upgrade();
  void read_body();
  void on_upload();
  void route();
  void get_page(const PageFile& file);
  void get_state();
  void get_map(std::string_view file);
  void get_run_report();
  void get_log();
  [[nodiscard]] bool may_watch();
  [[nodiscard]] bool has_token();
  [[nodiscard]] std::shared_ptr<Room> asked_room() const;
  void refuse(Status status, std::string_view cause, std::string_view remedy);
  void answer(Status status, std::string_view type, std::string body);
  void write(Response response);

  ServerCore& core_;
  std::shared_ptr<ServerCore::Ticket> ticket_;
  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_;
  std::optional<Parser> parser_;
  // Of the request that is being answered:
  bool keep_alive_ = false;
  std::string target_;
  std::shared_ptr<int> download_;  // while a map or log is on its way out
};

}  // namespace echoarc::server
