#include "carom/window/solver.hpp"

namespace carom {

std::unique_ptr<Solver> make_solver(const System& system, const SolverOptions& options) {
  switch (options.kind) {
    case SolverKind::fast: return make_fast_solver(system, options);
    case SolverKind::reference: return make_reference_solver(system);
  }
  return nullptr;
}

}  // namespace carom
