// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/studies/experiment.hpp"

/// The seven techniques of [Barshan07] as it used them, and what it printed of them.
namespace echoarc::studies::barshan {

/// One of the paper's set-ups.
enum class Place : std::uint8_t { curve, room_a, room_c, corner };

[[nodiscard]] std::string_view scene_name(Place place);   ///< "room-a"
[[nodiscard]] std::string_view title_of(Place place);     ///< "room (a)"
[[nodiscard]] std::string_view table_of(Place place);     ///< "Table 7"
[[nodiscard]] std::string_view table_id_of(Place place);  ///< "S2-T7"

/// Techniques; an order of rows, no ranking.
enum class Technique : std::uint8_t { pm, vt, dm, mp, bu, atm_org, atm_mod, tbf };
inline constexpr std::size_t technique_count = 8;
[[nodiscard]] std::string_view name_of(Technique technique);  ///< "ATM-org"

/// A technique with its parameter set: threshold of VT, DM, BU, m of MP, n_t of TBF, theta_t in degrees of the ATMs.
[[nodiscard]] MethodSpec spec_of(Technique technique, Place place, double parameter);
/// "VT, threshold 4", "MP, m = 7".
[[nodiscard]] std::string label_of(Technique technique, double parameter);

/// A row of Tables 1, 7, 8; NaN in t where nothing was printed.
struct PrintedRow {
  Technique technique;
  double parameter;  ///< 0 for PM
  double mae_cm;
  double cdr_overall;
  double cdr_full;
  double cdr_empty;
  double cpu_s;
};
[[nodiscard]] std::vector<PrintedRow> printed_rows(Place place);

/// The row that stands for a technique in rankings: the parameter of the paper's figures (3, 11, 12).
[[nodiscard]] std::size_t ranked_row(Place place, Technique technique);

}  // namespace echoarc::studies::barshan
