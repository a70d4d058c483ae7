// A batch is collided in two parts: whole vectors of pairs, and the pairs left over.
#pragma once

#include <cstddef>

#include "carom/rule/batch.hpp"

namespace carom::rule {

/// Collides the pairs from `first` to before `last`, one after the other.
void collide_one_by_one(const PairSpans& pairs, double restitution, std::size_t first, std::size_t last) noexcept;

/// Collides pairs from the first on, as many as fill whole vectors, and returns how many. None for Simd::scalar.
/// The caller guarantees that the processor has `simd`.
std::size_t collide_whole_vectors(const PairSpans& pairs, double restitution, Simd simd) noexcept;

}  // namespace carom::rule
