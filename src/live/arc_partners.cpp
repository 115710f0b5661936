// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "live/arc_partners.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace echoarc::live {
namespace {

std::string text_option(const OptionMap& options, std::string_view name) {
  const auto found = options.find(name);
  const auto* text = found != options.end() ? std::get_if<std::string>(&found->second) : nullptr;
  return text != nullptr ? *text : std::string();
}

/// How many arcs of a ring came before each ping: an arc leaves when so many as the ring holds came after it.
class RingPlaces {
 public:
  RingPlaces(const Evidence& evidence, const ComparedArcs& compared) : compared_(compared) {
    before_.reserve(evidence.readings.size());
    for (std::size_t k = 0; k < evidence.readings.size(); ++k) {
      const JudgedPing& ping = evidence.readings[k];
      const bool arc = is_used(evidence, ping) && echo_range_m(ping.reading.outcome);
      const SensorId ring = compared.scope == ComparedArcs::Scope::per_sensor ? ping.reading.rx : 0;
      before_.emplace_back(ring, counts_[ring]);
      if (arc) ++counts_[ring];
      if (compared.scope == ComparedArcs::Scope::per_sensor) at_.push_back(counts_);
    }
  }
  /// Whether the arc of the older ping is still in its ring when the newer one comes.
  [[nodiscard]] bool meet(std::size_t older, std::size_t newer) const {
    if (compared_.scope == ComparedArcs::Scope::all) return true;
    const auto [ring, place] = before_[older];
    const std::size_t now =
        compared_.scope == ComparedArcs::Scope::total ? before_[newer].second + 1 : at_[newer].at(ring);
    return now - place <= compared_.arcs;
  }

 private:
  ComparedArcs compared_;
  std::map<SensorId, std::size_t> counts_;
  std::vector<std::pair<SensorId, std::size_t>> before_;
  std::vector<std::map<SensorId, std::size_t>> at_;
};

/// Counts by reason; their order is that in which they are told.
class Reasons {
 public:
  enum Reason : std::uint8_t { apart, flat, too_long_ago, silent, no_arc, off, rejected, count };
  void add(Reason reason) { ++counts_[reason]; }
  [[nodiscard]] std::vector<UnusedPings> told(Angle theta_t) const {
    const std::array<std::string, count> words{"their arcs do not cross this one",
                                               "they cross it at less than " + degrees_text(theta_t),
                                               "they are not in the history together with it",
                                               "no echo, so no arc",
                                               "no arc",
                                               "their sensor is turned off",
                                               "rejected"};
    std::vector<UnusedPings> unused;
    for (std::size_t k = 0; k < count; ++k)
      if (counts_[k] > 0) unused.push_back({words[k], counts_[k]});
    return unused;
  }

 private:
  std::array<std::uint64_t, count> counts_{};
};

}  // namespace

ComparedArcs compared_arcs(std::string_view method, const OptionMap& options) {
  using Scope = ComparedArcs::Scope;
  ComparedArcs compared;
  compared.policy = beam_policy_of(options);
  const bool own_ring = method.starts_with("atm");  // carving and the two combined have one ring for all sensors
  const std::string scope = text_option(options, "history");
  if (own_ring) compared.scope = scope == "all" ? Scope::all : scope == "per_sensor" ? Scope::per_sensor : Scope::total;
  compared.arcs = std::size_t(std::max(1.0, number_option(options, own_ring ? "history_arcs" : "history", 250.0)));
  const std::string angle = text_option(options, "angle");
  if (angle.empty() || angle == "given") compared.theta_t = degrees(number_option(options, "theta_t_deg", 0.0));
  return compared;
}

Partners find_partners(const Evidence& evidence, std::size_t own, const Arc& arc, const ComparedArcs& compared) {
  Partners partners;
  Reasons reasons;
  const RingPlaces rings(evidence, compared);
  const CrossableArc own_arc(arc);
  const Box box = arc.bounds();
  for (std::size_t k = 0; k < evidence.readings.size(); ++k) {
    const JudgedPing& ping = evidence.readings[k];
    if (k == own) continue;
    if (!is_used(evidence, ping)) {
      reasons.add(ping.rejected ? Reasons::rejected : Reasons::off);
    } else if (!echo_range_m(ping.reading.outcome)) {
      reasons.add(Reasons::silent);
    } else if (const auto other = arc_of(ping.reading, compared.policy); !other) {
      reasons.add(Reasons::no_arc);
    } else if (const ArcCrossings found =
                   overlap(box, other->bounds()) ? crossings(own_arc, CrossableArc(*other)) : ArcCrossings{};
               found.empty()) {
      reasons.add(Reasons::apart);
    } else if (!rings.meet(std::min(k, own), std::max(k, own))) {
      reasons.add(Reasons::too_long_ago);
    } else {
      const std::size_t before = partners.crossing.size();
      for (const ArcCrossing& crossing : found)
        if (crossing.angle >= compared.theta_t) partners.crossing.push_back({k, crossing});
      if (partners.crossing.size() == before) reasons.add(Reasons::flat);
    }
  }
  partners.unused = reasons.told(compared.theta_t);
  return partners;
}

}  // namespace echoarc::live
