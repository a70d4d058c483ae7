// Blocking and batches tell the error of the mean of correlated samples, and that a run was too short to tell.
#include "carom/observe/blocking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "carom/base/random.hpp"
#include "carom/observe/batches.hpp"

namespace carom {
namespace {

/// x' = a x + √(1 − a²) ξ: variance 1, ρ(k) = a^k, and so Σ ρ = a/(1−a) and Var(mean) = (1+a)/(1−a)/n for large n.
class Ar1 {
 public:
  Ar1(double a, std::uint64_t seed) : a_(a), random_(seed, 0, 7), x_(random_.normal()) {}
  double next() { return x_ = a_ * x_ + std::sqrt(1 - a_ * a_) * random_.normal(); }

 private:
  double a_;
  RandomStream random_;
  double x_;
};

double true_error(double a, double n) { return std::sqrt((1 + a) / (1 - a) / n); }

Blocking::Result blocked(double a, int n, std::uint64_t seed) {
  Ar1 process(a, seed);
  Blocking blocking;
  for (int k = 0; k < n; ++k) blocking.add(process.next());
  return blocking.result();
}

TEST(Blocking, IsTheStandardErrorOfIndependentSamples) {
  const Blocking::Result result = blocked(0, 1 << 14, 1);
  EXPECT_EQ(result.samples, 1U << 14);
  ASSERT_TRUE(result.error);
  EXPECT_NEAR(*result.error / true_error(0, 1 << 14), 1, 0.08);
  EXPECT_NEAR(result.correlation, 0, 0.1);
  EXPECT_GE(result.blocks, 256U);
}

TEST(Blocking, FindsErrorAndCorrelationTimeOfAnAutoregressiveProcess) {
  for (const double tau : {3.0, 10.0, 30.0}) {
    const double a = std::exp(-1 / tau);
    const int n = 1 << 16;
    double error = 0;
    double correlation = 0;
    constexpr int kRuns = 10;
    for (int run = 0; run < kRuns; ++run) {
      const Blocking::Result result = blocked(a, n, 100 + static_cast<std::uint64_t>(run));
      ASSERT_TRUE(result.error);
      EXPECT_GE(result.blocks, 16U);
      error += *result.error / kRuns;
      correlation += result.correlation / kRuns;
    }
    EXPECT_NEAR(error / true_error(a, n), 1, 0.1) << tau;
    EXPECT_NEAR(correlation / (a / (1 - a)), 1, 0.2) << tau;
  }
}

TEST(Blocking, ErrorsCoverTheTruth) {
  // The mean is 0: in one run of three it lies outside one error, in one of twenty outside two.
  int outside_one = 0;
  int outside_two = 0;
  for (std::uint64_t run = 0; run < 200; ++run) {
    const Blocking::Result result = blocked(std::exp(-1 / 5.0), 4096, 1000 + run);
    outside_one += std::abs(result.mean) > *result.error;
    outside_two += std::abs(result.mean) > 2 * *result.error;
  }
  EXPECT_NEAR(outside_one, 64, 25);
  EXPECT_NEAR(outside_two, 10, 12);
}

TEST(Blocking, SaysWhenItCannotTell) {
  EXPECT_EQ(blocked(std::exp(-1 / 100.0), 500, 1).blocks, 0U);
  EXPECT_EQ(blocked(0, 20, 1).blocks, 0U);
  EXPECT_TRUE(blocked(0, 20, 1).error);
  EXPECT_FALSE(blocked(0, 3, 1).error);
  EXPECT_TRUE(std::isnan(Blocking().result().mean));
}

TEST(Blocking, ConstantSamplesHaveNoError) {
  Blocking blocking;
  for (int k = 0; k < 1000; ++k) blocking.add(0.1);
  EXPECT_EQ(blocking.result().mean, 0.1);
  EXPECT_EQ(*blocking.result().error, 0);
  EXPECT_GT(blocking.result().blocks, 0U);
  EXPECT_EQ(blocking.result().correlation, 0);
}

TEST(Blocking, LevelsAreThoseOfTheDefinition) {
  // Six samples by hand: pairs (1, 4), (2, 2), (9, 0) with means 2.5, 2, 4.5; of whole pairs of pairs there is one.
  Blocking blocking;
  for (const double sample : {1.0, 4.0, 2.0, 2.0, 9.0, 0.0}) blocking.add(sample);
  const Blocking::Result result = blocking.result();
  EXPECT_DOUBLE_EQ(result.mean, 3);
  const double squares = 4 + 1 + 1 + 1 + 36 + 9;
  EXPECT_DOUBLE_EQ(*result.error, std::sqrt(squares / (6.0 * 5)));
}

template <typename Sums, typename Feed, typename Look>
void expect_same_after_exchange(Sums whole, Sums first, Sums second, const Feed& feed, const Look& look) {
  feed(whole, 0, 777);
  feed(first, 0, 301);
  SavedSums saved;
  first.exchange(SumsExchange(saved, SumsExchange::Direction::save));
  second.exchange(SumsExchange(saved, SumsExchange::Direction::load));
  feed(second, 301, 777);
  EXPECT_EQ(look(second), look(whole));
}

double sample_of(int k) { return std::fmod(0.618 * k * k, 1.0); }

TEST(Blocking, GoesOnFromSavedSumsWithTheSameBits) {
  const auto feed = [](Blocking& blocking, int from, int to) {
    for (int k = from; k < to; ++k) blocking.add(sample_of(k));
  };
  const auto look = [](const Blocking& blocking) {
    const Blocking::Result result = blocking.result();
    return std::vector{result.mean, *result.error, static_cast<double>(result.blocks), result.correlation};
  };
  expect_same_after_exchange(Blocking(), Blocking(), Blocking(), feed, look);
}

TEST(Batches, GoOnFromSavedSumsWithTheSameBits) {
  const auto feed = [](Batches& batches, int from, int to) {
    for (int k = from; k < to; ++k) {
      batches.add(static_cast<std::size_t>(k % 3), sample_of(k));
      batches.end_sample();
    }
  };
  const auto look = [](const Batches& batches) {
    return std::vector{batches.mean(0).value, *batches.mean(1).error, static_cast<double>(batches.count(2))};
  };
  expect_same_after_exchange(Batches(3), Batches(3), Batches(3), feed, look);
}

TEST(Batches, TellTheErrorOfAMeanAndOfAFunction) {
  // Var(mean) = (1+a)/(1−a)/n; the square of a mean near 2 has 2 · 2 times its error.
  const double a = std::exp(-1 / 4.0);
  constexpr int n = 1 << 14;
  double error = 0;
  double error_of_square = 0;
  constexpr int kRuns = 10;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    Ar1 process(a, 50 + run);
    Batches batches(2);
    for (int k = 0; k < n; ++k) {
      batches.add(1, 2 + process.next());
      batches.end_sample();
    }
    EXPECT_TRUE(std::isnan(batches.mean(0).value));
    EXPECT_NEAR(batches.mean(1).value, 2, 5 * true_error(a, n));
    error += *batches.mean(1).error / kRuns;
    const Batches::Value square = batches.of([](const std::vector<double>& means) { return means[1] * means[1]; });
    error_of_square += *square.error / kRuns;
  }
  EXPECT_NEAR(error / true_error(a, n), 1, 0.12);
  EXPECT_NEAR(error_of_square / (4 * true_error(a, n)), 1, 0.12);
}

TEST(Batches, MergeWithoutLosingAnything) {
  Batches batches(1);
  double sum = 0;
  for (int k = 0; k < 1000; ++k) {
    batches.add(0, k);
    batches.add(0, k);
    batches.end_sample();
    sum += 2 * k;
  }
  EXPECT_EQ(batches.count(0), 2000U);
  EXPECT_EQ(batches.samples(), 1000U);
  EXPECT_DOUBLE_EQ(batches.mean(0).value, sum / 2000);
}

}  // namespace
}  // namespace carom
