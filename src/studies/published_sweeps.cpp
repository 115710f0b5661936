// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/published_sweeps.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "studies/chart_axis.hpp"

namespace echoarc::studies {
namespace {

constexpr std::string_view curve = "curve";
constexpr std::string_view room_a = "room-a";
constexpr std::string_view room_c = "room-c";

/// The columns of a table as printed.
struct Printed {
  std::span<const double> mae_cm;
  std::span<const double> cdr_overall;
  std::span<const double> cdr_full;
  std::span<const double> cdr_empty;
};

double entry(std::span<const double> column, std::size_t row) {
  return row < column.size() ? column[row] : std::numeric_limits<double>::quiet_NaN();
}

PublishedValue with_printed(OptionValue value, std::string label, const Printed& printed, std::size_t row) {
  return {std::move(value),
          std::move(label),
          entry(printed.mae_cm, row),
          entry(printed.cdr_overall, row),
          entry(printed.cdr_full, row),
          entry(printed.cdr_empty, row)};
}

std::vector<PublishedValue> whole_numbers(int first, int last, const Printed& printed) {
  std::vector<PublishedValue> values;
  for (int k = first; k <= last; ++k)
    values.push_back(with_printed(std::int64_t{k}, std::to_string(k), printed, std::size_t(k - first)));
  return values;
}

// Table 2, room (a), thresholds 1 to 10.
constexpr std::array vt_mae{14.76, 7.02, 4.58, 2.57, 1.87, 1.80, 1.54, 1.53, 1.48, 1.44};
constexpr std::array dm_mae{5.59, 3.10, 2.75, 2.36, 1.96, 1.87, 1.63, 1.55, 1.47, 1.45};
constexpr std::array t2_overall{.906, .946, .946, .938, .858, .834, .778, .753, .704, .657};
constexpr std::array t2_full{1.000, 1.000, .977, .951, .847, .813, .746, .717, .659, .604};
constexpr std::array t2_empty{.348, .627, .764, .863, .926, .957, .969, .969, .969, .969};

// Table 3, curve, m = 0 to 8.
constexpr std::array mp_mae{20.18, 17.85, 12.69, 11.11, 9.91, 8.63, 7.19, 5.87, 4.62};
constexpr std::array mp_overall{.671, .671, .671, .698, .748, .771, .834, .897, .967};
constexpr std::array mp_full{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, .995};
constexpr std::array mp_empty{.010, .010, .010, .090, .240, .310, .500, .690, .910};

// Table 4, curve, thresholds 0.990 to 1.000.
constexpr std::array bu_mae{13.58, 13.69, 13.51, 12.61, 12.65, 12.13, 12.24, 11.34, 11.02, 10.23, 16.54};
constexpr std::array bu_overall{.694, .691, .701, .714, .718, .721, .718, .721, .718, .734, .508};
constexpr std::array bu_full{.846, .841, .841, .841, .836, .831, .821, .796, .776, .761, .313};
constexpr std::array bu_empty{.390, .390, .420, .460, .480, .500, .510, .570, .600, .680, .900};

// Table 5, room (a), n_t = 1 to 8, all points.
constexpr std::array all_mae{6.63, 2.82, 2.44, 2.34, 2.29, 2.36, 2.46, 1.77};
constexpr std::array all_overall{.517, .427, .395, .368, .329, .297, .272, .244};
constexpr std::array all_full{.443, .334, .296, .262, .216, .179, .149, .117};
constexpr std::array all_empty{.957, .981, .981, .994, .994, .994, 1.0, 1.0};

// Table 6, room (a), n_t = 1 to 8, edge-like points.
constexpr std::array edge_mae{9.68, 1.59, 1.02, 1.09, 1.04, 1.06, 1.00, .73};
constexpr std::array edge_overall{.382, .261, .238, .219, .191, .176, .161, .155};
constexpr std::array edge_full{.283, .139, .111, .088, .056, .038, .019, .013};
constexpr std::array edge_empty{.963, .988, .988, .994, .994, .994, 1.0, 1.0};

PublishedSweep sweep(std::string id, std::string title, std::string_view source, std::string_view scene,
                     std::string_view method, std::string_view option) {
  return {.id = std::move(id),
          .title = std::move(title),
          .source = std::string(source),
          .scene = std::string(scene),
          .method = std::string(method),
          .fixed = {},
          .option = std::string(option),
          .values = {}};
}

void add_thresholds(std::vector<PublishedSweep>& all) {
  PublishedSweep vt = sweep("T2-vt", "VT, room (a)", "[Barshan07] Table 2", room_a, "vt", "threshold");
  vt.values = whole_numbers(1, 10, {vt_mae, t2_overall, t2_full, t2_empty});
  PublishedSweep dm = sweep("T2-dm", "DM, room (a)", "[Barshan07] Table 2", room_a, "dm", "threshold");
  dm.values = whole_numbers(1, 10, {dm_mae, t2_overall, t2_full, t2_empty});
  PublishedSweep mp = sweep("T3-mp", "MP, curve", "[Barshan07] Table 3", curve, "mp", "neighbours");
  mp.values = whole_numbers(0, 8, {mp_mae, mp_overall, mp_full, mp_empty});
  PublishedSweep bu = sweep("T4-bu", "BU, curve", "[Barshan07] Table 4", curve, "bu", "threshold");
  const Printed printed{bu_mae, bu_overall, bu_full, bu_empty};
  for (int k = 0; k <= 10; ++k) {
    const double threshold = k == 10 ? 0.9995 : double(990 + k) / 1000.0;
    bu.values.push_back(with_printed(threshold, fixed(double(990 + k) / 1000.0, 3), printed, std::size_t(k)));
  }
  for (PublishedSweep* made : {&vt, &dm, &mp, &bu}) all.push_back(std::move(*made));
}

void add_triangulations(std::vector<PublishedSweep>& all) {
  for (const bool edges : {false, true})
    for (const int columns : {20, 10}) {
      const std::string table = edges ? "T6" : "T5";
      const std::string window = columns == 20 ? "" : ", window of 10 columns";
      PublishedSweep tbf =
          sweep(table + "-tbf" + (columns == 20 ? "" : "-10"),
                std::string("TBF, ") + (edges ? "edge-like points" : "all points") + ", room (a)" + window,
                edges ? "[Barshan07] Table 6" : "[Barshan07] Table 5", room_a, "tbf", "threshold");
      tbf.fixed = {{"show", std::string(edges ? "edges" : "all")},
                   {"rows", std::int64_t{3}},
                   {"columns", std::int64_t{columns}},
                   {"column_m", 0.025}};
      Printed printed;
      if (columns == 20)
        printed = edges ? Printed{edge_mae, edge_overall, edge_full, edge_empty}
                        : Printed{all_mae, all_overall, all_full, all_empty};
      tbf.values = whole_numbers(1, 8, printed);
      all.push_back(std::move(tbf));
    }
}

void add_angles(std::vector<PublishedSweep>& all) {
  struct Figure {
    std::string_view name;
    std::string_view source;
    std::string_view scene;
    std::string_view title;
  };
  constexpr std::array figures{Figure{"F13", "[Barshan07] Fig. 13", curve, "curve"},
                               Figure{"F14", "[Barshan07] Fig. 14", room_a, "room (a)"},
                               Figure{"F15", "[Barshan07] Fig. 15", room_c, "room (c)"}};
  for (const Figure& figure : figures)
    for (const std::string_view method : {"atm_org", "atm_mod"}) {
      PublishedSweep atm = sweep(std::string(figure.name) + "-" + std::string(method),
                                 (method == "atm_org" ? "ATM-org, " : "ATM-mod, ") + std::string(figure.title),
                                 figure.source, figure.scene, method, "theta_t_deg");
      atm.fixed = {{"history", std::string("all")}};  // the paper works on the whole map of arcs
      for (int degree = 0; degree <= 90; ++degree)
        atm.values.push_back({.value = double(degree), .label = std::to_string(degree)});
      all.push_back(std::move(atm));
    }
}

}  // namespace

std::vector<PublishedSweep> published_sweeps() {
  std::vector<PublishedSweep> all;
  add_thresholds(all);
  add_triangulations(all);
  add_angles(all);
  return all;
}

}  // namespace echoarc::studies
