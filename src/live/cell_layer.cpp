// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/cell_layer.hpp"

#include <algorithm>
#include <array>

#include "echoarc/mapping/catalog.hpp"
#include "echoarc/mapping/inverse_sonar_model.hpp"

namespace echoarc::live {
namespace {

struct KnownLayer {
  std::string_view method;
  CellMeaning meaning;
  std::string_view unit;
};

constexpr std::array known_layers{
    KnownLayer{"vt", CellMeaning::state, "arcs"},
    KnownLayer{"dm", CellMeaning::state, "arcs"},
    KnownLayer{"mp", CellMeaning::state, "arcs"},
    KnownLayer{"bu", CellMeaning::probability, "p"},
    KnownLayer{"evidence", CellMeaning::log_odds, "log-odds"},
    KnownLayer{"himm", CellMeaning::state, "certainty"},
    KnownLayer{"numakura", CellMeaning::accumulation, "evidence"},
    KnownLayer{"limited", CellMeaning::log_odds, "log-odds"},
    KnownLayer{"carved_grid", CellMeaning::log_odds, "log-odds"},
    KnownLayer{"consensus_evidence", CellMeaning::log_odds, "log-odds"},
};

const KnownLayer* known_layer(std::string_view method) {
  const auto* found = std::ranges::find(known_layers, method, &KnownLayer::method);
  return found != known_layers.end() ? found : nullptr;
}

/// The value of a real option; of one that is not given its default.
std::optional<double> real_option(const MethodEntry& entry, const OptionMap& options, std::string_view name) {
  const auto number = [](const OptionValue& value) -> std::optional<double> {
    if (const auto* real = std::get_if<double>(&value)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return double(*whole);
    return std::nullopt;
  };
  if (const auto given = options.find(name); given != options.end()) return number(given->second);
  for (const OptionSpec& spec : entry.specs())
    if (spec.name == name) return number(spec.default_value);
  return std::nullopt;
}

constexpr double free_probability = 0.05;

}  // namespace

CellLayer cell_layer_of(std::string_view method, const OptionMap& options) {
  CellLayer layer;
  if (const KnownLayer* known = known_layer(method)) {
    layer.meaning = known->meaning;
    layer.unit = known->unit;
  }
  const MethodEntry* entry = find_method(method);
  if (entry == nullptr) return layer;
  const auto cell_m = real_option(*entry, options, "cell_m");
  if (cell_m && *cell_m > 0.0)
    layer.geometry = GridGeometry{*cell_m,
                                  {real_option(*entry, options, "origin_x_m").value_or(0.0),
                                   real_option(*entry, options, "origin_y_m").value_or(0.0)}};
  return layer;
}

bool has_cells(const MapExport& map) {
  return !std::holds_alternative<std::monostate>(map.values);
}

PingId own_ping(const PointMap& map, const MapPoint& point) {
  const std::span<const PingId> support = map.support(point);
  return support.empty() ? point.ping : support.front();
}

bool is_point_method(std::string_view method) {
  return known_layer(method) == nullptr;
}

std::optional<double> probability_of(CellMeaning meaning, double value, CellState state) {
  switch (meaning) {
    case CellMeaning::state:
      if (state == CellState::unknown) return std::nullopt;
      return state == CellState::occupied ? 1.0 : free_probability;
    case CellMeaning::probability: return value == 0.5 ? std::nullopt : std::optional(value);
    case CellMeaning::log_odds: return value == 0.0 ? std::nullopt : std::optional(probability(value));
    case CellMeaning::accumulation: return value == 0.0 ? std::nullopt : std::optional(probability(-value));
  }
  return std::nullopt;
}

}  // namespace echoarc::live
