// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/scene_materials.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "io/option_toml.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t max_materials = 1000;

void read_material(TomlFields& fields, sim::Material& material) {
  material.loss_db = fields.number("loss_db", 0.0, 200.0).value_or(material.loss_db);
  if (const auto rough_db = fields.number("rough_db", -200.0, -0.1)) material.rough_db = rough_db;
  material.rough_pitch_m = fields.length_m("rough_pitch", 0.001, 100.0).value_or(material.rough_pitch_m);
  material.laser_ok = fields.boolean("laser_ok").value_or(material.laser_ok);
}

}  // namespace

std::vector<sim::Material> builtin_materials() {
  return {{.name = "wood", .loss_db = 0.5},
          {.name = "painted", .loss_db = 0.5},
          {.name = "cardboard", .loss_db = 1.0},
          {.name = "shade", .loss_db = 1.0},
          {.name = "brick", .loss_db = 0.5, .rough_db = -18.0, .rough_pitch_m = 0.05},
          {.name = "glass", .loss_db = 0.5, .laser_ok = false}};
}

std::vector<sim::Material> read_materials(TomlFields& scene) {
  std::vector<sim::Material> materials = builtin_materials();
  const toml::table* table = scene.table("materials");
  if (table == nullptr) return materials;
  if (table->size() > max_materials)
    scene.fail(table, fmt::format("{} materials are too many", table->size()),
               fmt::format("at most {} are allowed", max_materials));
  for (const auto& [name, node] : *table) {
    if (!node.is_table()) {
      scene.fail(&node, fmt::format("material {} is no table", name.str()),
                 fmt::format("write [materials.{}] on a line of its own, loss_db = 0.5 below", name.str()));
      return materials;
    }
    auto found = std::ranges::find(materials, name.str(), &sim::Material::name);
    if (found == materials.end()) found = materials.insert(materials.end(), {.name = std::string(name.str())});
    TomlFields fields(*node.as_table(), scene.source(), "material");
    read_material(fields, *found);
    if (const Result<void> done = fields.finish(); !done) scene.fail(done.error());
  }
  return materials;
}

sim::MaterialId read_material_name(TomlFields& object, std::string_view key, std::string_view otherwise,
                                   const std::vector<sim::Material>& materials) {
  const std::string name = object.text(key).value_or(std::string(otherwise));
  const auto found = std::ranges::find(materials, name, &sim::Material::name);
  if (found != materials.end()) return static_cast<sim::MaterialId>(found - materials.begin());
  std::vector<std::string_view> names;
  for (const sim::Material& material : materials) names.push_back(material.name);
  fail_unknown(object, object.node(key), "material", name, names);
  return 0;
}

}  // namespace echoarc::io
