// The earliest contact with the disks of a plain list, one after the other.
#pragma once

#include "lists.hpp"
#include "record.hpp"

namespace carom::fast {

/// What a kernel finds in a list: the earliest contact, and whether another one comes at the same time.
struct Nearest {
  double time = predict::kNever;
  Index partner = kNobody;
  bool tied = false;
};

struct ScalarKernel {
  template <bool kOneRadius>
  static Nearest nearest(const Record* records, Index k, const List& list) noexcept {
    const Record& own = records[k];
    Nearest best;
    for (int m = 0; m < list.count; ++m) {
      const Record& other = records[list.near[m]];
      const double time = predict::contact_of_disks(own.flight(), other.flight(), {}, own.radius + other.radius);
      if (time > best.time || time == predict::kNever) continue;
      best.tied = time == best.time;
      best.time = time;
      best.partner = list.near[m];
    }
    return best;
  }
};

}  // namespace carom::fast
