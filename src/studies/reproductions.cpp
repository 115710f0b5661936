// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/reproductions.hpp"

#include <array>

#include "echoarc/studies/barshan2007.hpp"
#include "echoarc/studies/choset2003.hpp"
#include "echoarc/studies/numakura.hpp"
#include "echoarc/studies/silver2004.hpp"
#include "echoarc/studies/yamauchi.hpp"

namespace echoarc::studies {

std::span<const Reproduction> reproductions() {
  static constexpr std::array all{
      Reproduction{"barshan2007", "seven techniques on a curve, two rooms and three corners", &barshan2007},
      Reproduction{"silver2004", "arc carving: latency and azimuth on an office floor, a junction, a hallway",
                   &silver2004},
      Reproduction{"choset2003", "arc-transversal medians: openings, a T world, regions of constant depth",
                   &choset2003},
      Reproduction{"numakura", "two tests for outliers, four maps of a room", &numakura},
      Reproduction{"yamauchi", "laser-limited sonar in an alcove", &yamauchi}};
  return all;
}

const Reproduction* find_reproduction(std::string_view name) {
  for (const Reproduction& reproduction : reproductions())
    if (reproduction.name == name) return &reproduction;
  return nullptr;
}

}  // namespace echoarc::studies
