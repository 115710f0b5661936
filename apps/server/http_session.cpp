// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/http_session.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <utility>

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "server/json_values.hpp"
#include "server/viewer_session.hpp"

namespace echoarc::server {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::beast::error_code;

namespace {

constexpr std::string_view json_type = "application/json";

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

/// No inline script or style, nothing from elsewhere, never inside another page.
constexpr const char* content_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
    "manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

template <class Message>
void add_security_headers(Message& response) {
  response.set(http::field::server, "echoarc");
  response.set("Content-Security-Policy", content_policy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
}

/// Largest session log that is handed out in one piece.
constexpr std::uintmax_t max_download_bytes = std::uintmax_t{512} << 20U;

Result<std::string> read_parts(const std::vector<std::string>& parts) {
  std::ostringstream all;
  for (const std::string& part : parts) {
    const std::ifstream file(part, std::ios::binary);
    if (!file) return Error{ErrorCode::unreadable, "the log cannot be read", "", "look into the session's folder"};
    all << file.rdbuf();
    if (static_cast<std::uintmax_t>(all.tellp()) > max_download_bytes)
      return Error{ErrorCode::too_large, "the log is too large to be handed out", "",
                   "copy it from the session's folder"};
  }
  return std::move(all).str();
}

}  // namespace

HttpSession::HttpSession(ServerCore& core, std::shared_ptr<ServerCore::Ticket> ticket,
                         boost::asio::ip::tcp::socket&& socket)
    : core_(core), ticket_(std::move(ticket)), stream_(std::move(socket)) {}

void HttpSession::read_head() {
  parser_.emplace();
  parser_->header_limit(max_header_bytes);
  parser_->body_limit(core_.options.facts.upload_bytes);
  stream_.expires_after(header_timeout);
  http::async_read_header(stream_, buffer_, *parser_, [self = shared_from_this()](error_code failed, std::size_t) {
    if (!failed) return self->on_head();
    if (failed == http::error::header_limit) {
      self->target_.clear();
      self->keep_alive_ = false;
      self->refuse(Status::request_header_fields_too_large, "the request's head is too long", "send less");
    }
  });
}

void HttpSession::on_head() {
  const auto& request = parser_->get();
  target_.assign(request.target().data(), request.target().size());
  keep_alive_ = request.keep_alive();
  const bool has_body = request.method() == http::verb::post;
  if (has_body || parser_->content_length().value_or(0) > 0 || parser_->chunked())
    keep_alive_ = false;  // a refused body is not read, and would be taken for the next request
  if (!is_own_host(view(request[http::field::host]), core_.options.hosts)) {
    keep_alive_ = false;
    return refuse(Status::misdirected_request, "this server is not known under that name",
                  "use its address, or start it with --host NAME");
  }
  if (target_.size() > max_path_bytes || !target_.starts_with('/'))
    return refuse(Status::bad_request, "the path is too long or no path", "use the links of the page");
  if (beast::websocket::is_upgrade(request)) return upgrade();
  if (has_body) return read_body();
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return refuse(Status::method_not_allowed, "only GET is understood here", "use GET");
  route();
}

void HttpSession::upgrade() {
  const auto& request = parser_->get();
  if (!is_own_origin(view(request[http::field::origin]), view(request[http::field::host]))) {
    ++core_.refused.origins;
    keep_alive_ = false;
    return refuse(Status::forbidden, "pages of other sites may not talk to this server", "open the server's own page");
  }
  const std::shared_ptr<Room> room = asked_room();
  if (split_target(target_).path != "/ws" || !room)
    return refuse(Status::not_found, "there is no such room", "open the page again from its first link");
  auto session = std::make_shared<ViewerSession>(core_, std::move(ticket_), std::move(stream_), room);
  session->run(parser_->release());
}

void HttpSession::read_body() {
  if (split_target(target_).path != "/api/log")
    return refuse(Status::method_not_allowed, "nothing is sent there", "send logs to /api/log");
  if (!has_token()) return refuse(Status::unauthorized, "opening a log needs the token", "open the drive link");
  stream_.expires_after(upload_timeout);
  http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](error_code failed, std::size_t) {
    if (!failed) return self->on_upload();
    if (failed == http::error::body_limit)
      self->refuse(Status::payload_too_large, "the file is larger than this server takes",
                   "start `echoarc serve --log FILE` instead");
  });
}

