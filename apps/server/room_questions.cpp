// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The part of Room that answers questions about its maps.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "server/map_messages.hpp"
#include "server/room.hpp"
#include "server/room_messages.hpp"

namespace echoarc::server {

template <class Prepare>
void Room::question(Viewer& viewer, MessageId id, Prepare prepare) {
  mapping_->post([this, prepare = std::move(prepare), viewer_id = viewer.id, id](MappingLoop::Access& access) {
    // What needs the mapper itself is looked up now; the rest is work for another thread, from copies.
    auto evidence = std::make_shared<live::Evidence>(MappingLoop::evidence_of(access.mapper, source_));
    const bool taken = questions_->post([this, evidence, ask = prepare(access.mapper), viewer_id, id] {
      later(viewer_id, [frames = ask(*evidence), id](Room& room, Viewer& asker) {
        if (frames)
          asker.send(*frames);
        else
          room.refuse(asker, id, frames.error());
      });
    });
    if (taken) return;
    later(viewer_id, [id](Room& room, Viewer& asker) {
      room.refuse(asker, id, {ErrorCode::too_large, "too many questions wait already", "", "ask again in a moment"});
    });
  });
}

namespace {

SharedFrame text_frame(std::string text) {
  return std::make_shared<const Frame>(Frame{std::move(text), false});
}

using Frames = Result<std::vector<SharedFrame>>;
using Ask = std::function<Frames(const live::Evidence&)>;

Error no_such_method(const std::string& method) {
  return {ErrorCode::not_found, fmt::format("method \"{:.40}\" does not run here", method), "",
          "add it first; `methods` lists those that run"};
}

/// Place of a slot in the newest export of a method.
Result<std::size_t> place_of(const live::Mapper& mapper, const std::string& method, std::uint32_t slot) {
  for (const live::RunningMethod& running : mapper.methods())
    if (running.id() == method) {
      if (const auto place = running.store.index_of(slot)) return *place;
      return Error{ErrorCode::not_found, "that point is no longer on the map", "", "choose another point"};
    }
  return no_such_method(method);
}

/// Map frames that answer a question. `index`: of the method among those that were asked about.
void add_maps(std::vector<SharedFrame>& frames, MessageId id, std::size_t index, const live::MethodChoice& choice,
              const MapExport& map, const live::ReadingLog& readings) {
  live::MapStore store;
  const auto centre_of = [&](PingId ping) -> std::optional<Vec2> {
    const auto place = readings.find(ping);
    if (!place) return std::nullopt;
    const std::optional<Arc> arc = arc_of(readings[*place].reading);
    return arc && arc->is_circular() ? std::optional<Vec2>(arc->centre()) : std::nullopt;
  };
  store.update(map, centre_of, live::cell_layer_of(choice.name, choice.options));
  FrameHead head{.method = static_cast<std::uint8_t>(index), .sequence = store.sequence(), .question = id};
  head.kind = FrameKind::tiles;
  if (SharedFrame tiles = encode_tiles(head, store, 0)) frames.push_back(std::move(tiles));
  head.kind = FrameKind::points;
  if (SharedFrame points = encode_points(head, store, 0)) frames.push_back(std::move(points));
}

const live::MethodChoice* choice_of(const live::Evidence& evidence, const std::string& id) {
  const auto found = std::ranges::find(evidence.methods, id, &live::MethodChoice::key);
  return found == evidence.methods.end() ? nullptr : &*found;
}

Frames answer_step(const live::Evidence& evidence, const StepMessage& message, double temperature_k) {
  const Result<live::Step> step = live::step_ping(evidence, message.method, message.ping);
  if (!step) return step.error();
  std::vector<SharedFrame> frames;
  const live::MethodChoice* choice = choice_of(evidence, message.method);
  if (choice != nullptr && step->before) add_maps(frames, message.id, 0, *choice, *step->before, evidence.readings);
  frames.push_back(text_frame(stepped_message(message.id, *step, temperature_k)));
  return frames;
}

Frames answer_snapshot(const live::Evidence& evidence, const Snapshot& message) {
  const Result<live::PastMap> past = live::map_at(evidence, message.methods, message.time_s);
  if (!past) return past.error();
  std::vector<SharedFrame> frames;
  for (std::size_t k = 0; k < message.methods.size() && k < past->maps.size(); ++k)
    if (const live::MethodChoice* choice = choice_of(evidence, message.methods[k]); choice != nullptr && past->maps[k])
      add_maps(frames, message.id, k, *choice, *past->maps[k], evidence.readings);
  frames.push_back(text_frame(snapshot_end_message(message.id, message.time_s, past->pings, past->T_world_robot)));
  return frames;
}

Frames answer_pings(const live::Evidence& evidence, const PingsMessage& message) {
  const live::ReadingLog& readings = evidence.readings;
  std::vector<SharedFrame> frames;
  // Pings are judged nearly in the order of their ids.
  std::size_t begin = std::min<std::size_t>(message.from, readings.size());
  if (const auto place = readings.find(message.from)) begin = *place;
  const std::size_t end = std::min(readings.size(), begin + message.count);
  frames.push_back(encode_pings({.kind = FrameKind::pings, .question = message.id}, readings, begin, end));
  frames.push_back(text_frame(pings_end_message(message.id)));
  return frames;
}

}  // namespace

void Room::on(Viewer& viewer, const Explain& message) {
  question(viewer, message.id, [message](const live::Mapper& mapper) -> Ask {
    const auto written = [id = message.id,
                          slot = message.slot](const Result<live::Explanation>& explanation) -> Frames {
      if (!explanation) return explanation.error();
      return std::vector<SharedFrame>{text_frame(explanation_message(id, slot, *explanation))};
    };
    if (!message.slot)
      return [message, written](const live::Evidence& evidence) {
        return written(live::explain_cell(evidence, message.method, {*message.x_m, *message.y_m}));
      };
    return [place = place_of(mapper, message.method, *message.slot), message, written](const live::Evidence& evidence) {
      return place ? written(live::explain_point(evidence, message.method, *place)) : Frames(place.error());
    };
  });
}

void Room::on(Viewer& viewer, const StepMessage& message) {
  question(viewer, message.id, [message, temperature_k = source_.temperature_k](const live::Mapper&) -> Ask {
    return [=](const live::Evidence& evidence) { return answer_step(evidence, message, temperature_k); };
  });
}

void Room::on(Viewer& viewer, const PingsMessage& message) {
  question(viewer, message.id, [message](const live::Mapper&) -> Ask {
    return [message](const live::Evidence& evidence) { return answer_pings(evidence, message); };
  });
}

void Room::on(Viewer& viewer, const Snapshot& message) {
  question(viewer, message.id, [message](const live::Mapper&) -> Ask {
    return [message](const live::Evidence& evidence) { return answer_snapshot(evidence, message); };
  });
}

}  // namespace echoarc::server
