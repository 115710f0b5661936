// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/contestant.hpp"
#include "echoarc/mapping/evidence_grid.hpp"

namespace echoarc::bench {
namespace {

EvidenceGrid make_grid(double cell_m, const std::string& profile) {
  return EvidenceGrid(make_options<EvidenceGridOptions>({{"cell_m", cell_m}, {"profile", profile}}).value());
}

class Evidence final : public Contestant {
 public:
  Evidence(double cell_m, const std::string& profile)
      : cell_m_(cell_m), profile_(profile), grid_(make_grid(cell_m, profile)) {}

  std::string name() const override { return "evidence_" + profile_; }
  void prepare(std::span<const Reading> readings) override { readings_ = readings; }
  void insert() override { grid_.insert(readings_, executor_); }

  double cells_per_reading(std::span<const Reading> readings) const override {
    const EvidenceGrid empty = make_grid(cell_m_, profile_);
    double cells = 0.0;
    for (const Reading& reading : readings) cells += double(empty.trace(reading).cells.size());
    return cells / double(readings.size());
  }

 private:
  double cell_m_;
  std::string profile_;
  EvidenceGrid grid_;
  InlineExecutor executor_;
  std::span<const Reading> readings_;
};

}  // namespace

std::unique_ptr<Contestant> make_evidence(double cell_m, const std::string& profile) {
  return std::make_unique<Evidence>(cell_m, profile);
}

}  // namespace echoarc::bench
