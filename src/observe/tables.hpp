// Columns of tables with their errors.
#pragma once

#include <limits>

#include "carom/observe/batches.hpp"
#include "carom/run/measurement.hpp"

namespace carom {

/// The empty column that holds the errors of another.
inline Column error_column(const Column& of) { return {of.name + "_error", "error of " + of.label, of.unit, {}}; }

/// Appends a value and its error (NaN where it is absent) to their columns.
inline void append(Column& value, Column& error, const Batches::Value& entry) {
  value.values.push_back(entry.value);
  error.values.push_back(entry.error.value_or(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace carom
