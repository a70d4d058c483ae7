// The earliest contact with the disks of a plain list, one after the other.
#pragma once

#include <array>
#include <bit>
#include <cstddef>

#include "cells.hpp"
#include "lists.hpp"
#include "record.hpp"

namespace carom::fast {

/// What a kernel finds in a list: the earliest contact, and whether another one comes at the same time.
struct Nearest {
  double time = predict::kNever;
  Index partner = kNobody;
  bool tied = false;
};

/// `a` if `which`, else `b`, without a branch that could be guessed wrong.
inline Index choose(bool which, Index a, Index b) noexcept { return b ^ ((a ^ b) & -static_cast<Index>(which)); }
inline double choose(bool which, double a, double b) noexcept {
  const auto bits_a = std::bit_cast<std::uint64_t>(a);
  const auto bits_b = std::bit_cast<std::uint64_t>(b);
  return std::bit_cast<double>(bits_b ^ ((bits_a ^ bits_b) & -static_cast<std::uint64_t>(which)));
}

/// What has to be added to positions, for each of a disk's candidates, so that copies stand where they are (length).
/// The smaller id of a pair stays where it is: see predict::separation.
struct Shifts {
  static constexpr int kRoom = 64;
  alignas(64) std::array<double, kRoom> other_x, other_y;  ///< to the candidate's
  alignas(64) std::array<double, kRoom> own_x, own_y;      ///< to the disk's own
  std::array<Image, kRoom> images;                         ///< of the pair, as in Collision

  /// Candidate m is the copy at its stored position + copy L; `first`: the disk's own id is the smaller one.
  void set(int m, Image copy, bool first, Vec2 size) noexcept {
    images[m] = first ? copy : Image{-copy.x, -copy.y};
    const Vec2 shift{images[m].x * size.x, images[m].y * size.y};
    other_x[m] = first ? shift.x : 0;
    other_y[m] = first ? shift.y : 0;
    own_x[m] = first ? 0 : shift.x;
    own_y[m] = first ? 0 : shift.y;
  }
};

/// The earlier of two; tied if they come at the same time.
inline Nearest earlier(const Nearest& a, const Nearest& b) noexcept {
  const bool same = (a.time == b.time) & (a.time < predict::kNever);
  const bool first = a.time <= b.time;
  return {choose(first, a.time, b.time), choose(first, a.partner, b.partner),
          static_cast<bool>(static_cast<int>(same) | (static_cast<int>(a.tied) & static_cast<int>(first)) |
                            (static_cast<int>(b.tied) & static_cast<int>(!first)))};
}

struct ScalarKernel {
  static constexpr bool kSideBySide = false;
  static constexpr int kLanesPerPass = 1;

  template <bool kOneRadius>
  static Nearest nearest(const Record* records, Index k, const Index* near, int count) noexcept {
    const Record& own = records[k];
    Nearest best;
    for (int m = 0; m < count; ++m) {
      const Record& other = records[near[m]];
      const double time = predict::contact_of_disks(own.flight(), other.flight(), {}, own.radius + other.radius);
      best = earlier(best, {time, near[m], false});
    }
    return best;
  }

  /// The time of contact with candidate m.
  static double contact_time(const Record& record, const Record& other, const Shifts& shifts, int m) noexcept {
    const Vec2 to_other{shifts.other_x[m], shifts.other_y[m]};
    const Vec2 to_own{shifts.own_x[m], shifts.own_y[m]};
    const double sigma = record.radius + other.radius;
    // One of the two is zero; the disk whose id is the smaller one stays where it is.
    return to_own == Vec2{} ? predict::contact_of_disks(record.flight(), other.flight(), to_other, sigma)
                            : predict::contact_of_disks(other.flight(), record.flight(), to_own, sigma);
  }
  static void contact_times(const Record* records, Index k, const Index* near, int count, const Shifts& shifts,
                            double* times) {
    for (int m = 0; m < count; ++m) times[m] = contact_time(records[k], records[near[m]], shifts, m);
  }

  /// The same with copies among them; `which` becomes the candidate's number.
  template <bool kOneRadius>
  static Nearest nearest_copy(const Record* records, Index k, const Index* near, int count, const Shifts& shifts,
                              int& which) noexcept {
    Nearest best;
    for (int m = 0; m < count; ++m) {
      const double time = contact_time(records[k], records[near[m]], shifts, m);
      if (time < best.time) which = m;
      best = earlier(best, {time, near[m], false});
    }
    return best;
  }

  template <bool kOneRadius>
  static bool overlap(const Record* records, Index k, const Index* near, int count) noexcept {
    const Record& own = records[k];
    for (int m = 0; m < count; ++m) {
      const Record& other = records[near[m]];
      const Vec2 r{other.x - own.x, other.y - own.y};
      const double sigma = own.radius + other.radius;
      if (dot(r, r) < sigma * sigma) return true;
    }
    return false;
  }

  template <int kCount>
  static bool collect(const Index* slots, std::ptrdiff_t step, Index k, Index* near, int& size) noexcept {
    bool plain = true;
    for (int part = 0; part < 3; ++part, slots += step) {
      for (int m = 0; m < kCount; ++m) {
        if (slots[m] < 0 || slots[m] == k) continue;
        plain = plain && slots[m] < Slot::kMarked;
        near[size++] = slots[m];
      }
    }
    return plain;
  }

  /// The slots of a cell that hold this, one bit each.
  static unsigned slots_with(const Index* slots, Index what) noexcept {
    unsigned found = 0;
    for (unsigned m = 0; m < Cells::kSlots; ++m) found |= static_cast<unsigned>(slots[m] == what) << m;
    return found;
  }

  static ListSteps list_steps() noexcept { return scalar_list_steps(); }

  static void pad(Index /*k*/, Index* /*near*/, int /*size*/) noexcept {}
};

}  // namespace carom::fast
