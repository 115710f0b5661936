// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "live/formulas.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "echoarc/mapping/inverse_sonar_model.hpp"
#include "live/replay.hpp"

namespace echoarc::live {
namespace {

// Trees are written as the JSON that viewers get; see `Formula` of the schema.

std::string num(double value, std::string_view unit = "") {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  const std::string said = unit.empty() ? "" : ",\"" + std::string(unit) + "\"";
  return "[\"num\"," + std::string(text.data(), end) + said + "]";
}
std::string sym(std::string_view text) {
  return "[\"sym\",\"" + std::string(text) + "\"]";
}
std::string val(std::string_view term) {
  return "[\"val\",\"" + std::string(term) + "\"]";
}
std::string node(std::string_view operation, std::initializer_list<std::string> parts) {
  std::string text = "[\"" + std::string(operation) + "\"";
  for (const std::string& part : parts) text += "," + part;
  return text + "]";
}
/// exp(-x^2 / 2)
std::string bell(const std::string& x) {
  return node("exp", {node("neg", {node("frac", {node("pow", {x, num(2)}), num(2)})})});
}
std::string odds_of(std::string_view term) {
  return node("ln", {node("frac", {val(term), node("sub", {num(1), val(term)})})});
}

double term_of(const CellChange& cell, std::string_view name) {
  const auto found = std::ranges::find(cell.terms, name, &Term::name);
  return found != cell.terms.end() ? found->value : 0.0;
}

FormulaLine added_line(std::string_view term) {
  return {"Added to what the cell held", node("eq", {sym("after"), node("add", {val("before"), val(term)})}), "after"};
}

BeamProfile profile_of(const OptionMap& options) {
  const auto found = options.find("profile");
  const auto* text = found != options.end() ? std::get_if<std::string>(&found->second) : nullptr;
  if (text != nullptr && *text == "uniform") return BeamProfile::uniform;
  if (text != nullptr && *text == "parabolic") return BeamProfile::parabolic;
  return BeamProfile::gaussian;
}

InverseSonarModel model_of(const OptionMap& options, const Reading& reading) {
  const bool confidence = [&] {
    const auto found = options.find("range_confidence");
    return found != options.end() && found->second == OptionValue(true);
  }();
  const double range_m = echo_range_m(reading.outcome).value_or(std::min(reading.trusted_range_m, reading.range_max_m));
  const double amplitude = confidence ? std::max(0.0, 1.0 - range_m / reading.range_max_m) : 1.0;
  return {.profile = profile_of(options),
          .half_width = 0.5 * reading.beam_width,
          .angular_sigma = number_option(options, "angular_sigma", 0.5),
          .range_sigma_m = number_option(options, "range_sigma_m", 0.02),
          .occupied_peak = 0.5 + amplitude * (number_option(options, "occupied_peak", 0.85) - 0.5),
          .free_floor = 0.5 - amplitude * (0.5 - number_option(options, "free_floor", 0.25))};
}

FormulaLine profile_line(const InverseSonarModel& model) {
  const double half_deg = model.half_width.deg();
  std::string factor = num(1);
  if (model.profile == BeamProfile::gaussian)
    factor = bell(node("frac", {val("theta"), num(model.angular_sigma * half_deg, "deg")}));
  if (model.profile == BeamProfile::parabolic)
    factor = node("sub", {num(1), node("pow", {node("frac", {val("theta"), num(half_deg, "deg")}), num(2)})});
  return {"How much the beam counts at this bearing", node("eq", {sym("a(θ)"), factor}), "angular_factor"};
}

/// The evidence grid: the model's two parts, and what they are worth in log-odds.
std::vector<FormulaLine> evidence_lines(const OptionMap& options, const Reading& reading,
                                        std::vector<CellChange>& cells) {
  const InverseSonarModel model = model_of(options, reading);
  const auto range_m = echo_range_m(reading.outcome);
  std::vector<FormulaLine> lines{profile_line(model)};
  for (CellChange& cell : cells) {
    const Angle theta = degrees(term_of(cell, "theta"));
    const double behind_m = term_of(cell, "sigma") - range_m.value_or(0.0);
    if (range_m && behind_m >= -band_sigmas * model.range_sigma_m)
      cell.terms.push_back({"p_band", model.band_probability(behind_m, theta)});
    else
      cell.terms.push_back({"p_free", model.free_probability(theta)});
  }
  if (range_m) {
    const std::string depth =
        bell(node("frac", {node("sub", {val("sigma"), num(*range_m, "m")}), num(model.range_sigma_m, "m")}));
    lines.push_back({"In the band around the echo: likely occupied",
                     node("eq", {sym("p"), node("add", {num(0.5), node("mul", {num(model.occupied_peak - 0.5),
                                                                               val("angular_factor"), depth})})}),
                     "p_band"});
  }
  lines.push_back(
      {"Before the echo: likely free",
       node("eq",
            {sym("p"), node("sub", {num(0.5), node("mul", {num(0.5 - model.free_floor), val("angular_factor")})})}),
       "p_free"});
  if (range_m)
    lines.push_back(
        {"In log-odds, rounded to steps of 1/4096", node("eq", {sym("Δℓ"), odds_of("p")}), "log_odds_added"});
  else
    lines.push_back(
        {"In log-odds; silence counts less than an echo",
         node("eq", {sym("Δℓ"), node("mul", {num(number_option(options, "no_echo_weight", 0.5)), odds_of("p_free")})}),
         "log_odds_added"});
  lines.push_back(added_line("log_odds_added"));
  return lines;
}

std::vector<FormulaLine> numakura_lines(const OptionMap& options) {
  const auto step = [&](std::string_view option, double otherwise) {
    return node("mul", {val("I"), val("u"), num(number_option(options, option, otherwise))});
  };
  return {{"Before the echo: free evidence", node("eq", {sym("C_f"), step("free_step", 1.0)}), "C_f"},
          {"On the arc: obstacle evidence", node("eq", {sym("C_o"), step("obstacle_step", 3.0)}), "C_o"}};
}

}  // namespace

std::vector<FormulaLine> formulas_of(std::string_view method, const OptionMap& options, const Reading& reading,
                                     std::vector<CellChange>& cells) {
  std::vector<FormulaLine> lines;
  if (method == "evidence" || method == "limited") lines = evidence_lines(options, reading, cells);
  if (method == "numakura") lines = numakura_lines(options);
  if (method == "bu")
    lines = {
        {"Empty: by range and by bearing", node("eq", {sym("p_E"), node("mul", {val("E_r"), val("E_a")})}), "p_E"},
        {"Occupied: by range and by bearing", node("eq", {sym("p_O"), node("mul", {val("O_r"), val("O_a")})}), "p_O"}};
  if (method == "carved_grid" || method == "consensus_evidence")
    lines = {{"In log-odds", node("eq", {sym("Δℓ"), odds_of("p")}), "log_odds_added"}, added_line("log_odds_added")};
  if (method == "vt" || method == "dm" || method == "mp")
    lines = {
        {"One more arc through the cell", node("eq", {sym("after"), node("add", {val("before"), num(1)})}), "after"}};
  for (CellChange& cell : cells) {
    cell.terms.push_back({"before", cell.before});
    cell.terms.push_back({"after", cell.after});
  }
  return lines;
}

}  // namespace echoarc::live
