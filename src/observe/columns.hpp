// Columns of tables from values with errors.
#pragma once

#include <vector>

#include "carom/observe/batches.hpp"
#include "carom/run/measurement.hpp"

namespace carom {

/// Appends a column headed as `heading`, and the errors as the column "NAME_error"; NaN where there is none.
void append_columns(Table& table, const Column& heading, const std::vector<Batches::Value>& values);

/// Means of the columns of `batches`, in their order.
std::vector<Batches::Value> means_of(const Batches& batches);

}  // namespace carom
