// Estimates from sums, and the warnings that come with them.
#pragma once

#include <optional>
#include <string>

#include "carom/observe/blocking.hpp"
#include "carom/run/measurement.hpp"

namespace carom {

/// Appends an estimate to a measurement: the mean of samples that are `spacing` (time) apart, with the error that
/// blocking finds, and a warning where the samples are too few to tell it. With `value`, that number instead of the
/// mean. The reference is valid until the next estimate is added.
Estimate& add_estimate(Measurement& measurement, std::string name, std::string unit, const Blocking& samples,
                       double spacing, std::optional<double> value = {});

/// Appends a number that blocking had nothing to do with.
Estimate& add_estimate(Measurement& measurement, std::string name, std::string unit, double value,
                       std::optional<double> error = {});

/// An estimate times a constant, under another name; its theory is scaled, too.
Estimate scaled(const Estimate& estimate, std::string name, std::string unit, double factor);

}  // namespace carom
