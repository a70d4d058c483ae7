#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "carom/io/sweep_files.hpp"

namespace carom {
namespace {

/// A number of one row, with its own standard error where it has one.
struct Quantity {
  std::string name;
  std::optional<double> value;
  std::optional<double> error;
  std::string unit = {};
  std::optional<double> theory = {};
};

std::optional<double> finite(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> compressibility_factor(const SweepRow& row) {
  if (!row.results.pressure || !row.number_density) return std::nullopt;
  return *row.results.pressure / *row.number_density;
}

/// What the report says, in the order of columns.
std::vector<Quantity> reported(const SweepRow& row) {
  const RunResults& results = row.results;
  return {{"packing_fraction", results.packing_fraction, {}},
          {"time", results.time, {}},
          {"collisions", static_cast<double>(results.collisions), {}},
          {"temperature", results.temperature, {}},
          {"pressure", results.pressure, {}},
          {"Z", compressibility_factor(row), {}}};
}

std::vector<Quantity> observed(const SweepRow& row) {
  std::vector<Quantity> quantities;
  for (const Measurement& measurement : row.measurements) {
    for (const Estimate& estimate : measurement.estimates) {
      quantities.push_back({measurement.name + '.' + estimate.name, finite(estimate.value), finite(estimate.error),
                            estimate.unit, finite(estimate.theory)});
    }
  }
  return quantities;
}

const Quantity* find(const std::vector<Quantity>& quantities, const std::string& name) {
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const Quantity& quantity) { return quantity.name == name; });
  return found == quantities.end() ? nullptr : &*found;
}

/// The names of all rows' estimates, in the order in which they first occur.
std::vector<std::string> names_observed(const std::vector<SweepRow>& rows) {
  std::vector<std::string> names;
  for (const SweepRow& row : rows) {
    for (const Quantity& quantity : observed(row)) {
      if (std::find(names.begin(), names.end(), quantity.name) == names.end()) names.push_back(quantity.name);
    }
  }
  return names;
}

/// Columns of sweep.csv beside varied keys and estimates.
constexpr std::array<std::string_view, 10> kColumns{
    "replica", "seed", "disks", "packing_fraction", "time", "collisions", "temperature", "pressure", "Z", "digest"};

/// A varied key as the name of a column, where need be in full: no two columns have one name.
std::string column_of(const VariedKey& varied) {
  if (std::find(kColumns.begin(), kColumns.end(), varied.key) == kColumns.end()) return varied.key;
  return varied.key == "disks" ? "gas.count" : "gas." + varied.key;
}

/// Lines of a CSV file, field by field. Fields with commas or quotation marks are quoted.
class CsvText {
 public:
  void field(std::string_view text) {
    begin_field();
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
      text_ += text;
      return;
    }
    text_ += '"';
    for (const char letter : text) text_ += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    text_ += '"';
  }
  /// The shortest decimals that read back to the same bits; nothing if there is no number.
  void number(const std::optional<double>& value) {
    begin_field();
    if (value) fmt::format_to(std::back_inserter(text_), "{}", *value);
  }
  void count(std::uint64_t value) {
    begin_field();
    fmt::format_to(std::back_inserter(text_), "{}", value);
  }
  void end_line() {
    text_ += '\n';
    begun_ = false;
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  void begin_field() {
    if (begun_) text_ += ',';
    begun_ = true;
  }

  std::string text_;
  bool begun_ = false;
};

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double standard_error(const std::vector<double>& values, double mean) {
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto count = static_cast<double>(values.size());
  return std::sqrt(squares / (count - 1) / count);
}

SweepMean::Quantity averaged(const std::string& name, const std::vector<Quantity>& samples) {
  SweepMean::Quantity result{name, {}, {}};
  std::vector<double> values, theories;
  for (const Quantity& sample : samples) {
    if (sample.value) values.push_back(*sample.value);
    if (sample.theory) theories.push_back(*sample.theory);
    if (!sample.unit.empty()) result.unit = sample.unit;
  }
  if (!theories.empty() && theories.size() == samples.size()) result.theory = mean_of(theories);
  if (values.empty()) return result;
  result.mean = mean_of(values);
  if (values.size() > 1) result.error = standard_error(values, *result.mean);
  if (values.size() == 1 && samples.size() == 1) result.error = samples.front().error;
  return result;
}

/// The rows [begin, end) are the replicas of one point.
SweepMean mean_of_point(const std::vector<SweepRow>& rows, std::size_t begin, std::size_t end,
                        const std::vector<std::string>& names) {
  SweepMean mean{rows[begin].job.values, end - begin, {}};
  std::vector<std::vector<Quantity>> samples;
  for (std::size_t k = begin; k < end; ++k) {
    samples.push_back(reported(rows[k]));
    const std::vector<Quantity> estimates = observed(rows[k]);
    samples.back().insert(samples.back().end(), estimates.begin(), estimates.end());
  }
  for (const std::string& name : names) {
    std::vector<Quantity> same;
    for (const std::vector<Quantity>& one : samples) {
      const Quantity* const quantity = find(one, name);
      same.push_back(quantity != nullptr ? *quantity : Quantity{name, {}, {}});
    }
    mean.quantities.push_back(averaged(name, same));
  }
  return mean;
}

}  // namespace

