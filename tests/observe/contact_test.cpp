// Property: the contact fit gives back every polynomial of fourth degree, and nearly every exponential.
#include "observe/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "order/arrangements.hpp"

namespace carom {
namespace {

/// Σ of weights over the pairs of a gas with this g(σ + x), per pair.
double fitted(const ContactFit& fit, const IdealPairs& ideal, double sigma, const std::function<double(double)>& g) {
  const int steps = 10'000;
  const double dx = (fit.range() - sigma) / steps;
  double sum = 0;
  for (int step = 0; step < steps; ++step) {
    const double x = (step + 0.5) * dx;
    sum += fit.weight(sigma + x) * ideal.density(sigma + x) * g(x) * dx;
  }
  return sum;
}

TEST(ContactFit, IsExactForPolynomialsOfFourthDegree) {
  for (const auto& boundary : {kPeriodic, kReflecting}) {
    const IdealPairs ideal({{20, 30}, boundary}, 0.5, 0.3);
    const ContactFit fit(ideal, 0.8, 0.6);
    const auto g = [](double x) { return 4 - 20 * x + 70 * x * x - 150 * x * x * x + 300 * x * x * x * x; };
    EXPECT_NEAR(fitted(fit, ideal, 0.8, g), 4, 1e-4);
  }
}

// g of dense disks falls over a mean gap between neighbours by a factor of e, about.
TEST(ContactFit, IsCloseForWhatHardDisksDo) {
  const IdealPairs ideal({{20, 20}, kPeriodic}, 0.5, 0.5);
  for (const double eta : {0.1, 0.4, 0.6, 0.7, 0.8}) {
    const ContactFit fit(ideal, 1, eta);
    const double gap = std::sqrt(0.9069 / eta) - 1;
    EXPECT_NEAR(fitted(fit, ideal, 1, [gap](double x) { return std::exp(-x / gap); }), 1, 1e-4) << eta;
    EXPECT_LT(fit.range(), 1.51);
  }
}

TEST(ContactFit, APairTooCloseByRoundingIsInContact) {
  const ContactFit fit(IdealPairs({{20, 20}, kPeriodic}, 0.5, 0.5), 1, 0.5);
  EXPECT_NEAR(fit.weight(1 - 1e-15), fit.weight(1), 1e-9);
  EXPECT_EQ(fit.weight(fit.range() * 1.0001), 0);
}

}  // namespace
}  // namespace carom
