// One collision by itself: its parts, and its derivation.
#include "carom/explain/explain.hpp"
#include "carom/rule/collision.hpp"
#include "carom/rule/decomposition.hpp"
#include "exchange.hpp"

namespace carom::page {
namespace {

/// x, y, vx, vy, mass, radius of a disk at contact.
struct Given {
  Vec2 position, velocity;
  double mass, radius;

  explicit Given(const double* n) : position{n[0], n[1]}, velocity{n[2], n[3]}, mass(n[4]), radius(n[5]) {}

  [[nodiscard]] ExplainedDisk explained() const {
    ExplainedDisk disk;
    disk.position = position;
    disk.velocity = velocity;
    disk.mass = mass;
    disk.radius = radius;
    return disk;
  }
};

}  // namespace
}  // namespace carom::page

using namespace carom;
using namespace carom::page;

/// Room for 12 numbers, six for each of two disks, that the two functions below read.
CAROM_EXPORT double* carom_pair() {
  static double numbers[12];
  return numbers;
}

/// Normal and tangent; v1n, v1t, v2n, v2t; the same after; velocities after; momentum before and after; energy before
/// and after; impulse on disk 2; 1 if the disks approach.
CAROM_EXPORT double* carom_collide(double restitution) {
  return guarded<double*>(nullptr, [&] {
    const Given one(carom_pair());
    const Given two(carom_pair() + 6);
    const rule::Velocities v{one.velocity, two.velocity};
    const Vec2 r = two.position - one.position;
    const rule::Velocities f =
        rule::collide({.r = r, .v = v, .m1 = one.mass, .m2 = two.mass, .restitution = restitution});
    const Vec2 un = rule::unit_normal(one.position, two.position);
    const Vec2 ut = rule::unit_tangent(un);
    std::vector<double> numbers{un.x, un.y, ut.x, ut.y};
    for (const Vec2 velocity : {v.first, v.second, f.first, f.second}) {
      const rule::Parts parts = rule::decompose(velocity, un);
      numbers.insert(numbers.end(), {parts.normal, parts.tangential});
    }
    const Vec2 p = one.mass * v.first + two.mass * v.second;
    const Vec2 pf = one.mass * f.first + two.mass * f.second;
    const Vec2 impulse = rule::impulse_on_second(two.mass, v, f);
    numbers.insert(numbers.end(), {f.first.x, f.first.y, f.second.x, f.second.y, p.x, p.y, pf.x, pf.y});
    numbers.push_back(rule::kinetic_energy(one.mass, v.first) + rule::kinetic_energy(two.mass, v.second));
    numbers.push_back(rule::kinetic_energy(one.mass, f.first) + rule::kinetic_energy(two.mass, f.second));
    numbers.insert(numbers.end(), {impulse.x, impulse.y, rule::approach(r, v) < 0 ? 1.0 : 0.0});
    return answer_numbers(std::move(numbers));
  });
}

/// Puts the derivation into the text: format 0 text, 1 Markdown, 2 LaTeX. Returns 0 with the reason as text.
CAROM_EXPORT int carom_explain(double restitution, double time, int format) {
  return guarded(0, [&] {
    ExplainedCollision collision;
    collision.first = Given(carom_pair()).explained();
    collision.second = Given(carom_pair() + 6).explained();
    collision.restitution = restitution;
    collision.time_of_contact = time;
    answer(explain(collision, static_cast<ExplainFormat>(format)));
    return 1;
  });
}
