#include "carom/carom/run_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <memory>
#include <new>
#include <utility>

#include "carom/base/error.hpp"
#include "carom/carom/version.hpp"
#include "carom/io/file.hpp"
#include "carom/io/scene_file.hpp"
#include "carom/io/xyz.hpp"
#include "carom/run/exhaustion.hpp"
#include "checkpoint_keeper.hpp"
#include "observed.hpp"
#include "run_files.hpp"

namespace carom {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr double kProgressPerWindow = 16;
constexpr std::chrono::seconds kBetweenLooks(1);  // at the clock's limit and at the directory

const RunPlan& checked(const RunPlan& plan) {
  const RunSettings& settings = plan.settings;
  if (!settings.until && !settings.collisions) throw Error("a run needs an end: a time or a number of collisions");
  if (settings.until && !(*settings.until <= kLatestTime)) {
    throw Error(fmt::format("until is {}: no run goes beyond time {}", *settings.until, kLatestTime));
  }
  if (settings.collisions && *settings.collisions > kMostCollisions) {
    throw Error(fmt::format("collisions is {}: no run is told to go beyond {}", *settings.collisions, kMostCollisions));
  }
  return plan;
}

class SceneRun {
 public:
  SceneRun(Setup setup, const RunPlan& plan)
      : plan_(checked(plan)),
        scene_digest_(digest(setup.system, setup.frame)),
        observed_(plan.settings, setup),
        scene_(plan.directory ? to_toml({explicit_scene(setup, plan.title), plan.settings}) : std::string()),
        simulation_(std::move(setup), plan.solver, plan.parallel) {
    simulation_.measure_from(plan.settings.equilibrate);
    begin_files();
    prepare();
  }

  SceneRun(Checkpoint checkpoint, const RunPlan& plan)
      : plan_(checked(plan)),
        scene_digest_(checkpoint.scene_digest),
        observed_(checkpoint),
        simulation_(std::move(checkpoint.snapshot), plan.solver, plan.parallel),
        seconds_before_(checkpoint.wall_seconds),
        quiet_windows_(checkpoint.quiet_windows) {
    if (plan.settings.until && *plan.settings.until < simulation_.time()) {
      throw Error(
          fmt::format("cannot run to time {}: the checkpoint is at {}", *plan.settings.until, simulation_.time()));
    }
    go_on_with_files(checkpoint.files);
    prepare();
    judge_window_start();
  }

  RunEnd run() {
    save_checkpoint();
    write_frame_if_due();
    while (!stopped() && !finished()) {
      step();
      if (plan_.progress) plan_.progress(share_done(), simulation_);
      if (!end_.interrupted) write_frame_if_due();
      look_around();
    }
    return finish();
  }

 private:
  [[nodiscard]] bool writes_frames() const {
    return plan_.directory && plan_.settings.every && plan_.settings.trajectory != TrajectoryFormat::none;
  }

  /// The scene is written as it is run. An older run is lost only when nothing is left that may go wrong.
  void begin_files() {
    if (plan_.collisions_file) prove_appendable(*plan_.collisions_file);
    if (plan_.directory) {
      plan_.directory->remove_old_run();
      write_file(plan_.directory->scene(), std::exchange(scene_, {}));
    }
    if (plan_.collisions_file) log_ = std::make_unique<CollisionLog>(*plan_.collisions_file);
    const RunSettings& settings = plan_.settings;
    if (!writes_frames()) return;
    const std::string path = plan_.directory->trajectory(settings.trajectory);
    frames_.emplace(create_trajectory(path, settings.trajectory, simulation_.system()), *settings.every,
                    settings.until);
  }

  /// All that may be refused is opened before anything is replaced or cut.
  void go_on_with_files(const WrittenFiles& files) {
    open_files_again(files);
    if (plan_.directory) {
      if (plan_.goes_on_from) plan_.directory->make_newest(*plan_.goes_on_from);
      plan_.directory->remove_unfinished_files();
    }
    if (log_) log_->cut();
    if (frames_) frames_->cut_to({files.frames, files.trajectory_bytes});
  }

