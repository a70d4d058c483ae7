// carom sweep: one scene run many times with some of its numbers varied.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "carom/carom.hpp"
#include "command.hpp"
#include "environment.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "plots.hpp"
#include "progress.hpp"
#include "run_shared.hpp"
#include "variation.hpp"

namespace carom::program {
namespace {

constexpr std::uint64_t kMostThreads = 1024;

struct SweepOptions {
  std::string scene;
  std::vector<std::string> vary;
  std::uint64_t replicas = 1;
  std::uint64_t threads = 1;
  std::string out;
  std::optional<double> until;
  std::optional<std::uint64_t> collisions;
  std::optional<double> equilibrate;
  std::vector<ObserveSpec> observe;
  std::optional<std::uint64_t> seed;
  SolverKind solver = SolverKind::fast;
  SavingOptions saving;
  bool json = false;
  bool quiet = false;
};

/// The command line's words take the place of the scene's.
SceneFile settled(SceneFile file, const SweepOptions& options) {
  if (options.until || options.collisions) {
    file.run.until = options.until;
    file.run.collisions = options.collisions;
  }
  if (!options.observe.empty()) file.run.observe = options.observe;
  if (options.equilibrate) file.run.equilibrate = *options.equilibrate;
  if (options.seed) {
    if (file.scene.gas.empty()) throw UsageError("--seed: the scene has no [[gas]], nothing in it is random");
    for (GasSpec& gas : file.scene.gas) gas.seed = *options.seed;
  }
  return file;
}

void check_options(const SweepOptions& options) {
  if (options.replicas == 0) throw UsageError("--replicas 0: it must be greater than 0");
  if (options.threads < 1 || options.threads > kMostThreads) {
    throw UsageError(fmt::format("--threads {}: it must be from 1 to {}", options.threads, kMostThreads));
  }
  if (options.until && !(*options.until > 0 && *options.until <= kLatestTime)) {
    throw UsageError(fmt::format("--until {}: it must be a time greater than 0", *options.until));
  }
  if (options.collisions && *options.collisions == 0) throw UsageError("--collisions 0: it must be greater than 0");
  require_collisions(options.collisions);
  if (options.equilibrate && !(*options.equilibrate >= 0)) {
    throw UsageError(fmt::format("--equilibrate {}: it must be a time, 0 or more", *options.equilibrate));
  }
  check_saving(options.saving, true);
}

/// Every value in the scene: what cannot be varied, or not so, is a matter of the command line.
void try_variations(const SweepPlan& plan, const std::string& scene) {
  SceneFile tried = plan.file;
  try {
    for (const VariedKey& varied : plan.varied) {
      for (const double value : varied.values) set_scene_key(tried, varied.key, value);
    }
    jobs_of_sweep(plan);
  } catch (const Error& error) {
    throw UsageError(fmt::format("--vary in {}: {}", scene, error.problems().front().message));
  }
  if (tried.run.until || tried.run.collisions) return;
  throw UsageError(scene + ": when should the runs end? Give --until TIME or --collisions NUMBER");
}

SweepPlan planned(const SweepOptions& options) {
  check_options(options);
  SweepPlan plan;
  for (const std::string& text : options.vary) plan.varied.push_back(parse_variation(text));
  plan.replicas = options.replicas;
  plan.threads = static_cast<unsigned>(options.threads);
  plan.directory = options.out;
  plan.solver.kind = options.solver;
  plan.solver.simd = simd_from_environment();
  plan.checkpoint_every = options.saving.checkpoint_every;
  if (options.saving.checkpoint_minutes) plan.checkpoint_minutes = *options.saving.checkpoint_minutes;
  plan.command = command_line();
  plan.file = settled(read_scene(options.scene), options);
  try_variations(plan, options.scene);
  return plan;
}

std::string summary_json(const SweepEnd& end, const SweepOptions& options, const std::vector<std::string>& plots) {
  nlohmann::ordered_json json;
  json["jobs"] = end.jobs;
  json["finished"] = end.rows.size();
  json["kept"] = end.kept;
  json["resumed"] = end.resumed;
  json["interrupted"] = end.interrupted;
  json["directory"] = options.out;
  json["table"] = options.out + "/sweep.csv";
  json["means"] = options.out + "/sweep_mean.csv";
  json["plots"] = plots;
  json["version"] = version();
  json["command"] = command_line();
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string summary_text(const SweepEnd& end, const SweepOptions& options, const std::vector<std::string>& plots) {
  std::string text = fmt::format("{} of {} jobs are finished", end.rows.size(), end.jobs);
  if (end.kept > 0) text += fmt::format(", {} of them by an earlier sweep", end.kept);
  if (end.resumed > 0) text += fmt::format("; {} went on from checkpoints", end.resumed);
  text += fmt::format("\n  each job       {0}/sweep.csv\n  averages       {0}/sweep_mean.csv\n", options.out);
  for (const std::string& plot : plots) text += fmt::format("  plot           {}\n", plot);
  return text;
}

int conclude(const SweepEnd& end) {
  bool sound = end.failures.empty();
  for (const std::string& damaged : end.damaged) tell(damaged + "; the job went on from the one before it");
  for (const std::string& failure : end.failures) tell(failure);
  for (const SweepRow& row : end.rows) {
    for (const std::string& violation : row.violations) {
      tell(fmt::format("DO NOT TRUST {}: {}", row.job.name, violation));
      sound = false;
    }
  }
  if (end.interrupted) {
    tell("interrupted; the same command goes on");
    return kInterrupted;
  }
  return sound ? kSuccess : kFailure;
}

int sweep_command(const SweepOptions& options) {
  SweepPlan plan = planned(options);
  ProgressBar bar(!options.quiet);
  if (bar.visible()) {
    plan.progress = [&bar](const SweepProgress& now) {
      bar.show({now.done, 0, now.collisions, fmt::format("{} of {} jobs", now.finished, now.jobs)});
    };
  }
  plan.interrupt = &catch_interrupts();
  const SweepEnd end = run_sweep(plan);
  bar.clear();
  const std::vector<std::string> plots = end.rows.empty() ? std::vector<std::string>{} : draw_sweep(options.out);
  print(options.json ? summary_json(end, options, plots) : summary_text(end, options, plots));
  return conclude(end);
}

}  // namespace

void add_sweep(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "sweep", "Run a scene many times with some of its numbers varied",
                                  "carom sweep scenes/gas.toml --vary packing=0.3:0.6:0.1 --replicas 2 --threads 2 "
                                  "--collisions 2000 --out sweep --quiet");
  mention_simd_variable(*command);
  const auto options = std::make_shared<SweepOptions>();
  command->add_option("SCENE", options->scene, "the scene file")->required()->type_name("");
  command
      ->add_option("--vary", options->vary,
                   "a number of the scene and its values, KEY=FROM:TO:STEP or KEY=A,B,C: packing, disks, temperature, "
                   "restitution, wall_restitution, aspect, radius, mass_ratio, seed or any other of the scene, such as "
                   "gas.mass; several make a grid")
      ->required()
      ->type_name("KEY=VALUES")
      ->allow_extra_args(false);
  add_count(*command, "--replicas", options->replicas, "runs of each point, with seeds of their own (1)");
  add_count(*command, "--threads", options->threads, "jobs at a time (1); any number gives the same tables");
  add_path(*command, "--out", options->out, "DIR",
           "directory for the tables, the plots and the runs; a sweep that is there goes on")
      ->required();
  add_number(*command, "--until", options->until, "simulate each to this time");
  add_count(*command, "--collisions", options->collisions,
            "stop each at the first window's end at or after so many collisions");
  add_number(*command, "--equilibrate", options->equilibrate, "measure from the first window after this time");
  add_observables(*command, "--observe", options->observe,
                  "measure these observables instead of the scene's; 'carom run --help' lists them");
  add_solver(*command, options->solver);
  add_checkpoints(*command, options->saving);
  add_count(*command, "--seed", options->seed,
            "take the place of the seeds in the scene, from which those of the jobs "
            "are derived");
  command->add_flag("--json", options->json, "print a summary as one JSON object");
  command->add_flag("--quiet", options->quiet, "show no progress");
  command->callback([options, &action] { action = [options] { return sweep_command(*options); }; });
}

}  // namespace carom::program
