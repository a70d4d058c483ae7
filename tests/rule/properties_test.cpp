// Property: the rule has the symmetries of mechanics, exactly where floating-point arithmetic has them too, else to
// rounding. Cases are drawn by RapidCheck from a fixed seed (RC_PARAMS in the environment takes its place).
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "carom/rule/collision.hpp"
#include "carom/rule/decomposition.hpp"

namespace carom::rule {
namespace {

[[maybe_unused]] const int kSeedIsFixed = setenv("RC_PARAMS", "seed=20250101 max_success=1000", 0);

/// Relative to |v1| + |v2|: some ten roundings.
constexpr double kRounding = 2e-15;

double speeds(const Velocities& v) { return length(v.first) + length(v.second); }
double distance(const Velocities& a, const Velocities& b) {
  return std::max(length(a.first - b.first), length(a.second - b.second));
}
Velocities negative(const Velocities& v) { return {-v.first, -v.second}; }

// --- generators -----------------------------------------------------------------------------------------------

rc::Gen<double> in_unit_interval() {
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(0, (1LL << 53) + 1)),
                      [](std::int64_t n) { return static_cast<double>(n) * 0x1p-53; });
}

/// ± (1 … 2) · 2^k, k in −20 … 19: 12 decades; sometimes 0.
rc::Gen<double> any_component() {
  return rc::gen::map(rc::gen::tuple(in_unit_interval(), rc::gen::inRange(-20, 20), rc::gen::inRange(0, 20)),
                      [](const std::tuple<double, int, int>& t) {
                        const auto& [mantissa, exponent, kind] = t;
                        if (kind == 0) return 0.0;
                        return std::ldexp(kind % 2 == 0 ? 1 + mantissa : -1 - mantissa, exponent);
                      });
}

rc::Gen<Vec2> any_vector() {
  return rc::gen::map(rc::gen::pair(any_component(), any_component()), [](std::pair<double, double> p) {
    return Vec2{p.first, p.second};
  });
}

rc::Gen<double> any_mass() {
  return rc::gen::map(rc::gen::pair(in_unit_interval(), rc::gen::inRange(-20, 20)),
                      [](std::pair<double, int> p) { return std::ldexp(1 + p.first, p.second); });
}

/// Approaching, unless the velocities are equal or along the tangent. Elastic.
Contact contact() {
  Contact contact{.r = *rc::gen::suchThat(any_vector(), [](Vec2 r) { return r != Vec2{}; }),
                  .v = {*any_vector(), *any_vector()},
                  .m1 = *any_mass(),
                  .m2 = *any_mass()};
  if (approach(contact.r, contact.v) > 0) contact.r = -contact.r;
  return contact;
}

Contact inelastic_contact() {
  Contact inelastic = contact();
  inelastic.restitution = *in_unit_interval();
  return inelastic;
}

// --- exact symmetries -----------------------------------------------------------------------------------------

RC_GTEST_PROP(Symmetry, ExchangeOfLabelsKeepsTheBits, ()) {
  const Contact a = inelastic_contact();
  const Contact b{.r = -a.r, .v = {a.v.second, a.v.first}, .m1 = a.m2, .m2 = a.m1, .restitution = a.restitution};
  const Velocities after = collide(b);
  RC_ASSERT((Velocities{after.second, after.first} == collide(a)));
}

RC_GTEST_PROP(Symmetry, QuarterTurnKeepsTheBits, ()) {
  const auto turn = [](Vec2 a) { return Vec2{-a.y, a.x}; };
  const Contact a = inelastic_contact();
  Contact turned = a;
  turned.r = turn(a.r);
  turned.v = {turn(a.v.first), turn(a.v.second)};
  const Velocities after = collide(a);
  RC_ASSERT((Velocities{turn(after.first), turn(after.second)} == collide(turned)));
}

RC_GTEST_PROP(Symmetry, MirrorKeepsTheBits, ()) {
  const auto mirror = [](Vec2 a) { return Vec2{-a.x, a.y}; };
  const Contact a = inelastic_contact();
  Contact mirrored = a;
  mirrored.r = mirror(a.r);
  mirrored.v = {mirror(a.v.first), mirror(a.v.second)};
  const Velocities after = collide(a);
  RC_ASSERT((Velocities{mirror(after.first), mirror(after.second)} == collide(mirrored)));
}

