// The fast solver: chooses instructions and hands its windows to the hot loop compiled for them.
#include <fmt/format.h>

#include <algorithm>

#include "carom/base/error.hpp"
#include "carom/window/solver.hpp"
#include "loops.hpp"
#include "workspace.hpp"

namespace carom {
namespace {

Simd chosen_simd(const SolverOptions& options) {
  const std::vector<Simd> available = available_simd();
  if (!options.simd) return available.back();
  if (std::find(available.begin(), available.end(), *options.simd) == available.end()) {
    throw Error(fmt::format("this processor has no {} instructions", name_of(*options.simd)));
  }
  return *options.simd;
}

class FastSolver final : public Solver {
 public:
  FastSolver(const System& system, const SolverOptions& options)
      : simd_(chosen_simd(options)), process_events_(fast::process_events_with(simd_)), work_(system, options) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "fast"; }
  [[nodiscard]] std::string_view simd() const noexcept override { return name_of(simd_); }

  void open(const State& start, Books& books, std::vector<Collision>* log) override { work_.open(start, books, log); }

  bool advance_to(double time, const std::atomic<bool>& interrupt) override {
    if (!process_events_(work_, time, interrupt)) return false;
    work_.book();
    return true;
  }

  void read(double time, Frame& frame) const override { work_.read(time, frame); }
  void close(State& next) override { work_.close(next); }

 private:
  Simd simd_;
  fast::ProcessEvents process_events_;
  fast::Workspace work_;
};

}  // namespace

fast::ProcessEvents fast::process_events_with(Simd simd) noexcept {
  const ProcessEvents vector = process_events_vector(simd);
  return vector != nullptr ? vector : process_events_scalar;
}

std::unique_ptr<Solver> make_fast_solver(const System& system, const SolverOptions& options) {
  return std::make_unique<FastSolver>(system, options);
}

}  // namespace carom
