#include "carom/rule/batch.hpp"

#include <cassert>

#include "batch_parts.hpp"
#include "carom/rule/collision.hpp"

namespace carom::rule {
namespace {

[[maybe_unused]] bool have_one_length(const PairSpans& pairs) noexcept {
  for (const std::size_t length : {pairs.y1.size(), pairs.m1.size(), pairs.x2.size(), pairs.y2.size(), pairs.m2.size(),
                                   pairs.vx1.size(), pairs.vy1.size(), pairs.vx2.size(), pairs.vy2.size()}) {
    if (length != pairs.size()) return false;
  }
  return true;
}

Contact contact_of(const PairSpans& pairs, std::size_t k, double restitution) noexcept {
  return {.r = {pairs.x2[k] - pairs.x1[k], pairs.y2[k] - pairs.y1[k]},
          .v = {{pairs.vx1[k], pairs.vy1[k]}, {pairs.vx2[k], pairs.vy2[k]}},
          .m1 = pairs.m1[k],
          .m2 = pairs.m2[k],
          .restitution = restitution};
}

}  // namespace

void collide_one_by_one(const PairSpans& pairs, double restitution, std::size_t first, std::size_t last) noexcept {
  for (std::size_t k = first; k < last; ++k) {
    const Velocities after = collide(contact_of(pairs, k, restitution));
    pairs.vx1[k] = after.first.x;
    pairs.vy1[k] = after.first.y;
    pairs.vx2[k] = after.second.x;
    pairs.vy2[k] = after.second.y;
  }
}

void collide_batch(const PairSpans& pairs, double restitution, std::optional<Simd> simd) {
  assert(have_one_length(pairs));
  const std::size_t done = collide_whole_vectors(pairs, restitution, usable_simd(simd));
  collide_one_by_one(pairs, restitution, done, pairs.size());
}

}  // namespace carom::rule
