// The scenes of a sweep's jobs.
#pragma once

#include "carom/carom/sweep.hpp"

namespace carom {

/// The scene of one job: the plan's, with the job's values and seeds. `index` counts jobs from 0.
SceneFile scene_of_job(const SweepPlan& plan, const SweepJob& job, std::size_t index);

/// Everything that is wrong with the job's scene, as the reader of scene files and realize() find it.
std::vector<Problem> problems_of_job(const SweepPlan& plan, const SweepJob& job, std::size_t index);

}  // namespace carom