RC_GTEST_PROP(Symmetry, PowersOfTwoKeepTheBits, ()) {
  // Units of length, speed and mass are free; r need not be normalised.
  const Contact a = inelastic_contact();
  Contact scaled = a;
  scaled.r = 8.0 * a.r;
  scaled.v = {0.25 * a.v.first, 0.25 * a.v.second};
  scaled.m1 = 1024 * a.m1;
  scaled.m2 = 1024 * a.m2;
  const Velocities after = collide(a);
  RC_ASSERT((Velocities{0.25 * after.first, 0.25 * after.second} == collide(scaled)));
}

RC_GTEST_PROP(Symmetry, PairsThatDoNotApproachKeepTheirBits, ()) {
  Contact receding = inelastic_contact();
  receding.r = -receding.r;
  RC_PRE(approach(receding.r, receding.v) >= 0);
  RC_ASSERT(collide(receding) == receding.v);
}

// --- symmetries to rounding -----------------------------------------------------------------------------------

RC_GTEST_PROP(Symmetry, AnyRotation, ()) {
  const double angle = 6.283185307179586 * *in_unit_interval();
  const auto turn = [c = std::cos(angle), s = std::sin(angle)](Vec2 a) {
    return Vec2{c * a.x - s * a.y, s * a.x + c * a.y};
  };
  const Contact a = inelastic_contact();
  Contact turned = a;
  turned.r = turn(a.r);
  turned.v = {turn(a.v.first), turn(a.v.second)};
  const Velocities after = collide(a);
  RC_ASSERT(distance({turn(after.first), turn(after.second)}, collide(turned)) <= 2 * kRounding * speeds(a.v));
}

RC_GTEST_PROP(Symmetry, LengthOfTheLineOfCentresDoesNotMatter, ()) {
  const Contact a = inelastic_contact();
  Contact scaled = a;
  scaled.r = (0.5 + *in_unit_interval()) * a.r;
  RC_ASSERT(distance(collide(a), collide(scaled)) <= 2 * kRounding * speeds(a.v));
}

RC_GTEST_PROP(Symmetry, MovingObserver, ()) {
  const Vec2 u = *any_vector();
  const Contact a = inelastic_contact();
  Contact seen = a;
  seen.v = {a.v.first + u, a.v.second + u};
  const Velocities after = collide(seen);
  RC_ASSERT(distance({after.first - u, after.second - u}, collide(a)) <= 2 * kRounding * (speeds(a.v) + length(u)));
}

RC_GTEST_PROP(Symmetry, Reversal, ()) {
  const Contact a = contact();
  Contact back = a;
  back.v = negative(collide(a));
  RC_ASSERT(distance(negative(collide(back)), a.v) <= 2 * kRounding * speeds(a.v));
}

// --- conservation ---------------------------------------------------------------------------------------------

RC_GTEST_PROP(Conservation, MomentumForAnyRestitution, ()) {
  const Contact a = inelastic_contact();
  const Velocities after = collide(a);
  const Vec2 change = a.m1 * (after.first - a.v.first) + a.m2 * (after.second - a.v.second);
  RC_ASSERT(length(change) <= 1e-14 * (a.m1 * length(a.v.first) + a.m2 * length(a.v.second)));
}

RC_GTEST_PROP(Conservation, EnergyLossIsThatOfTheNormalMotion, ()) {
  const Contact a = inelastic_contact();
  const Velocities after = collide(a);
  const double before = kinetic_energy(a.m1, a.v.first) + kinetic_energy(a.m2, a.v.second);
  const double lost = before - kinetic_energy(a.m1, after.first) - kinetic_energy(a.m2, after.second);
  const double mu = a.m1 * a.m2 / (a.m1 + a.m2);
  const double normal = std::min(0.0, approach(a.r, a.v)) / length(a.r);
  const double expected = 0.5 * mu * (1 - a.restitution) * (1 + a.restitution) * normal * normal;
  RC_ASSERT(std::abs(lost - expected) <= 1e-14 * before);
}

RC_GTEST_PROP(Conservation, EnergyIfElastic, ()) {
  const Contact a = contact();
  const Velocities after = collide(a);
  const double before = kinetic_energy(a.m1, a.v.first) + kinetic_energy(a.m2, a.v.second);
  RC_ASSERT(std::abs(kinetic_energy(a.m1, after.first) + kinetic_energy(a.m2, after.second) - before) <=
            1e-14 * before);
}

