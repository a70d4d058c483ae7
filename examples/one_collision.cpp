// One collision: a disk of mass 3 meets one of mass 1.5 obliquely.
#include <carom/rule/collision.hpp>
#include <cstdio>

int main() {
  const carom::rule::Velocities after = carom::rule::collide({
      .r = {1, 1},               // from centre 1 to centre 2; its length does not matter
      .v = {{2, 1}, {-1, 0.5}},  // velocities before
      .m1 = 3,
      .m2 = 1.5,
      .restitution = 1,
  });
  std::printf("disk 1: (%g, %g)\n", after.first.x, after.first.y);
  std::printf("disk 2: (%g, %g)\n", after.second.x, after.second.y);
}
