// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "echoarc/studies/comparison_findings.hpp"
#include "report/comparison_document.hpp"

namespace echoarc::report {
namespace {

using Json = nlohmann::ordered_json;
using namespace studies;

constexpr std::array<std::string_view, 3> kinds{"log", "truncated_log", "scene"};

Json option_json(const OptionValue& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

Json method_json(const ComparedMethod& method) {
  Json options = Json::object();
  for (const auto& [name, value] : method.options) options[name] = option_json(value);
  return {{"label", method.label},
          {"method", method.method},
          {"options", std::move(options)},
          {"range_cut_m", method.range_cut_m}};
}

Json scores_json(const MeanScores& scores) {
  return {{"points", scores.points},
          {"accuracy_5cm", scores.accuracy[0]},
          {"accuracy_10cm", scores.accuracy[1]},
          {"accuracy_20cm", scores.accuracy[2]},
          {"coverage", scores.coverage},
          {"mae_m", scores.mean_m}};
}

Json share_json(const ObservedShare& share) {
  return {{"hits", share.hits}, {"of", share.of}, {"share", share.share}, {"low", share.low}, {"high", share.high}};
}

Json bins_json(const std::vector<CalibrationBin>& bins) {
  Json json = Json::array();
  for (const CalibrationBin& bin : bins)
    if (bin.observed.of > 0)
      json.push_back(
          {{"low", bin.low}, {"high", bin.high}, {"claimed", bin.claimed}, {"observed", share_json(bin.observed)}});
  return json;
}

Json calibration_json(const std::vector<ClaimedPoint>& claims) {
  const Calibration all = calibrate(claims);
  Json labels = Json::object();
  for (std::size_t k = 0; k < point_label_count; ++k) {
    const Calibration part = calibrate(with_label(claims, PointLabel(k)));
    if (part.points == 0) continue;
    labels[std::string(name(PointLabel(k)))] = {{"claimed", part.claimed},
                                                {"right", share_json(part.right)},
                                                {"bound_held", share_json(part.bound_held)},
                                                {"error", part.error},
                                                {"by_probability", bins_json(part.by_p)}};
  }
  return {{"points", all.points},
          {"claimed", all.claimed},
          {"right", share_json(all.right)},
          {"bound_held", share_json(all.bound_held)},
          {"error", all.error},
          {"by_probability", bins_json(all.by_p)},
          {"by_bound", bins_json(all.bound)},
          {"labels", std::move(labels)}};
}

Json pixels_json(const std::vector<ComparedMap>& maps) {
  Json seeds = Json::array();
  for (const ComparedMap& map : maps)
    seeds.push_back({{"mae_m", map.pixels->mae_m},
                     {"points", map.pixels->points},
                     {"cdr_full", map.pixels->detection.full_ratio()},
                     {"cdr_empty", map.pixels->detection.empty_ratio()},
                     {"cdr_overall", map.pixels->detection.overall_ratio()}});
  return seeds;
}

Json maps_json(const ComparedPlace& place, std::size_t method) {
  const std::vector<ComparedMap>& maps = place.maps[method];
  Json json{{"every_point", scores_json(mean_scores(maps, every_point))},
            {"one_per_cell", scores_json(mean_scores(maps, one_per_cell))}};
  if (place.kind == PlaceKind::truncated) {
    json["every_point_whole_laser"] = scores_json(mean_scores_against_whole(maps, every_point));
    json["one_per_cell_whole_laser"] = scores_json(mean_scores_against_whole(maps, one_per_cell));
  }
  if (!maps.empty() && maps.front().pixels) json["pixels_by_seed"] = pixels_json(maps);
  const std::vector<ClaimedPoint> claims = claims_of(place, method);
  if (!claims.empty()) json["calibration"] = calibration_json(claims);
  return json;
}

Json place_json(const Comparison& comparison, const ComparedPlace& place) {
  Json maps = Json::object();
  for (std::size_t m = 0; m < comparison.methods.size(); ++m) maps[comparison.methods[m].label] = maps_json(place, m);
  return {{"name", place.name},       {"kind", kinds[std::size_t(place.kind)]}, {"experiment", place.experiment},
          {"seconds", place.seconds}, {"reference", place.provenance},          {"methods", std::move(maps)}};
}

Json pooled_json(const Comparison& comparison) {
  Json json = Json::object();
  for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
    if (pooled_claims(comparison, m, Pool::all).empty()) continue;
    json[comparison.methods[m].label] = {{"logs", calibration_json(pooled_claims(comparison, m, Pool::logs))},
                                         {"scenes", calibration_json(pooled_claims(comparison, m, Pool::scenes))},
                                         {"all", calibration_json(pooled_claims(comparison, m, Pool::all))}};
  }
  return json;
}

std::string_view spelled(Counting counting) {
  return counting == every_point ? "every_point" : "one_per_cell";
}

Json dominance_json(const Comparison& comparison) {
  Json dominators = Json::array();
  for (const Dominance& one : dominators_of_consensus(comparison))
    dominators.push_back({{"place", comparison.places[one.place].name},
                          {"better", comparison.methods[one.better].label},
                          {"worse", comparison.methods[one.worse].label},
                          {"counting", spelled(one.counting)}});
  Json json{{"dominates_consensus", std::move(dominators)}};
  for (const Counting counting : {every_point, one_per_cell}) {
    Json list = Json::array();
    for (const Duel& duel : duels(comparison, counting)) {
      Json others = Json::array();
      for (const std::size_t p : duel.others) others.push_back(comparison.places[p].name);
      list.push_back({{"method", comparison.methods[duel.method].label},
                      {"places", duel.places},
                      {"dominated", duel.dominated},
                      {"not_dominated_on", std::move(others)}});
    }
    json[std::string(spelled(counting))] = std::move(list);
  }
  return json;
}

}  // namespace

std::string comparison_json(const ComparisonDocument& document) {
  const Comparison& comparison = document.comparison;
  Json methods = Json::array();
  for (const ComparedMethod& method : comparison.methods) methods.push_back(method_json(method));
  Json places = Json::array();
  for (const ComparedPlace& place : comparison.places) places.push_back(place_json(comparison, place));
  const Json json{{"format", "echoarc-comparison-1"},
                  {"version", document.version},
                  {"command", document.command},
                  {"seeds", comparison.seeds},
                  {"methods", std::move(methods)},
                  {"places", std::move(places)},
                  {"calibration", pooled_json(comparison)},
                  {"dominance", dominance_json(comparison)}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace echoarc::report
