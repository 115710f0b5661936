// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mapping/consensus/ellipse_pair.hpp"

namespace echoarc::consensus {
namespace {

/// Whether arc `j` sees some of arc `i` so near its range that it can speak of its points: a circle around the middle
/// that holds all that is searched of arc `i`, against the ring and the cone that arc `j` can speak of.
bool sees(const ArcTable& arcs, const ConsensusOptions& options, std::size_t i, std::size_t j) {
  constexpr double deviations = 5.5;  // beyond, support has fallen to a millionth
  const Vec2 apart = arcs.middle(i) - arcs[j].arc.centre();
  const double beyond_m = arcs.half_length_m(i) + arcs[j].arc.range_m() + deviations * options.range_sigma_m;
  if (squared_norm(apart) > beyond_m * beyond_m) return false;
  const BeamBins& bins = arcs.bins(j);
  const double aside_m = std::abs(cross(arcs.axis(j), apart));
  return aside_m * bins.cone_cos - dot(arcs.axis(j), apart) * bins.cone_sin <= arcs.half_length_m(i);
}

/// Arc `j` as arc `i` sees it.
kernels::CirclePair circle_pair(const ArcTable& arcs, std::size_t i, std::size_t j, Angle step) {
  const Arc& own = arcs[i].arc;
  const Arc& other = arcs[j].arc;
  const Vec2 apart = other.centre() - own.centre();
  const Vec2 axis = arcs.axis(i);
  const BeamBins& bins = arcs.bins(j);
  kernels::CirclePair pair{};
  pair.x_m = float(snapped(dot(axis, apart)));
  pair.y_m = float(snapped(cross(axis, apart)));
  pair.shorter_m = float(snapped(own.range_m() - other.range_m()));
  pair.range_m = float(other.range_m());
  pair.turn_rad = float(snapped(arcs.turn_rad(i, j)));
  pair.cos_turn = float(snapped(dot(arcs.axis(j), axis)));
  pair.sin_turn = float(snapped(cross(arcs.axis(j), axis)));
  pair.over_two_variance = 0.5F / (bins.sigma_rad * bins.sigma_rad);
  pair.half = bins.half;
  pair.shift = shifted_bins(double(pair.turn_rad) / step.rad()) + bins.half - arcs.bins(i).half;
  return pair;
}

}  // namespace

int widest_bins(const ArcTable& arcs) {
  int widest = 0;
  for (const BeamBins& bins : arcs.all_bins()) widest = std::max(widest, bins.padded());
  return widest;
}

WeightRows::WeightRows(std::size_t count, int bins)
    : pad_(std::size_t(bins)),
      stride_(3 * std::max<std::size_t>(1, pad_)),
      wall_(count * stride_),
      point_(count * stride_) {}

void WeightRows::resize(std::size_t count) {
  wall_.resize(count * stride_);
  point_.resize(count * stride_);
}

void WeightRows::forget(std::size_t count) {
  const auto floats = std::ptrdiff_t(count * stride_);
  wall_.erase(wall_.begin(), wall_.begin() + floats);
  point_.erase(point_.begin(), point_.begin() + floats);
}

void WeightRows::copy(std::size_t k, const WeightRows& from, std::size_t m) {
  std::copy_n(from.wall(m), from.pad_, wall_.data() + k * stride_ + pad_);
  std::copy_n(from.point(m), from.pad_, point_.data() + k * stride_ + pad_);
}

void WeightRows::fill(std::size_t k, const Posterior& posterior, float prior_top, float scale) {
  const auto fill_row = [&](std::span<const float> shares, float certainty, float* row) {
    for (std::size_t m = 0; m < shares.size(); ++m) row[m] = scale * std::min(1.0F, shares[m] * certainty / prior_top);
  };
  fill_row(posterior.wall, posterior.wall_share, wall_.data() + k * stride_ + pad_);
  fill_row(posterior.point, 1.0F - posterior.wall_share, point_.data() + k * stride_ + pad_);
}

WeightRows prior_rows(const ArcTable& arcs, const ConsensusOptions& options) {
  const auto& all = arcs.all_bins();
  WeightRows rows(all.size(), widest_bins(arcs));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto prior = std::span(all[k].prior).first(std::size_t(all[k].count()));
    rows.fill(k, {prior, prior, 0.5F, 0.0F}, all[k].prior_top, PosteriorEstimator::support_scale(options));
  }
  return rows;
}

