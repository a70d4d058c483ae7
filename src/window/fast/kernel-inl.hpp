// The earliest contact with the disks of a plain list, as many at a time as the vector registers hold.
//
// Each lane does what predict::contact_of_disks does, operation for operation; that function is the home of the
// formula, and a test holds the two together bit for bit. A list without traits knows no images, so that it makes no
// difference which disk of a pair comes first: both orders give the same r and v up to their common sign.
//
// Included once per target by hwy/foreach_target.h.
#if defined(CAROM_WINDOW_FAST_KERNEL_INL_) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WINDOW_FAST_KERNEL_INL_
#undef CAROM_WINDOW_FAST_KERNEL_INL_
#else
#define CAROM_WINDOW_FAST_KERNEL_INL_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace carom::fast::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::FixedTag<double, HWY_LANES(double)>;
using Vector = hn::Vec<Doubles>;
using Lanes = hn::Mask<Doubles>;
inline constexpr int kLanes = HWY_LANES(double);

/// The flights of kLanes disks, one disk per lane.
struct Flights {
  Vector x, y, vx, vy, t, radius;
};

/// Two neighbouring doubles, `offset` bytes into each of the records disks[0], disks[2], …: kCount doubles in all.
template <int kCount>
HWY_INLINE auto load_every_other(const Record* records, const Index* disks, std::size_t offset) {
  const hn::FixedTag<double, kCount> d;
  if constexpr (kCount == 2) {
    const char* record = reinterpret_cast<const char*>(records + *disks);
    return hn::Load(d, reinterpret_cast<const double*>(record + offset));
  } else {
    return hn::Combine(d, load_every_other<kCount / 2>(records, disks + kCount / 2, offset),
                       load_every_other<kCount / 2>(records, disks, offset));
  }
}

/// Two neighbouring doubles of each of kLanes records: the first ones in `a`, the second ones in `b`.
HWY_INLINE void load_pairs(const Record* records, const Index* disks, std::size_t offset, Vector& a, Vector& b) {
  const Doubles d;
  const Vector even = load_every_other<kLanes>(records, disks, offset);
  const Vector odd = load_every_other<kLanes>(records, disks + 1, offset);
  a = hn::InterleaveLower(d, even, odd);
  b = hn::InterleaveUpper(d, even, odd);
}

#if HWY_TARGET == HWY_AVX3
/// x, y, vx and vy of two disks.
HWY_INLINE Vector load_rows(const Record* records, Index low, Index high) {
  const Doubles d;
  const hn::Half<Doubles> half;
  return hn::Combine(d, hn::Load(half, &records[high].x), hn::Load(half, &records[low].x));
}
#endif

HWY_INLINE Flights load_flights(const Record* records, const Index* disks) {
  Flights flights;
  load_pairs(records, disks, offsetof(Record, t), flights.t, flights.radius);
#if HWY_TARGET == HWY_AVX3
  const Doubles d;
  const Vector a = load_rows(records, disks[0], disks[2]);
  const Vector b = load_rows(records, disks[1], disks[3]);
  const Vector e = load_rows(records, disks[4], disks[6]);
  const Vector f = load_rows(records, disks[5], disks[7]);
  const Vector x_low = hn::InterleaveLower(d, a, b);  // x0 x1 vx0 vx1 x2 x3 vx2 vx3
  const Vector x_high = hn::InterleaveLower(d, e, f);
  const Vector y_low = hn::InterleaveUpper(d, a, b);
  const Vector y_high = hn::InterleaveUpper(d, e, f);
  constexpr int kEvenBlocks = 0x88;  // of 16 bytes: 0 and 2 of either
  constexpr int kOddBlocks = 0xDD;
  flights.x = Vector{_mm512_shuffle_f64x2(x_low.raw, x_high.raw, kEvenBlocks)};
  flights.vx = Vector{_mm512_shuffle_f64x2(x_low.raw, x_high.raw, kOddBlocks)};
  flights.y = Vector{_mm512_shuffle_f64x2(y_low.raw, y_high.raw, kEvenBlocks)};
  flights.vy = Vector{_mm512_shuffle_f64x2(y_low.raw, y_high.raw, kOddBlocks)};
#elif HWY_TARGET == HWY_AVX2
  const Doubles d;
  const Vector a = hn::Load(d, &records[disks[0]].x);
  const Vector b = hn::Load(d, &records[disks[1]].x);
  const Vector e = hn::Load(d, &records[disks[2]].x);
  const Vector f = hn::Load(d, &records[disks[3]].x);
  const Vector x_low = hn::InterleaveLower(d, a, b);  // x0 x1 vx0 vx1
  const Vector x_high = hn::InterleaveLower(d, e, f);
  const Vector y_low = hn::InterleaveUpper(d, a, b);
  const Vector y_high = hn::InterleaveUpper(d, e, f);
  flights.x = hn::ConcatLowerLower(d, x_high, x_low);
  flights.vx = hn::ConcatUpperUpper(d, x_high, x_low);
  flights.y = hn::ConcatLowerLower(d, y_high, y_low);
  flights.vy = hn::ConcatUpperUpper(d, y_high, y_low);
#else
  load_pairs(records, disks, offsetof(Record, x), flights.x, flights.y);
  load_pairs(records, disks, offsetof(Record, vx), flights.vx, flights.vy);
#endif
  return flights;
}

