#include "columns.hpp"

#include <cstddef>
#include <limits>
#include <utility>

namespace carom {

void append_columns(Table& table, const Column& heading, const std::vector<Batches::Value>& values) {
  Column means = heading;
  Column errors{heading.name + "_error", "standard error of " + heading.label, heading.unit, {}};
  for (const Batches::Value& value : values) {
    means.values.push_back(value.value);
    errors.values.push_back(value.error.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  table.columns.push_back(std::move(means));
  table.columns.push_back(std::move(errors));
}

std::vector<Batches::Value> means_of(const Batches& batches) {
  std::vector<Batches::Value> means;
  for (std::size_t column = 0; column < batches.columns(); ++column) means.push_back(batches.mean(column));
  return means;
}

}  // namespace carom
