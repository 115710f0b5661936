// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/viewer_session.hpp"

#include <utility>
#include <variant>

#include <boost/asio/buffer.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <fmt/format.h>

#include "host/clocks.hpp"

namespace echoarc::server {

namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::beast::error_code;

namespace {

constexpr auto wants_token = static_cast<websocket::close_code>(4001);
constexpr auto too_slow = static_cast<websocket::close_code>(4008);
constexpr std::chrono::seconds silence_timeout{30};
constexpr const char* protocol = "echoarc.v1";

}  // namespace

ViewerSession::ViewerSession(ServerCore& core, std::shared_ptr<ServerCore::Ticket> ticket, beast::tcp_stream&& stream,
                             std::shared_ptr<Room> room)
    : core_(core),
      ticket_(std::move(ticket)),
      socket_(std::move(stream)),
      room_(std::move(room)),
      hello_timer_(core.io) {
  core_.sessions.insert(this);
}

ViewerSession::~ViewerSession() {
  gone();
  core_.sessions.erase(this);
}

void ViewerSession::run(Request request) {
  request_ = std::move(request);
  beast::get_lowest_layer(socket_).expires_never();  // the socket has time-outs of its own
  socket_.set_option(websocket::stream_base::timeout{header_timeout, silence_timeout, true});
  const auto offered = request_[beast::http::field::sec_websocket_protocol];
  const bool ours = std::string_view(offered.data(), offered.size()).find(protocol) != std::string_view::npos;
  socket_.set_option(websocket::stream_base::decorator([ours](websocket::response_type& response) {
    response.set(beast::http::field::server, "echoarc");
    if (ours) response.set(beast::http::field::sec_websocket_protocol, protocol);
  }));
  socket_.read_message_max(max_message_bytes);
  socket_.auto_fragment(false);
  error_code ignored;
  beast::get_lowest_layer(socket_).socket().set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  socket_.async_accept(request_, [self = shared_from_this()](error_code failed) {
    if (failed) return;
    self->hello_timer_.expires_after(hello_timeout);
    self->hello_timer_.async_wait([weak = self->weak_from_this()](error_code cancelled) {
      const auto session = weak.lock();
      if (!cancelled && session && !session->joined_) session->close(websocket::close_code::policy_error);
    });
    self->read();
  });
}

void ViewerSession::read() {
  socket_.async_read(buffer_, [self = shared_from_this()](error_code failed, std::size_t bytes) {
    if (failed) return self->gone();
    self->on_read(bytes);
  });
}

void ViewerSession::on_read(std::size_t bytes) {
  if (closing_) return;
  const std::string text(static_cast<const char*>(buffer_.data().data()), bytes);
  buffer_.consume(buffer_.size());
  if (!rate_.take(host::wall_time_s())) {
    ++core_.refused.floods;
    return close(websocket::close_code::policy_error);
  }
  if (socket_.got_text())
    on_text(text);
  else
    refuse(std::nullopt, {ErrorCode::bad_format, "binary messages are not understood", "", "send text frames"});
  if (!closing_) read();
}

void ViewerSession::on_text(std::string_view text) {
  const Result<ClientMessage> message = parse_message(text);
  if (!message) return refuse(id_of(text), message.error());
  if (const auto* hello = std::get_if<Hello>(&*message); hello != nullptr && !joined_) return greet(*hello);
  // Whoever wants the robot to stop need not introduce himself.
  if (!joined_ && !std::holds_alternative<Stop>(*message))
    return refuse(id_of(text), {ErrorCode::bad_format, "the first message must be hello", "", "say hello first"});
  if (const auto* open = std::get_if<OpenScene>(&*message)) return open_scene(*open);
  room_->hear(*this, *message);
}

void ViewerSession::greet(const Hello& hello) {
  may_drive = core_.is_token(hello.token);
  if (core_.options.is_private && !may_drive) {
    refuse(std::nullopt, {ErrorCode::unsupported, "this server is private: watching needs the token", "",
                          "open the link that was printed where echoarc was started"});
    return close(wants_token);
  }
  id = core_.next_viewer();
  name = hello.name.empty() ? fmt::format("Viewer {}", id) : hello.name;
  if (hello.methods) subscribed.emplace(hello.methods->begin(), hello.methods->end());
  joined_ = true;
  hello_timer_.cancel();
  send(welcome_message(core_.options.facts, *room_, *this));
  room_->join(*this);
}

void ViewerSession::open_scene(const OpenScene& message) {
  if (!may_drive)
    return refuse(message.id, {ErrorCode::unsupported, "this needs the token", "",
                               "open the drive link that was printed where echoarc was started"});
  core_.open_scene(message.scene, [self = shared_from_this(), id = message.id](const Result<std::string>& room) {
    if (room)
      self->send(opened_message(id, *room));
    else
      self->refuse(id, room.error());
  });
}

void ViewerSession::refuse(std::optional<MessageId> message_id, const Error& error) {
  ++core_.refused.messages;
  send(error_message(message_id, error));
}

void ViewerSession::offer() {
  if (closing_) return;
  if (!out_.empty()) {
    ++dropped;
    due_ = true;
    constexpr double limit_s = std::chrono::duration<double>(slow_viewer_timeout).count();
    if (host::wall_time_s() - writing_since_s_ < limit_s) return;
    ++core_.refused.slow_viewers;
    close(too_slow);
    // It does not read, so it will not read the close, either.
    error_code ignored;
    beast::get_lowest_layer(socket_).socket().close(ignored);
    return;
  }
  send(room_->take(*this));
}

void ViewerSession::send(std::string text) {
  send({std::make_shared<const Frame>(Frame{std::move(text), false})});
}

void ViewerSession::send(std::vector<SharedFrame> frames) {
  if (closing_) return;
  if (out_.size() > max_waiting_answers) {
    ++core_.refused.slow_viewers;
    return close(too_slow);
  }
  out_.insert(out_.end(), frames.begin(), frames.end());
  if (!writing_) {
    writing_since_s_ = host::wall_time_s();
    write_next();
  }
}

void ViewerSession::write_next() {
  writing_ = !out_.empty();
  // What came while it was busy is not left until something else comes.
  if (!writing_ && std::exchange(due_, false) && joined_ && !closing_) return send(room_->take(*this));
  if (!writing_) return;
  const SharedFrame frame = out_.front();
  socket_.binary(frame->binary);
  socket_.async_write(boost::asio::buffer(frame->bytes),
                      [self = shared_from_this(), frame](error_code failed, std::size_t) {
                        self->out_.pop_front();
                        if (failed) {
                          self->out_.clear();
                          self->writing_ = false;
                          return self->gone();
                        }
                        self->write_next();
                      });
}

void ViewerSession::dismiss(std::string_view reason) {
  send(bye_message(reason));
  close(websocket::close_code::going_away);
}

void ViewerSession::close(websocket::close_code code) {
  if (closing_) return;
  closing_ = true;
  gone();
  // A write that is under way ends first; what follows it in the queue is dropped.
  socket_.async_close(code, [self = shared_from_this()](error_code) {});
}

void ViewerSession::gone() {
  hello_timer_.cancel();
  if (!std::exchange(joined_, false)) return;
  room_->leave(*this);
}

}  // namespace echoarc::server
