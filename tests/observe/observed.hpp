// Runs with observables, for the tests of this folder.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "carom/observe/observable_set.hpp"
#include "carom/run/simulation.hpp"
#include "carom/state/scene.hpp"

namespace carom::test {

/// How long a run is watched, and how it is computed.
struct Watch {
  double from = 0;
  std::uint64_t collisions = 1000;  ///< until the first window's end that has so many
  SolverOptions solver = {};
  ParallelOptions parallel = {};
};

/// The observables after a run. They refer to the system of `setup`, not of the simulation, which is gone.
inline std::unique_ptr<ObservableSet> observe(const Scene& scene, const std::vector<ObserveSpec>& specs,
                                              const Watch& watch) {
  const carom::Setup setup = realize(scene);
  auto set = std::make_unique<ObservableSet>(specs, Subject{setup.system, setup.frame});
  Simulation simulation(setup, watch.solver, watch.parallel);
  simulation.measure_from(watch.from);
  simulation.add_observer(*set);
  while (simulation.books().collisions < watch.collisions) simulation.run_window();
  return set;
}

inline Measurement measurement(const ObservableSet& set, std::string_view observable) {
  for (const Measurement& found : set.results()) {
    if (found.name == observable) return found;
  }
  throw std::out_of_range("no observable " + std::string(observable));
}

inline Estimate estimate(const ObservableSet& set, std::string_view observable, std::string_view name) {
  for (const Estimate& found : measurement(set, observable).estimates) {
    if (found.name == name) return found;
  }
  throw std::out_of_range("no estimate " + std::string(name));
}

inline Table table(const ObservableSet& set, std::string_view observable, std::string_view name) {
  for (const Table& found : measurement(set, observable).tables) {
    if (found.name == name) return found;
  }
  throw std::out_of_range("no table " + std::string(name));
}

inline const std::vector<double>& column(const Table& table, std::string_view name) {
  for (const Column& found : table.columns) {
    if (found.name == name) return found.values;
  }
  throw std::out_of_range("no column " + std::string(name));
}

}  // namespace carom::test
