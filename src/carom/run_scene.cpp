#include "carom/carom/run_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>

#include "carom/base/error.hpp"
#include "carom/carom/version.hpp"
#include "carom/io/collisions_csv.hpp"
#include "carom/io/file.hpp"
#include "carom/io/scene_file.hpp"
#include "carom/io/xyz.hpp"
#include "carom/run/exhaustion.hpp"
#include "observed.hpp"

namespace carom {
namespace {

constexpr double kProgressPerWindow = 16;

/// Writes every finished window's collisions; what a window in flight holds is added at the end.
class CollisionLog final : public Observer {
 public:
  explicit CollisionLog(const std::string& path) : csv_(path) {}

  void on_window(const WindowRecord& window) override { csv_.append(window.collisions, window.before.clock.start); }

  void finish(const Simulation& simulation) {
    csv_.append(simulation.collisions_in_flight(), simulation.window_start().clock.start);
    csv_.close();
  }

 private:
  CollisionsCsv csv_;
};

/// Frames at times 0, dt, 2 dt, … Those of a window that is abandoned are taken back.
class Trajectory {
 public:
  Trajectory(const std::string& path, double every, std::optional<double> until)
      : stream_(path), every_(every), until_(until) {}

  /// A frame that is due at the end but for rounding is due at the end.
  [[nodiscard]] double next_time() const noexcept {
    const double time = static_cast<double>(frames_) * every_;
    return until_ && std::abs(time - *until_) <= 1e-9 * every_ ? *until_ : time;
  }

  void write_if_due(const Simulation& simulation) {
    if (simulation.time() != next_time()) return;
    const std::string frame = xyz_frame(simulation.system(), simulation.frame());
    stream_.write(frame);
    stream_.flush();
    bytes_ += frame.size();
    ++frames_;
  }

  /// What is written so far stays, whatever becomes of the next window.
  void keep() noexcept { kept_bytes_ = bytes_; }

  void finish(bool interrupted) {
    stream_.close();
    if (interrupted && kept_bytes_ < bytes_) std::filesystem::resize_file(stream_.path(), kept_bytes_);
  }

 private:
  OutputStream stream_;
  double every_;
  std::optional<double> until_;
  std::uint64_t frames_ = 0;
  std::uintmax_t bytes_ = 0;
  std::uintmax_t kept_bytes_ = 0;
};

const RunPlan& checked(const RunPlan& plan) {
  const RunSettings& settings = plan.settings;
  if (!settings.until && !settings.collisions) throw Error("a run needs an end: a time or a number of collisions");
  if (settings.until && !(*settings.until <= kLatestTime)) {
    throw Error(fmt::format("until is {}: no run goes beyond time {}", *settings.until, kLatestTime));
  }
  return plan;
}

class SceneRun {
 public:
  SceneRun(Setup setup, const RunPlan& plan)
      : plan_(checked(plan)),
        scene_digest_(digest(setup.system, setup.frame)),
        observed_(plan.settings, setup),
        log_(plan.collisions_file ? std::make_unique<CollisionLog>(*plan.collisions_file) : nullptr),
        simulation_(prepare(std::move(setup)), plan.solver, plan.parallel) {
    simulation_.measure_from(plan.settings.equilibrate);
    if (plan.interrupt != nullptr) simulation_.stop_when(*plan.interrupt);
    if (log_) simulation_.add_observer(*log_);
    observed_.watch(simulation_);
    const RunSettings& settings = plan.settings;
    if (plan.directory && settings.every && settings.trajectory == TrajectoryFormat::xyz) {
      trajectory_.emplace(plan.directory->trajectory(), *settings.every, settings.until);
    }
  }

  RunEnd run() {
    if (trajectory_) {
      trajectory_->write_if_due(simulation_);
      trajectory_->keep();
    }
    while (!interrupted_ && !exhausted_ && !finished()) {
      step();
      if (plan_.progress) plan_.progress(share_done(), simulation_);
      if (trajectory_ && !interrupted_) trajectory_->write_if_due(simulation_);
    }
    return finish();
  }

 private:
  /// Writes the scene as it is run, before anything can go wrong.
  Setup prepare(Setup setup) const {
    if (!plan_.directory) return setup;
    write_file(plan_.directory->scene(), to_toml({explicit_scene(setup, plan_.title), plan_.settings}));
    return setup;
  }

  [[nodiscard]] bool finished() const {
    const RunSettings& settings = plan_.settings;
    if (settings.until && simulation_.time() >= *settings.until) return true;
    const bool at_window_end = simulation_.time() == simulation_.window_start().clock.start;
    return settings.collisions && at_window_end && simulation_.books().collisions >= *settings.collisions;
  }

  /// To whatever comes first: the end, the next frame, the window's end, or the next sign of progress.
  void step() {
    const Clock& clock = simulation_.window_start().clock;
    const double window_end = clock.start + clock.length;
    double target = window_end;
    if (plan_.settings.until) target = std::min(target, *plan_.settings.until);
    if (trajectory_) target = std::min(target, trajectory_->next_time());
    // A window that is divided starts from its beginning after every stop.
    const bool steps = plan_.progress && simulation_.division().patches == 1;
    if (steps) target = std::min(target, simulation_.time() + clock.length / kProgressPerWindow);
    if (!(target > simulation_.time())) target = window_end;  // steps too short to be told apart
    if (target < window_end) {
      interrupted_ = simulation_.run_until(target) == Simulation::Stop::interrupted;
    } else if (window_end > kLatestTime && !plan_.settings.until) {
      exhausted_ = true;
    } else {
      run_window();
    }
  }

  void run_window() {
    interrupted_ = simulation_.run_window() == Simulation::Stop::interrupted;
    if (interrupted_) return;
    if (trajectory_) trajectory_->keep();
    const bool quiet = simulation_.books().collisions == collisions_before_;
    collisions_before_ = simulation_.books().collisions;
    quiet_windows_ = quiet ? quiet_windows_ + 1 : 0;
    if (plan_.settings.until || !std::has_single_bit(quiet_windows_))
      return;  // a costly question, asked ever more rarely
    exhausted_ = collisions_are_over(simulation_.system(), simulation_.window_start().disks);
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

  RunEnd finish() {
    RunEnd end;
    end.interrupted = interrupted_;
    end.exhausted = exhausted_;
    end.record.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    end.record.summary = summarize(simulation_);
    end.record.scene_digest = scene_digest_;
    end.record.version = version();
    end.record.compiler = compiler();
    end.record.command = plan_.command;
    end.record.observables = observed_.finish(plan_.directory);
    if (log_) log_->finish(simulation_);
    if (trajectory_) trajectory_->finish(interrupted_);
    if (plan_.directory) {
      write_file(plan_.directory->final_frame(), xyz_frame(simulation_.system(), simulation_.frame()));
      write_file(plan_.directory->report(), report_json(end.record));
    }
    return end;
  }

  const RunPlan& plan_;
  std::string scene_digest_;
  Observed observed_;
  std::unique_ptr<CollisionLog> log_;  // opened before scene.toml is written, so that a bad name leaves nothing behind
  Simulation simulation_;
  std::optional<Trajectory> trajectory_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::uint64_t collisions_before_ = 0;
  std::uint64_t quiet_windows_ = 0;
  bool interrupted_ = false;
  bool exhausted_ = false;
};

}  // namespace

RunEnd run_scene(Setup setup, const RunPlan& plan) { return SceneRun(std::move(setup), plan).run(); }

}  // namespace carom
