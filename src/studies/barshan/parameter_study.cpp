// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/barshan/parameter_study.hpp"

#include <array>
#include <utility>

#include "studies/barshan/methods.hpp"
#include "studies/barshan/sections.hpp"
#include "studies/findings.hpp"

namespace echoarc::studies::barshan {
namespace {

struct Studied {
  Technique technique;
  double parameter;
};
// VT and MP are what the earlier studies looked at; DM beside them. Parameters are those of the curve.
constexpr std::array studied{Studied{Technique::vt, 4}, Studied{Technique::mp, 8}, Studied{Technique::dm, 4}};

/// MAE in cm of every studied technique for one seed.
using Errors = std::array<double, studied.size()>;

Result<Errors> run_one(const Experiment& experiment, std::uint64_t seed) {
  const Result<Trial> trial = experiment.trial(seed);
  if (!trial) return trial.error();
  std::vector<MethodSpec> specs;
  for (const Studied& one : studied) specs.push_back(spec_of(one.technique, Place::curve, one.parameter));
  const Result<std::vector<MethodResult>> results = run_methods(*trial, specs);
  if (!results) return results.error();
  Errors errors{};
  for (std::size_t k = 0; k < errors.size(); ++k) errors[k] = mae_cm((*results)[k].cells);
  return errors;
}

/// What was measured of one variation, by seed.
struct Measured {
  Variation variation;
  std::vector<Errors> seeds;

  [[nodiscard]] std::vector<double> of(std::size_t technique) const {
    return figures(seeds, [&](const Errors& errors) { return errors[technique]; });
  }
};

Result<std::vector<Measured>> measure(const StudyHost& host, StudyProgress& progress) {
  std::vector<Experiment> experiments;
  for (const Variation& variation : variations()) {
    Result<StudyScene> scene = host.scene(variation.scene);
    if (!scene) return scene.error();
    Result<StudyScene> changed = varied(std::move(*scene), variation);
    if (!changed) return changed.error();
    Result<Experiment> experiment = Experiment::make(std::move(*changed));
    if (!experiment) return experiment.error();
    experiments.push_back(std::move(*experiment));
  }
  const auto seeds = std::size_t(host.seeds);
  const Result<std::vector<Errors>> errors =
      run_tasks<Errors>(host, experiments.size() * seeds, progress,
                        [&](std::size_t k) { return run_one(experiments[k / seeds], std::uint64_t(k % seeds) + 1); });
  if (!errors) return errors.error();
  std::vector<Measured> measured;
  const std::vector<Variation> all = variations();
  for (std::size_t v = 0; v < all.size(); ++v) {
    const auto begin = errors->begin() + std::ptrdiff_t(v * seeds);
    measured.push_back({all[v], {begin, begin + std::ptrdiff_t(seeds)}});
  }
  return measured;
}

std::vector<const Measured*> of_study(const std::vector<Measured>& all, std::string_view study) {
  std::vector<const Measured*> part;
  for (const Measured& one : all)
    if (one.variation.study == study) part.push_back(&one);
  return part;
}

std::string name_of(std::size_t technique) {
  return std::string(barshan::name_of(studied[technique].technique));
}

StudyTable table_of(const std::vector<const Measured*>& part) {
  StudyTable table{.id = "E13-" + part.front()->variation.study,
                   .title = "MAE against " + part.front()->variation.study,
                   .note = {},
                   .layout = TableLayout::matrix,
                   .rows = {}};
  for (const Measured* one : part)
    for (std::size_t k = 0; k < studied.size(); ++k)
      table.rows.push_back(row_of({name_of(k), one->variation.label, "cm", 2}, no_figure, one->of(k)));
  return table;
}

ChartFigure chart_of(const std::vector<const Measured*>& part) {
  const Variation& first = part.front()->variation;
  Chart chart{.title = "MAE against " + first.study,
              .x = {.title = first.study + (first.unit.empty() ? "" : " (" + first.unit + ")")},
              .y = {.title = "MAE (cm)", .low = 0.0}};
  chart.height_px = 330;
  for (std::size_t k = 0; k < studied.size(); ++k) {
    ChartSeries series{.name = name_of(k), .mark = ChartMark::both};
    for (const Measured* one : part) {
      const Spread spread = spread_of(one->of(k));
      series.x.push_back(one->variation.value);
      series.y.push_back(spread.mean);
      series.low.push_back(spread.min);
      series.high.push_back(spread.max);
    }
    chart.series.push_back(std::move(series));
  }
  return {"e13-" + first.study, "Bands: least to largest of the seeds.", std::move(chart)};
}

/// The first variation with a map at all: narrow beams leave no cell that four arcs cross.
const Measured& first_with_values(const std::vector<const Measured*>& part, std::size_t technique) {
  for (const Measured* one : part)
    if (spread_of(one->of(technique)).values == one->seeds.size()) return *one;
  return *part.front();
}

/// VT and MP: what the paper speaks of.
void add_claims(StudySection& section, const std::vector<const Measured*>& part) {
  const FigureFormat cm{"cm", 2, 1.0};
  const Variation& first = part.front()->variation;
  for (std::size_t k = 0; k < 2; ++k) {
    if (first.study == "layout") {
      for (std::size_t v = 1; v < part.size(); ++v)
        section.claims.push_back(claim_less({"E13-layout-" + name_of(k) + "-" + std::to_string(v),
                                             "MAE of " + name_of(k) + ": " + part[v - 1]->variation.label +
                                                 " layout < " + part[v]->variation.label + " layout",
                                             "4.3"},
                                            part[v - 1]->of(k), part[v]->of(k), cm));
      continue;
    }
    if (first.study == "range noise") continue;  // varied, but no trend is stated
    const Measured& low = first_with_values(part, k);
    section.claims.push_back(claim_less({"E13-" + first.study + "-" + name_of(k),
                                         "MAE of " + name_of(k) + " grows with " + first.study + " (" +
                                             low.variation.label + " to " + part.back()->variation.label + ")",
                                         "4.3"},
                                        low.of(k), part.back()->of(k), cm));
  }
}

}  // namespace

std::size_t parameter_tasks(const StudyHost& host) {
  return variations().size() * std::size_t(host.seeds);
}

Result<StudySection> parameter_section(const StudyHost& host, StudyProgress& progress) {
  const Result<std::vector<Measured>> measured = measure(host, progress);
  if (!measured) return measured.error();
  StudySection section;
  section.id = "parameters";
  section.title = "Section 4.3: layouts, beam width, roughness, curvature, distance, noise";
  section.paragraphs = {
      "The paper reports of earlier simulations of VT and MP: the best results with randomly placed transducers, then "
      "on "
      "a circle, then in a line; errors that grow with beam width, distance, curvature and roughness. It prints no "
      "figures. Ours: 31 transducers before the curved surface, one stop, all listen; VT with threshold 4, MP with m = "
      "8, "
      "DM with threshold 4. Everything but the layouts is varied on the circle. Curvature is a factor on the surface's "
      "height; roughness the strength of bumps 5 cm apart."};
  for (const std::string_view study : {"layout", "beam width", "roughness", "curvature", "distance", "range noise"}) {
    const std::vector<const Measured*> part = of_study(*measured, study);
    add_claims(section, part);
    section.tables.push_back(table_of(part));
    if (study != "layout") section.charts.push_back(chart_of(part));
  }
  return section;
}

}  // namespace echoarc::studies::barshan
