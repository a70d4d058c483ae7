#include "carom/carom/sweep.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>

#include "carom/base/error.hpp"
#include "carom/carom/run_scene.hpp"
#include "carom/carom/version.hpp"
#include "carom/io/directory_lock.hpp"
#include "carom/io/file.hpp"
#include "parallel_jobs.hpp"
#include "sweep_jobs.hpp"

namespace carom {
namespace {

namespace fs = std::filesystem;

std::optional<double> number_density(const System& system) {
  const double area = system.box.size.x * system.box.size.y;
  if (!(area > 0)) return std::nullopt;
  return static_cast<double>(system.size()) / area;
}

std::string settings_text(const RunSettings& settings) { return to_toml({{}, settings}); }

/// How far one job is: written by its thread, read by the caller's.
struct Share {
  std::atomic<double> done{0};
  std::atomic<std::uint64_t> collisions{0};
  std::uint64_t before = 0;  // the job's collisions that an earlier call has computed: for its thread alone
};

class Sweep {
 public:
  explicit Sweep(const SweepPlan& plan)
      : plan_(plan), jobs_(jobs_of_sweep(plan)), rows_(jobs_.size()), shares_(new Share[jobs_.size()]) {}

  SweepEnd run() {
    end_.jobs = jobs_.size();
    const std::string settings = settings_json();
    refuse_other_sweep(settings);
    find_finished();
    check_scenes();
    if (!interrupted()) {
      make_directory();
      const DirectoryLock lock(plan_.directory);
      refuse_other_sweep(settings);  // again: another may have come and gone until then
      write_file(in("sweep.json"), settings);
      run_jobs();
      write_tables();
    }
    end_.interrupted = interrupted() && end_.rows.size() < end_.jobs;
    return std::move(end_);
  }

 private:
  [[nodiscard]] bool interrupted() const noexcept {
    return plan_.interrupt != nullptr && plan_.interrupt->load(std::memory_order_relaxed);
  }
  [[nodiscard]] std::string in(const std::string& name) const { return (fs::path(plan_.directory) / name).string(); }
  [[nodiscard]] std::string directory_of(const SweepJob& job) const {
    return (fs::path(plan_.directory) / "runs" / job.name).string();
  }

  [[nodiscard]] std::string settings_json() const {
    return sweep_settings_json({to_toml(plan_.file), plan_.varied, plan_.replicas, std::string(version())});
  }

  /// What is in the directory must have been made by a sweep with the same settings.
  void refuse_other_sweep(const std::string& settings) const {
    std::error_code ignored;
    if (fs::exists(in("report.json"), ignored)) throw Error("holds a run: choose another directory", {plan_.directory});
    if (!fs::exists(in("sweep.json"), ignored)) return;
    if (read_file(in("sweep.json")) == settings) return;
    const SweepSettings old = read_sweep_settings(in("sweep.json"));
    const char* difference = "the scene or when it ends";
    if (old.varied != plan_.varied) difference = "what is varied";
    if (old.replicas != plan_.replicas) difference = "the number of replicas";
    if (old.version != version()) difference = "the version of carom";
    throw Error(fmt::format("holds a sweep with other settings ({} differs): choose another directory", difference),
                {plan_.directory});
  }

  void find_finished() {
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      rows_[k] = read_finished_job(directory_of(jobs_[k]), jobs_[k]);
      if (!rows_[k]) {
        left_.push_back(k);
        continue;
      }
      ++end_.kept;
      shares_[k].done = 1;
    }
  }

  /// The first replica that is left of each point: a sweep is not to fail after hours at its last point.
  void check_scenes() {
    std::vector<std::size_t> first;
    for (const std::size_t k : left_) {
      if (first.empty() || jobs_[first.back()].values != jobs_[k].values) first.push_back(k);
    }
    std::vector<std::vector<Problem>> found(first.size());
    work_in_parallel(
        plan_.threads, first.size(),
        [&](std::size_t at) {
          found[at] = problems_of_job(plan_, jobs_[first[at]], first[at]);
          return !interrupted();
        },
        [] {});
    std::vector<Problem> all;
    for (const std::vector<Problem>& problems : found) all.insert(all.end(), problems.begin(), problems.end());
    if (!all.empty()) throw Error(all);
  }

  void make_directory() const {
    std::error_code error;
    fs::create_directories(fs::path(plan_.directory) / "runs", error);
    if (error) throw Error("cannot be created: " + error.message(), {in("runs")});
  }

  void run_jobs() {
    work_in_parallel(
        plan_.threads, left_.size(), [this](std::size_t at) { return attempt(left_[at]); },
        [this] {
          if (plan_.progress) plan_.progress(progress());
        });
  }

  /// False if no other job is to begin.
  bool attempt(std::size_t k) {
    try {
      if (!interrupted()) run_job(k);
      return !interrupted();
    } catch (const std::bad_alloc&) {
      fail(k, "out of memory");
    } catch (const std::exception& error) {
      fail(k, error.what());
    }
    return false;
  }

