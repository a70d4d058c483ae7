// Observables get the windows that are measured and frames at their own times, and nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "carom/base/error.hpp"
#include "observed.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::gas;

ObservableSet set_of(const Simulation& simulation, const std::vector<ObserveSpec>& specs) {
  return {specs, {simulation.system(), simulation.frame()}};
}

TEST(Set, AsksForCollisionsOnlyIfItNeedsThem) {
  const Simulation simulation(realize(gas(30, 0.2)));
  EXPECT_FALSE(set_of(simulation, {{.name = "pressure"}, {.name = "rate"}, {.name = "speeds"}}).wants_collisions());
  EXPECT_TRUE(set_of(simulation, {{.name = "speeds", .options = {{"interval", 0.1}}}}).wants_collisions());
  EXPECT_TRUE(set_of(simulation, {{.name = "pressure_tensor"}}).wants_collisions());
  EXPECT_TRUE(set_of(simulation, {{.name = "rate"}, {.name = "msd"}}).wants_collisions());
}

TEST(Set, HandsOutFramesFromTheStartOfMeasuringOn) {
  Simulation simulation(realize(gas(30, 0.2)));
  ObservableSet set = set_of(simulation, {{.name = "speeds", .options = {{"interval", 0.3}}}});
  simulation.measure_from(2.1);
  simulation.add_observer(set);
  while (simulation.time() < 30) simulation.run_window();
  const std::vector<double> times = test::column(test::table(set, "speeds", "boltzmann_h"), "time");
  const double start = simulation.measured().start;
  EXPECT_GE(start, 2.1);
  ASSERT_EQ(times.size(), static_cast<std::size_t>(std::ceil((simulation.time() - start) / 0.3)));
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_EQ(times[k], start + static_cast<double>(k) * 0.3);
}

TEST(Set, ResultsBeforeAnythingWasMeasuredHaveNoValues) {
  Simulation simulation(realize(gas(30, 0.2)));
  ObservableSet set = set_of(simulation, test::everything_for({simulation.system(), simulation.frame()}));
  simulation.measure_from(1e9);
  simulation.add_observer(set);
  for (int k = 0; k < 3; ++k) simulation.run_window();
  EXPECT_TRUE(std::isnan(test::estimate(set, "pressure", "pressure").value));
  EXPECT_FALSE(test::estimate(set, "pressure", "pressure").warnings.empty());
}

TEST(Set, StopsWithAWarningWhereFramesWouldHaveNoEnd) {
  Simulation simulation(realize(gas(30, 0.2)));
  ObservableSet set = set_of(simulation, {{.name = "msd", .options = {{"interval", 1e-12}}}});
  simulation.add_observer(set);
  simulation.run_window();
  simulation.run_window();
  EXPECT_EQ(test::estimate(set, "msd", "diffusion").samples, 0U);
  ASSERT_EQ(test::measurement(set, "msd").warnings.size(), 1U);
  EXPECT_NE(test::measurement(set, "msd").warnings[0].find("no more frames from time 0 on"), std::string::npos);
}

TEST(Set, RestingAndSingleDisksAreObserved) {
  const Scene resting = test::box_of({9, 9}, Boundary::reflecting, Boundary::reflecting,
                                     {test::disk({2, 2}, {0, 0}), test::disk({5, 5}, {0, 0})});
  const Scene single = test::box_of({9, 9}, Boundary::periodic, Boundary::periodic, {test::disk({2, 2}, {1, 0.3})});
  const Scene open = test::gas(5, 0.2, Boundary::open);
  for (const Scene& scene : {resting, single, open}) {
    Simulation simulation(realize(scene));
    ObservableSet set = set_of(simulation, test::everything_for({simulation.system(), simulation.frame()}));
    simulation.add_observer(set);
    for (int k = 0; k < 8; ++k) simulation.run_window();
    EXPECT_FALSE(set.results().empty());
  }
}

}  // namespace
}  // namespace carom
