// The rule for as many pairs at once as a vector has lanes. carom/rule/collision.hpp is the home of the formulas: what
// bears a name from there repeats it here operation by operation, for the same bits; tests/rule/batch_test.cpp holds
// the two together.

#include "batch_parts.hpp"

#if defined(__x86_64__)

// Highway includes this file once for every instruction set. The name is seen from the folder of public headers.
#define HWY_TARGET_INCLUDE "../src/rule/batch_vectors.cpp"
#define HWY_COMPILE_ALL_ATTAINABLE  // also those below what the compiler was told to assume
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET & (HWY_SSE4 | HWY_AVX2 | HWY_AVX3)

HWY_BEFORE_NAMESPACE();
namespace carom::rule::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::ScalableTag<double> kTag;
using Number = hn::Vec<decltype(kTag)>;  // one number of each pair
using Which = hn::Mask<decltype(kTag)>;  // some of the pairs

struct Vectors {
  Number x;
  Number y;
};

HWY_INLINE Vectors operator+(Vectors a, Vectors b) { return {a.x + b.x, a.y + b.y}; }
HWY_INLINE Vectors operator-(Vectors a, Vectors b) { return {a.x - b.x, a.y - b.y}; }
HWY_INLINE Vectors operator*(Number s, Vectors a) { return {s * a.x, s * a.y}; }
HWY_INLINE Number dot(Vectors a, Vectors b) { return a.x * b.x + a.y * b.y; }

struct Velocities {
  Vectors first;
  Vectors second;
};

HWY_INLINE Number approach(Vectors r, Velocities v) { return dot(r, v.second - v.first); }

HWY_INLINE Number share_of_first(Number mass_a, Number mass_b) {
  const Number one = hn::Set(kTag, 1.0);
  return one / (one + mass_a / mass_b);
}

struct Unrounded {
  Number value;
  Number rest;
};

