// What observables find has the same bits for any solver, number of patches and threads, and after going on from saved
// sums; and observing changes nothing.
#include <gtest/gtest.h>

#include "carom/run/summary.hpp"
#include "observed.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::all_numbers;
using test::everything_for;
using test::gas;

Scene granular() {
  Scene scene = gas(150, 0.3);
  scene.gas.push_back(scene.gas.front());
  scene.gas.back().mass = 2;
  scene.restitution = 0.9;
  return scene;
}

/// All observables, on a scene.
class SameBits : public testing::TestWithParam<Scene> {};

TEST_P(SameBits, ForAnySolverPatchesAndThreads) {
  const std::vector<ObserveSpec> specs = everything_for(realize(GetParam()));
  EXPECT_GE(specs.size(), 5U);
  test::Watch watch{.from = 0.7, .collisions = 3500};
  const auto expected = all_numbers(*test::observe(GetParam(), specs, watch));
  EXPECT_GT(expected.size(), 200U);
  watch.solver.kind = SolverKind::reference;
  EXPECT_EQ(all_numbers(*test::observe(GetParam(), specs, watch)), expected);
  watch.solver.kind = SolverKind::fast;
  watch.parallel.patches = {3, 2};
  watch.parallel.threads = 2;
  EXPECT_EQ(all_numbers(*test::observe(GetParam(), specs, watch)), expected);
}

TEST_P(SameBits, AfterGoingOnFromSavedSums) {
  const carom::Setup setup = realize(GetParam());
  const std::vector<ObserveSpec> specs = everything_for(setup);
  ObservableSet whole(specs, {setup.system, setup.frame});
  ObservableSet first(specs, {setup.system, setup.frame});
  Simulation simulation(setup);
  simulation.measure_from(0.7);
  simulation.add_observer(whole);
  simulation.add_observer(first);
  for (int k = 0; k < 7; ++k) simulation.run_window();
  SavedSums saved;
  first.exchange(SumsExchange(saved, SumsExchange::Direction::save));
  // A resumed run knows the state where it goes on, not the start: defaults that depend on it must not matter.
  const Frame here = simulation.frame();
  ObservableSet second(specs, {setup.system, here});
  second.exchange(SumsExchange(saved, SumsExchange::Direction::load));
  EXPECT_EQ(all_numbers(second), all_numbers(whole));
  simulation.add_observer(second);
  for (int k = 0; k < 6; ++k) simulation.run_window();
  EXPECT_EQ(all_numbers(second), all_numbers(whole));
  EXPECT_NE(all_numbers(first).size(), 0U);
}

TEST_P(SameBits, DigestsDoNotChange) {
  const carom::Setup setup = realize(GetParam());
  ObservableSet set(everything_for(setup), {setup.system, setup.frame});
  Simulation plain(setup);
  Simulation observed(setup);
  observed.add_observer(set);
  plain.run_until(3.3);
  observed.run_until(3.3);
  EXPECT_EQ(summarize(observed).digest, summarize(plain).digest);
}

INSTANTIATE_TEST_SUITE_P(Bits, SameBits,
                         testing::Values(gas(300, 0.6), gas(100, 0.2, Boundary::reflecting), granular()));

TEST(SavedSums, OfOtherOptionsAreRefused) {
  const carom::Setup setup = realize(gas(30, 0.2));
  ObservableSet one({{.name = "msd", .options = {{"levels", 3}}}}, {setup.system, setup.frame});
  ObservableSet other({{.name = "msd", .options = {{"levels", 4}}}}, {setup.system, setup.frame});
  ObservableSet another({{.name = "rate"}}, {setup.system, setup.frame});
  SavedSums saved;
  one.exchange(SumsExchange(saved, SumsExchange::Direction::save));
  EXPECT_THROW(other.exchange(SumsExchange(saved, SumsExchange::Direction::load)), Error);
  EXPECT_THROW(another.exchange(SumsExchange(saved, SumsExchange::Direction::load)), Error);
}

}  // namespace
}  // namespace carom
