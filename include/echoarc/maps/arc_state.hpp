// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>

#include "echoarc/maps/arc_history.hpp"

namespace echoarc {

/// What has become of an arc in a method's history so far.
struct ArcState {
  Arc arc;  ///< its limits hold what carving left of it
  ArcSource source;
  bool crossed = false;  ///< has a transversal crossing with another arc
  bool carved = false;   ///< lost a part to newer readings, and lives
  bool removed = false;  ///< carving removed it: nothing, or more than one piece, was left

  /// Whether the method has worked on it ([Silver04] 5.B): a median, a carved end, or either.
  [[nodiscard]] bool processed() const { return crossed || carved; }
  /// theta_d ([Silver04] eq. 5.1).
  [[nodiscard]] Angle angular_length() const { return arc.t_end() - arc.t_begin(); }
};

/// Shown one arc; the reference is good for the call alone.
using ArcVisitor = std::function<void(const ArcState&)>;

}  // namespace echoarc
