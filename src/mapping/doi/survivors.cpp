// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/doi/survivors.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "mapping/doi/providers.hpp"

namespace echoarc::doi {
namespace {

constexpr std::int32_t support_reach_cells = 2;

WindowRule window_rule(const DirectionalMaximumOptions& options) {
  constexpr std::int32_t most_overlaps = 8;  // per direction: bounds the work of absurd strides
  const auto in_cells = [&](double length_m) {
    return std::max<std::int32_t>(1, std::int32_t(std::lround(length_m / options.cell_m)));
  };
  const std::int32_t size = in_cells(options.pca_window_m);
  const std::int32_t stride = std::max(in_cells(options.pca_stride_m), (size + most_overlaps - 1) / most_overlaps);
  return {size, stride, options.pca_max_ratio, options.pca_min_weight};
}

/// One run of the rule over a map: the providers with what they need to hand.
class Run {
 public:
  Run(const VoteGrid::Counts& counts, const DoiHistory& history, const DirectionalMaximumOptions& options)
      : counts_(counts), history_(history), options_(options), processor_(options) {}

  [[nodiscard]] std::vector<Cell> survivors() {
    const DirectionOfInterest doi = resolved();
    std::vector<Cell> cells;
    if (doi == DirectionOfInterest::polar) {
      cells = from_vantage_points();
    } else {
      visit_lines(doi, processor_.visitor());
      cells = processor_.take();
    }
    if (options_.unvisited == UnvisitedRule::keep) {
      for (const LineCell& c : cells_at_threshold(counts_, options_.threshold))
        if (!processor_.visited(c.cell)) cells.push_back(c.cell);
      make_unique(cells);
    }
    return cells;
  }

 private:
  [[nodiscard]] DirectionOfInterest resolved() const {
    if (options_.doi != DirectionOfInterest::automatic) return options_.doi;
    return history_.has_wall_labels() ? DirectionOfInterest::followed_wall : DirectionOfInterest::pca;
  }

  void visit_lines(DirectionOfInterest doi, const LineVisitor& visit) {
    switch (doi) {
      case DirectionOfInterest::axis:
        // Lines are counted from the centre of cell (0, 0), so that an axis of the grid gives rows or columns.
        return axis_lines(cells_at_threshold(counts_, options_.threshold), {0.5, 0.5}, unit(options_.axis), visit);
      case DirectionOfInterest::los: {
        RayLines rays(counts_, options_.threshold);
        return sight_lines(rays, history_.sights(), visit);
      }
      case DirectionOfInterest::path_normal: {
        RayLines rays(counts_, options_.threshold);
        return across_path(rays, named_sides(history_.stops()), true, visit);
      }
      case DirectionOfInterest::followed_wall: {
        RayLines rays(counts_, options_.threshold);
        return towards_followed_wall(rays, visit);
      }
      case DirectionOfInterest::pca:
      case DirectionOfInterest::polar:
      case DirectionOfInterest::automatic: return across_spread(visit);
    }
  }

  void across_path(RayLines& rays, const std::vector<WallSide>& sides, bool both_if_unknown, const LineVisitor& visit) {
    path_lines(rays, history_, sides, both_if_unknown, options_.cell_m, options_.tangent_window_m, visit);
  }

  void towards_followed_wall(RayLines& rays, const LineVisitor& visit) {
    across_path(rays, followed_sides(history_.stops(), options_.wall_switch_stops), false, visit);
  }

  /// Windows with a clear direction by their spread; the cells of no such window along the way to the followed wall.
  void across_spread(const LineVisitor& visit) {
    const std::vector<LineCell> cells = cells_at_threshold(counts_, options_.threshold);
    const CellSet covered = window_lines(cells, counts_.geometry(), history_.sights(), window_rule(options_), visit);
    if (covered.size() == cells.size()) return;
    constexpr std::uint64_t fallback_lines = std::uint64_t{1} << 63;
    std::vector<LineCell> rest;
    std::ranges::copy_if(cells, std::back_inserter(rest), [&](const LineCell& c) { return !covered.contains(c.cell); });
    RayLines rays(counts_, options_.threshold, rest);
    towards_followed_wall(rays, [&](std::uint64_t line, std::span<const LineCell> on_line) {
      rest.clear();
      std::ranges::copy_if(on_line, std::back_inserter(rest),
                           [&](const LineCell& c) { return !covered.contains(c.cell); });
      visit(fallback_lines + line, rest);
    });
  }

  [[nodiscard]] std::vector<Cell> from_vantage_points() {
    std::vector<std::vector<Cell>> views;
    RayLines rays(counts_, options_.threshold);
    for (const Vec2 point : vantage_points(history_.path(), options_.polar_spacing_m)) {
      polar_lines(rays, point, options_.polar_step, history_.range_max_m(), processor_.visitor());
      views.push_back(processor_.take());
    }
    if (options_.polar_fusion == PolarFusion::support) return supported(views, support_reach_cells);
    std::vector<Cell> cells;
    for (const std::vector<Cell>& view : views) cells.insert(cells.end(), view.begin(), view.end());
    make_unique(cells);
    return cells;
  }

  const VoteGrid::Counts& counts_;
  const DoiHistory& history_;
  const DirectionalMaximumOptions& options_;
  LineProcessor processor_;
};

}  // namespace

std::vector<Cell> survivors(const VoteGrid::Counts& counts, const DoiHistory& history,
                            const DirectionalMaximumOptions& options) {
  return Run(counts, history, options).survivors();
}

std::vector<Cell> supported(std::span<const std::vector<Cell>> views, std::int32_t reach_cells) {
  std::unordered_map<Cell, std::vector<std::size_t>, CellHash> seen_from;
  for (std::size_t view = 0; view < views.size(); ++view)
    for (const Cell c : views[view]) seen_from[c].push_back(view);
  const auto has_support = [&](Cell c, std::size_t view) {
    for (std::int32_t dj = -reach_cells; dj <= reach_cells; ++dj)
      for (std::int32_t di = -reach_cells; di <= reach_cells; ++di)
        if (const auto found = seen_from.find({c.i + di, c.j + dj}); found != seen_from.end())
          if (std::ranges::any_of(found->second, [&](std::size_t other) { return other != view; })) return true;
    return false;
  };
  std::vector<Cell> cells;
  for (std::size_t view = 0; view < views.size(); ++view)
    for (const Cell c : views[view])
      if (has_support(c, view)) cells.push_back(c);
  make_unique(cells);
  return cells;
}

}  // namespace echoarc::doi
