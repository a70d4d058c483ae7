#include "checkpoint_keeper.hpp"

#include <cmath>
#include <utility>

namespace carom {

CheckpointKeeper::CheckpointKeeper(OutputDirectory directory, std::optional<double> every, double minutes, double now)
    : directory_(std::move(directory)), every_(every), pause_(60 * minutes), last_time_(now) {}

bool CheckpointKeeper::due(double now) const noexcept {
  // Multiples of `every`, so that a resumed run saves where the uninterrupted one does.
  if (every_ && std::floor(now / *every_) > std::floor(last_time_ / *every_)) return true;
  return WallClock::now() - last_saved_ >= pause_;
}

void CheckpointKeeper::save(const Checkpoint& checkpoint) {
  directory_.require_still_there();
  write_checkpoint(directory_.checkpoint(), directory_.previous_checkpoint(), checkpoint);
  last_time_ = checkpoint.snapshot.state.clock.start;
  last_saved_ = WallClock::now();
}

}  // namespace carom
