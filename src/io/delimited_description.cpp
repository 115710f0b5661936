// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "echoarc/io/delimited.hpp"
#include "io/delimited_checks.hpp"
#include "io/files.hpp"
#include "io/sensor_toml.hpp"
#include "io/toml_fields.hpp"
#include "io/units.hpp"

namespace echoarc::io {
namespace {

constexpr std::int64_t max_column = 65'536;
constexpr std::int64_t max_id = 1'000'000;
constexpr std::size_t max_tables = 16;
constexpr std::size_t max_spellings = 64;

struct QuantityName {
  Quantity quantity;
  std::string_view name;
};
constexpr std::array quantity_names = {
    QuantityName{Quantity::time, "time"},
    QuantityName{Quantity::x, "x"},
    QuantityName{Quantity::y, "y"},
    QuantityName{Quantity::yaw, "yaw"},
    QuantityName{Quantity::left_wheel, "left_wheel"},
    QuantityName{Quantity::right_wheel, "right_wheel"},
    QuantityName{Quantity::sensor, "sensor"},
    QuantityName{Quantity::range, "range"},
    QuantityName{Quantity::scan, "scan"},
};

/// Reads one `columns = [ {...}, ... ]` entry.
class ColumnReader {
 public:
  ColumnReader(const toml::table& table, std::string_view source) : fields_(table, source, "column") {}

  Result<DelimitedColumn> read(double metres_per_tick, const NoEchoSpelling& table_no_echo) {
    read_quantity();
    read_place();
    read_scale(metres_per_tick);
    read_range_keys(table_no_echo);
    read_scan_keys();
    if (const Result<void> done = fields_.finish(); !done) return done.error();
    return column_;
  }

 private:
  void read_quantity() {
    const std::string name = fields_.text("quantity").value_or("");
    const auto known = std::ranges::find(quantity_names, std::string_view(name), &QuantityName::name);
    if (known != quantity_names.end()) {
      column_.quantity = known->quantity;
      return;
    }
    std::vector<std::string_view> names;
    for (const QuantityName& quantity : quantity_names) names.push_back(quantity.name);
    fields_.fail(
        fields_.node("quantity"),
        name.empty() ? std::string("the column has no quantity") : fmt::format("there is no quantity \"{}\"", name),
        fmt::format("use one of {}", fmt::join(names, ", ")));
  }

  void read_place() {
    const toml::node* single = fields_.node("column");
    if (single != nullptr && single->is_string()) column_.header = single->as_string()->get();
    if (single != nullptr && !single->is_string())
      column_.first = column_.last = static_cast<std::size_t>(fields_.integer("column", 1, max_column).value_or(1));
    const toml::array* range = fields_.array("columns");
    if ((single == nullptr) == (range == nullptr))
      fields_.fail(nullptr, "where the column is must be said once",
                   "write column = 3 (or a name of the header line), or columns = [2, 9] for neighbours");
    if (range != nullptr) read_neighbours(*range);
  }

  void read_neighbours(const toml::array& range) {
    const auto end = [&](std::size_t i) { return range.size() == 2 ? range[i].value<std::int64_t>().value_or(0) : 0; };
    if (end(0) < 1 || end(1) < end(0) || end(1) > max_column)
      return fields_.fail(&range, "columns is not a first and a last column",
                          fmt::format("write columns = [2, 9]; columns count from 1 to {}", max_column));
    column_.first = static_cast<std::size_t>(end(0));
    column_.last = static_cast<std::size_t>(end(1));
  }

  void read_scale(double metres_per_tick) {
    const Dimension dimension = dimension_of(column_.quantity);
    const bool is_wheel = column_.quantity == Quantity::left_wheel || column_.quantity == Quantity::right_wheel;
    if (const auto unit = fields_.text("unit")) {
      std::optional<double> si = si_scale(dimension, *unit);
      if (is_wheel && *unit == "ticks" && metres_per_tick > 0.0) si = metres_per_tick;
      if (!si)
        fields_.fail(fields_.node("unit"), fmt::format("\"{}\" is no unit of this quantity", *unit),
                     is_wheel && *unit == "ticks" ? "give the table metres_per_tick = 0.005"
                     : dimension == Dimension::none
                         ? "leave the unit out"
                         : "use one of " + units_of(dimension) + (is_wheel ? ", ticks" : ""));
      column_.scale = si.value_or(1.0);
    }
    if (const auto scale = fields_.number("scale", -1e9, 1e9)) {
      if (*scale == 0.0) fields_.fail(fields_.node("scale"), "a scale of 0 leaves nothing", "use -1 to turn the sign");
      column_.scale *= *scale;
    }
  }

