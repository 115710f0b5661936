// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <map>

#include "echoarc/core/options.hpp"
#include "echoarc/sensing/no_echo.hpp"

namespace echoarc {
namespace {

// What makes a value a code for no echo rather than a wall. A robot that moves sees walls at ever changing ranges, so a
// value that comes back again and again at the far end is written by the sensor's firmware.
constexpr std::size_t least_values = 10;     // different values; fewer: the robot stood still, nothing can be told
constexpr std::size_t least_count = 5;       // occurrences of the code
constexpr std::size_t least_share = 100;     // one reading in so many
constexpr std::size_t beyond_share = 20;     // beyond the code lies at most one in so many of its occurrences
constexpr std::size_t neighbour_factor = 5;  // so many times more frequent than any value within 10 %
constexpr double neighbourhood = 0.1;

/// One value with its number of occurrences.
struct Run {
  double value_m = 0.0;
  std::size_t count = 0;
};

/// A value that stands for no echo, and how many readings lie beyond it.
struct Code {
  Run run;
  std::size_t beyond = 0;
};

/// The positive finite values in ascending order with their frequencies.
std::vector<Run> histogram(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !(std::isfinite(v) && v > 0.0); });
  std::ranges::sort(values);
  std::vector<Run> runs;
  for (const double value : values) {
    if (runs.empty() || runs.back().value_m != value) runs.push_back({value, 0});
    ++runs.back().count;
  }
  return runs;
}

std::size_t readings_in(std::span<const Run> runs) {
  std::size_t count = 0;
  for (const Run& run : runs) count += run.count;
  return count;
}

/// The most frequent of the values that have at most one reading in a hundred beyond them.
Code top_candidate(std::span<const Run> runs) {
  const std::size_t allowed = readings_in(runs) / least_share;
  Code best;
  std::size_t beyond = 0;
  for (auto run = runs.rbegin(); run != runs.rend() && beyond <= allowed; ++run) {
    if (run->count > best.run.count) best = {*run, beyond};
    beyond += run->count;
  }
  return best;
}

std::size_t most_frequent_neighbour(std::span<const Run> runs, const Run& of) {
  std::size_t most = 0;
  for (const Run& run : runs)
    if (run.value_m != of.value_m && std::abs(run.value_m - of.value_m) <= neighbourhood * of.value_m)
      most = std::max(most, run.count);
  return most;
}

/// Whether most readings apart from `code` lie beyond twice the maximum: then the whole log is in another unit, and its
/// code for no echo cannot be told from a wall far away.
bool unit_is_doubtful(std::span<const Run> runs, const Run& code, double max_m) {
  std::size_t far = 0;
  std::size_t others = 0;
  for (const Run& run : runs) {
    if (run.value_m == code.value_m) continue;
    others += run.count;
    if (run.value_m > 2.0 * max_m) far += run.count;
  }
  return 2 * far > others;
}

std::optional<Code> find_code(std::span<const Run> runs, double max_m) {
  if (runs.size() < least_values) return std::nullopt;
  const Code code = top_candidate(runs);
  if (code.run.count < std::max(least_count, readings_in(runs) / least_share)) return std::nullopt;
  if (code.beyond * beyond_share > code.run.count) return std::nullopt;
  if (most_frequent_neighbour(runs, code.run) * neighbour_factor > code.run.count) return std::nullopt;
  if (code.run.value_m > 2.0 * max_m && unit_is_doubtful(runs, code.run, max_m)) return std::nullopt;
  return code;
}

std::string of_readings(std::size_t count, std::size_t all) {
  return " (" + std::to_string(count) + " of " + std::to_string(all) + " readings)";
}

std::string why_code(const Code& code, std::span<const Run> runs) {
  const auto most = std::ranges::max_element(runs, {}, &Run::count);
  const std::string frequent =
      most->value_m == code.run.value_m ? "the most frequent value" : "far more frequent than the values next to it";
  return " is read as no echo: " + frequent +
         (code.beyond == 0 ? " and nothing lies beyond it"
                           : " and only " + std::to_string(code.beyond) + " readings lie beyond it");
}

/// Puts the findings of one sensor into words, one clause per spelling that occurs.
class Sentence {
 public:
  Sentence(const Sensor& sensor, std::span<const double> values) : sensor_(sensor), values_(values) {}

  void code(const Code& code, std::span<const Run> runs) {
    const std::size_t here = count([&](double v) { return v == code.run.value_m; });
    add(to_text(code.run.value_m) + " m", here, why_code(code, runs));
  }
  template <class Predicate>
  void if_any(Predicate&& predicate, std::string_view subject, std::string_view verdict) {
    const std::size_t found = count(predicate);
    if (found > 0) add(std::string(subject), found, std::string(verdict));
  }
  /// With the sensor and how many of its readings each clause concerns.
  [[nodiscard]] std::string text() const { return "sensor " + std::to_string(sensor_.id) + ": " + joined(clauses_); }
  /// Without them.
  [[nodiscard]] std::string rule() const { return joined(rules_); }

