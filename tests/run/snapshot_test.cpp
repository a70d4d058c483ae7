// A simulation made of a snapshot goes on with the bits of the one it was taken of; a snapshot that no simulation can
// have made is refused.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "carom/base/error.hpp"
#include "carom/run/simulation.hpp"
#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::gas;

void expect_same(Simulation& a, Simulation& b, double time) {
  a.run_until(time);
  b.run_until(time);
  const Summary one = summarize(a);
  const Summary other = summarize(b);
  EXPECT_EQ(one.digest, other.digest);
  EXPECT_EQ(one.pressure, other.pressure);
  EXPECT_EQ(one.energy_drift, other.energy_drift);
  EXPECT_EQ(one.windows, other.windows);
  EXPECT_EQ(a.books().events_of, b.books().events_of);
  EXPECT_EQ(a.books().virial_of, b.books().virial_of);
  EXPECT_EQ(a.books().wall_impulse_of, b.books().wall_impulse_of);
}

TEST(Snapshot, GoesOnWithTheSameBits) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting, Boundary::open}) {
    for (const double restitution : {1.0, 0.9}) {
      Scene scene = gas(60, 0.5, boundary);
      scene.restitution = restitution;
      Simulation straight(realize(scene));
      straight.measure_from(2);
      straight.run_until(4.3);
      SolverOptions reference;
      reference.kind = SolverKind::reference;
      Simulation other(straight.snapshot(), reference);
      expect_same(straight, other, 9.1);
    }
  }
}

TEST(Snapshot, IsThatOfTheWindowsStart) {
  Simulation simulation(realize(gas(60, 0.5)));
  simulation.run_window();
  const Snapshot before = simulation.snapshot();
  simulation.run_until(simulation.time() + 0.5 * simulation.window_start().clock.length);
  const Snapshot after = simulation.snapshot();
  EXPECT_EQ(after.books.collisions, before.books.collisions);
  EXPECT_EQ(after.state.disks.x, before.state.disks.x);
  EXPECT_GT(simulation.books().collisions, after.books.collisions);
}

TEST(Snapshot, GoesOnInPatches) {
  Simulation straight(realize(gas(3000, 0.7)));
  straight.run_window();
  ParallelOptions parallel;
  parallel.threads = 2;
  parallel.patches = {2, 2};
  Simulation other(straight.snapshot(), {}, parallel);
  EXPECT_EQ(other.division().patches, 4U);
  const double time = straight.time() + 1.5 * straight.window_start().clock.length;
  expect_same(straight, other, time);
}

TEST(Snapshot, RefusesWhatNoSimulationHasMade) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Scene scene = gas(20, 0.3);
  scene.restitution = 0.9;
  Simulation simulation(realize(scene));
  simulation.run_until(3);
  const Snapshot sound = simulation.snapshot();
  EXPECT_TRUE(faults_of(sound).empty());
  const std::vector<std::function<void(Snapshot&)>> damages{
      [](Snapshot& s) { s.state.disks.x.pop_back(); },
      [](Snapshot& s) { s.state.disks.x[3] = kNan; },
      [](Snapshot& s) { s.state.disks.x[1] = s.state.disks.x[0], s.state.disks.y[1] = s.state.disks.y[0]; },
      [](Snapshot& s) { s.state.disks.vx[2] = 1e70; },
      [](Snapshot& s) { s.state.disks.winding_y[0] = std::numeric_limits<std::int64_t>::min(); },
      [](Snapshot& s) { s.state.disks.time = 1e-3; },
      [](Snapshot& s) { s.state.last_contact.clear(); },
      [](Snapshot& s) { s.state.last_contact[4] = 0.5; },
      [](Snapshot& s) { s.state.last_contact[4] = kNan; },
      [](Snapshot& s) { s.state.clock.length = 0.75; },
      [](Snapshot& s) { s.state.clock.length = 0; },
      [](Snapshot& s) { s.state.clock.length = kNan; },
      [](Snapshot& s) { s.state.clock.start = s.state.disks.time = 0.3; },
      [](Snapshot& s) { s.state.clock.start = s.state.disks.time = -1; },
      [](Snapshot& s) { s.state.clock.window = std::numeric_limits<std::uint64_t>::max(); },
      [](Snapshot& s) { s.books.events_of.push_back(0); },
      [](Snapshot& s) { s.books.virial_of[0] = -1; },
      [](Snapshot& s) { s.books.largest_overlap = kNan; },
      [](Snapshot& s) { s.books.collisions = std::numeric_limits<std::uint64_t>::max(); },
      [](Snapshot& s) { s.measured.start = 1e9; },
      [](Snapshot& s) { s.initial.energy = kNan; },
      [](Snapshot& s) { s.system.physics.restitution = 2; },
      [](Snapshot& s) { s.system.box.size.x = -1; }};
  for (std::size_t k = 0; k < damages.size(); ++k) {
    Snapshot damaged = sound;
    damages[k](damaged);
    EXPECT_FALSE(faults_of(damaged).empty()) << "damage " << k;
    EXPECT_THROW(Simulation{damaged}, Error) << "damage " << k;
  }
}

}  // namespace
}  // namespace carom