PosteriorEstimator::PosteriorEstimator(const ArcTable& arcs, const ConsensusOptions& options)
    : arcs_(arcs), options_(options) {
  for (auto* sums : {&wall_support_, &wall_free_, &point_support_, &point_free_})
    sums->resize(std::size_t(widest_bins(arcs)));
}

float PosteriorEstimator::support_scale(const ConsensusOptions& options) {
  const double kappa = options.clutter_m / (options.range_sigma_m * std::sqrt(2.0 * std::numbers::pi));
  return float(options.detection * kappa);
}

/// Sorts the neighbours of arc `i` by what they can speak of; those of bistatic readings speak at once.
void PosteriorEstimator::gather(std::size_t i, const Neighbours& neighbours, const SweepWeights& weights) {
  on_walls_.clear();
  on_points_.clear();
  const BeamBins& own = arcs_.bins(i);
  const BinSums sums{wall_support_.data(), wall_free_.data(), point_support_.data(), point_free_.data()};
  for (const std::size_t j : neighbours.arcs) {
    const std::size_t row = weights.row(arcs_, j);
    const float* const wall = weights.rows->wall(row);
    const float* const point = weights.rows->point(row);
    if (!arcs_[i].arc.is_circular() || !arcs_[j].arc.is_circular()) {
      add_any_pair(arcs_, options_, i, j, wall, point, sums);
      continue;
    }
    kernels::CirclePair pair = circle_pair(arcs_, i, j, options_.step);
    pair.wall_weight = wall;
    pair.point_weight = point;
    if (pair.shift < arcs_.bins(j).count() && pair.shift + own.count() > 0) on_walls_.push_back(pair);
    if (sees(arcs_, options_, i, j)) on_points_.push_back(pair);
  }
}

/// From the sums: L_W, L_P, and out of them Q_W, Q_P, p_w and ev.
Posterior PosteriorEstimator::read(std::size_t i, double neighbour_weight) {
  const BeamBins& bins = arcs_.bins(i);
  const auto weight = float(neighbour_weight);
  const auto independent = float(options_.independence * neighbour_weight);
  float top = -std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < std::size_t(bins.count()); ++k) {
    wall_support_[k] = bins.log_prior[k] + independent * wall_support_[k] + weight * wall_free_[k];
    point_support_[k] = bins.log_prior[k] + independent * point_support_[k] + weight * point_free_[k];
    top = std::max({top, wall_support_[k], point_support_[k]});
  }
  const kernels::PosteriorKernels& kernel = kernels::posterior_kernels();
  const float wall_sum = kernel.normalise(wall_support_.data(), bins.count(), top);
  const float point_sum = kernel.normalise(point_support_.data(), bins.count(), top);
  const auto count = std::size_t(bins.count());
  return {std::span(wall_support_).first(count), std::span(point_support_).first(count),
          std::clamp(wall_sum / (wall_sum + point_sum), 0.05F, 0.95F), top};
}

