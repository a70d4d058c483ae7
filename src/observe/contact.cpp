#include "contact.hpp"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr int kDegree = 4;
constexpr double kShareOfGap = 0.75;
constexpr double kMostWidth = 0.5;                    // in σ
constexpr double kClosePacking = 0.9068996821171089;  // π/√12
constexpr int kSteps = 128;

double width_of_fit(double sigma, double packing_fraction) {
  const double gap = std::sqrt(kClosePacking / std::min(packing_fraction, 0.999 * kClosePacking)) - 1;
  return sigma * std::min(kShareOfGap * gap, kMostWidth);
}

}  // namespace

ContactFit::ContactFit(const IdealPairs& ideal, double sigma, double packing_fraction)
    : sigma_(sigma), width_(width_of_fit(sigma, packing_fraction)) {
  for (int step = 0; step <= kSteps; ++step) {
    const double r = sigma_ + width_ * step / kSteps;
    per_pair_.push_back(r / ideal.density(r));
  }
}

double ContactFit::weight(double r) const noexcept {
  // A pair that rounding left a hair too close is in contact.
  const double x = std::max(r - sigma_, 0.0);
  if (x > width_) return 0;
  const double place = std::min(x / width_ * kSteps, kSteps - 1e-9);
  const auto step = static_cast<std::size_t>(place);
  const double between = place - static_cast<double>(step);
  const double per_pair = per_pair_[step] + between * (per_pair_[step + 1] - per_pair_[step]);
  return kernel(x) * per_pair / r;
}

double ContactFit::kernel(double x) const noexcept {
  const double t = 2 * x / width_ - 1;
  double before = 1;  // P_{k−1}(t), P_k(t)
  double legendre = t;
  double sum = 1;
  for (int k = 1; k <= kDegree; ++k) {
    sum += (k % 2 == 0 ? 1 : -1) * (2 * k + 1) * legendre;
    const double next = ((2 * k + 1) * t * legendre - k * before) / (k + 1);
    before = legendre;
    legendre = next;
  }
  return sum / width_;
}

}  // namespace carom
