// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/arc_study.hpp"

#include <algorithm>
#include <string_view>

#include "echoarc/mapping/centerline.hpp"

namespace echoarc::studies {
namespace {

/// The count of a name; 0 where the method has none such.
std::uint64_t count_of(std::span<const Tally> tallies, std::string_view name) {
  const auto found = std::ranges::find(tallies, name, &Tally::name);
  return found == tallies.end() ? 0 : found->count;
}

void look(const AnyMethod& method, LatencyMeter& meter) {
  method.visit_arcs([&](const ArcState& arc) { meter.see(arc); });
  meter.end_sample();
}

/// What [Silver04] 5.B says of the centerline model: every arc of every scan is processed as it comes.
void see_processed(std::span<const Reading> scan, LatencyMeter& meter) {
  for (const Reading& reading : scan)
    if (const auto arc = arc_of(reading)) meter.see({.arc = *arc, .source = {}, .crossed = true});
  meter.end_sample();
}

ArcStudy study_one(AnyMethod& method, std::span<const Reading> readings, const RadiusBins& bins) {
  ArcStudy study{.method = std::string(method.name()), .latency = {}, .azimuth = {}};
  LatencyMeter latency(bins);
  AzimuthMeter azimuth(bins);
  method.watch_leaving([&](const ArcState& arc) {
    azimuth.see(arc);
    study.finished += arc.removed ? 0 : 1;
    study.improved += !arc.removed && arc.processed() ? 1 : 0;
  });
  InlineExecutor here;
  bool sampled = false;
  for (std::size_t first = 0, last = 0; first < readings.size(); first = last) {
    while (last < readings.size() && readings[last].scan == readings[first].scan) ++last;
    const std::span<const Reading> scan = readings.subspan(first, last - first);
    method.insert(scan, here);
    if (method.name() == Centerline::name) see_processed(scan, latency);
    if (!method.history_full()) continue;
    look(method, latency);
    sampled = true;
  }
  method.finish(here);
  if (!sampled && method.keeps_arcs()) look(method, latency);
  method.watch_leaving({});
  study.latency = latency.latency();
  study.azimuth = azimuth.classes();
  const std::vector<Tally> tallies = method.tallies();
  study.fully_carved_share = fully_carved_share(count_of(tallies, "removed_full"), count_of(tallies, "removed_split"),
                                                count_of(tallies, "left_history"));
  return study;
}

}  // namespace

std::vector<ArcStudy> study_arcs(std::span<AnyMethod> methods, std::span<const Reading> readings, Executor& executor,
                                 const RadiusBins& bins) {
  std::vector<ArcStudy> studies(methods.size());
  executor.run(methods.size(), [&](std::size_t k) { studies[k] = study_one(methods[k], readings, bins); });
  return studies;
}

}  // namespace echoarc::studies