  void open_files_again(const WrittenFiles& files) {
    if (plan_.collisions_file) log_ = std::make_unique<CollisionLog>(*plan_.collisions_file, files.log_bytes);
    const RunSettings& settings = plan_.settings;
    if (!writes_frames()) return;
    const std::string path = plan_.directory->trajectory(settings.trajectory);
    frames_.emplace(
        continue_trajectory(path, settings.trajectory, simulation_.system(), {files.frames, files.trajectory_bytes}),
        *settings.every, settings.until);
  }

  void prepare() {
    if (plan_.interrupt != nullptr) simulation_.stop_when(*plan_.interrupt);
    if (log_) simulation_.add_observer(*log_);
    observed_.watch(simulation_);
    collisions_before_ = simulation_.books().collisions;
    if (!plan_.directory || !has_checkpoints()) return;
    keeper_.emplace(*plan_.directory, plan_.checkpoint_every, plan_.checkpoint_minutes, simulation_.time());
  }

  [[nodiscard]] bool stopped() const { return end_.interrupted || end_.exhausted || end_.out_of_time || untrusted_; }

  [[nodiscard]] bool stands_at_window_start() const {
    return simulation_.time() == simulation_.window_start().clock.start;
  }

  /// One at a window's start stays, even if that window is abandoned.
  void write_frame_if_due() {
    if (!frames_) return;
    frames_->write_if_due(simulation_);
    if (stands_at_window_start()) frames_->keep();
  }

  [[nodiscard]] bool finished() const {
    const RunSettings& settings = plan_.settings;
    if (settings.until && simulation_.time() >= *settings.until) return true;
    return settings.collisions && stands_at_window_start() && simulation_.books().collisions >= *settings.collisions;
  }

  /// To whatever comes first: the end, the next frame, the window's end, or the next sign of progress.
  void step() {
    const Clock& clock = simulation_.window_start().clock;
    const double window_end = clock.start + clock.length;
    double target = window_end;
    if (plan_.settings.until) target = std::min(target, *plan_.settings.until);
    if (frames_) target = std::min(target, frames_->next_time());
    // A window that is divided starts from its beginning after every stop.
    const bool steps = plan_.progress && simulation_.division().patches == 1;
    if (steps) target = std::min(target, simulation_.time() + clock.length / kProgressPerWindow);
    if (!(target > simulation_.time())) target = window_end;  // steps too short to be told apart
    if (target < window_end) {
      end_.interrupted = simulation_.run_until(target) == Simulation::Stop::interrupted;
    } else if (window_end > kLatestTime && !plan_.settings.until) {
      end_.exhausted = true;
    } else {
      run_window();
    }
  }

  void run_window() {
    end_.interrupted = simulation_.run_window() == Simulation::Stop::interrupted;
    if (end_.interrupted) return;
    if (frames_) frames_->keep();
    count_quiet_windows();
    judge_window_start();
    if (keeper_ && keeper_->due(simulation_.time())) save_checkpoint();
  }

  void count_quiet_windows() {
    const bool quiet = simulation_.books().collisions == collisions_before_;
    collisions_before_ = simulation_.books().collisions;
    quiet_windows_ = quiet ? quiet_windows_ + 1 : 0;
  }

  /// Whether the run ends here, whatever end it was given. A resumed run asks where it begins: the run that has
  /// written the checkpoint may have ended there. Whether any collisions are left is a costly question, asked ever
  /// more rarely.
  void judge_window_start() {
    untrusted_ = !violations_at_window_start(simulation_).empty();
    if (plan_.settings.until || !std::has_single_bit(quiet_windows_)) return;
    end_.exhausted = collisions_are_over(simulation_.system(), simulation_.window_start().disks);
  }

  void look_around() {
    const WallClock::time_point now = WallClock::now();
    if (plan_.max_minutes && now - start_ >= std::chrono::duration<double>(60 * *plan_.max_minutes)) {
      end_.out_of_time = !finished();
    }
    if (!plan_.directory || now - last_look_ < kBetweenLooks) return;
    last_look_ = now;
    plan_.directory->require_still_there();
  }

  [[nodiscard]] double seconds_spent() const {
    return seconds_before_ + std::chrono::duration<double>(WallClock::now() - start_).count();
  }

