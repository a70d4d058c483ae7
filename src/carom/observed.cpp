#include "observed.hpp"

#include "carom/base/error.hpp"
#include "carom/io/measurements.hpp"

namespace carom {
namespace {

const Frame& start_in(const Checkpoint& checkpoint) {
  const bool needed = !checkpoint.settings.observe.empty();
  if (needed && !checkpoint.start) throw Error("the checkpoint lacks what its observables need: their start");
  return needed ? *checkpoint.start : checkpoint.snapshot.state.disks;
}

}  // namespace

Observed::Observed(const Checkpoint& checkpoint)
    : set_(checkpoint.settings.observe, {checkpoint.snapshot.system, start_in(checkpoint)}), start_(checkpoint.start) {
  SavedSums sums = checkpoint.sums;
  if (!set_.empty()) set_.exchange({sums, SumsExchange::Direction::load});
}

void Observed::keep_in(Checkpoint& checkpoint) {
  checkpoint.start = start_;
  if (!set_.empty()) set_.exchange({checkpoint.sums, SumsExchange::Direction::save});
}

std::vector<Measurement> Observed::finish(const std::optional<OutputDirectory>& directory) const {
  std::vector<Measurement> found = set_.results();
  if (directory && !found.empty()) write_measurements(found, directory->observables());
  return found;
}

}  // namespace carom
