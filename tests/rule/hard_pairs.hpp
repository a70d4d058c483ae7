// Pairs that the rule finds hard, and ordinary ones between them.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "pairs.hpp"

namespace carom::rule {

class HardPairs {
 public:
  explicit HardPairs(std::uint64_t seed) : bits_(seed) {}

  /// Adds a pair of a kind drawn at random to `pairs`.
  void add_to(Pairs& pairs) {
    switch (bits_() % 8) {
      case 0: return add_apart(pairs, vector(2), {vector(2), vector(2)}, mass(2), mass(2));
      case 1: return add(pairs, vector(1), {vector(20), vector(20)}, mass(40), mass(40));
      case 2: return add_grazing(pairs);
      case 3: return add_wall(pairs);
      case 4: return add_of_few(pairs, {0.0, -0.0, 1.0, -1.0});
      case 5: return add(pairs, vector(490), {vector(10), vector(10)}, mass(1), mass(1));
      case 6: return add(pairs, vector(1), {tiny_vector(), tiny_vector()}, mass(2), mass(2));
      default: return add_of_few(pairs, {-3.0, 1.0, 2.0, 5.0});
    }
  }

  /// Of either sign, sizes from 2^-octaves to 2^(octaves+1).
  double number(int octaves) {
    const std::uint64_t bits = bits_();
    const auto exponent = static_cast<int>((bits >> 53) % (2 * static_cast<unsigned>(octaves) + 1)) - octaves;
    const auto biased = static_cast<std::uint64_t>(1023 + exponent) << 52;
    return std::bit_cast<double>((bits & kSign) | biased | ((bits << 11) & kMantissa));
  }

 private:
  static constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  static constexpr std::uint64_t kMantissa = (std::uint64_t{1} << 52) - 1;

  double mass(int octaves) { return std::abs(number(octaves)); }
  Vec2 vector(int octaves) {
    const double x = number(octaves);
    return {x, number(octaves)};
  }
  /// Components without a full set of digits, or close to it.
  double tiny() {
    const std::uint64_t bits = bits_();
    return std::bit_cast<double>(bits & (kSign | kMantissa | std::uint64_t{1} << 52));
  }
  Vec2 tiny_vector() {
    const double x = tiny();
    return {x, tiny()};
  }

  static void add(Pairs& pairs, Vec2 r, Velocities v, double m1, double m2) { pairs.add({0, 0}, r, v, m1, m2); }
  void add_apart(Pairs& pairs, Vec2 r, Velocities v, double m1, double m2) {
    const Vec2 centre = vector(6);
    pairs.add(centre, centre + r, v, m1, m2);
  }
  /// All but no motion along r; where a component is zero, it shows every bit of a small impulse.
  void add_grazing(Pairs& pairs) {
    const Vec2 r = vector(1);
    const std::uint64_t at_rest = bits_();
    const double x = number(3);
    const double y = number(3);
    const Vec2 v{at_rest % 2 == 0 ? 0 : x, at_rest / 2 % 2 == 0 ? 0 : y};
    const Vec2 across{-r.y, r.x};
    const double sideways = number(3);
    add(pairs, r, {v, v + sideways * across + 0x1p-51 * number(3) * r}, mass(10), mass(10));
  }
  void add_wall(Pairs& pairs) {
    const bool first = bits_() % 2 == 0;
    const double other = mass(20);
    add_apart(pairs, vector(1), {vector(4), vector(4)}, first ? INFINITY : other, first ? other : INFINITY);
  }
  /// All components are among the four, masses among their sizes; centres may coincide.
  void add_of_few(Pairs& pairs, std::array<double, 4> few) {
    const auto one = [&](std::uint64_t& bits) {
      const double number = few[bits % 4];
      bits /= 4;
      return number;
    };
    std::uint64_t bits = bits_() >> 1;
    const Vec2 r{one(bits), one(bits)};
    const Velocities v{{one(bits), one(bits)}, {one(bits), one(bits)}};
    const double m1 = std::abs(few[2 + bits % 2]);
    add(pairs, r, v, m1, std::abs(few[2 + bits / 2 % 2]));
  }

  std::mt19937_64 bits_;
};

}  // namespace carom::rule
