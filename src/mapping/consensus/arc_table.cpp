// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/arc_table.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/saved_history.hpp"

namespace echoarc::consensus {

Vec2 touch_point(const Arc& arc, Vec2 n) {
  if (arc.is_circular()) return arc.centre() + arc.range_m() * n;
  const Vec2 f = arc.focal_axis();
  const double along = arc.range_m() * dot(n, f);
  const double across = arc.semi_minor_m() * cross(f, n);
  const Vec2 offset = arc.range_m() * along * f + arc.semi_minor_m() * across * perpendicular(f);
  return arc.centre() + offset / std::hypot(along, across);
}

Vec2 normal_through(const Arc& arc, Vec2 p) {
  const auto direction = [](Vec2 v) {
    const double length = norm(v);
    return length > 0.0 ? v / length : Vec2{};
  };
  const Vec2 both = direction(p - arc.transmitter()) + direction(p - arc.receiver());
  return norm(both) > 0.0 ? both / norm(both) : unit(arc.axis());
}

bool ArcTable::repeats(const Arc& arc, SensorId tx, SensorId rx) const {
  const auto found = last_.find({tx, rx});
  if (found == last_.end()) return false;
  const Arc& last = echoes_[found->second].arc;
  const bool still = norm(arc.centre() - last.centre()) < options_.thin_move_m - eps_length_m;
  const bool straight = abs(wrap(arc.axis() - last.axis())) < options_.thin_turn - eps_angle;
  return still && straight && std::abs(arc.range_m() - last.range_m()) <= options_.thin_range_m;
}

void ArcTable::add(EchoArc echo) {
  auto bins = std::ranges::find(bins_, echo.beam_width, &BeamBins::beam_width);
  if (bins == bins_.end()) bins = bins_.insert(bins_.end(), make_bins(options_, prior_, echo.beam_width));
  echo.bins = std::uint32_t(bins - bins_.begin());
  last_[{echo.tx, echo.source.sensor}] = echoes_.size();
  headings_rad_.push_back(wrap(echo.arc.axis()).rad());
  axes_.push_back(unit(echo.arc.axis()));
  middles_.push_back(touch_point(echo.arc, axes_.back()));
  half_lengths_m_.push_back(bins->search_rad(options_.step) * echo.arc.range_m());
  echoes_.push_back(echo);
}

void ArcTable::assume(const BeamPrior& prior) {
  prior_ = prior;
  for (BeamBins& bins : bins_) bins = make_bins(options_, prior_, bins.beam_width);
  for (std::size_t i = 0; i < echoes_.size(); ++i)
    half_lengths_m_[i] = bins(i).search_rad(options_.step) * echoes_[i].arc.range_m();
}

ArcTable ArcTable::part(std::size_t begin, std::size_t end) const {
  const auto piece = [&]<class T>(const std::vector<T>& all) {
    return std::vector<T>(all.begin() + std::ptrdiff_t(begin), all.begin() + std::ptrdiff_t(end));
  };
  ArcTable table(options_);
  table.prior_ = prior_;
  table.echoes_ = piece(echoes_);
  table.headings_rad_ = piece(headings_rad_);
  table.axes_ = piece(axes_);
  table.middles_ = piece(middles_);
  table.half_lengths_m_ = piece(half_lengths_m_);
  table.bins_ = bins_;
  return table;
}

ArcTable ArcTable::since(std::size_t from) const {
  return part(from, size());
}

ArcTable ArcTable::first(std::size_t count) const {
  return part(0, count);
}

void ArcTable::forget(std::size_t count) {
  const auto forget_first = [&](auto& all) { all.erase(all.begin(), all.begin() + std::ptrdiff_t(count)); };
  forget_first(echoes_);
  forget_first(headings_rad_);
  forget_first(axes_);
  forget_first(middles_);
  forget_first(half_lengths_m_);
  std::erase_if(last_, [&](const auto& entry) { return entry.second < count; });
  for (auto& [sensors, index] : last_) index -= count;
}

void ArcTable::save(ByteWriter& out) const {
  out.put(prior_);
  out.put<std::uint64_t>(echoes_.size());
  for (const EchoArc& echo : echoes_) {
    out.put(echo.arc);
    out.put(echo.source.ping);
    out.put(echo.source.time_s);
    out.put(echo.source.sensor);
    out.put(echo.tx);
    out.put(echo.beam_width);
  }
}

bool ArcTable::restore(ByteReader& in) {
  prior_ = in.get<BeamPrior>();
  const auto is_width = [](double beams) { return beams >= 0.01 && beams <= 40.0; };
  if (!is_width(prior_.sigma_beams) || !is_width(prior_.search_beams)) return false;
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    EchoArc echo;
    echo.arc = in.get<Arc>();
    echo.source.ping = in.get<PingId>();
    echo.source.time_s = in.get<double>();
    echo.source.sensor = in.get<SensorId>();
    echo.tx = in.get<SensorId>();
    echo.beam_width = in.get<Angle>();
    const bool sound = is_plausible(echo.arc) && echo.arc.range_m() <= options_.range_max_m &&
                       echo.beam_width > Angle{} && echo.beam_width < degrees(180.0);
    if (!in.ok() || !sound) return false;
    add(echo);
  }
  return in.ok();
}

}  // namespace echoarc::consensus
