// The contact value of a pair distribution, by extrapolating a polynomial to the distance of contact.
#pragma once

#include <vector>

#include "ideal_pairs.hpp"

namespace carom {

/// Unweighted least squares of a polynomial of fourth degree to g(σ + x) over 0 ≤ x ≤ h, taken at x = 0, without bins:
/// g(σ⁺) = ∫ K(x) g(σ + x) dx with K(x) = Σ (−1)^k (2k + 1) P_k(2x/h − 1)/h, k = 0 … 4, P_k Legendre's polynomials.
/// Exact for polynomials up to fourth degree. It is linear in g, so every frame gives a sample free of bias.
class ContactFit {
 public:
  /// `sigma` is the distance of contact (length). The range h is three quarters of the mean gap between neighbours at
  /// this packing fraction, σ(√(η_cp/η) − 1) with η_cp = π/√12, and at most half of σ: over h, g falls to about 0.4.
  ContactFit(const IdealPairs& ideal, double sigma, double packing_fraction);

  /// Pairs farther apart than this do not count.
  [[nodiscard]] double range() const noexcept { return sigma_ + width_; }
  /// What a pair at this distance adds; the sum over all pairs, divided by their number, is g(σ⁺).
  [[nodiscard]] double weight(double r) const noexcept;

 private:
  [[nodiscard]] double kernel(double x) const noexcept;

  double sigma_;
  double width_;                  // h
  std::vector<double> per_pair_;  // 1/(p(r)/r) at equal steps of x
};

}  // namespace carom
