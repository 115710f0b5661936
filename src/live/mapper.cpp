// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// `Pipeline` drives a set of methods that stays as it is and finishes when its host says so. Here methods come, go and
// are computed anew, and finish by the records' time; so each walks along the log of judged pings at its own pace.

#include "echoarc/live/mapper.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "live/mapper_state.hpp"

namespace echoarc::live {
namespace {

constexpr std::size_t longest_id = 64;

Error unknown_method(std::string_view id) {
  return {ErrorCode::not_found, "method " + std::string(id) + " is not running", std::string(id), "add it first"};
}

Result<void> check_id(const MethodChoice& choice) {
  const std::string& id = choice.key();
  if (id == choice.name) return {};
  if (!is_method_id(id))
    return Error{ErrorCode::bad_value, "\"" + id.substr(0, longest_id) + "\" is no id of a method", choice.name,
                 "use up to 64 of a-z, 0-9, _ and -, a letter or digit first"};
  if (find_method(id) != nullptr)
    return Error{ErrorCode::bad_value, "the id " + id + " is the name of another method", id, "choose another id"};
  return {};
}

}  // namespace

bool is_method_id(std::string_view id) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  return !id.empty() && id.size() <= longest_id && letter(id.front()) &&
         std::ranges::all_of(id, [&](char c) { return letter(c) || c == '_' || c == '-'; });
}

Mapper::Mapper(std::unique_ptr<State> state) : state_(std::move(state)) {}
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;
Mapper::~Mapper() = default;

Result<Mapper> Mapper::make(const SourceDescription& source, const SensingOptions& sensing,
                            std::span<const MethodChoice> methods, Executor& executor,
                            std::function<double()> thread_cpu_s) {
  if (auto valid = validate(sensing); !valid) return valid.error();
  Mapper mapper(std::make_unique<State>(source, sensing, executor, std::move(thread_cpu_s)));
  for (const MethodChoice& choice : methods)
    if (auto added = mapper.add_method(choice); !added) return added.error();
  return mapper;
}

void Mapper::push(const Record& record) {
  std::visit(
      [&]<class R>(const R& r) {
        // The truth and what the robot was told are not for maps.
        if constexpr (std::is_same_v<R, Truth>) state_->truth.push(r.pose);
        if constexpr (!std::is_same_v<R, Truth> && !std::is_same_v<R, CommandNote>) {
          state_->plain->push(r);
          if (state_->limited) state_->limited->push(r);
        }
        if constexpr (std::is_same_v<R, Scan>) state_->scan.push(r);
      },
      record);
  state_->after_push();
}

void Mapper::end_of_records() {
  state_->plain->end();
  if (state_->limited) state_->limited->end();
  state_->after_push();
  state_->mark();
}

bool Mapper::work(std::size_t readings) {
  bool more = false;
  for (std::size_t k = 0; k < state_->entries.size(); ++k)
    if (state_->entries[k].next) more = state_->recompute_slice(k, std::max<std::size_t>(readings, 1)) || more;
  return more;
}

bool Mapper::refresh() {
  bool changed = false;
  for (std::size_t k = 0; k < state_->entries.size(); ++k) changed = state_->export_method(k) || changed;
  return changed;
}

void Mapper::restart() {
  state_->open_streams();
  for (std::size_t k = 0; k < state_->entries.size(); ++k) {
    RunningMethod& method = state_->methods[k];
    auto run = state_->fresh_run(method.choice);
    if (!run) continue;  // checked when the choice was made
    state_->entries[k] = {std::move(*run), std::nullopt, std::nullopt};
    method.state = RunningMethod::State::ok;
    method.reason.clear();
    method.map.reset();
    method.store.reset();
    method.insert_cpu_s = 0.0;
  }
}

Result<void> Mapper::add_method(const MethodChoice& choice) {
  if (auto good = check_id(choice); !good) return good;
  if (state_->find(choice.key()))
    return Error{ErrorCode::bad_value, "method " + choice.key() + " is running already", choice.key(),
                 "change its options instead"};
  if (state_->methods.size() >= max_methods)
    return Error{ErrorCode::too_large, std::to_string(max_methods) + " methods are running already", choice.key(),
                 "remove one first"};
  auto run = state_->fresh_run(choice);
  if (!run) return run.error();
  RunningMethod method;
  method.choice = choice;
  method.options = run->method().options();
  method.point_method = is_point_method(choice.name);
  method.store = MapStore(state_->removed_at);
  state_->methods.push_back(std::move(method));
  state_->entries.push_back({std::move(*run), std::nullopt, std::nullopt});
  if (state_->plain->log().size() > 0) state_->recompute(state_->entries.size() - 1);
  return {};
}

Result<void> Mapper::remove_method(std::string_view id) {
  const auto k = state_->find(id);
  if (!k) return unknown_method(id);
  state_->removed_at = std::max(state_->removed_at, state_->methods[*k].store.sequence());
  state_->methods.erase(state_->methods.begin() + std::ptrdiff_t(*k));
  state_->entries.erase(state_->entries.begin() + std::ptrdiff_t(*k));
  return {};
}

Result<void> Mapper::set_options(std::string_view id, const OptionMap& options) {
  const auto k = state_->find(id);
  if (!k) return unknown_method(id);
  MethodChoice choice = state_->methods[*k].choice;
  choice.options = options;
  auto run = state_->fresh_run(choice);
  if (!run) return run.error();
  state_->methods[*k].choice = choice;
  state_->methods[*k].options = run->method().options();
  state_->recompute(*k);
  return {};
}

Result<void> Mapper::use_sensor(SensorId sensor, bool on) {
  if (state_->source.robot.sensors.find(sensor) == nullptr)
    return Error{ErrorCode::not_found, "the robot has no sensor " + std::to_string(sensor), "sensor",
                 "use an id of the robot's description"};
  const bool changed = on ? state_->off.erase(sensor) > 0 : state_->off.insert(sensor).second;
  for (std::size_t k = 0; changed && k < state_->entries.size(); ++k) state_->recompute(k);
  return {};
}

std::span<const RunningMethod> Mapper::methods() const {
  return state_->methods;
}
const ReadingLog& Mapper::readings() const {
  return state_->plain->log();
}
const SensingReport& Mapper::report() const {
  return state_->plain->sensing().report();
}
std::span<const Odometry> Mapper::path() const {
  return state_->plain->sensing().track().samples();
}
const TruthLog& Mapper::truth() const {
  return state_->truth;
}
std::span<const Vec2> Mapper::laser() const {
  return state_->scan.returns();
}
std::span<const TimelineBin> Mapper::timeline() const {
  return state_->timeline.bins();
}
const std::set<SensorId>& Mapper::sensors_off() const {
  return state_->off;
}

Result<MapExport> Mapper::final_map(std::string_view id) const {
  const auto k = state_->find(id);
  if (!k) return unknown_method(id);
  const State::Entry& entry = state_->entries[*k];
  const MethodRun& newest = entry.next ? *entry.next : entry.run;
  auto copy = find_method(state_->methods[*k].choice.name)->restore(newest.method().save());
  if (!copy) return copy.error();
  MethodRun run = newest.with(std::move(*copy));
  run.take_rest(state_->stream_of(run.method()).log(), *state_->executor);
  // Twice: what was worked out on line is then weighed again as in one batch (see `Consensus`).
  run.method().finish(*state_->executor);
  run.method().finish(*state_->executor);
  return run.method().export_map();
}

}  // namespace echoarc::live
