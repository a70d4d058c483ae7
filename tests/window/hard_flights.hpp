// Pairs of disks whose time of contact is hard to get right, and ordinary ones between them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "window/encounter.hpp"
#include "window/fast/kernel_scalar.hpp"
#include "window/fast/record.hpp"

namespace carom::fast {

/// One disk and others that it may meet, as the kernel takes them.
struct Company {
  static constexpr int kMost = 56;
  static constexpr int kPadding = 8;
  static_assert(kMost + kPadding <= Shifts::kRoom);

  std::array<Record, kMost + 1> records;
  Index own = 0;
  int count = 0;
  std::array<Index, kMost + kPadding> near;
  std::array<bool, kMost> own_is_first;  ///< the own id is the smaller one
  Shifts shifts;
  Vec2 size;  ///< of the box

  /// By the function that is the home of the formula.
  [[nodiscard]] double contact_time(int m) const noexcept {
    const Record& i = records[own_is_first[m] ? own : near[m]];
    const Record& j = records[own_is_first[m] ? near[m] : own];
    return predict::contact_of_disks(i.flight(), j.flight(), shift_of(shifts.images[m], size), i.radius + j.radius);
  }
};

class HardFlights {
 public:
  explicit HardFlights(std::uint64_t seed) : bits_(seed) {}

  /// Fills `company` with a disk and `count` others, at a scale drawn at random.
  void draw(Company& company, int count) {
    company.count = count;
    company.own = static_cast<Index>(below(static_cast<unsigned>(count) + 1));
    company.near.fill(company.own);
    draw_scale();
    company.size = box();
    const bool of_few = below(4) == 0;
    Record& own = company.records[company.own];
    own = of_few ? record_of_few() : record();
    for (int m = 0; m < count; ++m) {
      const auto other = static_cast<Index>(count - m);  // backwards: the order in memory is not that of the list
      company.near[m] = other == company.own ? 0 : other;
      const Image copy = below(2) == 0 ? Image{} : Image{below(7) - 3, below(7) - 3};
      company.own_is_first[m] = below(2) == 0;
      company.shifts.set(m, copy, company.own_is_first[m], company.size);
      Record& met = company.records[company.near[m]];
      const Vec2 shift = shift_of(copy, company.size);
      met = !of_few ? partner_of(own, shift) : below(4) == 0 ? passing(own, shift) : record_of_few();
    }
    for (int m = count; m < count + Company::kPadding; ++m) company.shifts.set(m, {}, true, company.size);
  }

 private:
  std::int32_t below(std::uint64_t bound) { return static_cast<std::int32_t>((bits_() >> 32) % bound); }
  /// In [0, 1).
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  /// In [-1, 1).
  double even() { return 2 * uniform() - 1; }
  /// 1, or next to it.
  double about_one() { return 1 + 0x1p-52 * (below(9) - 4); }
  Vec2 vector() {
    const double x = even();
    return {x, even()};
  }
  Vec2 unit_vector() {
    const Vec2 v = vector();
    const double size = length(v);
    return size > 0 ? v / size : Vec2{1, 0};
  }
  double power_of_two(int octaves) { return std::ldexp(1.0, below(2 * static_cast<unsigned>(octaves) + 1) - octaves); }

  /// Lengths and speeds are of order 1, or anything that a scene may hold.
  void draw_scale() {
    const int octaves = below(4) == 0 ? 220 : 2;
    length_ = power_of_two(octaves);
    speed_ = power_of_two(octaves);
    duration_ = length_ / speed_;
    plain_times_ = below(3) == 0;
  }
  Vec2 box() {
    const Vec2 odd{4 + 30 * uniform(), 4 + 30 * uniform()};
    return length_ * (below(2) == 0 ? odd : Vec2{4, 8});
  }

  double radius() { return length_ * (below(8) == 0 ? power_of_two(30) : 0.5 + uniform()); }
  double time() { return plain_times_ || below(3) == 0 ? 0 : duration_ * uniform(); }
  static Record record(Vec2 position, Vec2 velocity, double time, double radius) {
    return {position.x, position.y, velocity.x, velocity.y, time, radius, predict::kNever, kNobody, 0};
  }
  Record record() {
    const Vec2 place = 16 * length_ * vector();
    const Vec2 velocity = below(6) == 0 ? Vec2{} : speed_ * vector();
    const double since = time();
    return record(place, velocity, since, radius());
  }

  /// Small whole numbers: contact distances, discriminants and approaches that are exactly zero.
  Record record_of_few() {
    constexpr std::array kSpeeds{0.0, -0.0, 1.0, -1.0, 2.0};
    constexpr std::array kRadii{0.5, 0.5, 1.0, 2.5};
    constexpr std::array kTimes{0.0, 0.0, 0.5, 1.0};
    const auto few = [&](const auto& values) { return values[below(values.size())]; };
    const double x = length_ * (below(9) - 4);
    const double y = length_ * (below(9) - 4);
    const double vx = speed_ * few(kSpeeds);
    const double vy = speed_ * few(kSpeeds);
    const double since = duration_ * few(kTimes);
    return record({x, y}, {vx, vy}, since, length_ * few(kRadii));
  }

  /// Touches `own` of record_of_few(), and all but passes by: rounding can make the discriminant negative.
  Record passing(const Record& own, Vec2 shift) {
    const double sigma = own.radius + own.radius;
    const Vec2 place{own.x + (below(2) == 0 ? sigma : -sigma), own.y};
    const Vec2 velocity = Vec2{own.vx, own.vy} + speed_ * Vec2{0x1p-28 * even(), even()};
    return record(place - shift, velocity, own.t, own.radius);
  }

  /// A disk whose copy, `shift` from it, has something to do with `own`.
  Record partner_of(const Record& own, Vec2 shift) {
    const double other_radius = below(2) == 0 ? own.radius : radius();
    const double other_time = below(3) == 0 ? own.t : time();
    const double start = std::max(own.t, other_time);
    const auto [r, v] = approach(own.radius + other_radius);
    const Vec2 velocity = below(8) == 0 ? Vec2{} : Vec2{own.vx, own.vy} + v;
    const Vec2 place = predict::position_at(own.flight(), start) + r - shift;
    return record(place - velocity * (start - other_time), velocity, other_time, other_radius);
  }

  struct Approach {
    Vec2 r, v;
  };
  /// Relative position and velocity of two disks with contact distance `sigma`.
  Approach approach(double sigma) {
    const Vec2 towards = unit_vector();
    const Vec2 across{-towards.y, towards.x};
    const double speed = speed_ * (0.01 + uniform());
    const double aside = even();
    const double gap = uniform();
    switch (below(8)) {
      case 0: return {4 * sigma * vector(), speed_ * vector()};
      case 1: return {-sigma * power_of_two(20) * towards + 1.1 * aside * sigma * across, speed * towards};
      case 2: return {-sigma * (1 + 4 * gap) * towards + about_one() * sigma * across, speed * towards};
      case 3: return {about_one() * sigma * towards, speed_ * vector()};
      case 4: return {gap * sigma * towards, speed_ * vector()};
      case 5: return {4 * sigma * vector(), 0x1p-52 * below(3) * speed_ * unit_vector()};
      case 6: return {sigma * (1 + gap) * towards, (0x1p-50 * even() * towards + aside * across) * speed};
      default: return {-2 * sigma * towards, (towards + aside * across) * power_of_two(30) * speed};
    }
  }

  std::mt19937_64 bits_;
  double length_ = 1;
  double speed_ = 1;
  double duration_ = 1;
  bool plain_times_ = false;
};

}  // namespace carom::fast
