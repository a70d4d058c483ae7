// Random numbers that depend on what they are for, not on when they are drawn.
#pragma once

#include <array>
#include <cstdint>

namespace carom {

/// A stream of random numbers keyed by (seed, stream, purpose), from the counter-based generator
/// Philox4x32-10 (Salmon et al., SC11). Two streams with different keys are independent; the same key
/// gives the same numbers on every machine. Draws use comparisons and + − × ÷ only, no libm.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream, std::uint32_t purpose) noexcept;

  /// 64 random bits.
  std::uint64_t bits() noexcept;

  /// Uniform in [0, 1), a multiple of 2⁻⁵³.
  double uniform() noexcept;

  /// Uniform among 0 … bound − 1 without bias. The caller guarantees bound > 0.
  std::uint64_t below(std::uint64_t bound) noexcept;

  /// Normal with mean 0 and variance 1, by Karney's Algorithm N (ACM TOMS 42, 3, 2016): comparisons
  /// of uniforms only, so the bits do not depend on a libm.
  double normal() noexcept;

 private:
  bool true_with_exp_minus_half() noexcept;
  bool accept_fraction(int k, double x) noexcept;

  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint64_t, 2> block_{};
  int left_ = 0;
};

}  // namespace carom
