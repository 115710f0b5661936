// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "mapping/consensus/arc_table.hpp"

namespace echoarc::consensus {

/// What to assume of the beams of these arcs: as the options say, or twice or four times as wide, if their clear echoes
/// come from farther off the axis than so narrow a beam explains. Cheap sensors state a narrow beam and hear from far
/// beside it.
///
/// Pilots weigh some of the first `sweeps * history` arcs in one sweep, with sigma as it is, and with twice as much.
/// Given twice the room, the bearings of clear echoes spread to less than twice as far where the beam is what it is
/// said to be: the neighbours know better. Where it is not, the true bearings were out of reach, and they spread to
/// three times as far and more.
[[nodiscard]] BeamPrior heard_beams(const ArcTable& arcs, const ConsensusOptions& options);

}  // namespace echoarc::consensus
