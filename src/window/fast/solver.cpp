// The fast solver: chooses instructions and hands its windows to the hot loop compiled for them.
#include "carom/window/solver.hpp"
#include "carom/base/simd.hpp"
#include "carom/window/patch.hpp"
#include "loops.hpp"
#include "workspace.hpp"

namespace carom {
namespace {

class FastSolver final : public Solver {
 public:
  FastSolver(const System& system, const SolverOptions& options)
      : simd_(usable_simd(options.simd)), work_(system, options) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "fast"; }
  [[nodiscard]] std::string_view simd() const noexcept override { return name_of(simd_); }
  [[nodiscard]] bool sums_at_stops_only() const noexcept override { return true; }

  void open(const State& start, Books& books, std::vector<Collision>* log) override {
    work_.open(start, books, log);
    loops_ = fast::loops_for(simd_, work_.cells ? Neighbourhood::cells : Neighbourhood::lists, work_.one_kind);
  }

  bool advance_to(double time, const std::atomic<bool>& interrupt) override {
    if (!work_.records.empty() && !loops_.process_events(work_, time, interrupt)) return false;
    work_.book();
    return true;
  }

  void read(double time, Frame& frame) const override { work_.read(time, frame); }
  void close(State& next) override {
    work_.close(next);
    if (!work_.records.empty()) loops_.note_overlaps(work_);
  }

 private:
  Simd simd_;
  fast::Loops loops_;  // for the window that is open
  fast::Workspace work_;
};

class FastPatchSolver final : public PatchSolver {
 public:
  FastPatchSolver(const System& system, const SolverOptions& options)
      : simd_(usable_simd(options.simd)), work_(system, options) {}

  bool run(const State& start, const Books& books, const PatchTask& task, double until, bool logs,
           const PatchOutput& output, PatchReport& report, const std::atomic<bool>& interrupt) override {
    report = {};
    work_.open_patch(start, books, task, until, report.books, logs ? &report.log : nullptr);
    if (work_.records.empty()) return true;
    const Neighbourhood neighbourhood = work_.cells ? Neighbourhood::cells : Neighbourhood::lists;
    const fast::Loops loops = fast::loops_for(simd_, neighbourhood, work_.one_kind);
    if (!loops.process_events(work_, until, interrupt)) return false;
    work_.store_patch(until, output, report);
    if (until == work_.length) loops.note_overlaps(work_);
    return true;
  }

 private:
  Simd simd_;
  fast::Workspace work_;
};

}  // namespace

fast::Loops fast::loops_for(Simd simd, Neighbourhood neighbourhood, bool one_kind) noexcept {
  const Loops loops = vector_loops(simd, neighbourhood, one_kind);
  return loops.process_events != nullptr ? loops : scalar_loops(neighbourhood, one_kind);
}

std::unique_ptr<Solver> make_fast_solver(const System& system, const SolverOptions& options) {
  return std::make_unique<FastSolver>(system, options);
}

std::unique_ptr<PatchSolver> make_patch_solver(const System& system, const SolverOptions& options) {
  return std::make_unique<FastPatchSolver>(system, options);
}

}  // namespace carom
