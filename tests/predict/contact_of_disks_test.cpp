// Property: the time of contact is a pure function of two flights and an image, with known values by hand, the first
// of the two roots, and never where disks part.
#include <gtest/gtest.h>

#include <cmath>

#include "carom/base/random.hpp"
#include "carom/predict/contact.hpp"

namespace carom::predict {
namespace {

static_assert(position_at({{1, 2}, {3, -4}, 10}, 12) == Vec2{7, -6});
static_assert(position_at({{0.1, 0.2}, {1e300, -1e300}, 0.3}, 0.3) == Vec2{0.1, 0.2}, "exact at its own time");
static_assert(separation({{1, 1}, {0, 0}, 0}, {{4, 5}, {1, 0}, 1}, {-10, 0}, 2) == Vec2{-6, 4});

TEST(ContactOfDisks, ByHand) {
  // Heads meet half way: gap 2 − 1 closes at speed 2.
  EXPECT_EQ(contact_of_disks({{0, 0}, {1, 0}}, {{2, 0}, {-1, 0}}, {}, 1), 0.5);
  // The worked example: a = 1, b = −3, c = 8.64, d = 0.36, t = 8.64/3.6.
  EXPECT_DOUBLE_EQ(contact_of_disks({{0, 0}, {1, 0}}, {{3, 0.8}, {0, 0}}, {}, 1), 2.4);
  // Flying past outside of reach, and just within.
  EXPECT_EQ(contact_of_disks({{0, 0}, {1, 0}}, {{3, 1.25}, {0, 0}}, {}, 1), kNever);
  EXPECT_EQ(contact_of_disks({{0, 0}, {1, 0}}, {{3, 1}, {0, 0}}, {}, 1), 3) << "grazing: the centres pass at σ";
  // Parting, and standing still.
  EXPECT_EQ(contact_of_disks({{0, 0}, {-1, 0}}, {{2, 0}, {1, 0}}, {}, 1), kNever);
  EXPECT_EQ(contact_of_disks({{0, 0}, {1, 1}}, {{2, 0}, {1, 1}}, {}, 1), kNever);
}

TEST(ContactOfDisks, OfDistantDisksKeepsItsDigits) {
  // b² − a c would give 100000000, where the centres are 0.5 apart instead of 1.
  EXPECT_DOUBLE_EQ(contact_of_disks({{0, 0}, {0, 0}}, {{1e8, 0.5}, {-1, 0}}, {}, 1), 99999999.13397460);
}

TEST(ContactOfDisks, OfNearlyTouchingDisks) {
  // A gap of 2⁻⁴⁰ closes at speed 1: right to a rounding of σ.
  EXPECT_NEAR(contact_of_disks({{0, 0}, {1, 0}}, {{1 + 0x1p-40, 0}, {0, 0}}, {}, 1), 0x1p-40, 0x1p-53);
}

TEST(ContactOfDisks, StartsAtTheLaterOfTheTwoTimes) {
  // At time 5 disk j stands at (12, 0) and disk i comes from (3, 0): gap 8 at speed 1.
  EXPECT_EQ(contact_of_disks({{0, 0}, {1, 0}, 2}, {{12, 0}, {0, 0}, 5}, {}, 1), 13);
  EXPECT_EQ(contact_of_disks({{0, 0}, {1, 0}, 2}, {{12, 0}, {0, 0}, 0}, {}, 1), 13);
}

TEST(ContactOfDisks, ThatTouchOrOverlap) {
  const Flight i{{0, 0}, {1, 0}, 3};
  for (const double x : {1.0, 0.75, 0.25}) {
    EXPECT_EQ(contact_of_disks(i, {{1 + x, 0}, {0.5, 0}, 4}, {}, 1), 4) << "approaching: at once";
    EXPECT_EQ(contact_of_disks(i, {{1 + x, 0}, {1, 0}, 4}, {}, 1), kNever) << "at relative rest";
    EXPECT_EQ(contact_of_disks(i, {{1 + x, 0}, {1.5, 0}, 4}, {}, 1), kNever) << "receding";
    EXPECT_EQ(contact_of_disks(i, {{1 + x, 0}, {1, 3}, 4}, {}, 1), kNever) << "sliding past each other";
  }
}

TEST(ContactOfDisks, GoesThroughTheSeamByImageOnly) {
  const Flight i{{0.5, 5}, {-1, 0}};
  const Flight j{{9.5, 5}, {1, 0}};
  EXPECT_EQ(contact_of_disks(i, j, {0, 0}, 0.5), kNever);
  EXPECT_EQ(contact_of_disks(i, j, {-10, 0}, 0.5), 0.25) << "gap 0.5 closes at speed 2";
  EXPECT_EQ(contact_of_disks(i, j, {-20, 0}, 0.5), 5.25) << "once round the box, had they not met before";
  EXPECT_EQ(contact_of_disks(i, j, {10, 0}, 0.5), kNever);
}

// --- symmetries that floating-point arithmetic has, too --------------------------------------------------------

struct Pair {
  Flight i, j;
};

Pair any_pair(RandomStream& random) {
  const auto vector = [&](double size) {
    return Vec2{size * (random.uniform() - 0.5), size * (random.uniform() - 0.5)};
  };
  return {{vector(6), vector(2), random.uniform()}, {vector(6), vector(2), random.uniform()}};
}

TEST(ContactOfDisks, IsPureAndSymmetric) {
  RandomStream random(1, 0, 0);
  int contacts = 0;
  for (int k = 0; k < 20'000; ++k) {
    const auto [i, j] = any_pair(random);
    const double time = contact_of_disks(i, j, {}, 1);
    contacts += time < kNever;
    ASSERT_EQ(contact_of_disks(j, i, {}, 1), time) << "without an image the order does not matter";
    const auto turn = [](Vec2 a) { return Vec2{-a.y, a.x}; };
    ASSERT_EQ(contact_of_disks({turn(i.position), turn(i.velocity), i.time},
                               {turn(j.position), turn(j.velocity), j.time}, {}, 1),
              time);
    const auto mirror = [](Vec2 a) { return Vec2{a.x, -a.y}; };
    ASSERT_EQ(contact_of_disks({mirror(i.position), mirror(i.velocity), i.time},
                               {mirror(j.position), mirror(j.velocity), j.time}, {}, 1),
              time);
    ASSERT_EQ(contact_of_disks({4.0 * i.position, 4.0 * i.velocity, i.time},
                               {4.0 * j.position, 4.0 * j.velocity, j.time}, {}, 4),
              time)
        << "the unit of length is free";
    ASSERT_EQ(contact_of_disks(i, j, {}, 1), time) << "asked again";
  }
  EXPECT_GT(contacts, 2'000);
  EXPECT_LT(contacts, 18'000);
}

// Which of two disks an image shifts is seen in the last bits: hence the smaller id is always i.
TEST(ContactOfDisks, ImageGoesWithTheSecondDisk) {
  RandomStream random(2, 0, 0);
  int different = 0;
  for (int k = 0; k < 20'000; ++k) {
    const auto [i, j] = any_pair(random);
    const double there = contact_of_disks(i, j, {6.1, 0}, 1);
    const double back = contact_of_disks(j, i, {-6.1, 0}, 1);
    if (there == kNever || back == kNever) continue;
    different += there != back;
    ASSERT_NEAR(there, back, 1e-6 * (1 + there));
  }
  EXPECT_GT(different, 0);
}

}  // namespace
}  // namespace carom::predict