 private:
  template <class Predicate>
  [[nodiscard]] std::size_t count(Predicate&& predicate) const {
    return static_cast<std::size_t>(std::ranges::count_if(values_, predicate));
  }

  void add(const std::string& subject, std::size_t readings, const std::string& verdict) {
    clauses_.push_back(subject + of_readings(readings, values_.size()) + verdict);
    rules_.push_back(subject + verdict);
  }
  [[nodiscard]] std::string joined(const std::vector<std::string>& clauses) const {
    if (clauses.empty())
      return "no value stands for no echo; one of " + to_text(sensor_.model.range_max_m) +
             " m or more would, as would 0, -1 and +Inf";
    std::string text;
    for (const std::string& clause : clauses) text += (text.empty() ? "" : "; ") + clause;
    return text;
  }

  const Sensor& sensor_;
  std::span<const double> values_;
  std::vector<std::string> clauses_;
  std::vector<std::string> rules_;
};

NoEchoDecision decide(const Sensor& sensor, std::span<const double> values, const std::optional<Code>& code,
                      std::span<const Run> pool) {
  NoEchoDecision decision = describe_no_echo(sensor);
  const double max_m = sensor.model.range_max_m;
  Sentence sentence(sensor, values);
  if (code) {
    decision.code_m = code->run.value_m;
    decision.from_m = std::min(max_m, decision.code_m);
    sentence.code(*code, pool);
  }
  const auto outcome_of = [&](double v) { return decode_range(v, decision, sensor.model); };
  const auto silent = [&](double v) { return !outcome_of(v).rejection && is_no_echo(outcome_of(v).outcome); };
  sentence.if_any([](double v) { return v == HUGE_VAL; }, "+Inf", " is read as no echo (REP 117)");
  sentence.if_any([](double v) { return v == 0.0; }, "0", " is read as no echo");
  sentence.if_any([&](double v) { return v < 0.0 && silent(v); }, "-1", " is read as no echo");
  sentence.if_any([&](double v) { return std::isfinite(v) && v > 0.0 && v != decision.code_m && silent(v); },
                  "everything from " + to_text(decision.from_m) + " m up", " is read as no echo");
  sentence.if_any([&](double v) { return outcome_of(v).rejection == Rejection::implausible_range; },
                  "beyond " + to_text(2.0 * max_m) + " m, twice the maximum,", " is rejected: check the unit");
  sentence.if_any([](double v) { return std::isnan(v); }, "NaN",
                  " is read as a failed measurement; if it means no echo, set no_echo = \"nan\"");
  decision.sentence = sentence.text();
  decision.rule = sentence.rule();
  return decision;
}

/// The values of every sensor of the array, in its order.
std::vector<std::vector<double>> values_by_sensor(const SensorArray& array, std::span<const Ping> pings) {
  std::vector<std::vector<double>> values(array.size());
  for (const Ping& ping : pings)
    if (const Sensor* sensor = array.find(ping.rx); sensor != nullptr && ping.echo_index == 0)
      values[static_cast<std::size_t>(sensor - array.sensors().data())].push_back(ping.range_m);
  return values;
}

}  // namespace

std::vector<NoEchoDecision> decide_no_echo(const SensorArray& array, std::span<const Ping> pings) {
  const std::span<const Sensor> sensors = array.sensors();
  const std::vector<std::vector<double>> values = values_by_sensor(array, pings);
  std::vector<NoEchoDecision> decisions;
  for (const Sensor& sensor : sensors) decisions.push_back(describe_no_echo(sensor));
  std::vector<bool> done(sensors.size(), false);
  for (std::size_t first = 0; first < sensors.size(); ++first) {
    const SensorModel& model = sensors[first].model;
    if (done[first] || model.no_echo.kind != NoEchoRule::Kind::automatic) continue;
    std::vector<std::size_t> alike;
    std::vector<double> pool;
    for (std::size_t k = first; k < sensors.size(); ++k) {
      if (sensors[k].model != model) continue;
      alike.push_back(k);
      pool.insert(pool.end(), values[k].begin(), values[k].end());
    }
    const std::vector<Run> runs = histogram(std::move(pool));
    const std::optional<Code> code = find_code(runs, model.range_max_m);
    for (const std::size_t k : alike) {
      decisions[k] = decide(sensors[k], values[k], code, runs);
      done[k] = true;
    }
  }
  return decisions;
}

}  // namespace echoarc
