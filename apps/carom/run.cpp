// carom run: the main job.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "carom/carom.hpp"
#include "command.hpp"
#include "environment.hpp"
#include "options.hpp"
#include "run_shared.hpp"

namespace carom::program {
namespace {

const std::map<std::string, std::optional<TrajectoryFormat>> kTrajectories{
    {"xyz", TrajectoryFormat::xyz}, {"h5md", TrajectoryFormat::h5md}, {"none", TrajectoryFormat::none}};

struct RunOptions {
  std::string scene;
  std::optional<double> until;
  std::optional<std::uint64_t> collisions;
  std::optional<double> equilibrate;
  SolverKind solver = SolverKind::fast;
  ParallelOptions parallel;
  std::optional<std::uint64_t> seed;
  std::string out;
  std::optional<double> every;
  std::optional<TrajectoryFormat> trajectory;
  std::string log_collisions;
  SavingOptions saving;
  std::vector<ObserveSpec> observe;
  bool overwrite = false;
  bool json = false;
  bool quiet = false;
};

void check_options(const RunOptions& options) {
  require_time("--until", options.until, true);
  require_time("--every", options.every, false);
  require_time("--equilibrate", options.equilibrate, true);
  require_collisions(options.collisions);
  std::error_code not_there;
  if (options.log_collisions == "-") throw UsageError("--log-collisions needs the name of a file");
  if (!options.log_collisions.empty() &&
      std::filesystem::equivalent(options.log_collisions, options.scene, not_there)) {
    throw UsageError("--log-collisions " + options.log_collisions + ": this is the scene, which would be lost");
  }
  check_saving(options.saving, !options.out.empty());
  if (!options.out.empty()) return;
  if (options.every) throw UsageError("--every writes frames of the trajectory: it needs --out DIR");
  if (options.trajectory.value_or(TrajectoryFormat::none) != TrajectoryFormat::none) {
    throw UsageError("--trajectory needs --out DIR");
  }
  if (options.overwrite) throw UsageError("--overwrite goes with --out DIR");
}

/// The command line's words take the place of the scene's.
RunSettings settled(RunSettings settings, const RunOptions& options) {
  if (options.until || options.collisions) {
    settings.until = options.until;
    settings.collisions = options.collisions;
  }
  if (!settings.until && !settings.collisions) {
    throw UsageError(options.scene + ": when should the run end? Give --until TIME or --collisions NUMBER");
  }
  if (options.equilibrate) settings.equilibrate = *options.equilibrate;
  if (!options.observe.empty()) settings.observe = options.observe;
  if (options.every) settings.every = options.every;
  if (options.every && settings.trajectory == TrajectoryFormat::none) settings.trajectory = TrajectoryFormat::xyz;
  if (options.trajectory) settings.trajectory = *options.trajectory;
  if (!options.out.empty() && settings.trajectory == TrajectoryFormat::h5md) require_hdf5("H5MD trajectories need");
  if (!options.out.empty() && settings.trajectory != TrajectoryFormat::none && !settings.every) {
    throw UsageError("a trajectory needs --every DT (or `every` in the scene), the time between two frames");
  }
  if (settings.until && *settings.until > kLatestTime) {
    throw Error(fmt::format("until is {}: no run goes beyond time {}", *settings.until, kLatestTime));
  }
  return settings;
}

std::string observable_names() {
  std::string names;
  for (const ObservableKind& kind : observable_kinds()) names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

void reseed(Scene& scene, std::uint64_t seed) {
  if (scene.gas.empty()) throw UsageError("--seed: the scene has no [[gas]], nothing in it is random");
  for (GasSpec& gas : scene.gas) gas.seed = seed;
}

int run_command(const RunOptions& options) {
  check_options(options);
  SceneFile file = read_scene(options.scene);
  if (options.seed) reseed(file.scene, *options.seed);

  RunPlan plan;
  plan.settings = settled(file.run, options);
  plan.solver.kind = options.solver;
  plan.solver.simd = simd_from_environment();
  plan.parallel = options.parallel;
  plan.title = file.scene.title;
  plan.command = command_line();
  Setup setup = realize_here(file.scene);
  if (!options.out.empty()) plan.directory.emplace(options.out, options.overwrite);
  if (!options.log_collisions.empty()) plan.collisions_file = options.log_collisions;

  apply(options.saving, plan);
  const RunEnd end = with_progress(plan, options.quiet, [&] { return run_scene(std::move(setup), plan); });
  return conclude(end, options.json, options.out);
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "run", "Simulate a scene", "carom run scenes/gas.toml --collisions 5000");
  mention_simd_variable(*command);
  const auto options = std::make_shared<RunOptions>();
  command
      ->add_option("SCENE", options->scene,
                   "a scene (TOML), an algs4 CollisionSystem file, the last frame of an extended XYZ or H5MD\n"
                   "file, a checkpoint, or -")
      ->required()
      ->type_name("");
  add_number(*command, "--until", options->until, "simulate to this time");
  add_count(*command, "--collisions", options->collisions,
            "stop at the first window's end at or after so many collisions");
  add_number(*command, "--equilibrate", options->equilibrate,
             "start pressure and observables at the first window after this time");
  add_observables(*command, "--observe", options->observe,
                  "measure these observables instead of the scene's: " + observable_names());
  add_solver(*command, options->solver);
  add_parallel(*command, options->parallel);
  add_count(*command, "--seed", options->seed, "take the place of the seeds in the scene");
  add_path(*command, "--out", options->out, "DIR",
           "directory for report.json, scene.toml, final.xyz, checkpoints and the trajectory");
  add_number(*command, "--every", options->every, "time between two frames of the trajectory");
  add_choice(*command, "--trajectory", options->trajectory, kTrajectories,
             "format of the trajectory: xyz, h5md or none");
  add_path(*command, "--log-collisions", options->log_collisions, "FILE", "write every collision to this CSV file");
  add_saving(*command, options->saving);
  command->add_flag("--overwrite", options->overwrite, "replace the run that is in the directory");
  command->add_flag("--json", options->json, "print the report as one JSON object");
  command->add_flag("--quiet", options->quiet, "show no progress");
  command->callback([options, &action] { action = [options] { return run_command(*options); }; });
}

}  // namespace carom::program
