// Property: random numbers depend on their key alone, and have the distributions that their names promise.
#include "carom/base/random.hpp"

#include <gtest/gtest.h>

#include <Random123/philox.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace carom {
namespace {

TEST(RandomStream, FirstBlockIsThePublishedKnownAnswer) {
  // Random123's kat_vectors: philox4x32 10, counter 0, key 0 → 6627e8d5 e169c58d bc57ac4c 9b00dbd8.
  RandomStream random(0, 0, 0);
  EXPECT_EQ(random.bits(), 0x9b00dbd8bc57ac4cu);
  EXPECT_EQ(random.bits(), 0xe169c58d6627e8d5u);
}

TEST(RandomStream, CountsBlocksUnderItsKey) {
  const std::uint64_t seed = 0x0123456789abcdef;
  const std::uint64_t stream = 0xfedcba9876543210;
  RandomStream random(seed, stream, 7);
  for (std::uint32_t block = 0; block < 10; ++block) {
    const auto words = r123::Philox4x32{}({{block, 0x76543210, 0xfedcba98, 7}}, {{0x89abcdef, 0x01234567}});
    EXPECT_EQ(random.bits(), std::uint64_t{words[3]} << 32 | words[2]);
    EXPECT_EQ(random.bits(), std::uint64_t{words[1]} << 32 | words[0]);
  }
}

TEST(RandomStream, FirstDrawsAreGolden) {
  EXPECT_EQ(RandomStream(1, 2, 3).uniform(), 0x1.9af08e407a86p-1);
  EXPECT_EQ(RandomStream(1, 2, 3).below(1000), 874u);
  RandomStream random(1, 2, 3);
  EXPECT_EQ(random.normal(), 0x1.d61ba2f4632f1p-1);
  EXPECT_EQ(random.normal(), 0x1.6aed5284514f7p+0);
}

TEST(RandomStream, UniformStaysBelowOneAndIsAMultipleOfTwoToMinus53) {
  RandomStream random(11, 0, 0);
  double sum = 0;
  double squares = 0;
  constexpr int kDraws = 1'000'000;
  for (int k = 0; k < kDraws; ++k) {
    const double u = random.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    ASSERT_EQ(u * 0x1p53, std::floor(u * 0x1p53));
    sum += u;
    squares += u * u;
  }
  // Five standard errors of mean and mean square.
  EXPECT_NEAR(sum / kDraws, 0.5, 5 * std::sqrt(1.0 / 12 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / kDraws));
}

TEST(RandomStream, BelowHitsEveryValueEquallyOften) {
  for (const std::uint64_t bound : {1u, 2u, 3u, 7u, 10u, 64u}) {
    RandomStream random(5, bound, 0);
    std::vector<double> hits(bound);
    constexpr double kDraws = 200'000;
    for (int k = 0; k < kDraws; ++k) {
      const std::uint64_t draw = random.below(bound);
      ASSERT_LT(draw, bound);
      ++hits[draw];
    }
    double chi_squared = 0;
    const double expected = kDraws / static_cast<double>(bound);
    for (const double hit : hits) chi_squared += (hit - expected) * (hit - expected) / expected;
    // Mean bound − 1, variance 2 (bound − 1): four standard deviations.
    const auto freedom = static_cast<double>(bound - 1);
    EXPECT_LE(chi_squared, freedom + 4 * std::sqrt(2 * freedom) + 4) << "bound " << bound;
  }
}

TEST(RandomStream, BelowIsUnbiasedWhereTheRemainderIsLarge) {
  // With 3·2⁶² the plain remainder of 64 bits would fall into the lowest third half of the time.
  const std::uint64_t bound = std::uint64_t{3} << 62;
  RandomStream random(6, 0, 0);
  constexpr int kDraws = 90'000;
  int lowest_third = 0;
  for (int k = 0; k < kDraws; ++k) lowest_third += random.below(bound) < bound / 3;
  EXPECT_NEAR(lowest_third, kDraws / 3, 5 * std::sqrt(kDraws * 2.0 / 9));
}

TEST(RandomStream, NormalHasTheMomentsOfTheNormalDistribution) {
  RandomStream random(42, 0, 1);
  constexpr int kDraws = 1'000'000;
  double m1 = 0, m2 = 0, m3 = 0, m4 = 0;
  for (int k = 0; k < kDraws; ++k) {
    const double x = random.normal();
    m1 += x;
    m2 += x * x;
    m3 += x * x * x;
    m4 += x * x * x * x;
  }
  // Five standard errors: variances of x, x², x³, x⁴ are 1, 2, 15, 96.
  EXPECT_NEAR(m1 / kDraws, 0, 5 * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(m2 / kDraws, 1, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(m3 / kDraws, 0, 5 * std::sqrt(15.0 / kDraws));
  EXPECT_NEAR(m4 / kDraws, 3, 5 * std::sqrt(96.0 / kDraws));
}

TEST(RandomStream, NormalFollowsTheErrorFunction) {
  RandomStream random(43, 0, 1);
  constexpr int kDraws = 1'000'000;
  std::vector<double> draws(kDraws);
  for (double& draw : draws) draw = random.normal();
  std::sort(draws.begin(), draws.end());
  double distance = 0;  // Kolmogorov–Smirnov
  for (int k = 0; k < kDraws; ++k) {
    const double expected = 0.5 * std::erfc(-draws[static_cast<std::size_t>(k)] / std::sqrt(2.0));
    distance =
        std::max({distance, std::abs(expected - k / double{kDraws}), std::abs(expected - (k + 1) / double{kDraws})});
  }
  EXPECT_LT(distance, 1.95 / std::sqrt(double{kDraws}));  // exceeded once in a thousand seeds
  EXPECT_GT(draws.back(), 4);
  EXPECT_LT(draws.front(), -4);
}

TEST(RandomStream, TailsHaveTheirShare) {
  RandomStream random(44, 0, 1);
  constexpr double kDraws = 1'000'000;
  int beyond_three = 0;
  for (int k = 0; k < kDraws; ++k) beyond_three += std::abs(random.normal()) > 3;
  const double expected = kDraws * std::erfc(3 / std::sqrt(2.0));
  EXPECT_NEAR(beyond_three, expected, 5 * std::sqrt(expected));
}

TEST(RandomStream, SameKeySameNumbers) {
  RandomStream a(9, 8, 7);
  RandomStream b(9, 8, 7);
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(a.bits(), b.bits());
}

TEST(RandomStream, AnyBitOfTheKeyMakesAnotherStream) {
  const std::uint64_t first = RandomStream(0, 0, 0).bits();
  for (int bit = 0; bit < 64; ++bit) {
    EXPECT_NE(RandomStream(std::uint64_t{1} << bit, 0, 0).bits(), first);
    EXPECT_NE(RandomStream(0, std::uint64_t{1} << bit, 0).bits(), first);
    if (bit < 32) {
      EXPECT_NE(RandomStream(0, 0, std::uint32_t{1} << bit).bits(), first);
    }
  }
}

TEST(RandomStream, NeighbouringStreamsAreUncorrelated) {
  // Correlation of uniforms, and of bits: streams of consecutive disks, of consecutive seeds, of two purposes.
  constexpr int kDraws = 100'000;
  const auto check = [](auto first, auto second) {
    double product = 0;
    int equal_bits = 0;
    for (int k = 0; k < kDraws; ++k) {
      RandomStream a = first(k);
      RandomStream b = second(k);
      product += (a.uniform() - 0.5) * (b.uniform() - 0.5);
      equal_bits += std::popcount(~(a.bits() ^ b.bits()));
    }
    EXPECT_NEAR(product / kDraws, 0, 5.0 / 12 / std::sqrt(double{kDraws}));
    EXPECT_NEAR(equal_bits / (64.0 * kDraws), 0.5, 5 * 0.5 / std::sqrt(64.0 * kDraws));
  };
  const auto stream = [](std::uint64_t k) { return k; };
  check([&](int k) { return RandomStream(1, stream(k), 1); }, [&](int k) { return RandomStream(1, stream(k) + 1, 1); });
  check([&](int k) { return RandomStream(stream(k), 1, 1); }, [&](int k) { return RandomStream(stream(k) + 1, 1, 1); });
  check([&](int k) { return RandomStream(1, stream(k), 1); }, [&](int k) { return RandomStream(1, stream(k), 2); });
}

}  // namespace
}  // namespace carom