// --- what happens along the normal and the tangent ------------------------------------------------------------

RC_GTEST_PROP(Parts, TangentialPartsStay, ()) {
  const Contact a = inelastic_contact();
  const Velocities after = collide(a);
  const Vec2 tangent = unit_tangent(unit_normal({}, a.r));
  RC_ASSERT(std::abs(dot(tangent, after.first - a.v.first)) <= kRounding * speeds(a.v));
  RC_ASSERT(std::abs(dot(tangent, after.second - a.v.second)) <= kRounding * speeds(a.v));
}

RC_GTEST_PROP(Parts, ApproachIsReversedAndReducedByRestitution, ()) {
  const Contact a = inelastic_contact();
  const Vec2 normal = unit_normal({}, a.r);
  const double after = approach(normal, collide(a));
  RC_ASSERT(std::abs(after + a.restitution * approach(normal, a.v)) <= 2 * kRounding * speeds(a.v));
}

RC_GTEST_PROP(Parts, PairDoesNotApproachAfterwards, ()) {
  const Contact a = inelastic_contact();
  RC_ASSERT(approach(a.r, collide(a)) >= 0);
}

RC_GTEST_PROP(Parts, TakenApartAndPutTogetherIsTheSame, ()) {
  const Contact a = inelastic_contact();
  RC_PRE(approach(a.r, a.v) < 0);
  const Vec2 normal = unit_normal({}, a.r);
  const CollidedParts parts =
      collide_parts(a.m1, decompose(a.v.first, normal), a.m2, decompose(a.v.second, normal), a.restitution);
  RC_ASSERT(distance({compose(parts.first, normal), compose(parts.second, normal)}, collide(a)) <=
            2 * kRounding * speeds(a.v));
}

RC_GTEST_PROP(Parts, Equations5And6AreTheElasticCase, ()) {
  const Contact a = contact();
  const LineVelocities general = collide_on_line(a.m1, a.v.first.x, a.m2, a.v.second.x, 1);
  const LineVelocities text = collide_on_line(a.m1, a.v.first.x, a.m2, a.v.second.x);
  RC_ASSERT(std::abs(general.v1 - text.v1) <= kRounding * speeds(a.v));
  RC_ASSERT(std::abs(general.v2 - text.v2) <= kRounding * speeds(a.v));
}

RC_GTEST_PROP(Parts, EquationsAToDAreTheCaseOfEqualMasses, ()) {
  Contact a = contact();
  RC_PRE(approach(a.r, a.v) < 0);
  a.m2 = a.m1;
  RC_ASSERT(distance(collide(a), collide_equal_masses(a.r, a.v)) <= 2 * kRounding * speeds(a.v));
}

RC_GTEST_PROP(Parts, InfiniteMassIsAWall, ()) {
  Contact a = inelastic_contact();
  a.m2 = std::numeric_limits<double>::infinity();
  a.v.second = {};
  a.r = *rc::gen::element(Vec2{1, 0}, Vec2{-1, 0});
  RC_PRE(approach(a.r, a.v) < 0);
  const Velocities after = collide(a);
  RC_ASSERT(std::abs(after.first.x - reflect(a.v.first.x, a.restitution)) <= kRounding * std::abs(a.v.first.x));
  RC_ASSERT(after.first.y == a.v.first.y);
  RC_ASSERT(after.second == Vec2{});
}

RC_GTEST_PROP(Parts, ImpulseIsAlongTheLineOfCentresAndOpposite, ()) {
  const Contact a = inelastic_contact();
  const Velocities after = collide(a);
  const Vec2 impulse = impulse_on_second(a.m2, a.v, after);
  const double scale = a.m1 * length(a.v.first) + a.m2 * length(a.v.second);
  RC_ASSERT(std::abs(cross(unit_normal({}, a.r), impulse)) <= kRounding * scale);
  RC_ASSERT(dot(a.r, impulse) >= -kRounding * scale * length(a.r));
  RC_ASSERT(length(impulse + impulse_on_second(a.m1, {{}, a.v.first}, {{}, after.first})) <= 4 * kRounding * scale);
}

}  // namespace
}  // namespace carom::rule
