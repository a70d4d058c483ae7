// The earliest contact with the disks of a plain list, one after the other.
#pragma once

#include "cells.hpp"
#include "record.hpp"

namespace carom::fast {

/// What a kernel finds in a list: the earliest contact, and whether another one comes at the same time.
struct Nearest {
  double time = predict::kNever;
  Index partner = kNobody;
  bool tied = false;
};

/// The earlier of two; tied if they come at the same time.
inline Nearest earlier(const Nearest& a, const Nearest& b) noexcept {
  if (a.time == b.time) return {a.time, a.partner, a.time < predict::kNever};
  return a.time < b.time ? a : b;
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
  static bool collect(const Index* slots, Index k, Index* near, int& size) noexcept {
    bool plain = true;
    for (int m = 0; m < kCount; ++m) {
      if (slots[m] < 0 || slots[m] == k) continue;
      plain = plain && slots[m] < Cells::kMarked;
      near[size++] = slots[m];
    }
    return plain;
  }

  /// The slots of a cell that hold this, one bit each.
  static unsigned slots_with(const Index* slots, Index what) noexcept {
    unsigned found = 0;
    for (unsigned m = 0; m < Cells::kSlots; ++m) found |= static_cast<unsigned>(slots[m] == what) << m;
    return found;
  }

  static void pad(Index /*k*/, Index* /*near*/, int /*size*/) noexcept {}
};

}  // namespace carom::fast
