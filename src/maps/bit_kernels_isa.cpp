// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name. Every bit of a word is one cell: a sum of eight
// neighbours is four words, its binary digits, added up by the gates of an adder.

#include "maps/bit_kernels.hpp"

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

using Word = std::uint64_t;

inline Word from_west(Word west, Word here) {
  return here << 1 | west >> 63;
}
inline Word from_east(Word here, Word east) {
  return here >> 1 | east << 63;
}

/// Sum and carry of three bits.
struct Added {
  Word sum;
  Word carry;
};
inline Added add(Word a, Word b, Word c) {
  const Word ab = a ^ b;
  return {ab ^ c, (a & b) | (ab & c)};
}

}  // namespace

void thin(const BitRows& rows, std::size_t count, int neighbours, std::uint64_t* __restrict out) {
  const BitRows r = rows;
  Word wanted[4];  // the digits of `neighbours`, each in all bits
  for (int digit = 0; digit < 4; ++digit) wanted[digit] = (neighbours >> digit & 1) != 0 ? ~Word{0} : Word{0};
  const Word w0 = wanted[0];
  const Word w1 = wanted[1];
  const Word w2 = wanted[2];
  const Word w3 = wanted[3];
  const Word* const here_below = r.here - r.row;
  const Word* const here_above = r.here + r.row;
  const Word* const west_below = r.west - r.row;
  const Word* const west_above = r.west + r.row;
  const Word* const east_below = r.east - r.row;
  const Word* const east_above = r.east + r.row;
  for (std::size_t n = 0; n < count; ++n) {
    const Word below = here_below[n];
    const Word here = r.here[n];
    const Word above = here_above[n];
    const Added a = add(from_west(west_below[n], below), below, from_east(below, east_below[n]));
    const Added b = add(from_west(west_above[n], above), above, from_east(above, east_above[n]));
    const Word west = from_west(r.west[n], here);
    const Word east = from_east(here, r.east[n]);
    const Added ones = add(a.sum, b.sum, west ^ east);
    const Added twos = add(a.carry, b.carry, west & east);
    const Word digit0 = ones.sum;
    const Word digit1 = twos.sum ^ ones.carry;
    const Word fours = twos.sum & ones.carry;
    const Word digit2 = twos.carry ^ fours;
    const Word digit3 = twos.carry & fours;
    // Fewer than wanted, decided by the highest digit that differs.
    Word fewer = ~digit0 & w0;
    fewer = (~digit1 & w1) | (~(digit1 ^ w1) & fewer);
    fewer = (~digit2 & w2) | (~(digit2 ^ w2) & fewer);
    fewer = (~digit3 & w3) | (~(digit3 ^ w3) & fewer);
    out[n] = here & ~fewer;
  }
}

void dilate(const BitRows& rows, std::size_t count, std::uint64_t* __restrict out) {
  const BitRows r = rows;
  for (std::size_t n = 0; n < count; ++n) {
    const Word west = (r.west - r.row)[n] | r.west[n] | (r.west + r.row)[n];
    const Word here = (r.here - r.row)[n] | r.here[n] | (r.here + r.row)[n];
    const Word east = (r.east - r.row)[n] | r.east[n] | (r.east + r.row)[n];
    out[n] = from_west(west, here) | here | from_east(here, east);
  }
}

}  // namespace echoarc::kernels::ECHOARC_ISA
