#include "carom/io/run_results.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "carom/base/error.hpp"
#include "carom/io/file.hpp"
#include "csv_rows.hpp"
#include "numbers.hpp"

namespace carom {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Parses a file and lets `take` read from it; whatever is malformed is an Error that names the file.
template <typename Take>
auto read_json(const std::string& path, Take take) {
  const std::string text = read_file(path);
  try {
    return take(json::parse(text));
  } catch (const json::exception& error) {
    throw Error(std::string("is not what carom writes: ") + error.what(), {path});
  }
}

std::optional<double> number_or_nothing(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return std::nullopt;
  return found->get<double>();
}

Estimate estimate_of(const json& object) {
  Estimate estimate;
  estimate.name = object.at("name").get<std::string>();
  estimate.unit = object.value("unit", "");
  estimate.value = number_or_nothing(object, "value").value_or(kNone);
  estimate.error = number_or_nothing(object, "error");
  estimate.samples = object.value("samples", std::uint64_t{0});
  estimate.blocks = object.value("blocks", std::uint64_t{0});
  estimate.correlation_time = number_or_nothing(object, "correlation_time");
  estimate.theory = number_or_nothing(object, "theory");
  estimate.theory_source = object.value("theory_source", "");
  return estimate;
}

/// Only letters that a name of a file beside the index can have: nothing outside is read.
void refuse_path(const std::string& file, const std::string& index) {
  if (file.empty() || file.find('/') != std::string::npos || file == "." || file == "..") {
    throw Error("names the file '" + file + "', which is not one beside it", {index});
  }
}

/// Values by the names in the file's header; columns that the index does not know come last.
void read_values(const std::string& path, Table& table) {
  const std::string text = read_file(path);
  io::CsvRows rows(text, path);
  io::CsvRow row;
  if (!rows.next(row)) return;
  std::vector<std::size_t> column_of_field;
  for (const std::string& name : row.fields) {
    std::size_t index = 0;
    while (index < table.columns.size() && table.columns[index].name != name) ++index;
    if (index == table.columns.size()) table.columns.push_back({name, "", "", {}});
    column_of_field.push_back(index);
  }
  while (rows.next(row)) {
    for (Column& column : table.columns) column.values.push_back(kNone);
    for (std::size_t field = 0; field < std::min(row.fields.size(), column_of_field.size()); ++field) {
      const io::ParsedNumber number = io::parse_number(row.fields[field]);
      if (number.fault.empty()) table.columns[column_of_field[field]].values.back() = number.value;
    }
  }
}

Table table_of(const json& object) {
  Table table;
  table.name = object.at("name").get<std::string>();
  table.title = object.value("title", "");
  table.logarithmic_x = object.value("logarithmic_x", false);
  table.logarithmic_y = object.value("logarithmic_y", false);
  table.bars = object.value("bars", false);
  for (const json& column : object.value("columns", json::array())) {
    table.columns.push_back(
        {column.at("name").get<std::string>(), column.value("label", ""), column.value("unit", ""), {}});
  }
  return table;
}

Measurement measurement_of(const json& object, const std::string& index, bool tables) {
  Measurement measurement;
  measurement.name = object.at("name").get<std::string>();
  for (const json& estimate : object.value("estimates", json::array())) {
    measurement.estimates.push_back(estimate_of(estimate));
  }
  for (const json& entry : object.value("tables", json::array())) {
    Table table = table_of(entry);
    const std::string file = entry.value("file", table.name + ".csv");
    refuse_path(file, index);
    if (tables) read_values((fs::path(index).parent_path() / file).string(), table);
    measurement.tables.push_back(std::move(table));
  }
  measurement.warnings = object.value("warnings", std::vector<std::string>{});
  return measurement;
}

}  // namespace

RunResults read_run_results(const std::string& directory) {
  const std::string path = (fs::path(directory) / "report.json").string();
  return read_json(path, [](const json& report) {
    RunResults results;
    results.disks = report.at("disks").get<std::uint64_t>();
    results.packing_fraction = number_or_nothing(report, "packing_fraction");
    results.time = report.at("time").get<double>();
    results.collisions = report.at("collisions").get<std::uint64_t>();
    results.wall_collisions = report.at("wall_collisions").get<std::uint64_t>();
    results.temperature = number_or_nothing(report, "temperature");
    results.pressure = number_or_nothing(report, "pressure");
    results.digest = report.at("digest").get<std::string>();
    return results;
  });
}

std::vector<Measurement> read_measurements(const std::string& directory, bool tables) {
  const std::string path = (fs::path(directory) / "observables" / "index.json").string();
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return {};
  return read_json(path, [&](const json& index) {
    std::vector<Measurement> measurements;
    for (const json& entry : index.at("observables")) measurements.push_back(measurement_of(entry, path, tables));
    return measurements;
  });
}

}  // namespace carom
