// A window advanced patch by patch: speculate with a halo, verify against the owner, repair.
#pragma once

#include <memory>

#include "carom/run/parallel.hpp"
#include "carom/window/solver.hpp"
#include "executor.hpp"

namespace carom {

/// The checks that make a window's result certain. A test leaves one out to see that it is needed.
struct Checks {
  bool near_copies = true;   ///< every near copy has its owner's history
  bool far_contacts = true;  ///< no owned disk met a far copy
  bool excursions = true;    ///< whoever went far stayed clear of the patches in which it is not near
};

/// A solver that divides its windows.
class DividedSolver : public Solver {
 public:
  [[nodiscard]] virtual Division division() const noexcept = 0;
};

/// Chooses the patches where nobody did: one for a system that is too small to gain from more. The reference solver
/// works undivided.
ParallelOptions divided(const System& system, const State& start, const SolverOptions& solver,
                        const ParallelOptions& parallel);

/// `parallel.patches` chosen. `system` must outlive it.
std::unique_ptr<DividedSolver> make_patched_solver(const System& system, const SolverOptions& solver,
                                                   const ParallelOptions& parallel, const Checks& checks = {});

}  // namespace carom
