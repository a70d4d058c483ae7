// Property: a batch has the same bits as one collision after the other, for any size and mix of pairs.
#include "carom/rule/batch.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "random_contact.hpp"

namespace carom::rule {
namespace {

/// Pairs as arrays, and the same pairs as contacts.
struct Pairs {
  std::vector<double> x1, y1, m1, x2, y2, m2, vx1, vy1, vx2, vy2;
  std::vector<Contact> contacts;

  void add(Vec2 centre1, Vec2 centre2, const Contact& contact) {
    x1.push_back(centre1.x), y1.push_back(centre1.y), m1.push_back(contact.m1);
    x2.push_back(centre2.x), y2.push_back(centre2.y), m2.push_back(contact.m2);
    vx1.push_back(contact.v.first.x), vy1.push_back(contact.v.first.y);
    vx2.push_back(contact.v.second.x), vy2.push_back(contact.v.second.y);
    contacts.push_back(contact);
    contacts.back().r = centre2 - centre1;
  }
  PairSpans spans() { return {x1, y1, m1, x2, y2, m2, vx1, vy1, vx2, vy2}; }
};

Pairs random_pairs(std::size_t count, std::uint64_t seed) {
  RandomStream random(seed, count, 0);
  Pairs pairs;
  for (std::size_t k = 0; k < count; ++k) {
    const Contact contact = any_contact(random);  // half of them approach
    const Vec2 centre1{100 * random.uniform(), 100 * random.uniform()};
    pairs.add(centre1, centre1 + contact.r, contact);
  }
  return pairs;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(Batch, HasTheBitsOfSingleCollisions) {
  for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u}) {
    for (const double restitution : {1.0, 0.5, 0.0}) {
      Pairs pairs = random_pairs(count, 12);
      collide_batch(pairs.spans(), restitution);
      int unchanged = 0;
      for (std::size_t k = 0; k < count; ++k) {
        Contact contact = pairs.contacts[k];
        contact.restitution = restitution;
        const Velocities after = collide(contact);
        unchanged += after == contact.v;
        EXPECT_TRUE(same_bits(pairs.vx1[k], after.first.x) && same_bits(pairs.vy1[k], after.first.y));
        EXPECT_TRUE(same_bits(pairs.vx2[k], after.second.x) && same_bits(pairs.vy2[k], after.second.y));
      }
      if (count == 1000) {
        EXPECT_GT(unchanged, 300) << "pairs that do not approach belong to the test";
        EXPECT_LT(unchanged, 700);
      }
    }
  }
}

TEST(Batch, IsElasticUnlessSaidOtherwise) {
  Pairs pairs = random_pairs(7, 13);
  collide_batch(pairs.spans());
  for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(pairs.vx1[k], collide(pairs.contacts[k]).first.x);
}

TEST(Batch, KnowsWalls) {
  Pairs pairs;
  pairs.add({0, 0}, {1, 0}, {.r = {1, 0}, .v = {{3, 4}, {0, 0}}, .m2 = INFINITY});
  collide_batch(pairs.spans(), 0.5);
  EXPECT_EQ(pairs.vx1[0], -1.5);
  EXPECT_EQ(pairs.vy1[0], 4);
  EXPECT_EQ(pairs.vx2[0], 0);
}

}  // namespace
}  // namespace carom::rule
