// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/evidence_window.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "mapping/consensus/evidence_beam.hpp"
#include "mapping/consensus/heard_beams.hpp"
#include "mapping/consensus/validation.hpp"

namespace echoarc::consensus {
namespace {

/// Arcs settled together: enough that those looked at on both sides of them cost little.
constexpr std::size_t largest_block = 1024;

/// Of one arc with a beam of 20 degrees, and all that is kept of it.
constexpr std::size_t arc_bytes = sizeof(EchoArc) + 3 * sizeof(Vec2) + sizeof(WaitingArc) + 31 * sizeof(float);

}  // namespace

EvidenceWindow::EvidenceWindow(const ConsensusEvidenceOptions& options, std::size_t bytes)
    : options_(options), arcs_(options) {
  // Three parts: arcs that are looked back at, arcs that wait for later ones, and a block on its way.
  const std::size_t third = std::max<std::size_t>(1, bytes / arc_bytes / 3);
  ahead_ = std::min(std::size_t(options.sweeps) * std::size_t(options.history), third);
  beside_ = std::min(std::size_t(options.history), ahead_ / 2);
  block_ = std::min(largest_block, third);
}

void EvidenceWindow::add(const EchoArc& echo, double near_m, Vec2 robot) {
  arcs_.add(echo);
  waiting_.push_back({.near_m = near_m, .robot = robot, .estimate = {}, .posterior = {}});
}

/// Steps B and C of the arcs below `end` whose posterior is not final.
void EvidenceWindow::weigh(std::size_t end, Executor& executor) {
  if (known_ >= end) return;
  if (known_ == 0) arcs_.assume(heard_beams(arcs_, options_));
  find_posteriors(arcs_, options_, known_, end, executor, [&](std::size_t i, const Posterior& posterior) {
    waiting_[i].estimate = read_out(arcs_[i], arcs_.bins(i), options_, posterior);
    waiting_[i].posterior = mixture(posterior);
  });
}

/// Step D among the arcs below `end`.
void EvidenceWindow::vote(std::size_t end) {
  std::vector<Element> elements;
  std::vector<Vec2> path;
  for (std::size_t i = 0; i < end; ++i) {
    WaitingArc& waiting = waiting_[i];
    const EchoEstimate& estimate = waiting.estimate;
    path.push_back(waiting.robot);
    waiting.verdict = Verdict::unsure;
    if (is_believed(arcs_[i], options_, estimate)) elements.push_back(element_of(arcs_, i, estimate.t));
  }
  const std::vector<bool> valid = validate(arcs_, options_, elements, path);
  for (std::size_t k = 0; k < elements.size(); ++k)
    waiting_[elements[k].echo].verdict = valid[k] ? Verdict::kept : Verdict::outlier;
}

/// Drops arcs that none looks back at any more.
void EvidenceWindow::forget() {
  const std::size_t first = std::min(left_, known_ - std::min(known_, ahead_));
  if (first == 0) return;
  arcs_.forget(first);
  waiting_.erase(waiting_.begin(), waiting_.begin() + std::ptrdiff_t(first));
  left_ -= first;
  known_ -= first;
}

void EvidenceWindow::advance(Executor& executor, const Leave& leave) {
  if (arcs_.size() < known_ + block_ + ahead_) return;
  const std::size_t end = known_ + block_;
  weigh(end, executor);
  known_ = end;
  vote(known_);
  for (; left_ + beside_ < known_; ++left_) leave(arcs_[left_], arcs_.bins(left_), waiting_[left_]);
  forget();
}

void EvidenceWindow::visit_open(Executor& executor, const Leave& show) {
  weigh(arcs_.size(), executor);
  vote(arcs_.size());
  for (std::size_t i = left_; i < arcs_.size(); ++i) show(arcs_[i], arcs_.bins(i), waiting_[i]);
}

void EvidenceWindow::save(ByteWriter& out) const {
  arcs_.save(out);
  out.put<std::uint64_t>(left_);
  out.put<std::uint64_t>(known_);
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const WaitingArc& waiting = waiting_[i];
    out.put(waiting.near_m);
    out.put(waiting.robot);
    if (i >= known_) continue;
    const EchoEstimate& e = waiting.estimate;
    for (const double value : {e.t.rad(), e.p, e.bound_m, e.wall_share, e.evidence}) out.put(value);
    out.put_vector(waiting.posterior);
  }
}

bool EvidenceWindow::restore(ByteReader& in) {
  if (!arcs_.restore(in)) return false;
  left_ = in.get<std::uint64_t>();
  known_ = in.get<std::uint64_t>();
  if (!in.ok() || left_ > known_ || known_ > arcs_.size()) return false;
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    WaitingArc waiting;
    waiting.near_m = in.get<double>();
    waiting.robot = in.get<Vec2>();
    if (i < known_) {
      EchoEstimate& e = waiting.estimate;
      const double t_rad = in.get<double>();
      e.t = radians(t_rad);
      for (double* value : {&e.p, &e.bound_m, &e.wall_share, &e.evidence}) *value = in.get<double>();
      waiting.posterior = in.get_vector<float>();
      const auto sound = [](double x) { return std::isfinite(x); };
      if (!sound(t_rad) || !sound(e.p) || !sound(e.evidence) || !std::ranges::all_of(waiting.posterior, sound) ||
          waiting.posterior.size() != std::size_t(arcs_.bins(i).count()))
        return false;
    }
    if (!in.ok() || !is_finite(waiting.robot)) return false;
    waiting_.push_back(std::move(waiting));
  }
  return true;
}

}  // namespace echoarc::consensus