void HttpSession::on_upload() {
  stream_.expires_after(upload_timeout);
  // A name to be shown; the file is kept under another.
  std::string title = shown_name(view(parser_->get()["X-File-Name"]));
  core_.open_log(std::move(parser_->get().body()), std::move(title),
                 [self = shared_from_this()](const Result<std::string>& room) {
                   if (room) return self->answer(Status::ok, json_type, text_of({{"room", *room}}));
                   const bool full = room.error().code == ErrorCode::too_large;
                   const std::string where = room.error().where.empty() ? "" : room.error().where + ": ";
                   self->refuse(full ? Status::service_unavailable : Status::bad_request, where + room.error().message,
                                room.error().remedy);
                 });
}

void HttpSession::route() {
  const std::string_view path = split_target(target_).path;
  const auto files = page_files();
  const auto file = std::ranges::find(files, path, &PageFile::path);
  if (file != files.end()) return get_page(*file);
  constexpr std::string_view maps = "/api/map/";
  if (!path.starts_with("/api/")) return refuse(Status::not_found, "there is nothing here", "start at /");
  if (!may_watch())
    return refuse(Status::unauthorized, "this server is private: it needs the token", "open the drive link");
  if (path == "/api/state") return get_state();
  if (path == "/api/parameters") return answer(Status::ok, json_type, core_.options.parameters);
  download_ = core_.admit_download();
  if (!download_) return refuse(Status::service_unavailable, "too much is asked at once", "ask again in a moment");
  if (path == "/api/run.json") return get_run_report();
  if (path == "/api/log") return get_log();
  if (path.starts_with(maps)) return get_map(path.substr(maps.size()));
  refuse(Status::not_found, "there is nothing here", "docs/live.md lists what there is");
}

void HttpSession::get_page(const PageFile& file) {
  Response response{Status::ok, 11};
  response.set(http::field::content_type, std::string(file.type));
  response.set(http::field::etag, std::string(file.etag));
  response.set(http::field::cache_control, "no-cache");
  if (view(parser_->get()[http::field::if_none_match]) == file.etag) {
    response.result(Status::not_modified);
  } else {
    response.set(http::field::content_encoding, "gzip");
    response.body() = file.gzip;
  }
  write(std::move(response));
}

void HttpSession::get_state() {
  const std::shared_ptr<Room> room = asked_room();
  if (!room) return refuse(Status::not_found, "there is no such room", "leave the room out for the main one");
  const RefusalCounters& refused = core_.refused;
  Json json{{"version", core_.options.facts.version},
            {"room", room->name()},
            {"title", room->source().title},
            {"watchers", room->viewers().size()},
            {"refused",
             {{"connections", refused.connections},
              {"origins", refused.origins},
              {"tokens", refused.tokens},
              {"requests", refused.requests},
              {"messages", refused.messages},
              {"floods", refused.floods},
              {"slow_viewers", refused.slow_viewers}}}};
  json["state"] = room->state() ? Json::parse(room->state()->bytes) : Json();
  answer(Status::ok, json_type, text_of(json));
}

void HttpSession::get_run_report() {
  const std::shared_ptr<Room> room = asked_room();
  if (!room) return refuse(Status::not_found, "there is no such room", "leave the room out for the main one");
  room->with_mapper([self = shared_from_this(), post = room->post()](MappingLoop::Access& access) {
    post([self, report = self->core_.openers.run_report(access.mapper)]() mutable {
      self->answer(Status::ok, json_type, std::move(report));
    });
  });
}

