// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "report/report_document.hpp"

namespace echoarc::report {
namespace {

using Json = nlohmann::ordered_json;
using namespace studies;

Json spread_json(const Spread& spread) {
  return {{"mean", spread.mean}, {"deviation", spread.deviation}, {"min", spread.min},
          {"max", spread.max},   {"values", spread.values},       {"runs", spread.runs}};
}

Json row_json(const StudyRow& row) {
  return {{"quantity", row.quantity},     {"condition", row.condition},    {"unit", row.unit},    {"paper", row.paper},
          {"paper_text", row.paper_text}, {"ours", spread_json(row.ours)}, {"remark", row.remark}};
}

Json table_json(const StudyTable& table) {
  Json rows = Json::array();
  for (const StudyRow& row : table.rows) rows.push_back(row_json(row));
  return {{"id", table.id}, {"title", table.title}, {"note", table.note}, {"rows", std::move(rows)}};
}

std::string_view spelled(Verdict verdict) {
  return verdict == Verdict::holds ? "holds" : verdict == Verdict::fails ? "fails" : "undecided";
}

Json claim_json(const Claim& claim) {
  return {{"id", claim.id},
          {"text", claim.text},
          {"source", claim.source},
          {"verdict", spelled(claim.verdict)},
          {"seeds", claim.seeds},
          {"holds_on", claim.holds_on},
          {"evidence", claim.evidence}};
}

Json chart_json(const ChartFigure& figure) {
  Json series = Json::array();
  for (const ChartSeries& one : figure.chart.series) {
    Json json{{"name", one.name}, {"x", one.x}, {"y", one.y}};
    if (!one.low.empty()) json.update({{"low", one.low}, {"high", one.high}});
    series.push_back(std::move(json));
  }
  return {{"id", figure.id},
          {"caption", figure.caption},
          {"title", figure.chart.title},
          {"x", figure.chart.x.title},
          {"y", figure.chart.y.title},
          {"categories", figure.chart.categories},
          {"series", std::move(series)}};
}

Json picture_json(const PictureFigure& figure) {
  return {
      {"id", figure.id}, {"caption", figure.caption}, {"width", figure.image.width}, {"height", figure.image.height}};
}

template <class T>
Json list(const std::vector<T>& items, Json (*one)(const T&)) {
  Json json = Json::array();
  for (const T& item : items) json.push_back(one(item));
  return json;
}

Json section_json(const StudySection& section) {
  return {{"id", section.id},
          {"title", section.title},
          {"paragraphs", section.paragraphs},
          {"claims", list(section.claims, &claim_json)},
          {"tables", list(section.tables, &table_json)},
          {"charts", list(section.charts, &chart_json)},
          {"pictures", list(section.pictures, &picture_json)},
          {"remarks", section.remarks}};
}

Json study_json(const StudyReport& study) {
  return {{"name", study.name},   {"title", study.title},     {"source", study.source},
          {"seeds", study.seeds}, {"summary", study.summary}, {"sections", list(study.sections, &section_json)}};
}

}  // namespace

std::string json_report(const ReportDocument& document) {
  const Json json{{"format", "echoarc-reproduction-1"},
                  {"version", document.version},
                  {"command", document.command},
                  {"studies", list(document.studies, &study_json)}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace echoarc::report
