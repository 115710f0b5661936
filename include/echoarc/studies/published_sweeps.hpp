// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <limits>
#include <string>
#include <vector>

#include "echoarc/core/options.hpp"

namespace echoarc::studies {

/// One value of a parameter and what the paper printed for it; NaN where it printed nothing.
struct PublishedValue {
  OptionValue value;  ///< of the method's option
  std::string label;  ///< as the paper writes it
  double mae_cm = std::numeric_limits<double>::quiet_NaN();
  double cdr_overall = std::numeric_limits<double>::quiet_NaN();
  double cdr_full = std::numeric_limits<double>::quiet_NaN();
  double cdr_empty = std::numeric_limits<double>::quiet_NaN();
};

/// A parameter of a method that a paper varied, on one of its scenes.
struct PublishedSweep {
  std::string id;      ///< "T2-vt", "F13-atm_org"
  std::string title;   ///< for people
  std::string source;  ///< "[Barshan07] Table 2"
  std::string scene;   ///< name of the scene: "room-a"
  std::string method;  ///< of the catalogue
  OptionMap fixed;     ///< options that the paper set beside
  std::string option;  ///< the one that varies
  std::vector<PublishedValue> values;
};

/// Every sweep of [Barshan07] 4: VT and DM thresholds 1 to 10 (Table 2), MP 0 to 8 (Table 3), BU thresholds 0.990 to
/// 1.000 (Table 4), TBF 1 to 8 with all and with edge-like points (Tables 5 and 6; windows of 10 columns, without
/// printed figures, beside the paper's 20), ATM theta_t 0 to 90 degrees in steps of one (Figs. 13 to 15).
///
/// BU at 1.000 counts a cell as full when 1 - P < 5e-4, as three printed decimals do: threshold 0.9995.
[[nodiscard]] std::vector<PublishedSweep> published_sweeps();

}  // namespace echoarc::studies
