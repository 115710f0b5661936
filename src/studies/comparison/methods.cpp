// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <utility>

#include "echoarc/mapping/catalog.hpp"
#include "echoarc/mapping/consensus_options.hpp"
#include "echoarc/studies/comparison.hpp"

namespace echoarc::studies {
namespace {

// Ranges are rounded to centimetres, and the cut keeps what is just as far: "below 3 m" ends before 3.00 m.
constexpr double near_m = 2.9995;

void add_near(std::vector<ComparedMethod>& methods, ComparedMethod method) {
  methods.push_back(method);
  method.label += " < 3 m";
  method.range_cut_m = near_m;
  methods.push_back(std::move(method));
}

}  // namespace

std::vector<ComparedMethod> compared_methods() {
  std::vector<ComparedMethod> methods;
  for (const MethodEntry& entry : catalog()) {
    const std::string name(entry.name);
    if (name == "consensus") {
      for (const Choice<ConsensusMode>& mode : choices(ConsensusMode{}))
        methods.push_back({name + " " + std::string(mode.name), name, {{"mode", std::string(mode.name)}}});
      continue;
    }
    add_near(methods, {name, name, {}});
    if (name == "atm_mod") add_near(methods, {name + " 5°", name, {{"theta_t_deg", 5.0}}});
  }
  return methods;
}

std::optional<std::size_t> Comparison::find(std::string_view label) const {
  const auto found = std::ranges::find(methods, label, &ComparedMethod::label);
  return found == methods.end() ? std::nullopt : std::optional(std::size_t(found - methods.begin()));
}

}  // namespace echoarc::studies
