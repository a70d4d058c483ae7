// carom resume: a run goes on from its last checkpoint.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "carom/carom.hpp"
#include "command.hpp"
#include "environment.hpp"
#include "options.hpp"
#include "run_shared.hpp"

namespace carom::program {
namespace {

namespace fs = std::filesystem;

struct ResumeOptions {
  std::string from;
  std::optional<double> until;
  std::optional<std::uint64_t> collisions;
  SolverKind solver = SolverKind::fast;
  ParallelOptions parallel;
  SavingOptions saving;
  std::string log_collisions;
  bool json = false;
  bool quiet = false;
};

void check_options(const ResumeOptions& options) {
  require_hdf5("checkpoints need");
  require_time("--until", options.until, true);
  require_collisions(options.collisions);
  check_saving(options.saving, true);
}

/// The directory of the run, and its checkpoints from the newest on.
struct Source {
  std::string directory;
  std::vector<std::string> checkpoints;
};

Source find(const std::string& from) {
  std::error_code error;
  const bool is_directory = fs::is_directory(from, error);
  if (!is_directory && !fs::exists(from, error)) {
    throw Error(error ? "cannot be read: " + error.message() : "there is no such file or directory", {from});
  }
  Source source;
  source.directory = is_directory ? from : fs::path(from).parent_path().string();
  if (source.directory.empty()) source.directory = ".";
  const fs::path newest = fs::path(source.directory) / "checkpoint.h5";
  const fs::path previous = fs::path(source.directory) / "checkpoint-1.h5";
  if (is_directory) {
    source.checkpoints = {newest.string(), previous.string()};
  } else {
    source.checkpoints = {from};
    if (fs::equivalent(from, newest, error) && !error) source.checkpoints.push_back(previous.string());
  }
  return source;
}

/// The newest checkpoint that is whole.
NewestCheckpoint read_newest(const Source& source) {
  std::optional<NewestCheckpoint> newest = read_newest_checkpoint(source.checkpoints);
  if (!newest) throw Error("holds no checkpoint of a run", {source.directory});
  for (const Problem& problem : newest->damaged) tell(to_string(problem));
  if (newest->path != source.checkpoints.front()) {
    tell(fmt::format("going on from the checkpoint before it, {}", newest->path));
  }
  return std::move(*newest);
}

/// Where the collision log is. Only a name in the run's own directory is taken from the checkpoint.
std::optional<std::string> log_of(const Checkpoint& checkpoint, const ResumeOptions& options,
                                  const OutputDirectory& directory) {
  const std::optional<std::string>& log = checkpoint.files.log;
  if (!log) {
    if (!options.log_collisions.empty()) throw UsageError("--log-collisions: this run has kept no log of collisions");
    return std::nullopt;
  }
  if (!options.log_collisions.empty()) return options.log_collisions;
  if (log->find('/') == std::string::npos) return directory.in(*log);
  throw UsageError(
      fmt::format("this run logs its collisions to {}, outside its directory: give --log-collisions {}", *log, *log));
}

RunPlan plan_of(const Checkpoint& checkpoint, const ResumeOptions& options, const OutputDirectory& directory) {
  RunPlan plan;
  plan.settings = checkpoint.settings;
  if (options.until || options.collisions) {
    plan.settings.until = options.until;
    plan.settings.collisions = options.collisions;
  }
  plan.solver.kind = options.solver;
  plan.solver.simd = simd_from_environment();
  plan.parallel = options.parallel;
  plan.title = checkpoint.title;
  plan.command = command_line();
  plan.directory = directory;
  plan.collisions_file = log_of(checkpoint, options, directory);
  apply(options.saving, plan);
  return plan;
}

int resume_command(const ResumeOptions& options) {
  check_options(options);
  const Source source = find(options.from);
  const OutputDirectory directory = OutputDirectory::of_run(source.directory);  // from now on nobody else writes there
  NewestCheckpoint newest = read_newest(source);
  RunPlan plan = plan_of(newest.checkpoint, options, directory);
  plan.goes_on_from = newest.path;
  const RunEnd end = with_progress(plan, options.quiet, [&] { return resume_run(std::move(newest.checkpoint), plan); });
  return conclude(end, options.json, source.directory);
}

}  // namespace

void add_resume(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "resume", "Go on with a run that was stopped, as if it never had been",
                                  "carom run scenes/gas.toml --until 1 --out gas --overwrite\n"
                                  "  carom resume gas --until 2");
  mention_simd_variable(*command);
  const auto options = std::make_shared<ResumeOptions>();
  command->add_option("FROM", options->from, "the directory of the run, or one of its checkpoints")
      ->required()
      ->type_name("");
  add_number(*command, "--until", options->until, "simulate to this time; by default to the end asked for at first");
  add_count(*command, "--collisions", options->collisions,
            "stop at the first window's end at or after so many collisions, counted from time 0");
  add_solver(*command, options->solver);
  add_parallel(*command, options->parallel);
  add_saving(*command, options->saving);
  add_path(*command, "--log-collisions", options->log_collisions, "FILE",
           "where the log of collisions is, if not in the directory of the run");
  command->add_flag("--json", options->json, "print the report as one JSON object");
  command->add_flag("--quiet", options->quiet, "show no progress");
  command->callback([options, &action] { action = [options] { return resume_command(*options); }; });
}

}  // namespace carom::program