std::vector<SweepMean> means_of(const std::vector<SweepRow>& rows) {
  std::vector<SweepMean> means;
  if (rows.empty()) return means;
  std::vector<std::string> names;
  for (const Quantity& quantity : reported(rows.front())) names.push_back(quantity.name);
  const std::vector<std::string> estimates = names_observed(rows);
  names.insert(names.end(), estimates.begin(), estimates.end());
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin;
    while (end < rows.size() && rows[end].job.values == rows[begin].job.values) ++end;
    means.push_back(mean_of_point(rows, begin, end, names));
    begin = end;
  }
  return means;
}

std::string sweep_csv(const std::vector<VariedKey>& varied, const std::vector<SweepRow>& rows) {
  const std::vector<std::string> estimates = names_observed(rows);
  CsvText csv;
  for (const VariedKey& key : varied) csv.field(column_of(key));
  for (const std::string_view name : kColumns) csv.field(name);
  for (const std::string& name : estimates) {
    csv.field(name);
    csv.field(name + "_error");
  }
  csv.end_line();
  for (const SweepRow& row : rows) {
    for (const double value : row.job.values) csv.number(value);
    csv.count(row.job.replica);
    csv.count(row.job.seed);
    csv.count(row.results.disks);
    csv.number(row.results.packing_fraction);
    csv.number(row.results.time);
    csv.count(row.results.collisions);
    csv.number(row.results.temperature);
    csv.number(row.results.pressure);
    csv.number(compressibility_factor(row));
    csv.field(row.results.digest);
    const std::vector<Quantity> quantities = observed(row);
    for (const std::string& name : estimates) {
      const Quantity* const quantity = find(quantities, name);
      csv.number(quantity != nullptr ? quantity->value : std::nullopt);
      csv.number(quantity != nullptr ? quantity->error : std::nullopt);
    }
    csv.end_line();
  }
  return csv.take();
}

std::string sweep_mean_csv(const std::vector<VariedKey>& varied, const std::vector<SweepMean>& means) {
  CsvText csv;
  for (const VariedKey& key : varied) csv.field(column_of(key));
  csv.field("replicas");
  if (!means.empty()) {
    for (const SweepMean::Quantity& quantity : means.front().quantities) {
      csv.field(quantity.name);
      csv.field(quantity.name + "_error");
    }
  }
  csv.end_line();
  for (const SweepMean& mean : means) {
    for (const double value : mean.values) csv.number(value);
    csv.count(mean.replicas);
    for (const SweepMean::Quantity& quantity : mean.quantities) {
      csv.number(quantity.mean);
      csv.number(quantity.error);
    }
    csv.end_line();
  }
  return csv.take();
}

}  // namespace carom
