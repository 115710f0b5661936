// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "echoarc/sensing/sensing_options.hpp"
#include "echoarc/studies/experiment.hpp"
#include "echoarc/studies/sweep.hpp"

namespace echoarc::studies {

/// What has to be done anew when an option takes another value.
enum class SweepStage : std::uint8_t { drive, sensing, mapping };
[[nodiscard]] SweepStage stage_of(const SweepAxis& axis);

/// All combinations of the values of one stage's axes, counted through with the last axis fastest.
class Combinations {
 public:
  Combinations(std::span<const SweepAxis> axes, SweepStage stage);
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Writes the place of every value of combination `index` into the places of its axes; leaves those of others.
  void write(std::size_t index, std::span<std::size_t> places) const;

 private:
  std::vector<std::size_t> axes_;
  std::vector<std::size_t> sizes_;
  std::size_t count_ = 1;
};

/// The index of a combination of all axes' values, the last axis fastest.
[[nodiscard]] std::size_t combination_index(std::span<const SweepAxis> axes, std::span<const std::size_t> places);

/// The options that a combination sets, by what they belong to.
[[nodiscard]] Result<StudyScene> scene_of(const StudyScene& scene, std::span<const SweepAxis> axes,
                                          std::span<const std::size_t> places);
[[nodiscard]] Result<SensingOptions> sensing_of(std::span<const SweepAxis> axes, std::span<const std::size_t> places);
[[nodiscard]] MethodSpec method_of(const std::string& method, std::span<const SweepAxis> axes,
                                   std::span<const std::size_t> places);

/// Whether a request can be meant; see `run_sweep`.
[[nodiscard]] Result<void> check(const SweepRequest& request, std::size_t seeds);

}  // namespace echoarc::studies
