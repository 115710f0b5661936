// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/feature_extraction.hpp"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "echoarc/io/geojson.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view tangents_name = "tangents";
constexpr std::string_view regions_name = "regions";
constexpr std::string_view lines_name = "lines";

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

template <class Options>
Result<Options> options_of(const std::map<std::string, OptionMap>& options, std::string_view name) {
  const auto found = options.find(std::string(name));
  return make_options<Options>(found == options.end() ? OptionMap{} : found->second);
}

}  // namespace

std::span<const OptionGroup> feature_groups() {
  static const std::array<OptionGroup, 3> groups{{
      {tangents_name, "Common tangents", "Segments that touch successive arcs of one sonar (map --features).",
       "[Choset03] II-C, after McKerrow", option_specs<TangentOptions>()},
      {regions_name, "Regions of constant depth",
       "Walls, corners and edges out of turns in place at several positions (map --features).",
       "[Choset03] II-C, after Leonard", option_specs<DepthRegionOptions>()},
      {lines_name, "Cluster lines", "Segments through clusters of map points (map --features).",
       "[Silver04] 2.C, after MacKenzie and Dudek", option_specs<ClusterLineOptions>()},
  }};
  return groups;
}

Result<std::vector<std::string>> choose_features(const std::vector<std::string>& wanted) {
  std::vector<std::string> chosen;
  std::vector<std::string_view> names;
  for (const OptionGroup& group : feature_groups()) {
    names.push_back(group.name);
    if (contains(wanted, "all") || contains(wanted, group.name)) chosen.emplace_back(group.name);
  }
  for (const std::string& name : wanted)
    if (name != "all" && std::ranges::find(names, name) == names.end())
      return Error{ErrorCode::bad_value, fmt::format("there are no features {}", name), "--features",
                   fmt::format("use all, or some of {}", fmt::join(names, ","))};
  return chosen;
}

Result<FeatureExtraction> FeatureExtraction::make(const std::vector<std::string>& chosen,
                                                  const std::map<std::string, OptionMap>& options) {
  const auto tangents = options_of<TangentOptions>(options, tangents_name);
  if (!tangents) return tangents.error();
  const auto regions = options_of<DepthRegionOptions>(options, regions_name);
  if (!regions) return regions.error();
  const auto lines = options_of<ClusterLineOptions>(options, lines_name);
  if (!lines) return lines.error();
  FeatureExtraction extraction;
  extraction.tangents_wanted_ = contains(chosen, tangents_name);
  extraction.regions_wanted_ = contains(chosen, regions_name);
  extraction.lines_wanted_ = contains(chosen, lines_name);
  extraction.tangents_ = CommonTangents(*tangents);
  extraction.landmarks_ = Landmarks(*regions);
  extraction.line_options_ = *lines;
  return extraction;
}

void FeatureExtraction::insert(std::span<const Reading> readings) {
  if (tangents_wanted_) tangents_.insert(readings);
  if (regions_wanted_) landmarks_.insert(readings);
}

Result<void> FeatureExtraction::write_arc_features(const fs::path& folder, std::string_view frame) {
  if (!any()) return {};
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return Error{ErrorCode::unwritable, code.message(), folder.string(), "choose another folder with -o"};
  const auto write = [&](std::string_view name, const std::vector<Feature>& features) -> Result<void> {
    of_arcs_.insert(of_arcs_.end(), features.begin(), features.end());
    summary_.push_back(fmt::format("{}: {}", name, features.size()));
    return io::write_features_geojson(folder / fmt::format("{}.geojson", name), features, frame);
  };
  if (tangents_wanted_)
    if (Result<void> written = write(tangents_name, tangents_.features()); !written) return written;
  if (regions_wanted_)
    if (Result<void> written = write(regions_name, landmarks_.features()); !written) return written;
  return {};
}

Result<std::vector<Feature>> FeatureExtraction::write_lines(const fs::path& folder, std::string_view method,
                                                            const PointMap& points, std::string_view frame) const {
  std::vector<Feature> drawn = of_arcs_;
  if (!lines_wanted_) return drawn;
  std::vector<Vec2> positions;
  for (const MapPoint& point : points.points()) positions.push_back(point.position);
  const std::vector<Feature> lines = cluster_lines(positions, line_options_);
  const fs::path file = folder / fmt::format("{}-{}.geojson", lines_name, method);
  if (const Result<void> written = io::write_features_geojson(file, lines, frame); !written) return written.error();
  drawn.insert(drawn.end(), lines.begin(), lines.end());
  return drawn;
}

}  // namespace echoarc::cli
