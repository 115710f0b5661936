// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/scene_office.hpp"

#include <string>
#include <utility>

#include "echoarc/sim/office_floor.hpp"
#include "io/option_toml.hpp"
#include "io/scene_materials.hpp"
#include "io/toml_points.hpp"

namespace echoarc::io {
namespace {

void fail_at_option(TomlFields& fields, const Error& error) {
  fields.fail(fields.node(error.where), error.message, error.remedy);
}

}  // namespace

void read_office(TomlFields& fields, sim::Scene& scene) {
  const toml::table* table = fields.table("office");
  if (table == nullptr) return;
  TomlFields office(*table, fields.source(), "office");
  sim::OfficeFloorOptions options;
  read_options(office, options);
  const auto smooth = read_material_name(office, "smooth", "painted", scene.world.materials);
  const auto rough = read_material_name(office, "rough", "brick", scene.world.materials);
  Result<void> done = office.finish();
  if (done) {
    Result<sim::OfficeFloor> floor = sim::make_office_floor(options, smooth, rough);
    if (!floor) {
      fail_at_option(office, floor.error());
      done = office.finish();
    } else {
      for (sim::Wall& wall : floor->walls) wall.line = toml_line(*table);
      scene.world.walls.insert(scene.world.walls.end(), floor->walls.begin(), floor->walls.end());
      const toml::table* drive = fields.table("drive");
      if (drive == nullptr || (!drive->contains("start") && !drive->contains("legs"))) {
        scene.drive.start = floor->start;
        scene.drive.legs = std::move(floor->tour);
      }
    }
  }
  if (!done) fields.fail(done.error());
}

}  // namespace echoarc::io
