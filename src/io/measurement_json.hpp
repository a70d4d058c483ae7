// Estimates as JSON, for all reports that hold some.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "carom/run/measurement.hpp"

namespace carom::io {

/// Observable → list of estimates.
nlohmann::ordered_json estimates_as_json(const std::vector<Measurement>& measurements);

}  // namespace carom::io
