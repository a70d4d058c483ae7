#include "estimates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace carom {

Estimate& add_estimate(Measurement& measurement, std::string name, std::string unit, const Blocking& samples,
                       double spacing, std::optional<double> value) {
  const Blocking::Result result = samples.result();
  Estimate estimate;
  estimate.name = std::move(name);
  estimate.unit = std::move(unit);
  estimate.value = value.value_or(result.mean);
  estimate.error = result.error;
  estimate.samples = result.samples;
  estimate.blocks = result.blocks;
  if (result.error) estimate.correlation_time = result.correlation * spacing;
  constexpr double kRounding = 1e-12;
  const bool constant = result.error && *result.error <= kRounding * std::abs(result.mean);
  if (result.blocks == 0 && !constant) {
    estimate.warnings.push_back(fmt::format("the run is too short to tell the error: {} sample{}{}", result.samples,
                                            result.samples == 1 ? "" : "s",
                                            result.error ? ", and it may be larger than shown" : ""));
  }
  measurement.estimates.push_back(std::move(estimate));
  return measurement.estimates.back();
}

Estimate& add_estimate(Measurement& measurement, std::string name, std::string unit, double value,
                       std::optional<double> error) {
  Estimate estimate;
  estimate.name = std::move(name);
  estimate.unit = std::move(unit);
  estimate.value = value;
  estimate.error = error;
  measurement.estimates.push_back(std::move(estimate));
  return measurement.estimates.back();
}

Estimate scaled(const Estimate& estimate, std::string name, std::string unit, double factor) {
  Estimate other = estimate;
  other.name = std::move(name);
  other.unit = std::move(unit);
  other.value *= factor;
  if (other.error) *other.error *= std::abs(factor);
  if (other.theory) *other.theory *= factor;
  return other;
}

}  // namespace carom