void HttpSession::get_log() {
  const std::shared_ptr<Room> room = asked_room();
  const std::vector<std::string> parts =
      room && room->has_log() ? core_.openers.log_parts() : std::vector<std::string>{};
  if (parts.empty())
    return refuse(Status::not_found, "no log is written for this source", "a log that is played is there already");
  const bool taken = room->ask([self = shared_from_this(), post = room->post(), parts] {
    post([self, bytes = read_parts(parts)]() mutable {
      if (bytes)
        self->answer(Status::ok, "application/x-ndjson", std::move(*bytes));
      else
        self->refuse(Status::internal_server_error, bytes.error().message, bytes.error().remedy);
    });
  });
  if (!taken) refuse(Status::service_unavailable, "too much is asked at once", "ask again in a moment");
}

void HttpSession::get_map(std::string_view file) {
  struct Kind {
    std::string_view extension;
    std::string_view type;
  };
  constexpr std::array<Kind, 4> kinds{{{"png", "image/png"},
                                       {"pgm", "image/x-portable-graymap"},
                                       {"yaml", "application/yaml"},
                                       {"csv", "text/csv; charset=utf-8"}}};
  const std::size_t dot = std::min(file.rfind('.'), file.size());
  const auto kind = std::ranges::find(kinds, file.substr(std::min(dot + 1, file.size())), &Kind::extension);
  const std::shared_ptr<Room> room = asked_room();
  std::string id(file.substr(0, dot));
  if (kind == kinds.end() || !room || !live::is_method_id(id))
    return refuse(Status::not_found, "there is no such map", "/api/map/METHOD.png, .pgm, .yaml or .csv");
  room->with_mapper([self = shared_from_this(), post = room->post(), room_name = room->name(), kind = *kind,
                     name = std::move(id)](MappingLoop::Access& access) {
    auto map = std::make_shared<Result<MapExport>>(access.mapper.final_map(name));
    std::vector<Vec2> path;
    for (const Odometry& pose : access.mapper.path()) path.push_back(pose.T_world_robot.position);
    post([self, map, room_name, kind, name, path = std::move(path), post] {
      const auto same_room = self->core_.room(room_name);
      if (!*map || !same_room)
        return self->refuse(Status::not_found, *map ? "the room is closed" : map->error().message,
                            *map ? "open it again" : map->error().remedy);
      const bool taken = same_room->ask([self, map, kind, name, path, post] {
        post([self, kind, bytes = self->core_.openers.map_file(**map, name, kind.extension, path)]() mutable {
          if (bytes)
            self->answer(Status::ok, kind.type, std::move(*bytes));
          else
            self->refuse(Status::not_found, bytes.error().message, bytes.error().remedy);
        });
      });
      if (!taken) self->refuse(Status::service_unavailable, "too much is asked at once", "ask again in a moment");
    });
  });
}

std::shared_ptr<Room> HttpSession::asked_room() const {
  return core_.room(parameter(split_target(target_).query, "room"));
}

bool HttpSession::has_token() {
  return core_.is_token(bearer(view(parser_->get()[http::field::authorization])));
}

bool HttpSession::may_watch() {
  return !core_.options.is_private || has_token();
}

void HttpSession::refuse(Status status, std::string_view cause, std::string_view remedy) {
  ++core_.refused.requests;
  answer(status, json_type, text_of({{"error", cause}, {"remedy", remedy}}));
}

void HttpSession::answer(Status status, std::string_view type, std::string body) {
  Response response{status, 11};
  response.set(http::field::content_type, std::string(type));
  response.set(http::field::cache_control, "no-store");
  response.body() = std::move(body);
  write(std::move(response));
}

void HttpSession::write(Response response) {
  add_security_headers(response);
  response.keep_alive(keep_alive_);
  const bool head_alone = parser_ && parser_->get().method() == http::verb::head;
  response.prepare_payload();
  if (head_alone) response.body().clear();
  auto shared = std::make_shared<Response>(std::move(response));
  stream_.expires_after(answer_timeout);
  http::async_write(stream_, *shared, [self = shared_from_this(), shared](error_code failed, std::size_t) {
    self->download_.reset();
    if (failed) return;
    if (self->keep_alive_) return self->read_head();
    error_code ignored;
    self->stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  });
}

}  // namespace echoarc::server
