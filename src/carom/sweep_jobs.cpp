#include "sweep_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "carom/base/error.hpp"
#include "carom/base/random.hpp"
#include "carom/carom/scene_keys.hpp"

namespace carom {
namespace {

constexpr std::uint32_t kSweepSeeds = 0x53574550;  // purpose of the random stream: no other part of carom uses it
constexpr double kMostJobs = 1e6;

bool varies_seeds(const SweepPlan& plan) {
  return std::any_of(plan.varied.begin(), plan.varied.end(), [](const VariedKey& varied) {
    const std::string key = full_scene_key(varied.key);
    return key.starts_with("gas.") && key.ends_with(".seed");
  });
}

bool varies_disks(const SweepPlan& plan) {
  return std::any_of(plan.varied.begin(), plan.varied.end(),
                     [](const VariedKey& varied) { return varied.key.starts_with("disk."); });
}

/// Seeds of different jobs differ, and fit exactly into doubles and TOML's integers.
std::uint64_t derived_seed(std::uint64_t seed, std::size_t index) {
  return (RandomStream(seed, 0, kSweepSeeds).bits() >> 12) + index;
}

void check(const SweepPlan& plan) {
  double jobs = static_cast<double>(plan.replicas);
  for (const VariedKey& varied : plan.varied) {
    if (varied.values.empty()) throw Error(varied.key + ": there are no values");
    jobs *= static_cast<double>(varied.values.size());
    const auto same = [&](const VariedKey& other) { return full_scene_key(other.key) == full_scene_key(varied.key); };
    if (std::count_if(plan.varied.begin(), plan.varied.end(), same) > 1) {
      throw Error(varied.key + " is varied twice");
    }
  }
  if (plan.replicas < 1) throw Error("a sweep needs at least one replica");
  if (jobs > kMostJobs)
    throw Error(fmt::format("these would be {:g} jobs: no sweep has more than {:g}", jobs, kMostJobs));
  if (plan.replicas == 1) return;
  if (plan.file.scene.gas.empty()) {
    throw Error("the scene has no [[gas]]: nothing in it is random, so all replicas would be the same");
  }
  if (varies_seeds(plan)) throw Error("seeds are varied, so all replicas would be the same");
}

std::string name_of(const SweepPlan& plan, const SweepJob& job) {
  std::string name;
  for (std::size_t k = 0; k < plan.varied.size(); ++k) {
    name += fmt::format("{}={},", plan.varied[k].key, job.values[k]);
  }
  return name + fmt::format("replica={}", job.replica);
}

}  // namespace

SceneFile scene_of_job(const SweepPlan& plan, const SweepJob& job, std::size_t index) {
  SceneFile file = plan.file;
  for (GasSpec& gas : file.scene.gas) gas.seed = derived_seed(gas.seed, index);
  for (std::size_t k = 0; k < plan.varied.size(); ++k) set_scene_key(file, plan.varied[k].key, job.values[k]);
  return file;
}

std::vector<SweepJob> jobs_of_sweep(const SweepPlan& plan) {
  check(plan);
  std::size_t points = 1;
  for (const VariedKey& varied : plan.varied) points *= varied.values.size();
  std::vector<SweepJob> jobs;
  for (std::size_t point = 0; point < points; ++point) {
    SweepJob job;
    std::size_t rest = point;
    for (auto varied = plan.varied.rbegin(); varied != plan.varied.rend(); ++varied) {
      job.values.push_back(varied->values[rest % varied->values.size()]);
      rest /= varied->values.size();
    }
    std::reverse(job.values.begin(), job.values.end());
    for (job.replica = 1; job.replica <= plan.replicas; ++job.replica) {
      job.name = name_of(plan, job);
      jobs.push_back(job);
    }
  }
  // The scene itself, not its disks one by one: explicit ones are the same in every job.
  SweepPlan without_disks = plan;
  if (without_disks.file.scene.disks.size() > 1) without_disks.file.scene.disks.resize(1);
  for (std::size_t index = 0; index < jobs.size(); ++index) {
    const SceneFile file = scene_of_job(varies_disks(plan) ? plan : without_disks, jobs[index], index);
    if (!file.scene.gas.empty()) jobs[index].seed = file.scene.gas.front().seed;
  }
  return jobs;
}

std::vector<Problem> problems_of_job(const SweepPlan& plan, const SweepJob& job, std::size_t index) {
  std::vector<Problem> problems;
  try {
    SceneFile file = scene_of_job(plan, job, index);
    if (!file.run.until && !file.run.collisions) throw Error("a run needs an end: a time or a number of collisions");
    problems = problems_of(file.scene);
    // The reader knows the range of every key. Disks that are not varied were read before.
    if (!varies_disks(plan)) file.scene.disks.clear();
    if (problems.empty()) parse_scene(to_toml(file), "scene.toml");
  } catch (const Error& error) {
    problems = error.problems();
  }
  for (Problem& problem : problems) problem.place = {job.name, 0, 0};
  return problems;
}

}  // namespace carom