  void read_range_keys(const NoEchoSpelling& table_no_echo) {
    if (column_.quantity != Quantity::range) return;
    column_.no_echo = read_spelling("no_echo").value_or(table_no_echo);
    const toml::array* sensors = fields_.array("sensors");
    if (sensors == nullptr) return;
    for (const toml::node& id : *sensors) {
      const std::int64_t value = id.value_exact<std::int64_t>().value_or(-1);
      if (value < 0 || value > max_id)
        return fields_.fail(&id, "a sensor id is not a whole number from 0 on", "write sensors = [0, 1, 2]");
      column_.sensors.push_back(static_cast<SensorId>(value));
    }
  }

  void read_scan_keys() {
    if (column_.quantity != Quantity::scan) return;
    column_.laser = static_cast<std::uint32_t>(fields_.integer("laser", 0, max_id).value_or(0));
    const auto angle_min = fields_.angle("angle_min");
    const auto angle_step = fields_.angle("angle_step");
    if (!angle_min || !angle_step)
      fields_.fail(nullptr, "a scan needs the bearing of its first beam and the step to the next",
                   "write angle_min_deg = -90, angle_step_deg = 0.5");
    column_.angle_min = angle_min.value_or(Angle{});
    column_.angle_step = angle_step.value_or(Angle{});
    column_.no_echo = read_spelling("no_return").value_or(NoEchoSpelling{});
  }

 public:
  /// A number, a word, a list of both, or { above = number }, all as the file writes them.
  static std::optional<NoEchoSpelling> read_spelling(TomlFields& fields, std::string_view key) {
    const toml::node* node = fields.node(key);
    if (node == nullptr) return std::nullopt;
    NoEchoSpelling spelling;
    if (const toml::table* table = node->as_table()) {
      TomlFields rule(*table, fields.source(), key);
      spelling.above = rule.number("above").value_or(spelling.above);
      if (const Result<void> done = rule.finish(); !done) fields.fail(done.error());
    } else if (const toml::array* list = node->as_array(); list != nullptr && list->size() <= max_spellings) {
      for (const toml::node& element : *list) add_spelling(element, spelling);
      if (spelling.words.size() + spelling.values.size() != list->size()) spelling = {};
    } else {
      add_spelling(*node, spelling);
    }
    if (spelling.empty())
      fields.fail(
          node, fmt::format("{} is no spelling", key),
          fmt::format("write {0} = 5110, {0} = \"none\", a list of such, or {0} = {{ above = 4.999 }}, as the file "
                      "writes it",
                      key));
    return spelling;
  }

 private:
  static void add_spelling(const toml::node& node, NoEchoSpelling& spelling) {
    if (const auto* word = node.as_string()) spelling.words.push_back(word->get());
    if (node.is_number()) spelling.values.push_back(node.value<double>().value_or(0.0));
  }
  std::optional<NoEchoSpelling> read_spelling(std::string_view key) { return read_spelling(fields_, key); }