/// Has what has been loaded wait in registers. Left alone, the compiler keeps the parts that vectors are put together
/// from, has no registers for so many, and sends them through memory.
HWY_INLINE void hold(Vector& v) {
#if HWY_TARGET == HWY_AVX3 && (HWY_COMPILER_GCC || HWY_COMPILER_CLANG)
  asm volatile("" : "+v"(v.raw));
#else
  (void)v;
#endif
}

/// What is added to positions so that copies stand where they are.
struct Offsets {
  Vector own_x, own_y, other_x, other_y;
};

/// predict::contact_of_disks in every lane; infinity where there is no contact.
template <bool kCopies>
HWY_INLINE Vector contacts(const Flights& i, const Flights& j, Vector sigma, const Offsets& offsets) {
  const Doubles d;
  const Vector zero = hn::Zero(d);
  const Vector start = hn::Max(i.t, j.t);
  const Vector dt_i = hn::Sub(start, i.t);
  const Vector dt_j = hn::Sub(start, j.t);
  Vector x_i = hn::Add(i.x, hn::Mul(i.vx, dt_i));
  Vector y_i = hn::Add(i.y, hn::Mul(i.vy, dt_i));
  Vector x_j = hn::Add(j.x, hn::Mul(j.vx, dt_j));
  Vector y_j = hn::Add(j.y, hn::Mul(j.vy, dt_j));
  if constexpr (kCopies) {
    x_i = hn::Add(x_i, offsets.own_x);
    y_i = hn::Add(y_i, offsets.own_y);
    x_j = hn::Add(x_j, offsets.other_x);
    y_j = hn::Add(y_j, offsets.other_y);
  }
  const Vector rx = hn::Sub(x_j, x_i);
  const Vector ry = hn::Sub(y_j, y_i);
  const Vector vx = hn::Sub(j.vx, i.vx);
  const Vector vy = hn::Sub(j.vy, i.vy);
  const Vector b = hn::Add(hn::Mul(rx, vx), hn::Mul(ry, vy));
  const Vector sigma_squared = hn::Mul(sigma, sigma);
  const Vector c = hn::Sub(hn::Add(hn::Mul(rx, rx), hn::Mul(ry, ry)), sigma_squared);
  const Vector twist = hn::Sub(hn::Mul(rx, vy), hn::Mul(ry, vx));
  const Vector v_squared = hn::Add(hn::Mul(vx, vx), hn::Mul(vy, vy));
  const Vector discriminant = hn::Sub(hn::Mul(v_squared, sigma_squared), hn::Mul(twist, twist));
  const Vector root = hn::Sqrt(hn::Max(discriminant, zero));
  const Vector wait = hn::Div(hn::Max(c, zero), hn::Sub(root, b));  // 0 where the two touch already
  const Lanes meet = hn::And(hn::Lt(b, zero), hn::Or(hn::Ge(discriminant, zero), hn::Le(c, zero)));
  return hn::IfThenElse(meet, hn::Add(start, wait), hn::Set(d, predict::kNever));
}

/// kLanes lanes with the flight of one disk.
HWY_INLINE Flights same_flights(const Record& record) {
  const Doubles d;
  return {hn::Set(d, record.x),  hn::Set(d, record.y), hn::Set(d, record.vx),
          hn::Set(d, record.vy), hn::Set(d, record.t), hn::Set(d, record.radius)};
}

