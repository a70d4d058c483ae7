// Property: a digest is XXH3 of the numbers' little-endian bytes in order, whatever the machine and the portions.
#include "carom/base/digest.hpp"

#include <gtest/gtest.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <bit>
#include <set>
#include <utility>
#include <vector>

namespace carom {
namespace {

void append_little_endian(std::vector<unsigned char>& bytes, std::uint64_t word) {
  for (int k = 0; k < 8; ++k) bytes.push_back(static_cast<unsigned char>(word >> (8 * k)));
}

TEST(Digest, OfNothingIsXxh3OfNoBytes) { EXPECT_EQ(Digest().hex(), "2d06800538d394c2"); }

TEST(Digest, EqualsTheOneShotFunctionForEveryLength) {
  Digest digest;
  std::vector<unsigned char> bytes;
  // XXH3 has separate code for up to 16, 128 and 240 bytes and for longer inputs, and a buffer of 256 bytes.
  for (int k = 0; k < 600; ++k) {
    if (k % 3 == 0) {
      const std::int64_t value = k * -1'234'567'890'123LL;
      digest.add(value);
      append_little_endian(bytes, static_cast<std::uint64_t>(value));
    } else {
      const double value = 1.0 / (k - 300.5);
      digest.add(value);
      append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
    }
    ASSERT_EQ(digest.value(), XXH3_64bits(bytes.data(), bytes.size())) << "after " << k + 1 << " numbers";
  }
}

TEST(Digest, HexIsTheValueWithLeadingZeros) {
  std::set<char> first_digits;
  for (std::int64_t k = 0; k < 200; ++k) {
    Digest digest;
    digest.add(k);
    const std::string hex = digest.hex();
    ASSERT_EQ(hex.size(), 16u);
    EXPECT_EQ(std::stoull(hex, nullptr, 16), digest.value());
    first_digits.insert(hex[0]);
  }
  EXPECT_TRUE(first_digits.contains('0'));
}

TEST(Digest, TellsZerosApartAndSeesOrder) {
  const auto of = [](double a, double b) {
    Digest digest;
    digest.add(a);
    digest.add(b);
    return digest.value();
  };
  EXPECT_NE(of(0.0, 1), of(-0.0, 1));
  EXPECT_NE(of(1, 2), of(2, 1));
}

TEST(Digest, CanBeReadInTheMiddleAndMoved) {
  Digest digest;
  digest.add(1.5);
  const std::uint64_t middle = digest.value();
  Digest moved = std::move(digest);
  EXPECT_EQ(moved.value(), middle);
  moved.add(2.5);
  Digest straight;
  straight.add(1.5);
  straight.add(2.5);
  EXPECT_EQ(moved.value(), straight.value());
}

}  // namespace
}  // namespace carom
