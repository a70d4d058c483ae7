// Property: at the predicted time the disks touch, and no contact is missed, up to rounding of the numbers given.
//
// A grazing contact's time is ill-conditioned: a change of the last digit of a coordinate moves it by the root of that
// digit. So errors are measured backwards, in 100 digits: the gap of the rims at the predicted time, and the depth of
// a contact that was called none, must be below kUnits · 2⁻⁵³ times the size of what is added up to get there: the
// coordinates, the image, the ways flown up to the later of the two own times, and the relative way |v| |t| after it.
// Each of the roundings on the way (positions, r, v, the cross product, the time itself) moves a disk by at most half
// such a unit; that they do not all point the same way is measured, not proved.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "carom/base/random.hpp"
#include "exact_flight.hpp"

namespace carom::predict {
namespace {

constexpr double kUnits = 4;

/// The sum of the lengths that rounding errors are relative to.
double scale(const Pair& pair, double time) {
  const double start = std::max(pair.i.time, pair.j.time);
  const auto way = [&](const Flight& f) { return length(f.position) + length(f.velocity) * (start - f.time); };
  return way(pair.i) + way(pair.j) + length(pair.image) + pair.sigma +
         length(pair.j.velocity - pair.i.velocity) * std::abs(time);
}

struct Tally {
  int contacts = 0;
  int misses = 0;
  double worst = 0;  // in units
};

void check_contact(const Pair& pair, double time, Tally& tally) {
  const ExactPair exact(pair);
  const double start = std::max(pair.i.time, pair.j.time);
  const double unit = 0x1p-53 * scale(pair, time);
  ASSERT_GE(time, start);
  const auto gap = static_cast<double>(exact.gap(time));
  if (time > start) {
    ASSERT_LE(std::abs(gap), kUnits * unit);
    tally.worst = std::max(tally.worst, std::abs(gap) / unit);
  } else {
    ASSERT_LE(gap, kUnits * unit) << "at once only if they touch";
  }
  // The first of the two roots, not the second: not past the closest approach, which a grazing pair reaches within
  // the way √(2 σ gap) that belongs to such a gap.
  const auto past = static_cast<double>(exact.past_closest_approach(time));
  ASSERT_LE(past, kUnits * unit + std::sqrt(2 * pair.sigma * kUnits * unit));
  ++tally.contacts;
}

void check_miss(const Pair& pair, Tally& tally) {
  const double unit = 0x1p-53 * scale(pair, std::max(pair.i.time, pair.j.time));
  const auto depth = static_cast<double>(ExactPair(pair).penetration());
  ASSERT_LE(depth, kUnits * unit) << "a contact was missed";
  tally.worst = std::max(tally.worst, depth / unit);
  ++tally.misses;
}

/// Checks many pairs of one family; returns how many met and how many did not.
Tally check_family(const std::function<Pair(RandomStream&)>& make, int pairs = 4000) {
  RandomStream random(20, 0, 0);
  Tally tally;
  for (int k = 0; k < pairs && !testing::Test::HasFatalFailure(); ++k) {
    const Pair pair = make(random);
    const double time = contact_of_disks(pair.i, pair.j, pair.image, pair.sigma);
    if (time < kNever) {
      check_contact(pair, time, tally);
    } else {
      check_miss(pair, tally);
    }
    EXPECT_FALSE(testing::Test::HasFatalFailure()) << "pair " << k;
  }
  testing::Test::RecordProperty("worst_error_in_units", std::to_string(tally.worst));
  return tally;
}

double log_uniform(RandomStream& random, double low, double high) {
  return low * std::pow(high / low, random.uniform());
}
double sign(RandomStream& random) { return random.uniform() < 0.5 ? -1 : 1; }
Vec2 direction(RandomStream& random) {
  const double angle = 6.283185307179586 * random.uniform();
  return {std::cos(angle), std::sin(angle)};
}
Vec2 place(RandomStream& random, double size) { return {size * random.uniform(), size * random.uniform()}; }
Vec2 left_of(Vec2 n) { return {-n.y, n.x}; }

/// Disk j flies past disk i: first `distance` away, then at `impact` beside it, at `speed` relative to it.
Pair passing(RandomStream& random, double distance, double impact, double speed) {
  const Vec2 n = direction(random);
  const Vec2 drift = speed * place(random, 1);
  const Vec2 position = place(random, 10);
  return {.i = {position, drift, 0},
          .j = {position + distance * n + impact * left_of(n), drift - speed * n, 0},
          .image = {},
          .sigma = 1};
}

TEST(Oracle, PairsOfAGas) {
  const Tally tally = check_family([](RandomStream& random) {
    return Pair{.i = {place(random, 20), direction(random), random.uniform()},
                .j = {place(random, 20), 2.0 * direction(random), random.uniform()},
                .image = {20 * std::floor(3 * random.uniform() - 1), 20 * std::floor(3 * random.uniform() - 1)},
                .sigma = log_uniform(random, 0.01, 10)};
  });
  EXPECT_GT(tally.contacts, 50);
  EXPECT_GT(tally.misses, 1000);
}

TEST(Oracle, GrazingPairs) {
  const Tally tally = check_family([](RandomStream& random) {
    const double off = sign(random) * log_uniform(random, 1e-15, 1e-3);
    return passing(random, log_uniform(random, 0.1, 100), sign(random) * (1 + off), 1);
  });
  EXPECT_GT(tally.contacts, 1500);
  EXPECT_GT(tally.misses, 1500);
}

TEST(Oracle, NearlyParallelPairs) {
  const Tally tally = check_family([](RandomStream& random) {
    const double difference = log_uniform(random, 1e-15, 1e-3);
    Pair pair = passing(random, log_uniform(random, 1, 5), 1.5 * random.uniform(), difference);
    const Vec2 drift = direction(random);
    pair.i.velocity = pair.i.velocity + drift;
    pair.j.velocity = pair.j.velocity + drift;
    return pair;
  });
  EXPECT_GT(tally.contacts, 1000);
  EXPECT_GT(tally.misses, 500);
}

TEST(Oracle, HugeAndTinySpeeds) {
  const Tally tally = check_family([](RandomStream& random) {
    Pair pair = passing(random, log_uniform(random, 1, 100), 1.5 * random.uniform(), log_uniform(random, 1e-12, 1e12));
    pair.i.velocity = log_uniform(random, 1e-12, 1e12) * direction(random);
    return random.uniform() < 0.5 ? pair : passing(random, 3, random.uniform(), log_uniform(random, 1e-12, 1e12));
  });
  EXPECT_GT(tally.contacts, 500);
  EXPECT_GT(tally.misses, 500);
}

TEST(Oracle, DistantPairs) {
  const Tally tally = check_family([](RandomStream& random) {
    return passing(random, log_uniform(random, 1e2, 1e8), 1.5 * random.uniform(), log_uniform(random, 0.1, 10));
  });
  EXPECT_GT(tally.contacts, 2000);
  EXPECT_GT(tally.misses, 1000);
}

TEST(Oracle, TouchingPairs) {
  const Tally tally = check_family([](RandomStream& random) {
    const Vec2 n = direction(random);
    const Vec2 position = place(random, 10);
    return Pair{
        .i = {position, direction(random), 0}, .j = {position + n, direction(random), 0}, .image = {}, .sigma = 1};
  });
  EXPECT_GT(tally.contacts, 1500);
  EXPECT_GT(tally.misses, 1500);
}

TEST(Oracle, OverlappingPairsMeetAtOnceOrNotAtAll) {
  RandomStream random(21, 0, 0);
  int approaching = 0;
  for (int k = 0; k < 4000; ++k) {
    const Vec2 n = direction(random);
    const Vec2 position = place(random, 10);
    Pair pair{.i = {position, direction(random), 0.5},
              .j = {position + (1 - log_uniform(random, 1e-9, 0.9)) * n, direction(random), 0.25},
              .image = {},
              .sigma = 1};
    pair.j.position = pair.j.position - pair.j.velocity * 0.25;
    const auto closing = static_cast<double>(ExactPair(pair).past_closest_approach(0.5));
    if (std::abs(closing) < 1e-13) continue;
    ASSERT_EQ(contact_of_disks(pair.i, pair.j, {}, 1), closing < 0 ? 0.5 : kNever);
    approaching += closing < 0;
  }
  EXPECT_GT(approaching, 1500);
  EXPECT_LT(approaching, 2500);
}

TEST(Oracle, PairsWithDifferentOwnTimes) {
  const Tally tally = check_family([](RandomStream& random) {
    Pair pair = passing(random, log_uniform(random, 1, 100), 1.5 * random.uniform(), 1);
    const auto earlier = [](Flight& f, double time) {
      f.position = f.position - f.velocity * time;
      f.time = -time;
    };
    earlier(pair.i, 10 * random.uniform());
    earlier(pair.j, 10 * random.uniform());
    pair.i.time += 1000;  // late in a long window
    pair.j.time += 1000;
    return pair;
  });
  EXPECT_GT(tally.contacts, 2000);
  EXPECT_GT(tally.misses, 1000);
}

TEST(Oracle, PairsThroughTheSeam) {
  const Tally tally = check_family([](RandomStream& random) {
    constexpr double kLength = 12.3;
    Pair pair = passing(random, log_uniform(random, 1, 100), 1.5 * random.uniform(), 1);
    const auto fold = [](double x) { return kLength * std::floor(x / kLength); };
    pair.image = {fold(pair.j.position.x), fold(pair.j.position.y)};
    pair.j.position = pair.j.position - pair.image;
    return pair;
  });
  EXPECT_GT(tally.contacts, 2000);
  EXPECT_GT(tally.misses, 1000);
}

TEST(Oracle, UnequalSizes) {
  const Tally tally = check_family([](RandomStream& random) {
    const double sigma = log_uniform(random, 1e-6, 1e6);
    Pair pair = passing(random, sigma * log_uniform(random, 1.5, 100), sigma * 1.5 * random.uniform(), 1);
    pair.sigma = sigma;
    return pair;
  });
  EXPECT_GT(tally.contacts, 2000);
  EXPECT_GT(tally.misses, 1000);
}

}  // namespace
}  // namespace carom::predict
