// The rule for many pairs at once, over structure-of-arrays.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "carom/base/simd.hpp"

namespace carom::rule {

/// Pairs as arrays of equal length: entry k of every span belongs to pair k. Centres in lengths, velocities
/// in length/time, masses positive (at most one of a pair infinite). Velocities are overwritten.
struct PairSpans {
  std::span<const double> x1, y1, m1;
  std::span<const double> x2, y2, m2;
  std::span<double> vx1, vy1;
  std::span<double> vx2, vy2;

  [[nodiscard]] std::size_t size() const noexcept { return x1.size(); }
};

/// rule::collide for every pair, with the same bits. Pairs that do not approach keep their velocities.
/// The caller guarantees spans of one length that do not overlap; they may begin at any double.
/// `simd`: one of available_simd(), the fastest by default; throws Error if the processor lacks it.
void collide_batch(const PairSpans& pairs, double restitution = 1, std::optional<Simd> simd = {});

}  // namespace carom::rule