  /// The state at the start of the window in flight. Files that it speaks of are on the disk before it is.
  void save_checkpoint() {
    if (!keeper_) return;
    plan_.directory->require_still_there();
    Checkpoint checkpoint{.snapshot = simulation_.snapshot(),
                          .settings = plan_.settings,
                          .title = plan_.title,
                          .scene_digest = scene_digest_,
                          .files = {},
                          .quiet_windows = quiet_windows_,
                          .wall_seconds = seconds_spent(),
                          .sums = {}};
    observed_.keep_in(checkpoint);
    if (log_) {
      log_->sync();
      checkpoint.files.log = plan_.directory->name_within(*plan_.collisions_file);
      checkpoint.files.log_bytes = log_->kept();
    }
    if (frames_) {
      frames_->sync();
      checkpoint.files.frames = frames_->kept().frames;
      checkpoint.files.trajectory_bytes = frames_->kept().bytes;
    }
    try {
      keeper_->save(checkpoint);
    } catch (const Error&) {
      plan_.directory->require_still_there();  // then that is the reason
      throw;
    }
  }

  [[nodiscard]] double share_done() const {
    const RunSettings& settings = plan_.settings;
    double share = 0;
    if (settings.until) share = std::max(share, simulation_.time() / *settings.until);
    if (settings.collisions) {
      share = std::max(share,
                       static_cast<double>(simulation_.books().collisions) / static_cast<double>(*settings.collisions));
    }
    return share;
  }

  [[nodiscard]] Ended reason() const {
    if (end_.interrupted) return Ended::interrupted;
    if (untrusted_) return Ended::untrusted;
    if (end_.exhausted) return Ended::exhausted;
    if (end_.out_of_time) return Ended::out_of_time;
    return plan_.settings.until && simulation_.time() >= *plan_.settings.until ? Ended::time : Ended::collisions;
  }

  RunEnd finish() {
    save_checkpoint();
    end_.record.wall_seconds = seconds_spent();
    end_.record.summary = summarize(simulation_);
    end_.record.scene_digest = scene_digest_;
    end_.record.ended = reason();
    end_.record.version = version();
    end_.record.compiler = compiler();
    end_.record.command = plan_.command;
    end_.record.observables = observed_.finish(plan_.directory);
    if (log_) log_->finish(simulation_);
    if (frames_) frames_->finish(end_.interrupted);
    if (plan_.directory) {
      plan_.directory->require_still_there();
      write_file(plan_.directory->final_frame(), xyz_frame(simulation_.system(), simulation_.frame()));
      write_file(plan_.directory->report(), report_json(end_.record));
    }
    return std::move(end_);
  }

  const RunPlan& plan_;
  std::string scene_digest_;
  Observed observed_;
  std::string scene_;  // as TOML, until it is written
  std::unique_ptr<CollisionLog> log_;
  Simulation simulation_;
  std::optional<FrameSchedule> frames_;
  std::optional<CheckpointKeeper> keeper_;
  WallClock::time_point start_ = WallClock::now();
  WallClock::time_point last_look_ = start_;
  double seconds_before_ = 0;  // spent before the run was resumed
  std::uint64_t collisions_before_ = 0;
  std::uint64_t quiet_windows_ = 0;
  bool untrusted_ = false;
  RunEnd end_;
};

}  // namespace

namespace {

[[noreturn]] void fail_for_memory(const RunPlan& plan, std::size_t disks) {
  Place place;
  if (plan.directory) place.file = plan.directory->path();
  throw Error(fmt::format("out of memory: the run of {} disks cannot go on", disks), place);
}

}  // namespace

RunEnd run_scene(Setup setup, const RunPlan& plan) {
  const std::size_t disks = setup.system.size();
  try {
    return SceneRun(std::move(setup), plan).run();
  } catch (const std::bad_alloc&) {
    fail_for_memory(plan, disks);
  }
}

RunEnd resume_run(Checkpoint checkpoint, const RunPlan& plan) {
  const std::size_t disks = checkpoint.snapshot.system.size();
  try {
    return SceneRun(std::move(checkpoint), plan).run();
  } catch (const std::bad_alloc&) {
    fail_for_memory(plan, disks);
  }
}

}  // namespace carom
