// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/silver/building_charts.hpp"

#include <string>
#include <utility>
#include <vector>

#include "echoarc/core/range_quantum.hpp"
#include "echoarc/studies/spread.hpp"

namespace echoarc::studies::silver {
namespace {

/// `figure(run, bin)` over the radii.
template <class Figure>
ChartSeries by_radius(std::string name, std::span<const BuildingRun> runs, const Figure& figure) {
  const RadiusBins bins;
  ChartSeries series{.name = std::move(name), .mark = ChartMark::both};
  for (std::size_t b = 0; b < bins.count(); ++b) {
    std::vector<double> values;
    for (const BuildingRun& run : runs) values.push_back(figure(run, b));
    const Spread spread = spread_of(values);
    series.x.push_back(bins.middle_m(b));
    series.y.push_back(spread.mean);
    series.low.push_back(spread.min);
    series.high.push_back(spread.max);
  }
  return series;
}

Chart chart_over_radius(std::string title, std::string y) {
  Chart chart;
  chart.title = std::move(title);
  chart.x = {.title = "radius of the arc (m)", .low = 0.0, .high = 4.0};
  chart.y.title = std::move(y);
  chart.y.low = 0.0;
  return chart;
}

}  // namespace

Chart latency_chart(std::span<const BuildingRun> runs) {
  Chart chart = chart_over_radius("Unprocessed arcs", "unprocessed (%)");
  chart.y.high = 100.0;
  const auto add = [&](std::string name, Watched method) {
    chart.series.push_back(by_radius(std::move(name), runs, [&](const BuildingRun& run, std::size_t b) {
      return 100.0 * run.study(method).latency.share_by_radius[b];
    }));
  };
  add("ATM", Watched::atm);
  add("arc carving", Watched::carve);
  add("arc carving and ATM", Watched::combined);
  return chart;
}

Chart length_chart(std::span<const BuildingRun> runs) {
  Chart chart = chart_over_radius("Angular length of carved arcs", "angular length (degrees)");
  const auto add = [&](std::string name, double AzimuthClass::* length) {
    chart.series.push_back(by_radius(std::move(name), runs, [&](const BuildingRun& run, std::size_t b) {
      return radians(run.study(Watched::carve).azimuth[b].*length).deg();
    }));
  };
  add("mean", &AzimuthClass::mean_length_rad);
  add("median", &AzimuthClass::median_length_rad);
  return chart;
}

Chart error_chart(std::span<const BuildingRun> runs) {
  Chart chart = chart_over_radius("Largest error of a point", "error (cm)");
  chart.series.push_back(by_radius("arc carving, mean", runs, [](const BuildingRun& run, std::size_t b) {
    return 100.0 * run.study(Watched::carve).azimuth[b].mean_error_m;
  }));
  const auto add_curve = [&](std::string name, auto error_m) {
    ChartSeries curve{.name = std::move(name), .dashed = true};
    for (double radius_m = 0.0; radius_m <= 3.81; radius_m += 0.05) {
      curve.x.push_back(radius_m);
      curve.y.push_back(100.0 * error_m(radius_m));
    }
    chart.series.push_back(std::move(curve));
  };
  add_curve("centerline, 2 r sin(phi/4)", [](double r) { return centerline_error_m(r, degrees(22.5)); });
  add_curve("ATM, q cot(psi/2)", [](double) { return crossing_error_m(inch_m, degrees(30.0)); });
  return chart;
}

}  // namespace echoarc::studies::silver
