// Runs with observables, for the tests of this folder.
#pragma once

#include <bit>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/observe/observable_set.hpp"
#include "carom/run/simulation.hpp"
#include "carom/state/scene.hpp"

namespace carom::test {

/// How long a run is watched, and how it is computed.
struct Watch {
  double from = 0;
  std::uint64_t collisions = 1000;  ///< until the first window's end that has so many
  std::uint64_t windows = 0;        ///< instead, if above 0: so many windows
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
  const auto goes_on = [&] {
    return watch.windows > 0 ? simulation.windows() < watch.windows : simulation.books().collisions < watch.collisions;
  };
  while (goes_on()) simulation.run_window();
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

inline std::vector<double> column(const Table& table, std::string_view name) {
  for (const Column& found : table.columns) {
    if (found.name == name) return found.values;
  }
  throw std::out_of_range("no column " + std::string(name));
}

/// Every number that observables found, bit by bit, each with its name before it.
inline std::vector<std::string> all_numbers(const ObservableSet& set) {
  std::vector<std::string> numbers;
  const auto add = [&numbers](const std::string& name, double value) {
    numbers.push_back(name + ' ' + std::to_string(value) + ' ' + std::to_string(std::bit_cast<std::uint64_t>(value)));
  };
  for (const Measurement& found : set.results()) {
    for (const Estimate& estimate : found.estimates) {
      const std::string name = found.name + '.' + estimate.name;
      add(name, estimate.value);
      add(name + " error", estimate.error.value_or(-1));
      add(name + " blocks", static_cast<double>(estimate.blocks));
      add(name + " samples", static_cast<double>(estimate.samples));
      add(name + " theory", estimate.theory.value_or(-1));
    }
    for (const Table& table : found.tables) {
      for (const Column& column : table.columns) {
        for (const double value : column.values) add(table.name + '.' + column.name, value);
      }
    }
  }
  return numbers;
}

/// All observables that this system has.
inline std::vector<ObserveSpec> everything_for(const Setup& setup) {
  std::vector<ObserveSpec> specs;
  for (const ObservableKind& kind : observable_kinds()) {
    const ObserveSpec spec{.name = std::string(kind.name)};
    try {
      make_observable(spec, {setup.system, setup.frame});
      specs.push_back(spec);
    } catch (const Error&) {  // this system has no such thing
    }
  }
  return specs;
}

}  // namespace carom::test
