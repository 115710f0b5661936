// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/office_floor.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "echoarc/core/rng.hpp"
#include "sim/office_plan.hpp"

namespace echoarc::sim {
namespace {

constexpr double door_margin_m = 0.2;  // between a door and the next wall
constexpr double least_width_share = 0.7;
constexpr double most_width_share = 1.3;
constexpr double longest_step_inside_m = 3.0;
constexpr double least_walls_per_room = 9.0;

struct Span {
  double from = 0.0;
  double to = 0.0;
  [[nodiscard]] double length() const { return to - from; }
};

Result<void> check(const OfficeFloorOptions& o) {
  if (const Result<void> valid = validate(o); !valid) return valid;
  const double narrowest_m = least_width_share / most_width_share * o.room_width_m;
  if (o.door_m + 2.0 * door_margin_m > narrowest_m)
    return Error{ErrorCode::bad_value, "the doors of the office are too wide for its rooms", "door_m",
                 "make room_width_m at least twice door_m plus 0.8 m"};
  if (o.corridor_m < o.door_m)
    return Error{ErrorCode::bad_value, "the corridors of the office are narrower than its doors", "corridor_m",
                 "make corridor_m at least door_m"};
  if (o.block_m < 2.0 * (o.door_m + 2.0 * door_margin_m + 2.0 * o.wall_m) + o.corridor_m)
    return Error{ErrorCode::bad_value, "the cross corridors of the office are too close for its doors", "block_m",
                 "make block_m at least corridor_m plus twice door_m plus 2 m"};
  const double walls = least_walls_per_room * o.area_m2 / ((o.room_depth_m + o.corridor_m) * o.room_width_m);
  if (walls > static_cast<double>(World::max_walls))
    return Error{ErrorCode::too_large, "the office would have more than " + std::to_string(World::max_walls) + " walls",
                 "area_m2", "make area_m2 smaller, or the rooms larger"};
  return {};
}

class FloorBuilder {
 public:
  FloorBuilder(const OfficeFloorOptions& options, MaterialId smooth, MaterialId rough)
      : o_(options), smooth_(smooth), rough_(rough), rng_(static_cast<std::uint64_t>(options.seed)) {}

  OfficeFloor build() {
    lay_out();
    add_outside();
    for (std::size_t row = 0; row + 1 < plan_.row_y.size(); ++row)
      for (std::size_t column = 0; column + 1 < plan_.column_x.size(); ++column) add_block(column, row);
    for (std::vector<OfficeDoor>& doors : plan_.doors)
      std::ranges::sort(doors, {}, [](const OfficeDoor& door) { return door.outside.x; });
    const std::vector<Vec2> tour = office_tour(plan_);
    floor_.start = {tour.front(), bearing(tour[1] - tour.front())};
    for (std::size_t i = 1; i < tour.size(); ++i) floor_.tour.push_back({.to = tour[i]});
    return std::move(floor_);
  }

 private:
  /// As many corridors as make the floor about square, as long as the area asks for.
  void lay_out() {
    const double row_depth_m = o_.room_depth_m + 2.0 * o_.wall_m;  // of the outermost rooms with both walls
    const double block_depth_m = 2.0 * o_.room_depth_m + 3.0 * o_.wall_m;
    const double pitch_m = o_.corridor_m + block_depth_m;
    const double side_m = std::sqrt(o_.area_m2);
    const auto rows = static_cast<std::size_t>(std::max(1.0, std::round(side_m / pitch_m)));
    const double height_m = static_cast<double>(rows) * pitch_m - block_depth_m + 2.0 * row_depth_m;
    width_m_ = std::max(o_.area_m2 / height_m, 2.0 * o_.corridor_m + o_.block_m / 2.0);
    floor_.area_m2 = width_m_ * height_m;
    for (std::size_t row = 0; row < rows; ++row)
      plan_.row_y.push_back(row_depth_m + o_.corridor_m / 2.0 + static_cast<double>(row) * pitch_m);
    const double blocks = std::max(1.0, std::round((width_m_ - o_.corridor_m) / (o_.block_m + o_.corridor_m)));
    const double column_pitch_m = (width_m_ - o_.corridor_m) / blocks;
    for (std::size_t column = 0; column <= static_cast<std::size_t>(blocks); ++column)
      plan_.column_x.push_back(o_.corridor_m / 2.0 + static_cast<double>(column) * column_pitch_m);
    plan_.doors.resize(rows * (plan_.column_x.size() - 1));
  }

  /// The ends of the corridors, and the rooms below the lowest and above the highest.
  void add_outside() {
    const double low = plan_.row_y.front() - o_.corridor_m / 2.0;
    const double high = plan_.row_y.back() + o_.corridor_m / 2.0;
    add_wall({0.0, low}, {0.0, high}, any_material());
    add_wall({width_m_, low}, {width_m_, high}, any_material());
    add_rooms(0, low, -1.0, {0.0, width_m_});
    add_rooms(plan_.row_y.size() - 1, high, 1.0, {0.0, width_m_});
  }

