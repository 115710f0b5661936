// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option_groups.hpp"
#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/features/cluster_lines.hpp"
#include "echoarc/features/common_tangents.hpp"
#include "echoarc/features/landmarks.hpp"
#include "echoarc/maps/point_map.hpp"

namespace echoarc::cli {

/// The extractors by name: title, summary, source and options, as the catalogue has them of methods.
[[nodiscard]] std::span<const OptionGroup> feature_groups();
/// Names of --features, each once; "all" is every one. Errors: an unknown name.
[[nodiscard]] Result<std::vector<std::string>> choose_features(const std::vector<std::string>& wanted);

/// The extractors of a run: those of arcs get the readings that the methods get, cluster lines the finished maps.
class FeatureExtraction {
 public:
  /// `options` by the name of the extractor. Errors: options out of range.
  [[nodiscard]] static Result<FeatureExtraction> make(const std::vector<std::string>& chosen,
                                                      const std::map<std::string, OptionMap>& options);

  [[nodiscard]] bool any() const { return tangents_wanted_ || regions_wanted_ || lines_wanted_; }
  void insert(std::span<const Reading> readings);
  /// Writes tangents.geojson and regions.geojson. `folder` is made if absent. Call it once, after the last reading.
  [[nodiscard]] Result<void> write_arc_features(const std::filesystem::path& folder, std::string_view frame);
  /// Writes lines-METHOD.geojson. Returns what belongs into the picture of the method: these and the features of arcs.
  [[nodiscard]] Result<std::vector<Feature>> write_lines(const std::filesystem::path& folder, std::string_view method,
                                                         const PointMap& points, std::string_view frame) const;
  /// "tangents: 12 segments", one line per kind of file written so far.
  [[nodiscard]] std::vector<std::string> summary() const { return summary_; }

 private:
  bool tangents_wanted_ = false;
  bool regions_wanted_ = false;
  bool lines_wanted_ = false;
  CommonTangents tangents_;
  Landmarks landmarks_;
  ClusterLineOptions line_options_;
  std::vector<Feature> of_arcs_;
  std::vector<std::string> summary_;
};

}  // namespace echoarc::cli
