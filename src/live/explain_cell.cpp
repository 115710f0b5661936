// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "live/explain_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "echoarc/live/cell_layer.hpp"
#include "live/replay.hpp"

namespace echoarc::live {
namespace {

constexpr std::size_t shown_changes = 200;

/// Methods in which a cell is changed by the readings that reach it and by nothing else: the others need not be
/// replayed to know it.
bool is_local(std::string_view method) {
  constexpr std::array local{"evidence", "limited", "vt", "dm", "mp", "bu"};
  return std::ranges::find(local, method) != local.end();
}

CellHistoryEntry::Where where_of(const Reading& reading, Vec2 centre, double cell_m) {
  using Where = CellHistoryEntry::Where;
  const Vec2 eye = 0.5 * (reading.T_world_tx.position + reading.T_world_rx.position);
  const Angle off_axis = wrap(bearing(centre - eye) - reading.T_world_rx.heading);
  if (reading.monostatic() && abs(off_axis) > 0.5 * reading.beam_width + eps_angle) return Where::beside;
  const auto range_m = echo_range_m(reading.outcome);
  if (!range_m) return Where::before;
  const double half_path_m =
      0.5 * (norm(centre - reading.T_world_tx.position) + norm(centre - reading.T_world_rx.position));
  if (std::abs(half_path_m - *range_m) <= std::max(cell_m, 0.04)) return Where::on;
  return half_path_m < *range_m ? Where::before : Where::beside;
}

/// The value of the newest export there, if it has that cell.
std::optional<double> exported_value(const MapExport* map, Vec2 centre) {
  if (map == nullptr || map->states.empty()) return std::nullopt;
  const Cell cell = map->states.geometry().cell_of(centre);
  if (!map->states.box().contains(cell)) return std::nullopt;
  if (const auto* grid = std::get_if<DenseGrid<float>>(&map->values)) return double(grid->at(cell));
  if (const auto* grid = std::get_if<DenseGrid<std::uint16_t>>(&map->values)) return double(grid->at(cell));
  return std::nullopt;
}

CellState exported_state(const MapExport* map, Vec2 centre) {
  if (map == nullptr || map->states.empty()) return CellState::unknown;
  const Cell cell = map->states.geometry().cell_of(centre);
  return map->states.box().contains(cell) ? map->states.at(cell) : CellState::unknown;
}

/// Every change of one cell, one reading after the other.
Result<void> follow_cell(const Evidence& evidence, const MethodChoice& choice, Vec2 centre, double cell_m,
                         CellHistory& history) {
  auto method = make_method(choice.name, choice.options);
  if (!method) return method.error();
  InlineExecutor executor;
  const bool local = is_local(choice.name);
  for (std::size_t k = 0; k < evidence.readings.size(); ++k) {
    const JudgedPing& judged = evidence.readings[k];
    if (!is_used(evidence, judged)) continue;
    const Reading& reading = judged.reading;
    const bool near = reaches(reading, centre, 0.1 + 2.0 * cell_m);
    if (!near && local) continue;
    if (near) {
      const Trace trace = method->trace(reading);
      const auto change = std::ranges::find(trace.cells, history.cell, &CellChange::cell);
      if (change != trace.cells.end())
        history.changes.push_back({judged, change->before, change->after, where_of(reading, centre, cell_m)});
    }
    method->insert(std::span(&reading, 1), executor);
  }
  // Elsewhere a cell moves between two readings, too: a scan is closed, an arc carved. What it held when the next
  // reading came is what the one before left.
  for (std::size_t k = 1; !local && k < history.changes.size(); ++k)
    history.changes[k - 1].after = history.changes[k].before;
  if (!local && !history.changes.empty()) {
    method->finish(executor);
    const auto map = method->export_map();
    if (!map) return map.error();
    history.changes.back().after = exported_value(&*map, centre).value_or(0.0);
  }
  return {};
}

}  // namespace

Result<CellHistory> cell_history(const Evidence& evidence, std::size_t place, Vec2 position) {
  const MethodChoice& choice = evidence.methods[place];
  const CellLayer layer = cell_layer_of(choice.name, choice.options);
  if (is_point_method(choice.name) || !layer.geometry)
    return Error{ErrorCode::bad_value, "method " + choice.key() + " has no cells", choice.key(),
                 "ask about one of its points"};
  CellHistory history;
  history.method = choice.key();
  history.unit = layer.unit;
  history.cell = layer.geometry->cell_of(position);
  const Vec2 centre = layer.geometry->centre(history.cell);
  const MapExport* map = place < evidence.maps.size() ? evidence.maps[place].get() : nullptr;
  // Of the consensus no reading's share stays as it was: all are weighed anew with each that comes.
  if (choice.name != "consensus_evidence")
    if (auto followed = follow_cell(evidence, choice, centre, layer.geometry->cell_m, history); !followed)
      return followed.error();
  history.total = history.changes.size();
  history.value = !history.changes.empty() ? history.changes.back().after : exported_value(map, centre).value_or(0.0);
  if (history.changes.size() > shown_changes)
    history.changes.erase(history.changes.begin(), history.changes.end() - std::ptrdiff_t(shown_changes));
  if (layer.meaning != CellMeaning::state)
    history.probability = probability_of(layer.meaning, history.value, exported_state(map, centre));
  return history;
}

Result<Explanation> explain_cell(const Evidence& evidence, std::string_view id, Vec2 position) {
  const auto place = place_of(evidence, id);
  if (!place) return place.error();
  auto history = cell_history(evidence, *place, position);
  if (!history) return history.error();
  const MethodChoice& choice = evidence.methods[*place];
  Explanation explanation;
  explanation.method = choice.key();
  explanation.searched = evidence.readings.size();
  explanation.position = cell_layer_of(choice.name, choice.options).geometry->centre(history->cell);
  explanation.label = name(PointLabel::cell);
  explanation.probability = history->probability;
  const auto raised = std::ranges::count_if(history->changes, [](const auto& c) { return c.after > c.before; });
  if (history->total > 0)
    explanation.sentence = std::to_string(history->total) + (history->total == 1 ? " ping" : " pings") +
                           " changed this cell; of the newest " + std::to_string(history->changes.size()) + ", " +
                           std::to_string(raised) + " raised its value and " +
                           std::to_string(history->changes.size() - std::size_t(raised)) + " lowered it or left it.";
  else if (choice.name == "consensus_evidence")
    explanation.sentence =
        "Every reading has all echoes near it weighed anew, so no ping's share of this cell is its own.";
  else
    explanation.sentence = "No ping has said anything about this cell.";
  explanation.cell = std::move(*history);
  return explanation;
}

}  // namespace echoarc::live
