// The façade alone: make a scene, simulate it, report.
#include <cstdio>
#include <string>

#include "carom/carom.hpp"

int main() {
  carom::Simulation simulation(carom::realize(carom::make_two_disks().scene));
  simulation.run_until(10);
  const carom::Summary summary = carom::summarize(simulation);
  std::printf("carom %s: digest %s\n", std::string(carom::version()).c_str(), summary.digest.c_str());
  return summary.collisions == 1 && carom::violations(summary).empty() ? 0 : 1;
}
