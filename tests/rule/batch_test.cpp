// Property: a batch has the same bits as one collision after the other, whatever the instructions, the number of
// pairs, where the arrays begin and what the numbers are.
#include "carom/rule/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "carom/base/error.hpp"
#include "hard_pairs.hpp"
#include "pairs.hpp"

namespace carom::rule {
namespace {

Pairs hard_pairs(HardPairs& hard, std::size_t count) {
  Pairs pairs;
  for (std::size_t k = 0; k < count; ++k) hard.add_to(pairs);
  return pairs;
}

bool is_available(Simd simd) {
  const std::vector<Simd> available = available_simd();
  return std::find(available.begin(), available.end(), simd) != available.end();
}

std::string letters_of(Simd simd) {
  std::string letters(name_of(simd));
  std::erase(letters, '-');
  return letters;
}

/// Each of these tests once for every instruction set.
class Batch : public testing::TestWithParam<Simd> {
 protected:
  void SetUp() override {
    if (!is_available(GetParam())) GTEST_SKIP() << "this computer has no " << name_of(GetParam());
  }
};

INSTANTIATE_TEST_SUITE_P(Simd, Batch, testing::Values(Simd::scalar, Simd::sse4, Simd::avx2, Simd::avx512),
                         [](const auto& test) { return letters_of(test.param); });

/// The first pair of `pairs` whose bits differ from those in `expected`; its size if there is none.
std::size_t first_difference(const Pairs& pairs, const std::vector<Velocities>& expected) {
  std::size_t k = 0;
  while (k < pairs.size() && same_bits(pairs.velocities(k), expected[k])) ++k;
  return k;
}

TEST_P(Batch, HasTheBitsOfSingleCollisionsInTenMillionPairs) {
  constexpr std::size_t kBlock = 1021;  // no multiple of any number of lanes
  constexpr std::array kRestitutions{1.0, 0.0, 0.5, 1 - 0x1p-53, 0x1p-53, 0.9};
  HardPairs hard(11);
  std::size_t done = 0;
  for (std::size_t block = 0; done < 10'000'000; ++block, done += kBlock) {
    const double restitution = kRestitutions[block % kRestitutions.size()];
    const Pairs before = hard_pairs(hard, kBlock);
    Pairs after = before;
    collide_batch(after.spans(), restitution, GetParam());
    const std::size_t k = first_difference(after, before.collided_one_by_one(restitution));
    ASSERT_EQ(k, kBlock) << "block " << block << ", e = " << restitution;
  }
}

TEST(HardPairs, ApproachOrNotAndOftenApproachStillAfterTheFirstImpulse) {
  HardPairs hard(12);
  const Pairs pairs = hard_pairs(hard, 10'000);
  for (const double restitution : {1.0, 0.0}) {
    int approaching = 0;
    int approaching_still = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Contact contact = pairs.contact(k, restitution);
      const double b = approach(contact.r, contact.v);
      if (!(b < 0)) continue;
      ++approaching;
      const double change = detail::change_of_relative_velocity(contact.r, b, restitution);
      approaching_still += approach(contact.r, detail::with_impulse(contact, change)) < 0;
    }
    EXPECT_GT(approaching, 3000);
    EXPECT_LT(approaching, 7000);
    EXPECT_GT(approaching_still, restitution == 0 ? 1000 : 10);
  }
}

TEST_P(Batch, TakesAnyNumberOfPairsFromAnyDoubleOn) {
  HardPairs hard(13);
  const Pairs before = hard_pairs(hard, 48);
  const std::vector<Velocities> collided = before.collided_one_by_one(0.5);
  for (std::size_t first = 0; first < 8; ++first) {
    for (std::size_t count = 0; first + count <= before.size(); ++count) {
      Pairs after = before;
      collide_batch(after.spans(first, count), 0.5, GetParam());
      for (std::size_t k = 0; k < before.size(); ++k) {
        const bool inside = k >= first && k < first + count;
        ASSERT_TRUE(same_bits(after.velocities(k), inside ? collided[k] : before.velocities(k)))
            << "pair " << k << " of " << count << " from " << first;
      }
    }
  }
}

TEST_P(Batch, KeepsToItselfWhatIsNoNumber) {
  HardPairs hard(14);
  const std::array<double, 7> strange{NAN, INFINITY, -INFINITY, 1e308, -1e308, 1e-308, 0.0};
  for (int round = 0; round < 2000; ++round) {
    Pairs before = hard_pairs(hard, 17);
    const std::array arrays{&before.x1, &before.y1,  &before.m1,  &before.x2,  &before.y2,
                            &before.m2, &before.vx1, &before.vy1, &before.vx2, &before.vy2};
    for (std::size_t k = static_cast<std::size_t>(round) % 5; k < before.size(); k += 5)
      (*arrays[(k + static_cast<std::size_t>(round)) % arrays.size()])[k] = strange[(k * 3 + round) % strange.size()];
    Pairs after = before;
    collide_batch(after.spans(), 1, GetParam());
    const auto same = [](double a, double b) { return same_bits(a, b) || (std::isnan(a) && std::isnan(b)); };
    const std::vector<Velocities> expected = before.collided_one_by_one(1);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Velocities v = after.velocities(k);
      ASSERT_TRUE(same(v.first.x, expected[k].first.x) && same(v.first.y, expected[k].first.y) &&
                  same(v.second.x, expected[k].second.x) && same(v.second.y, expected[k].second.y))
          << "round " << round << ", pair " << k;
    }
  }
}

TEST_P(Batch, KnowsWalls) {
  Pairs pairs;
  for (int k = 0; k < 9; ++k) pairs.add({0, 0}, {1, 0}, {{3, 4}, {0, 0}}, 1, INFINITY);
  collide_batch(pairs.spans(), 0.5, GetParam());
  for (std::size_t k = 0; k < pairs.size(); ++k)
    EXPECT_EQ(pairs.velocities(k), (Velocities{{-1.5, 4}, {0, 0}})) << "pair " << k;
}

TEST(BatchByDefault, IsElastic) {
  HardPairs hard(15);
  const Pairs before = hard_pairs(hard, 100);
  Pairs after = before;
  collide_batch(after.spans());
  EXPECT_EQ(first_difference(after, before.collided_one_by_one(1)), before.size());
}

TEST(BatchByDefault, RefusesInstructionsThatAreNotThere) {
  for (const Simd simd : {Simd::scalar, Simd::sse4, Simd::avx2, Simd::avx512}) {
    if (is_available(simd)) {
      EXPECT_NO_THROW(collide_batch({}, 1, simd));
    } else {
      EXPECT_THROW(collide_batch({}, 1, simd), Error);
    }
  }
}

}  // namespace
}  // namespace carom::rule