struct VectorKernel {
  /// Two disks are predicted side by side where one pass usually does for each.
  static constexpr bool kSideBySide = kLanes == 8;
  static constexpr int kLanesPerPass = kLanes;

  /// The earliest contact of disk k with these disks. `near` goes on beyond `count` with k itself, which it never
  /// meets, for as many entries as a vector has lanes.
  template <bool kOneRadius>
  static HWY_INLINE Nearest nearest(const Record* records, Index k, const Index* near, int count) {
    const Flights own = same_flights(records[k]);
    Nearest best = nearest_of(times_of<kOneRadius>(own, load_flights(records, near)), near);
    for (int first = kLanes; first < count; first += kLanes) {
      const Flights others = load_flights(records, near + first);
      best = earlier(best, nearest_of(times_of<kOneRadius>(own, others), near + first));
    }
    return best;
  }

  template <bool kOneRadius>
  static HWY_INLINE Vector times_of(const Flights& own, const Flights& others) {
    const Vector sigma = kOneRadius ? hn::Add(own.radius, own.radius) : hn::Add(own.radius, others.radius);
    return contacts<false>(own, others, sigma, Offsets{});
  }

  /// The same times but for `met`: the two have just met, and part.
  static HWY_INLINE Vector without(Vector times, const Index* near, Index met) {
    const Doubles d;
#if HWY_TARGET == HWY_AVX3
    const hn::FixedTag<std::int32_t, kLanes> d32;
    const Lanes parting = Lanes{hn::Eq(hn::LoadU(d32, near), hn::Set(d32, met)).raw};
#else
    const hn::Rebind<std::int64_t, Doubles> d64;
    const hn::Rebind<std::int32_t, Doubles> d32;
    const auto disks = hn::PromoteTo(d64, hn::LoadU(d32, near));
    const Lanes parting = hn::RebindMask(d, hn::Eq(disks, hn::Set(d64, met)));
#endif
    return hn::IfThenElse(parting, hn::Set(d, predict::kNever), times);
  }

