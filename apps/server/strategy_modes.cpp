// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/strategy_modes.hpp"

#include <array>
#include <utility>

namespace echoarc::server {
namespace {

constexpr std::array<std::string_view, 6> modes{"frontier", "gvg", "wall-left", "wall-right", "goto", home_mode};

/// Goes to a point, under another name.
class WayHome final : public nav::Strategy {
 public:
  explicit WayHome(std::unique_ptr<nav::Strategy> way) : way_(std::move(way)) {}

  [[nodiscard]] std::string_view name() const override { return home_mode; }
  [[nodiscard]] nav::Steering update(const nav::Surroundings& now) override { return way_->update(now); }
  [[nodiscard]] nav::Sketch sketch() const override { return way_->sketch(); }

 private:
  std::unique_ptr<nav::Strategy> way_;
};

}  // namespace

std::span<const std::string_view> strategy_modes() {
  return modes;
}

Result<std::unique_ptr<nav::Strategy>> make_mode(std::string_view mode, const nav::StrategySettings& settings) {
  if (mode != home_mode) return nav::make_strategy(mode, settings);
  Result<std::unique_ptr<nav::Strategy>> way = nav::make_strategy("goto", settings);
  if (!way) return way.error();
  return std::make_unique<WayHome>(std::move(*way));
}

}  // namespace echoarc::server
