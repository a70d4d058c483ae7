#include "observed.hpp"

#include "carom/io/measurements.hpp"

namespace carom {

std::vector<Measurement> Observed::finish(const std::optional<OutputDirectory>& directory) const {
  std::vector<Measurement> found = set_.results();
  if (directory && !found.empty()) write_measurements(found, directory->observables());
  return found;
}

}  // namespace carom
