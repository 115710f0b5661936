// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/geojson.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::io {
namespace {

TEST(GeoJson, SegmentsAndPointsOneALine) {
  const std::vector<Feature> features{
      {FeatureKind::wall, {0.5, 1.5}, {2.0, 1.5}, 0.25, 3, {1, 7}},
      {FeatureKind::edge, {-1.0, 0.125}, {-1.0, 0.125}, 0.0, 4, {}},
  };
  EXPECT_EQ(features_geojson(features, "odom"),
            R"({"type":"FeatureCollection","echoarc":{"frame":"odom","unit":"m","axes":"x right, y up, right-handed",)"
            R"("note":"local metric coordinates, not longitude and latitude"},"features":[)"
            "\n"
            R"({"type":"Feature","geometry":{"type":"LineString","coordinates":[[0.5,1.5],[2.0,1.5]]},)"
            R"("properties":{"kind":"wall","residual_m":0.25,"count":3,"pings":[1,7]}},)"
            "\n"
            R"({"type":"Feature","geometry":{"type":"Point","coordinates":[-1.0,0.125]},)"
            R"("properties":{"kind":"edge","residual_m":0.0,"count":4,"pings":[]}})"
            "\n]}\n");
}

TEST(GeoJson, NothingIsAnEmptyCollection) {
  const std::string text = features_geojson({}, "a\"b\xff");
  EXPECT_NE(text.find("\"features\":[]}"), std::string::npos);
  EXPECT_NE(text.find("a\\\"b"), std::string::npos);
}

TEST(GeoJson, WhatIsNotFiniteIsLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Feature> features{{FeatureKind::line, {nan, 0.0}, {1.0, 0.0}, 0.0, 5, {}}};
  EXPECT_EQ(features_geojson(features, "odom"), features_geojson({}, "odom"));
}

}  // namespace
}  // namespace echoarc::io