  /// One bit per lane.
  static HWY_INLINE unsigned bits_of(Lanes lanes) {
#if HWY_TARGET == HWY_AVX3
    return lanes.raw;
#else
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Doubles(), lanes, bits);
    return bits[0];
#endif
  }

  static HWY_INLINE Nearest nearest_of(Vector times, const Index* near) {
    const Doubles d;
    const Vector least = hn::MinOfLanes(d, times);
    Nearest best;
    best.time = hn::GetLane(least);
    const unsigned here = bits_of(hn::Eq(times, least)) | (1U << kLanes);
    best.partner = near[__builtin_ctz(here) & (kLanes - 1)];
    // Times are never NaN, so that one lane at least is the least.
    best.tied = static_cast<int>(best.time < predict::kNever) & static_cast<int>((here & (here - 1)) != (1U << kLanes));
    return best;
  }

  /// Times of contact with the candidates from number `first` on.
  static HWY_INLINE Vector times_of_copies(const Record* records, const Flights& own, const Index* near,
                                           const Shifts& shifts, int first) {
    const Doubles d;
    const Flights others = load_flights(records, near);
    const Offsets offsets{hn::LoadU(d, shifts.own_x.data() + first), hn::LoadU(d, shifts.own_y.data() + first),
                          hn::LoadU(d, shifts.other_x.data() + first), hn::LoadU(d, shifts.other_y.data() + first)};
    return contacts<true>(own, others, hn::Add(own.radius, others.radius), offsets);
  }
  static void contact_times(const Record* records, Index k, const Index* near, int count, const Shifts& shifts,
                            double* times) {
    const Flights own = same_flights(records[k]);
    for (int first = 0; first < count; first += kLanes) {
      hn::StoreU(times_of_copies(records, own, near + first, shifts, first), Doubles(), times + first);
    }
  }

  /// The same with copies among them; `which` becomes the candidate's number.
  template <bool kOneRadius>
  static HWY_INLINE Nearest nearest_copy(const Record* records, Index k, const Index* near, int count,
                                         const Shifts& shifts, int& which) {
    const Doubles d;
    const Flights own = same_flights(records[k]);
    Nearest best;
    for (int first = 0; first < count; first += kLanes) {
      const Vector times = times_of_copies(records, own, near + first, shifts, first);
      const Nearest here = nearest_of(times, near + first);
      if (here.time < best.time) {
        which = first + static_cast<int>(hn::FindFirstTrue(d, hn::Eq(times, hn::Set(d, here.time))));
      }
      best = earlier(best, here);
    }
    return best;
  }

  /// Whether disk k overlaps one of these disks, all at the same time.
  template <bool kOneRadius>
  static HWY_INLINE bool overlap(const Record* records, Index k, const Index* near, int count) {
    const Doubles d;
    const Flights own = same_flights(records[k]);
    for (int first = 0; first < count; first += kLanes) {
      const Flights others = load_flights(records, near + first);
      const Vector rx = hn::Sub(others.x, own.x);
      const Vector ry = hn::Sub(others.y, own.y);
      const Vector sigma = hn::Add(own.radius, others.radius);
      auto over = hn::Lt(hn::Add(hn::Mul(rx, rx), hn::Mul(ry, ry)), hn::Mul(sigma, sigma));
      if (first + kLanes > count) over = hn::And(over, hn::FirstN(d, static_cast<std::size_t>(count - first)));
      if (!hn::AllFalse(d, over)) return true;
    }
    return false;
  }

  /// The flights of the first kLanes candidates, in registers.
  template <bool kOneRadius>
  static HWY_INLINE Flights flights_of(const Record* records, const Index* near) {
    Flights flights = load_flights(records, near);
    hold(flights.x);
    hold(flights.y);
    hold(flights.vx);
    hold(flights.vy);
    hold(flights.t);
    if constexpr (!kOneRadius) hold(flights.radius);
    return flights;
  }
  static HWY_INLINE Flights flights_of(const Record& record) { return same_flights(record); }

  /// Appends to `near` the disks other than k in three times `count` neighbouring slots, at most 15 of them; 16 can be
  /// read. The second and the third of the three begin `step` slots after the one before. Returns false if one of the
  /// disks needs a closer look.
  template <int kCount>
  static HWY_INLINE bool collect(const Index* slots, std::ptrdiff_t step, Index k, Index* near, int& size) {
#if HWY_TARGET == HWY_AVX3
    constexpr int kWidth = kCount <= 8 ? 8 : 16;
    const hn::FixedTag<std::int32_t, kWidth> d;
    const auto marked = hn::Set(d, Slot::kMarked - 1);
    auto largest = hn::Set(d, Slot::kEmpty);
    const auto take = [&](const Index* from) HWY_ATTR {
      const auto slot = hn::LoadU(d, from);
      const auto taken = disks_other_than<kCount>(slot, hn::Set(d, k));
      hn::StoreU(hn::Compress(slot, taken), d, near + size);
      size += std::popcount(static_cast<unsigned>(taken.raw));
      largest = hn::Max(largest, hn::IfThenElseZero(taken, slot));
    };
    take(slots);
    take(slots + step);
    take(slots + 2 * step);
    return hn::Gt(largest, marked).raw == 0;
#else
    // There is no instruction for it; one by one without branches is the next best.
    Index largest = Slot::kEmpty;
    for (int part = 0; part < 3; ++part, slots += step) {
      for (int m = 0; m < kCount; ++m) {
        near[size] = slots[m];
        size += static_cast<int>(slots[m] >= 0) & static_cast<int>(slots[m] != k);
        largest = std::max(largest, slots[m]);
      }
    }
    return largest < Slot::kMarked;
#endif
  }

#if HWY_TARGET == HWY_AVX3
  /// Of the first kCount slots those that hold a disk other than k.
  template <int kCount>
  static HWY_INLINE auto disks_other_than(hn::Vec512<std::int32_t> slots, hn::Vec512<std::int32_t> k) {
    const __mmask16 disks =
        _mm512_mask_cmpgt_epi32_mask((1U << kCount) - 1, slots.raw, _mm512_set1_epi32(Slot::kEmpty));
    return hn::Mask512<std::int32_t>{_mm512_mask_cmpneq_epi32_mask(disks, slots.raw, k.raw)};
  }
  template <int kCount>
  static HWY_INLINE auto disks_other_than(hn::Vec256<std::int32_t> slots, hn::Vec256<std::int32_t> k) {
    const __mmask8 disks = _mm256_mask_cmpgt_epi32_mask((1U << kCount) - 1, slots.raw, _mm256_set1_epi32(Slot::kEmpty));
    return hn::Mask256<std::int32_t>{_mm256_mask_cmpneq_epi32_mask(disks, slots.raw, k.raw)};
  }