  /// Two rows of rooms back to back, with corridors all around.
  void add_block(std::size_t column, std::size_t row) {
    const double half_m = o_.corridor_m / 2.0;
    const Span x{plan_.column_x[column] + half_m, plan_.column_x[column + 1] - half_m};
    const Span y{plan_.row_y[row] + half_m, plan_.row_y[row + 1] - half_m};
    add_wall({x.from, y.from}, {x.from, y.to}, any_material());
    add_wall({x.to, y.from}, {x.to, y.to}, any_material());
    add_rooms(row, y.from, 1.0, x);
    add_rooms(row + 1, y.to, -1.0, x);
  }

  /// A row of rooms whose corridor lies at `face_y`; `side` is +1 for rooms above it, -1 below.
  void add_rooms(std::size_t row, double face_y, double side, Span x) {
    const MaterialId face = any_material();
    double face_x = x.from;
    for (const Span& room : room_spans(x)) {
      const double door_x = rng_.uniform(room.from + door_margin_m, room.to - door_margin_m - o_.door_m);
      const Span door{door_x, door_x + o_.door_m};
      add_wall({face_x, face_y}, {door.from, face_y}, face);
      face_x = door.to;
      add_room(room, door, face_y, side);
      add_door(row, door, face_y, side);
    }
    add_wall({face_x, face_y}, {x.to, face_y}, face);
  }

  /// Widths between 0.7 and 1.3 of one another that fill the row with walls between them and at both ends.
  std::vector<Span> room_spans(Span x) {
    const auto count =
        static_cast<std::size_t>(std::max(1.0, std::floor((x.length() - o_.wall_m) / (o_.room_width_m + o_.wall_m))));
    const double free_m = x.length() - static_cast<double>(count + 1) * o_.wall_m;
    std::vector<double> weights(count);
    double sum = 0.0;
    for (double& weight : weights) sum += weight = rng_.uniform(least_width_share, most_width_share);
    std::vector<Span> spans;
    double at = x.from + o_.wall_m;
    for (const double weight : weights) {
      spans.push_back({at, at + free_m * weight / sum});
      at = spans.back().to + o_.wall_m;
    }
    return spans;
  }

  /// The inside of a room: three walls, and the fourth on both sides of the door with the door's jambs.
  void add_room(Span room, Span door, double face_y, double side) {
    const MaterialId material = any_material();
    const double front = face_y + side * o_.wall_m;
    const double back = front + side * o_.room_depth_m;
    add_wall({door.from, front}, {room.from, front}, material);
    add_wall({room.from, front}, {room.from, back}, material);
    add_wall({room.from, back}, {room.to, back}, material);
    add_wall({room.to, back}, {room.to, front}, material);
    add_wall({room.to, front}, {door.to, front}, material);
    add_wall({door.from, face_y}, {door.from, front}, smooth_);
    add_wall({door.to, face_y}, {door.to, front}, smooth_);
    ++floor_.rooms;
  }

  void add_door(std::size_t row, Span door, double face_y, double side) {
    const double x = (door.from + door.to) / 2.0;
    const double inside_m = o_.wall_m + std::min(o_.room_depth_m / 2.0, longest_step_inside_m);
    const bool visited = rng_.uniform() < o_.visited_share;
    const auto& columns = plan_.column_x;
    const auto right = std::upper_bound(columns.begin() + 1, columns.end() - 1, x);
    plan_.doors_of(row, static_cast<std::size_t>(right - columns.begin()) - 1)
        .push_back({{x, plan_.row_y[row]}, {x, face_y + side * inside_m}, visited});
    floor_.visited_rooms += visited ? 1 : 0;
  }

  void add_wall(Vec2 a, Vec2 b, MaterialId material) { floor_.walls.push_back({.a = a, .b = b, .material = material}); }
  MaterialId any_material() { return rng_.uniform() < o_.rough_share ? rough_ : smooth_; }

  const OfficeFloorOptions& o_;
  MaterialId smooth_;
  MaterialId rough_;
  Rng rng_;
  double width_m_ = 0.0;
  OfficePlan plan_;
  OfficeFloor floor_;
};

}  // namespace

Result<OfficeFloor> make_office_floor(const OfficeFloorOptions& options, MaterialId smooth, MaterialId rough) {
  if (const Result<void> checked = check(options); !checked) return checked.error();
  OfficeFloor floor = FloorBuilder(options, smooth, rough).build();
  if (floor.walls.size() > World::max_walls)
    return Error{ErrorCode::too_large, "the office has more than " + std::to_string(World::max_walls) + " walls",
                 "area_m2", "make area_m2 smaller, or the rooms larger"};
  return floor;
}

}  // namespace echoarc::sim
