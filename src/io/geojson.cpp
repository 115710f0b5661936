// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/geojson.hpp"

#include <nlohmann/json.hpp>

#include "io/files.hpp"

namespace echoarc::io {
namespace {

using Json = nlohmann::ordered_json;

Json position_json(Vec2 p) {
  return Json::array({p.x, p.y});
}

Json feature_json(const Feature& feature) {
  Json geometry = Json::object();
  geometry["type"] = feature.is_point() ? "Point" : "LineString";
  geometry["coordinates"] = feature.is_point()
                                ? position_json(feature.begin)
                                : Json::array({position_json(feature.begin), position_json(feature.end)});
  return {{"type", "Feature"},
          {"geometry", std::move(geometry)},
          {"properties",
           {{"kind", name(feature.kind)},
            {"residual_m", feature.residual_m},
            {"count", feature.count},
            {"pings", feature.pings}}}};
}

}  // namespace

std::string features_geojson(std::span<const Feature> features, std::string_view frame) {
  const Json collection = {{"type", "FeatureCollection"},
                           {"echoarc",
                            {{"frame", frame},
                             {"unit", "m"},
                             {"axes", "x right, y up, right-handed"},
                             {"note", "local metric coordinates, not longitude and latitude"}}}};
  std::string text = collection.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.pop_back();  // one feature a line: files that people can read and compare
  text += ",\"features\":[";
  bool first = true;
  for (const Feature& feature : features) {
    if (!is_finite(feature.begin) || !is_finite(feature.end)) continue;  // JSON knows no such numbers
    text += (first ? "\n" : ",\n") + feature_json(feature).dump();
    first = false;
  }
  return text + (first ? "]}\n" : "\n]}\n");
}

Result<void> write_features_geojson(const std::filesystem::path& path, std::span<const Feature> features,
                                    std::string_view frame) {
  return write_file(path, features_geojson(features, frame));
}

}  // namespace echoarc::io
