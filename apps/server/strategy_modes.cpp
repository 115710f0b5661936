// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/strategy_modes.hpp"

#include <array>
#include <string>
#include <utility>

namespace echoarc::server {
namespace {

constexpr std::array<std::string_view, 6> modes{"frontier", "gvg", "wall-left", "wall-right", "goto", home_mode};

/// A strategy under the name of its mode: one strategy may serve several.
class Named final : public nav::Strategy {
 public:
  Named(std::string_view name, std::unique_ptr<nav::Strategy> strategy) : name_(name), strategy_(std::move(strategy)) {}

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] nav::Steering update(const nav::Surroundings& now) override { return strategy_->update(now); }
  [[nodiscard]] nav::Sketch sketch() const override { return strategy_->sketch(); }

 private:
  std::string name_;
  std::unique_ptr<nav::Strategy> strategy_;
};

}  // namespace

std::span<const std::string_view> strategy_modes() {
  return modes;
}

Result<std::unique_ptr<nav::Strategy>> make_mode(std::string_view mode, const nav::StrategySettings& settings) {
  Result<std::unique_ptr<nav::Strategy>> strategy = nav::make_strategy(mode == home_mode ? "goto" : mode, settings);
  if (!strategy) return strategy.error();
  return std::unique_ptr<nav::Strategy>(std::make_unique<Named>(mode, std::move(*strategy)));
}

}  // namespace echoarc::server