  TomlFields fields_;
  DelimitedColumn column_;
};

char read_delimiter(TomlFields& fields) {
  const std::string name = fields.text("delimiter").value_or("space");
  if (name == "space") return DelimitedTable::whitespace;
  if (name == "comma") return ',';
  if (name == "semicolon") return ';';
  if (name == "tab") return '\t';
  if (name.size() == 1) return name == " " ? DelimitedTable::whitespace : name[0];
  fields.fail(fields.node("delimiter"), fmt::format("\"{}\" is no delimiter", name),
              R"(use "space", "comma", "semicolon", "tab" or a single character)");
  return DelimitedTable::whitespace;
}

Result<DelimitedTable> read_table(const toml::table& toml, std::string_view source) {
  TomlFields fields(toml, source, "table");
  DelimitedTable table;
  table.file = fields.text("file").value_or("");
  table.delimiter = read_delimiter(fields);
  table.comment = fields.text("comment").value_or(table.comment);
  table.header = fields.boolean("header").value_or(table.header);
  table.skip_lines = static_cast<std::uint64_t>(fields.integer("skip_lines", 0, 1'000'000).value_or(0));
  table.rate_hz = fields.number("rate_hz", 1e-3, 1e6).value_or(0.0);
  table.wheel_counters = fields.boolean("wheel_counters").value_or(false);
  table.track_m = fields.length_m("track", 1e-3, 1000.0).value_or(0.0);
  const double metres_per_tick = fields.number("metres_per_tick", 1e-9, 1000.0).value_or(0.0);
  const NoEchoSpelling no_echo = ColumnReader::read_spelling(fields, "no_echo").value_or(NoEchoSpelling{});
  const auto columns = fields.tables("columns", static_cast<std::size_t>(max_column));
  if (columns.empty())
    fields.fail(nullptr, "the table has no columns", "list them: columns = [ { column = 1, quantity = \"time\" } ]");
  for (const toml::table* entry : columns) {
    Result<DelimitedColumn> column = ColumnReader(*entry, source).read(metres_per_tick, no_echo);
    if (!column) return column.error();
    table.columns.push_back(std::move(*column));
  }
  if (const Result<void> done = fields.finish(); !done) return done.error();
  if (const Result<void> checked = check_table(table); !checked) {
    Error error = checked.error();
    error.where = toml_place(source, toml.source());
    return error;
  }
  return table;
}

/// Ranges whose column says what no echo looks like arrive as +Inf; a sensor that was left to guess need not.
Result<void> settle_no_echo(DelimitedDescription& description) {
  const auto all_sensors = description.robot.sensors.sensors();
  std::vector<Sensor> sensors(all_sensors.begin(), all_sensors.end());
  for (const DelimitedTable& table : description.tables)
    for (const DelimitedColumn& column : table.columns)
      for (Sensor& sensor : sensors)
        if (!column.no_echo.empty() && std::ranges::count(column.sensors, sensor.id) > 0 &&
            sensor.model.no_echo.kind == NoEchoRule::Kind::automatic)
          sensor.model.no_echo.kind = NoEchoRule::Kind::inf;
  Result<SensorArray> array = SensorArray::make(std::move(sensors));
  if (!array) return array.error();
  description.robot.sensors = std::move(*array);
  return {};
}

Result<TableJoin> read_join(TomlFields& fields) {
  const std::string name = fields.text("join").value_or("time");
  if (name == "row") return TableJoin::row;
  if (name != "time")
    fields.fail(fields.node("join"), fmt::format("there is no join \"{}\"", name), R"(use "time" or "row")");
  return TableJoin::time;
}

}  // namespace

Result<DelimitedDescription> parse_description(std::string_view text, std::string_view source) {
  const Result<toml::table> toml = parse_toml(text, source);
  if (!toml) return toml.error();
  TomlFields fields(*toml, source, "the description");
  DelimitedDescription description;
  description.source = source;
  description.frame = fields.text("frame").value_or(description.frame);
  description.temperature_k = fields.number("temperature_k", 150.0, 400.0).value_or(description.temperature_k);
  if (const auto join = read_join(fields)) description.join = *join;
  if (const toml::table* robot = fields.table("robot")) {
    Result<RobotDescription> read = read_robot_table(*robot, source);
    if (!read) return read.error();
    description.robot = std::move(*read);
  }
  for (const toml::table* entry : fields.tables("table", max_tables)) {
    Result<DelimitedTable> table = read_table(*entry, source);
    if (!table) return table.error();
    description.tables.push_back(std::move(*table));
  }
  if (const Result<void> done = fields.finish(); !done) return done.error();
  if (const Result<void> checked = check_tables(description); !checked) return checked.error();
  if (const Result<void> settled = settle_no_echo(description); !settled) return settled.error();
  return description;
}

Result<DelimitedDescription> read_description(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, max_description_bytes);
  if (!text) return text.error();
  return parse_description(*text, path.string());
}

}  // namespace echoarc::io
