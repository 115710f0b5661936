// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>
#include <tuple>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/mapping/vote_grid.hpp"
#include "echoarc/maps/tiled_bits.hpp"

namespace echoarc {

struct MorphologicalOptions {
  double cell_m = 0.01;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  ArcSampling sampling = ArcSampling::exact;
  int neighbours = 7;
  int passes = 1;

  static constexpr auto fields() {
    using O = MorphologicalOptions;
    return std::tuple_cat(
        grid_fields<O>(), arc_fields<O>(),
        std::tuple{field("sampling", &O::sampling,
                         {.doc = "cells of an arc: by steps of half a cell, or every cell it crosses",
                          .source = "[Barshan07] 3.2"}),
                   field("neighbours", &O::neighbours,
                         {.unit = "cells",
                          .min = 0,
                          .max = 8,
                          .doc = "thinning parameter m: a cell with fewer set neighbours is dropped; 0 keeps all, 1 "
                                 "prunes, 8 erodes",
                          .source = "[Barshan07] 3.4, 4.2: 8 for the curve, 7 for rooms, 4 for corners"}),
                   field("passes", &O::passes,
                         {.min = 1,
                          .max = 1000,
                          .doc = "how often the map is thinned",
                          .source = "[Barshan07] 4.2: once; more passes cost detections"})});
  }
};

/// What the method knows: the arc map, and what thinning has left of it.
struct MorphologicalMap {
  VoteGrid votes;
  TiledBits kept;
};

/// Morphological processing ([Barshan07] 3.4): a cell is set when at least one arc crosses it, and set cells with fewer
/// than `neighbours` set cells among their eight neighbours are dropped, all at once. Knows occupied and unknown cells,
/// no free ones; silence says nothing to it.
class MorphologicalProcessing {
 public:
  using Options = MorphologicalOptions;
  using Map = MorphologicalMap;
  static constexpr std::string_view name = "mp";

  explicit MorphologicalProcessing(Options options = {});

  [[nodiscard]] const Options& options() const { return options_; }
  void insert(std::span<const Reading> readings, Executor& executor);
  /// Thins the arc map; costs time in proportion to the map.
  void finish(Executor& executor);
  [[nodiscard]] const Map& map() const { return map_; }
  [[nodiscard]] Result<MapExport> export_map() const;
  [[nodiscard]] const InsertCounters& counters() const { return counters_; }
  /// The counts that would change; whether a cell is kept is decided by `finish`.
  [[nodiscard]] Trace trace(const Reading& reading) const;
  /// Whether the reading's arc crosses the cell at `position`.
  [[nodiscard]] bool supports(const Reading& reading, Vec2 position) const;
  [[nodiscard]] std::vector<std::byte> save() const;
  [[nodiscard]] static Result<MorphologicalProcessing> restore(std::span<const std::byte> bytes);

 private:
  void thin();

  Options options_;
  Map map_;
  InsertCounters counters_;
  bool finished_ = false;  // whether `kept` belongs to the votes
};

static_assert(MappingMethod<MorphologicalProcessing>);

}  // namespace echoarc