  void fail(std::size_t k, const std::string& reason) {
    const std::lock_guard lock(mutex_);
    end_.failures.push_back(jobs_[k].name + ": " + reason);
  }

  void run_job(std::size_t k) {
    const SweepJob& job = jobs_[k];
    const fs::path finished = fs::path(directory_of(job)) / "job.json";
    fs::remove(finished);
    const SceneFile file = scene_of_job(plan_, job, k);
    const RunPlan run = plan_of_job(k, file);
    Setup setup = realize(file.scene);
    const std::optional<double> density = number_density(setup.system);
    const RunEnd end = begin_or_go_on(k, std::move(setup), run);
    if (end.interrupted) {
      fs::remove(run.directory->report());
      return;
    }
    SweepRow row;
    row.job = job;
    row.number_density = density;
    row.violations = violations(end.record.summary);
    row.results.digest = end.record.summary.digest;
    write_file(finished.string(), finished_job_json(row, plan_.varied));
    finish(k);
  }

  RunPlan plan_of_job(std::size_t k, const SceneFile& file) {
    RunPlan run;
    run.settings = file.run;
    run.solver = plan_.solver;
    run.checkpoint_every = plan_.checkpoint_every;
    run.checkpoint_minutes = plan_.checkpoint_minutes;
    run.title = file.scene.title;
    run.command = plan_.command;
    run.interrupt = plan_.interrupt;
    run.directory.emplace(directory_of(jobs_[k]), true);
    if (plan_.progress) {
      run.progress = [&share = shares_[k]](double done, const Simulation& simulation) {
        share.done = done;
        share.collisions = simulation.books().collisions - share.before;
      };
    }
    return run;
  }

  RunEnd begin_or_go_on(std::size_t k, Setup setup, RunPlan run) {
    std::optional<NewestCheckpoint> newest = checkpoint_of(setup, run);
    if (!newest) return run_scene(std::move(setup), run);
    setup = {};
    shares_[k].before = newest->checkpoint.snapshot.books.collisions;
    run.goes_on_from = newest->path;
    return resume_run(std::move(newest->checkpoint), run);
  }

  /// The last one of the job that an earlier call has left, if it is of the same scene and settings. What cannot be
  /// read is not taken to be worthless: then this throws Error.
  std::optional<NewestCheckpoint> checkpoint_of(const Setup& setup, const RunPlan& run) {
    if (!has_checkpoints()) return std::nullopt;
    std::optional<NewestCheckpoint> newest =
        read_newest_checkpoint({run.directory->checkpoint(), run.directory->previous_checkpoint()});
    if (!newest) return std::nullopt;
    const Checkpoint& checkpoint = newest->checkpoint;
    const bool same = checkpoint.scene_digest == digest(setup.system, setup.frame) &&
                      settings_text(checkpoint.settings) == settings_text(run.settings);
    if (!same) return std::nullopt;
    const std::lock_guard lock(mutex_);
    ++end_.resumed;
    for (const Problem& problem : newest->damaged) end_.damaged.push_back(to_string(problem));
    return newest;
  }

  /// What is tabulated is read back from the files, so that it is the same whenever the job was run.
  void finish(std::size_t k) {
    std::optional<SweepRow> row = read_finished_job(directory_of(jobs_[k]), jobs_[k]);
    if (!row) throw Error("its files cannot be read back");
    const std::lock_guard lock(mutex_);
    rows_[k] = std::move(row);
    ++finished_;
  }

  [[nodiscard]] SweepProgress progress() {
    SweepProgress progress;
    double done = 0;
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      done += std::min(1.0, shares_[k].done.load());
      progress.collisions += shares_[k].collisions.load();
    }
    progress.done = done / static_cast<double>(jobs_.size());
    const std::lock_guard lock(mutex_);
    progress.finished = end_.kept + finished_;
    progress.jobs = jobs_.size();
    return progress;
  }

  void write_tables() {
    for (std::optional<SweepRow>& row : rows_) {
      if (row) end_.rows.push_back(std::move(*row));
    }
    write_file(in("sweep.csv"), sweep_csv(plan_.varied, end_.rows));
    write_file(in("sweep_mean.csv"), sweep_mean_csv(plan_.varied, means_of(end_.rows)));
  }

  const SweepPlan& plan_;
  std::vector<SweepJob> jobs_;
  std::vector<std::optional<SweepRow>> rows_;
  std::unique_ptr<Share[]> shares_;
  std::vector<std::size_t> left_;  // jobs that are not finished
  std::mutex mutex_;               // guards what follows, and rows_, while jobs run
  std::uint64_t finished_ = 0;
  SweepEnd end_;
};

}  // namespace

SweepEnd run_sweep(const SweepPlan& plan) { return Sweep(plan).run(); }

}  // namespace carom
