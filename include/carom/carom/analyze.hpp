// Observables of a trajectory that was saved.
#pragma once

#include <string>
#include <vector>

#include "carom/run/measurement.hpp"
#include "carom/run/settings.hpp"

namespace carom {

/// Names of the observables that frames are enough for.
std::vector<std::string> observables_of_frames();

/// What the observables find in the frames of an extended XYZ file, or of DIR/trajectory.xyz if `path` is the directory
/// of a run. All frames must have the same disks and box; times must grow. Windings are found from frame to frame by
/// the nearest image, which is right as long as no disk moves farther than half a box in between: where that may fail,
/// `msd` has a warning. Without specifications: all that these frames have. Throws Error if a frame cannot be read or
/// an observable cannot be had from frames.
std::vector<Measurement> analyze(const std::string& path, const std::vector<ObserveSpec>& specs);

}  // namespace carom
