#include "carom/io/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "carom/base/error.hpp"
#include "carom/base/error_bar.hpp"
#include "carom/io/file.hpp"
#include "measurement_json.hpp"
#include "numbers.hpp"

namespace carom {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// A general warning of the measurement stands with each of its estimates.
Json as_json(const Estimate& estimate, const std::vector<std::string>& general) {
  std::vector<std::string> warnings = estimate.warnings;
  warnings.insert(warnings.end(), general.begin(), general.end());
  return {{"name", estimate.name},
          {"value", number_or_null(estimate.value)},
          {"error", number_or_null(estimate.error)},
          {"unit", estimate.unit},
          {"samples", estimate.samples},
          {"blocks", estimate.blocks},
          {"correlation_time", number_or_null(estimate.correlation_time)},
          {"theory", number_or_null(estimate.theory)},
          {"theory_source", estimate.theory_source},
          {"warnings", warnings}};
}

Json estimates_of(const Measurement& measurement) {
  Json estimates = Json::array();
  for (const Estimate& estimate : measurement.estimates) {
    estimates.push_back(as_json(estimate, measurement.warnings));
  }
  return estimates;
}

std::string file_of(const Table& table) { return table.name + ".csv"; }

Json as_json(const Table& table) {
  Json columns = Json::array();
  for (const Column& column : table.columns) {
    columns.push_back({{"name", column.name}, {"label", column.label}, {"unit", column.unit}});
  }
  return {{"name", table.name},
          {"file", file_of(table)},
          {"title", table.title},
          {"logarithmic_x", table.logarithmic_x},
          {"logarithmic_y", table.logarithmic_y},
          {"bars", table.bars},
          {"columns", columns}};
}

Json index_of(const std::vector<Measurement>& measurements) {
  Json list = Json::array();
  for (const Measurement& measurement : measurements) {
    Json tables = Json::array();
    for (const Table& table : measurement.tables) tables.push_back(as_json(table));
    list.push_back({{"name", measurement.name},
                    {"estimates", estimates_of(measurement)},
                    {"warnings", measurement.warnings},
                    {"tables", tables}});
  }
  return {{"observables", list}};
}

std::string dumped(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

/// "name value(error) unit, theory … (source)".
std::string described(const Estimate& estimate) {
  std::string text = fmt::format("{} = {}", estimate.name, with_error(estimate.value, estimate.error));
  if (!estimate.unit.empty()) text += ' ' + estimate.unit;
  if (estimate.theory) text += fmt::format(", theory {:.6g} ({})", *estimate.theory, estimate.theory_source);
  return text;
}

/// All warnings, each once; those of one estimate alone with its name.
std::vector<std::string> warnings_of(const Measurement& measurement) {
  std::vector<std::string> warnings = measurement.warnings;
  for (const Estimate& estimate : measurement.estimates) {
    for (const std::string& warning : estimate.warnings) {
      const auto has_it = [&warning](const Estimate& other) {
        return std::find(other.warnings.begin(), other.warnings.end(), warning) != other.warnings.end();
      };
      const auto sharing = std::count_if(measurement.estimates.begin(), measurement.estimates.end(), has_it);
      const std::string text = sharing > 1 ? warning : fmt::format("{}: {}", estimate.name, warning);
      if (std::find(warnings.begin(), warnings.end(), text) == warnings.end()) warnings.push_back(text);
    }
  }
  return warnings;
}

}  // namespace

std::string table_csv(const Table& table) {
  fmt::memory_buffer text;
  const auto end_with = [&text](std::size_t column, std::size_t columns) {
    text.push_back(column + 1 < columns ? ',' : '\n');
  };
  std::size_t rows = 0;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    rows = std::max(rows, table.columns[k].values.size());
    text.append(table.columns[k].name);
    end_with(k, table.columns.size());
  }
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      const std::vector<double>& values = table.columns[k].values;
      if (row < values.size() && std::isfinite(values[row])) {
        io::append_17_digits(text, values[row]);
      } else {
        text.append(std::string_view("nan"));
      }
      end_with(k, table.columns.size());
    }
  }
  return fmt::to_string(text);
}

void write_measurements(const std::vector<Measurement>& measurements, const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw Error("cannot be created: " + error.message(), {directory});
  const std::filesystem::path path(directory);
  for (const Measurement& measurement : measurements) {
    for (const Table& table : measurement.tables) write_file((path / file_of(table)).string(), table_csv(table));
  }
  write_file((path / "index.json").string(), dumped(index_of(measurements)));
}

nlohmann::ordered_json io::estimates_as_json(const std::vector<Measurement>& measurements) {
  Json json = Json::object();
  for (const Measurement& measurement : measurements) json[measurement.name] = estimates_of(measurement);
  return json;
}

std::string measurements_json(const std::vector<Measurement>& measurements) {
  return dumped(io::estimates_as_json(measurements));
}

std::string measurements_text(const std::vector<Measurement>& measurements) {
  fmt::memory_buffer text;
  const auto end = std::back_inserter(text);
  fmt::format_to(end, "Observables\n");
  for (const Measurement& measurement : measurements) {
    std::string_view label = measurement.name;
    const auto line = [&](std::string_view what) {
      fmt::format_to(end, "  {:<20} {}\n", label, what);
      label = "";
    };
    for (const Estimate& estimate : measurement.estimates) line(described(estimate));
    for (const std::string& warning : warnings_of(measurement)) line("warning: " + warning);
    std::string tables;
    for (const Table& table : measurement.tables) tables += (tables.empty() ? "" : ", ") + table.name;
    if (!tables.empty()) line((measurement.tables.size() == 1 ? "table " : "tables ") + tables);
  }
  return fmt::to_string(text);
}

}  // namespace carom
