// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>

#include "sim/ping_search.hpp"

namespace echoarc::sim {

namespace {

class PlaneSearch {
 public:
  explicit PlaneSearch(PingSearch& ping) : ping_(ping) {
    for (const Wall& wall : ping.world.description.walls) mirrors_.emplace_back(wall);
  }

  void reflect(Vec2 source, std::size_t depth) {
    for (std::uint32_t w = 0; w < mirrors_.size(); ++w) {
      if ((depth > 0 && walls_[depth - 1] == w) || !mirrors_[w].reflects(source)) continue;
      walls_[depth] = w;
      images_[depth] = mirrors_[w].image(source);
      listen(depth + 1);
      if (static_cast<int>(depth) + 1 < ping_.limits.max_order) reflect(images_[depth], depth + 1);
    }
  }

 private:
  /// Backwards from the listener through the images.
  void listen(std::size_t order) {
    const Vec2 ear = ping_.listener.position;
    const double length_m = norm(images_[order - 1] - ear);
    if (length_m > ping_.limits.max_length_m) return;
    Vec2 target = ear;
    for (std::size_t k = order; k-- > 0;) {
      if (!mirrors_[walls_[k]].bounce(target, images_[k], bounces_[k])) return;
      target = bounces_[k];
    }
    if (!ping_.listener.hears(bounces_[order - 1]) || !ping_.sender.hears(bounces_[0])) return;
    Vec2 from = ping_.sender.position;
    for (std::size_t k = 0; k < order; ++k) {
      if (!ping_.sees(from, bounces_[k])) return;
      from = bounces_[k];
    }
    if (!ping_.sees(from, ear)) return;
    double loss_db = 0.0;
    for (std::size_t k = 0; k < order; ++k)
      loss_db += ping_.world.loss_db(ping_.world.description.walls[walls_[k]].material);
    ping_.add(bounces_[0], bounces_[order - 1], length_m, -loss_db, cause(order), order);
  }

  [[nodiscard]] EchoCause cause(std::size_t order) const {
    if (order == 1) return EchoCause::wall;
    for (std::size_t k = 1; k < order; ++k)
      if (!ping_.world.share_vertex(walls_[k - 1], walls_[k])) return EchoCause::multiple;
    return EchoCause::corner;
  }

  PingSearch& ping_;
  std::vector<Mirror> mirrors_;
  std::array<std::uint32_t, PathLimits::highest_order> walls_{};
  std::array<Vec2, PathLimits::highest_order> images_{};
  std::array<Vec2, PathLimits::highest_order> bounces_{};
};

}  // namespace

void find_plane_paths(PingSearch& ping) {
  PlaneSearch(ping).reflect(ping.sender.position, 0);
}

}  // namespace echoarc::sim