Posterior PosteriorEstimator::estimate(std::size_t i, const Neighbours& neighbours, const SweepWeights& weights) {
  const BeamBins& bins = arcs_.bins(i);
  for (auto* sums : {&wall_support_, &wall_free_, &point_support_, &point_free_}) std::ranges::fill(*sums, 0.0F);
  gather(i, neighbours, weights);
  const auto length_m = float(options_.wall_length_m);
  const auto sigma_m = float(options_.range_sigma_m);
  constexpr double tie_rad = 1e-6;  // beyond what snapping moves
  constexpr float lost = 17.0F;     // 1 + exp(-17) is 1 in a float
  const kernels::PosteriorTerms terms{.over_two_length = 0.5F / (length_m * length_m),
                                      .over_two_range = 0.5F / (sigma_m * sigma_m),
                                      .no_support = -std::log(std::max(support_scale(options_), 1.0F)) - lost,
                                      .facing = float(options_.facing),
                                      .facing_rad = float(options_.facing_angle.rad() + tie_rad),
                                      .free_margin_m = float(options_.free_margin_m),
                                      .over_step = float(1.0 / options_.step.rad()),
                                      .range_m = float(arcs_[i].arc.range_m()),
                                      .blocks = bins.padded() / kernels::bin_block,
                                      .t_rad = bins.t_rad.data(),
                                      .cos_t = bins.cos_t.data(),
                                      .sin_t = bins.sin_t.data()};
  const kernels::PosteriorKernels& kernel = kernels::posterior_kernels();
  kernel.add_walls(terms, on_walls_.data(), std::int32_t(on_walls_.size()), {wall_support_.data(), wall_free_.data()});
  kernel.add_points(terms, on_points_.data(), std::int32_t(on_points_.size()),
                    {point_support_.data(), point_free_.data()});
  return read(i, neighbours.weight);
}

namespace {

/// Calls `work(begin, end)` for pieces of 0 ... count, on several threads.
void in_pieces(std::size_t count, Executor& executor, const std::function<void(std::size_t, std::size_t)>& work) {
  constexpr std::size_t piece = 64;
  executor.run((count + piece - 1) / piece,
               [&](std::size_t task) { work(task * piece, std::min(count, (task + 1) * piece)); });
}

}  // namespace

std::vector<Neighbours> neighbours_of(const ArcTable& arcs, const ConsensusOptions& options, std::size_t first,
                                      std::size_t end, Executor& executor) {
  std::vector<Neighbours> neighbours(end - first);
  in_pieces(neighbours.size(), executor, [&](std::size_t begin, std::size_t stop) {
    for (std::size_t k = begin; k < stop; ++k) find_neighbours(arcs, options, first + k, arcs.size(), neighbours[k]);
  });
  return neighbours;
}

void sweep(const ArcTable& arcs, const ConsensusOptions& options, std::size_t first,
           std::span<const Neighbours> neighbours, const SweepWeights& weights, Executor& executor,
           const FoundPosterior& found) {
  in_pieces(neighbours.size(), executor, [&](std::size_t begin, std::size_t stop) {
    PosteriorEstimator estimator(arcs, options);
    for (std::size_t k = begin; k < stop; ++k) found(first + k, estimator.estimate(first + k, neighbours[k], weights));
  });
}

SweptRows find_posteriors(const ArcTable& arcs, const ConsensusOptions& options, std::size_t first, std::size_t end,
                          Executor& executor, const FoundPosterior& found) {
  SweptRows swept{prior_rows(arcs, options), 0};
  // What later sweeps look at: a history more for each, before and after.
  const auto from = [&](std::size_t margin) { return first - std::min(first, margin); };
  const auto to = [&](std::size_t margin) { return std::min(arcs.size(), end + margin); };
  std::size_t margin = std::size_t(options.sweeps - 1) * std::size_t(options.history);
  const std::size_t lowest = from(margin);
  const std::vector<Neighbours> neighbours = neighbours_of(arcs, options, lowest, to(margin), executor);
  bool by_beam = true;
  for (; margin > 0; margin -= std::size_t(options.history), by_beam = false) {
    WeightRows next(to(margin) - from(margin), widest_bins(arcs));
    sweep(arcs, options, from(margin), std::span(neighbours).subspan(from(margin) - lowest, to(margin) - from(margin)),
          {&swept.rows, swept.first, by_beam}, executor, [&](std::size_t i, const Posterior& posterior) {
            next.fill(i - from(margin), posterior, arcs.bins(i).prior_top, PosteriorEstimator::support_scale(options));
          });
    swept = {std::move(next), from(margin)};
  }
  sweep(arcs, options, first, std::span(neighbours).subspan(first - lowest, end - first),
        {&swept.rows, swept.first, by_beam}, executor, found);
  return swept;
}

}  // namespace echoarc::consensus