HWY_INLINE Unrounded product(Number a, Number b) {
  const Number split = hn::Set(kTag, 0x1p27 + 1);
  const Number a_high = split * a - (split * a - a);
  const Number b_high = split * b - (split * b - b);
  const Number a_low = a - a_high;
  const Number b_low = b - b_high;
  const Number value = a * b;
  return {value, a_low * b_low - (((value - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

HWY_INLINE Unrounded squared_length(Vectors r) {
  const Unrounded x = product(r.x, r.x);
  const Unrounded y = product(r.y, r.y);
  const Number value = x.value + y.value;
  const Number y_part = value - x.value;
  const Number rest = (x.value - (value - y_part)) + (y.value - y_part);
  return {value, rest + (x.rest + y.rest)};
}

HWY_INLINE Number change_of_relative_velocity(Vectors r, Number b, Number one_plus_restitution) {
  const Number dividend = one_plus_restitution * b;
  const Unrounded divisor = squared_length(r);
  const Number quotient = dividend / divisor.value;
  const Unrounded back = product(quotient, divisor.value);
  const Number remainder = ((dividend - back.value) - back.rest) - quotient * divisor.rest;
  return quotient + remainder / divisor.value;
}

struct Contact {
  Vectors r;
  Velocities v;
  Number m1;
  Number m2;
};

HWY_INLINE Velocities with_impulse(const Contact& contact, Number change) {
  return {contact.v.first + (change * share_of_first(contact.m1, contact.m2)) * contact.r,
          contact.v.second - (change * share_of_first(contact.m2, contact.m1)) * contact.r};
}

/// For the pairs of `which`; what it returns for the others is of no use.
HWY_INLINE Velocities separate(const Contact& contact, Number change, Which which) {
  const Velocities& v = contact.v;
  const Number speeds = (hn::Abs(v.first.x) + hn::Abs(v.first.y)) + (hn::Abs(v.second.x) + hn::Abs(v.second.y));
  Number extra = hn::Set(kTag, 0x1p-53) * speeds / hn::Sqrt(dot(contact.r, contact.r));
  Velocities after = with_impulse(contact, change - extra);
  for (int doubling = 0; doubling < 64; ++doubling) {
    const Which again = hn::And(which, approach(contact.r, after) < hn::Zero(kTag));
    if (hn::AllFalse(kTag, again)) break;
    extra = hn::IfThenElse(again, extra + extra, extra);
    after = with_impulse(contact, change - extra);
  }
  return after;
}

HWY_INLINE Number load(std::span<const double> numbers, std::size_t k) { return hn::LoadU(kTag, numbers.data() + k); }

HWY_INLINE void store(Vectors vectors, std::span<double> x, std::span<double> y, std::size_t k) {
  hn::StoreU(vectors.x, kTag, x.data() + k);
  hn::StoreU(vectors.y, kTag, y.data() + k);
}

HWY_INLINE Contact load_contact(const PairSpans& pairs, std::size_t k) {
  return {Vectors{load(pairs.x2, k), load(pairs.y2, k)} - Vectors{load(pairs.x1, k), load(pairs.y1, k)},
          {{load(pairs.vx1, k), load(pairs.vy1, k)}, {load(pairs.vx2, k), load(pairs.vy2, k)}},
          load(pairs.m1, k),
          load(pairs.m2, k)};
}

HWY_INLINE Velocities choose(Which which, Velocities a, Velocities b) {
  return {{hn::IfThenElse(which, a.first.x, b.first.x), hn::IfThenElse(which, a.first.y, b.first.y)},
          {hn::IfThenElse(which, a.second.x, b.second.x), hn::IfThenElse(which, a.second.y, b.second.y)}};
}

/// Collides the pairs from k on, a vector of them. Returns whether all that approached have parted; where velocities
/// became too large to be numbers, they are left as they were.
HWY_INLINE bool collide_lanes(const PairSpans& pairs, std::size_t k, Number one_plus_restitution) {
  const Contact contact = load_contact(pairs, k);
  const Number b = approach(contact.r, contact.v);
  const Which approaching = b < hn::Zero(kTag);
  const Number change = change_of_relative_velocity(contact.r, b, one_plus_restitution);
  Velocities after = with_impulse(contact, change);
  Number b_after = approach(contact.r, after);
  const Which again = hn::And(approaching, b_after < hn::Zero(kTag));
  if (!hn::AllFalse(kTag, again)) {
    after = choose(again, separate(contact, change, again), after);
    b_after = approach(contact.r, after);
  }
  const Which parted = hn::And(approaching, b_after >= hn::Zero(kTag));
  after = choose(parted, after, contact.v);
  store(after.first, pairs.vx1, pairs.vy1, k);
  store(after.second, pairs.vx2, pairs.vy2, k);
  return hn::AllFalse(kTag, hn::AndNot(parted, approaching));
}

std::size_t collide_whole_vectors(const PairSpans& pairs, double restitution) noexcept {
  const std::size_t lanes = hn::Lanes(kTag);
  const std::size_t whole = pairs.size() - pairs.size() % lanes;
  const Number one_plus_restitution = hn::Set(kTag, 1 + restitution);
  for (std::size_t k = 0; k < whole; k += lanes) {
    // Changes only the pairs that have not parted: the others no longer approach.
    if (!collide_lanes(pairs, k, one_plus_restitution)) collide_one_by_one(pairs, restitution, k, k + lanes);
  }
  return whole;
}

}  // namespace
}  // namespace carom::rule::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
#endif

#if !defined(__x86_64__) || HWY_ONCE

namespace carom::rule {

std::size_t collide_whole_vectors([[maybe_unused]] const PairSpans& pairs, [[maybe_unused]] double restitution,
                                  Simd simd) noexcept {
  switch (simd) {
#if defined(__x86_64__)
    case Simd::sse4: return N_SSE4::collide_whole_vectors(pairs, restitution);
    case Simd::avx2: return N_AVX2::collide_whole_vectors(pairs, restitution);
    case Simd::avx512: return N_AVX3::collide_whole_vectors(pairs, restitution);
#endif
    default: return 0;
  }
}

}  // namespace carom::rule

#endif
