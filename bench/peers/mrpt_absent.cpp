// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/peers/mrpt_grid.hpp"

namespace echoarc::bench {

std::unique_ptr<Contestant> make_mrpt(double) {
  return nullptr;
}

}  // namespace echoarc::bench