#endif

  /// The slots of a cell that hold this, one bit each.
  static HWY_INLINE unsigned slots_with(const Index* slots, Index what) {
#if HWY_TARGET == HWY_AVX3
    const hn::FixedTag<std::int32_t, 8> d;
    std::uint8_t found = 0;
    hn::StoreMaskBits(d, hn::And(hn::Eq(hn::LoadU(d, slots), hn::Set(d, what)), hn::FirstN(d, Cells::kSlots)), &found);
    return found;
#else
    return ScalarKernel::slots_with(slots, what);
#endif
  }

#if HWY_TARGET == HWY_AVX3
  /// See ListSteps.
  static int find_in_list(const Grid::Rows& rows, const List* lists, Index k, double range_squared, double far_squared,
                          Index* found) {
    constexpr int kAtOnce = 3 * Grid::kSlots;
    constexpr unsigned kLastSlots = 0x4210;  // of each cell
    const hn::FixedTag<std::int32_t, 16> d32;
    int candidates = 0;
    unsigned full = 0;
    const Index* row = rows.first;
    for (int b = 0; b < rows.rows; ++b, row += rows.stride) {
      for (int a = 0; a < rows.slots; a += kAtOnce) {
        const auto slots = hn::LoadU(d32, row + a);
        const unsigned here = (1U << std::min(rows.slots - a, kAtOnce)) - 1;
        const auto taken =
            static_cast<__mmask16>(_mm512_mask_cmpge_epi32_mask(here, slots.raw, _mm512_setzero_si512()));
        hn::StoreU(hn::Compress(slots, hn::Mask512<std::int32_t>{taken}), d32, found + candidates);
        candidates += std::popcount(static_cast<unsigned>(taken));
        full |= taken & kLastSlots;
      }
    }
    const Doubles d;
    const hn::FixedTag<std::int32_t, kLanes> half;
    hn::StoreU(hn::Set(half, k), half, found + candidates);
    const Vector here_x = hn::Set(d, lists[k].x);
    const Vector here_y = hn::Set(d, lists[k].y);
    Vector farthest = hn::Zero(d);
    int size = 0;
    for (int first = 0; first < candidates; first += kLanes) {
      Vector x, y;
      const auto disks = hn::LoadU(half, found + first);
      load_pairs(reinterpret_cast<const Record*>(lists), found + first, offsetof(List, x), x, y);
      const Vector rx = hn::Sub(x, here_x);
      const Vector ry = hn::Sub(y, here_y);
      const Vector distance_squared = hn::Add(hn::Mul(rx, rx), hn::Mul(ry, ry));
      farthest = hn::Max(farthest, distance_squared);
      const Lanes near = hn::Lt(distance_squared, hn::Set(d, range_squared));
      const auto kept = static_cast<__mmask8>(_mm256_mask_cmpneq_epi32_mask(near.raw, disks.raw, _mm256_set1_epi32(k)));
      hn::StoreU(hn::Compress(disks, hn::Mask256<std::int32_t>{kept}), half, found + size);
      size += std::popcount(static_cast<unsigned>(kept));
    }
    const bool all = full == 0 && hn::GetLane(hn::MaxOfLanes(d, farthest)) < far_squared;
    return all ? size : -1;
  }
  static int drop_from_lists(List* lists, const Index* disks, int count, Index k) {
    constexpr int kBefore = offsetof(List, near) / sizeof(Index);
    const hn::FixedTag<std::int32_t, 16> d;
    for (int m = 0; m < count; ++m) {
      List& list = lists[disks[m]];
      if ((list.traits & List::kLong) != 0) return m;
      const unsigned found = hn::Eq(hn::Load(d, reinterpret_cast<const Index*>(&list)), hn::Set(d, k)).raw >> kBefore;
      if (found == 0) continue;
      list.near[std::countr_zero(found)] = list.near[--list.count];
      list.near[list.count] = disks[m];
    }
    return count;
  }
  static ListSteps list_steps() noexcept { return {find_in_list, drop_from_lists}; }
#else
  static ListSteps list_steps() noexcept { return scalar_list_steps(); }
#endif

  static HWY_INLINE void pad(Index k, Index* near, int size) {
    const hn::FixedTag<std::int32_t, HWY_MIN(8, HWY_LANES(std::int32_t))> d;
    hn::StoreU(hn::Set(d, k), d, near + size);
  }
};

}  // namespace carom::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
