// A box of 100 disks between walls, run for 10 time units.
#include <carom/carom.hpp>
#include <cstdio>

int main() {
  carom::GasPreset gas;
  gas.disks = 100;
  gas.packing = 0.4;
  gas.boundary = carom::Boundary::reflecting;

  carom::Simulation simulation(carom::realize(carom::make_gas(gas).scene));
  simulation.run_until(10);

  const carom::Summary summary = carom::summarize(simulation);
  std::printf("%llu collisions, energy drift %.1e\n", static_cast<unsigned long long>(summary.collisions),
              summary.energy_drift);
  const carom::Frame frame = simulation.frame();  // positions and velocities at time 10
  std::printf("disk 0 is at (%.3f, %.3f)\n", frame.x[0], frame.y[0]);
}
