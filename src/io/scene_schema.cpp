// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/scene_schema.hpp"

#include <initializer_list>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "echoarc/eval/scene_scoring.hpp"
#include "echoarc/io/builtin.hpp"
#include "echoarc/sim/office_floor.hpp"
#include "echoarc/sim/scene.hpp"
#include "io/option_json.hpp"
#include "io/scene_materials.hpp"

namespace echoarc::io {
namespace {

using Json = nlohmann::ordered_json;

Json text(std::string_view what) {
  return {{"type", "string"}, {"description", what}};
}

Json number(std::string_view what, std::string_view unit = "") {
  Json json = {{"type", "number"}, {"description", what}};
  if (!unit.empty()) json["unit"] = unit;
  return json;
}

Json flag(bool default_value, std::string_view what) {
  return {{"type", "boolean"}, {"default", default_value}, {"description", what}};
}

Json numbers(int count, std::string_view what) {
  return {{"type", "array"},
          {"items", {{"type", "number"}}},
          {"minItems", count},
          {"maxItems", count},
          {"description", what}};
}

Json list(Json items, int least, std::string_view what) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", least}, {"description", what}};
}

Json any_point() {
  return {{"$ref", "#/$defs/point"}};
}

Json point(std::string_view what) {
  return {{"$ref", "#/$defs/point"}, {"description", what}};
}

Json object(std::string_view what, Json properties, Json required = Json::array()) {
  Json json = {{"type", "object"},
               {"additionalProperties", false},
               {"description", what},
               {"properties", std::move(properties)}};
  if (!required.empty()) json["required"] = std::move(required);
  return json;
}

/// One table, or a list of them, of the kind that stands under $defs.
Json tables(const std::string& kind) {
  const Json item = {{"$ref", "#/$defs/" + kind}};
  return {{"anyOf", {item, {{"type", "array"}, {"items", item}}}}};
}

/// A length or an angle, under its plain name and under the one with the unit; one of them, if it is required.
struct Spelling {
  std::string plain;
  std::string with_unit;
};
Spelling in_m(const std::string& key) {
  return {key, key + "_m"};
}
Spelling in_deg(const std::string& key) {
  return {key, key + "_deg"};
}
void add(Json& properties, const Spelling& key, std::string_view what) {
  const bool angle = key.with_unit.ends_with("_deg");
  properties[key.plain] = number(what, angle ? "rad" : "m");
  properties[key.with_unit] = number(what, angle ? "deg" : "m");
}
void require_one(Json& table, const Spelling& key) {
  table["allOf"].push_back({{"anyOf", {{{"required", {key.plain}}}, {{"required", {key.with_unit}}}}}});
}

template <OptionStruct S>
Json options() {
  return option_properties(option_specs<S>());
}

Json material() {
  Json properties = {
      {"loss_db", {{"type", "number"}, {"minimum", 0}, {"unit", "dB"}, {"description", "of every reflection"}}},
      {"rough_db", number("strength of the bumps of a rough surface, below 0; without it the surface is "
                          "smooth as a mirror",
                          "dB")}};
  add(properties, in_m("rough_pitch"), "mean distance of the bumps");
  properties["laser_ok"] = flag(true, "false: lasers get no return");
  return object("How a surface answers sound and light; a built-in name changes the built-in material.", properties);
}

Json with_material(Json properties) {
  properties["material"] = text("name of a material; wood where there is none");
  return properties;
}

Json wall() {
  return object("A polyline: a straight wall between every two neighbouring points.",
                with_material({{"points", list(any_point(), 2, "corners, in order")},
                               {"closed", flag(false, "one more wall, from the last point to the first")},
                               {"one_sided", flag(false, "stands only for what is on the left of its direction")}}),
                {"points"});
}

Json box() {
  Json properties = with_material({{"centre", point("its middle")}, {"size", numbers(2, "[length, width] in metres")}});
  add(properties, in_deg("turn"), "counter-clockwise about its middle");
  return object("A rectangle, seen from outside.", properties, {"centre", "size"});
}

Json disc() {
  Json properties = with_material({{"centre", point("its middle")}});
  add(properties, in_m("radius"), "of the disc");
  Json json = object("A solid disc: a post, a bin.", properties, {"centre"});
  require_one(json, in_m("radius"));
  return json;
}

Json curve() {
  const Json terms = numbers(3, "[amplitude in m, radians per metre of x, phase in radians]");
  Json properties = with_material({{"x", numbers(2, "[from, to]: the curve is y over x, the sum of all terms below")},
                                   {"cosines", list(terms, 0, "amplitude * cos(rate * x + phase)")},
                                   {"sines", list(terms, 0, "amplitude * sin(rate * x + phase)")},
                                   {"polynomial", list({{"type", "number"}}, 0, "factors of 1, x, x^2, ...")}});
  add(properties, in_m("y"), "a constant term");
  properties["centre"] = point("the curve is a part of a circle about this point");
  add(properties, in_m("radius"), "of that circle");
  properties["from_deg"] = number("bearing of its first end", "deg");
  properties["to_deg"] = number("bearing of its last end", "deg");
  properties["points"] = list(any_point(), 3, "the curve goes smoothly through these points (centripetal Catmull-Rom)");
  Json json = object("A smooth surface, in one of three forms: over x, part of a circle, through points.", properties);
  json["oneOf"] = {{{"required", {"x"}}}, {{"required", {"centre"}}}, {{"required", {"points"}}}};
  return json;
}

Json slats() {
  Json properties = with_material({{"from", point("where the row begins")}, {"to", point("where it ends")}});
  add(properties, in_m("width"), "of a slat");
  add(properties, in_m("pitch"), "from slat to slat; its width where there is none");
  add(properties, in_deg("angle"), "every slat is turned by it about its middle, to one side and the other in turn");
  Json json = object("A row of vertical slats, as of a window shade; the last is cut where the row ends.", properties,
                     {"from", "to"});
  require_one(json, in_m("width"));
  return json;
}

Json moving() {
  Json properties = with_material({{"path", list(numbers(3, "[time in s, x, y]"), 1,
                                                 "stations, straight lines between them; at rest before the first and "
                                                 "after the last")}});
  add(properties, in_m("radius"), "of the disc; 0.2 m where there is none");
  return object("A disc that moves: a person.", properties, {"path"});
}

Json office() {
  Json properties = options<sim::OfficeFloorOptions>();
  properties["smooth"] = text("material of smooth walls; painted where there is none");
  properties["rough"] = text("material of rough walls; brick where there is none");
  return object("An office floor made from a seed; without start and legs, the drive is a tour of it.", properties);
}

Json drive() {
  Json properties = {{"start", numbers(3, "[x, y, heading]: metres and degrees")}};
  Json turn;
  add(turn, in_deg("turn"), "a turn on the spot, counter-clockwise");
  turn["to"] = point("straight to this point");
  const Json leg = {{"anyOf", {any_point(), object("straight, or a turn", turn)}}};
  properties["legs"] = list(leg, 0, "[x, y] or { to = [x, y] }: straight there; { turn_deg = 90 }: a turn on the spot");
  properties.update(options<sim::Drive>());
  return object("How the robot goes.", properties);
}

Json span() {
  Json properties = {{"from", point("one end, the inside on the left of the way to the other")},
                     {"to", point("the other end")}};
  add(properties, in_m("depth"), "from the wall back to where the directions start: the robot's way");
  Json json = object("Directions of interest at right angles to a wall.", properties, {"from", "to"});
  require_one(json, in_m("depth"));
  return json;
}

Json scoring() {
  Json properties = {{"region", list(any_point(), 2, "lower left and upper right corner of what is judged")},
                     {"span", tables("span")},
                     {"polar_centre", point("directions of interest fan out from this point")}};
  properties["region"]["maxItems"] = 2;
  add(properties, in_deg("axis"), "directions of interest all over the region, parallel to this bearing");
  properties.update(options<SceneScoring>());
  return object("How maps of the scene are judged; one of span, axis and polar_centre.", properties, {"region"});
}

Json robot() {
  Json names = Json::array();
  for (const BuiltinText& built_in : builtin_robots()) names.push_back(built_in.name);
  const Json by_name = {{"type", "string"}, {"enum", names}};
  const Json table = {{"type", "object"}, {"description", "a robot as a robot.toml describes it"}};
  return {{"description", "a built-in robot by name, or a table as in a robot.toml"}, {"anyOf", {by_name, table}}};
}

template <OptionStruct S>
Json option_table(std::string_view what) {
  return object(what, options<S>());
}

Json scene_properties() {
  const Json world = object(
      "What concerns the whole world.",
      {{"seed",
        {{"type", "integer"}, {"minimum", 0}, {"default", 1}, {"description", "of places and strengths of bumps"}}}});
  return {
      {"name", text("short, as the file")},
      {"title", text("one line for people")},
      {"source", text("the paper and section it follows")},
      {"robot", robot()},
      {"materials", {{"type", "object"}, {"additionalProperties", material()}}},
      {"world", world},
      {"wall", tables("wall")},
      {"box", tables("box")},
      {"disc", tables("disc")},
      {"curve", tables("curve")},
      {"slats", tables("slats")},
      {"moving", tables("moving")},
      {"office", office()},
      {"drive", drive()},
      {"sonar", option_table<sim::SonarOptions>("Transducers, air, echoes, errors and firing.")},
      {"odometry", option_table<sim::OdometryOptions>("Drift of the wheels' odometry.")},
      {"laser", tables("laser")},
      {"polling", option_table<sim::PollingOptions>("Registers read at a fixed rate.")},
      {"explore", object("For robots that find their own way; see `echoarc explore`.",
                         {{"goals", list(any_point(), 1, "places to drive to in this order, or to find")}}, {"goals"})},
      {"scoring", scoring()}};
}

}  // namespace

std::string scene_schema() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "echoarc scene"}};
  schema.update(object("A world, a robot in it, how it goes, and how its maps are judged. Lengths in metres.",
                       scene_properties(), {"robot"}));
  schema["$defs"] = {{"point", numbers(2, "[x, y] in metres")},
                     {"wall", wall()},
                     {"box", box()},
                     {"disc", disc()},
                     {"curve", curve()},
                     {"slats", slats()},
                     {"moving", moving()},
                     {"laser", option_table<sim::LaserOptions>("A laser of the robot that measures.")},
                     {"span", span()}};
  return schema.dump(2) + "\n";
}

}  // namespace echoarc::io
