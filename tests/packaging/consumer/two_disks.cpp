// Two equal disks meet head on and exchange their velocities: once by the rule, once in a simulation.
#include <cstdio>
#include <utility>

#include "carom/rule/collision.hpp"
#include "carom/run/simulation.hpp"

int main() {
  const carom::rule::Velocities before{{1, 0}, {-1, 0}};
  const carom::rule::Velocities after = carom::rule::collide({.r = {1, 0}, .v = before});
  if (after != carom::rule::Velocities{{-1, 0}, {1, 0}}) {
    std::puts("the rule did not exchange the velocities");
    return 1;
  }

  carom::Scene scene;
  scene.size = carom::Vec2{10, 10};
  scene.disks = {{.position = {2, 5}, .velocity = {1, 0}, .place = {}},
                 {.position = {8, 5}, .velocity = {-1, 0}, .place = {}}};
  carom::Simulation simulation(carom::realize(scene));
  simulation.run_until(4);
  const carom::Frame frame = simulation.frame();
  if (simulation.books().collisions != 1 || frame.velocity(0) != carom::Vec2{-1, 0}) {
    std::puts("the simulation did not exchange the velocities");
    return 1;
  }
  std::printf("digest %s\n", carom::digest(frame).c_str());
  return 0;
}
