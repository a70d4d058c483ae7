// The fast solver: chooses instructions and hands its windows to the hot loop compiled for them.
#include "carom/window/solver.hpp"
#include "carom/base/simd.hpp"
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

}  // namespace

fast::Loops fast::loops_for(Simd simd, Neighbourhood neighbourhood, bool one_kind) noexcept {
  const Loops loops = vector_loops(simd, neighbourhood, one_kind);
  return loops.process_events != nullptr ? loops : scalar_loops(neighbourhood, one_kind);
}

std::unique_ptr<Solver> make_fast_solver(const System& system, const SolverOptions& options) {
  return std::make_unique<FastSolver>(system, options);
}

}  // namespace carom
