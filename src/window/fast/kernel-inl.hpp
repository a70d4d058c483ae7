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

HWY_INLINE Flights load_flights(const Record* records, const Index* disks) {
  Flights flights;
  load_pairs(records, disks, offsetof(Record, x), flights.x, flights.y);
  load_pairs(records, disks, offsetof(Record, vx), flights.vx, flights.vy);
  load_pairs(records, disks, offsetof(Record, t), flights.t, flights.radius);
  return flights;
}

/// predict::contact_of_disks in every lane; infinity where there is no contact.
HWY_INLINE Vector contacts(const Flights& i, const Flights& j, Vector sigma) {
  const Doubles d;
  const Vector zero = hn::Zero(d);
  const Vector start = hn::Max(i.t, j.t);
  const Vector dt_i = hn::Sub(start, i.t);
  const Vector dt_j = hn::Sub(start, j.t);
  const Vector rx = hn::Sub(hn::Add(j.x, hn::Mul(j.vx, dt_j)), hn::Add(i.x, hn::Mul(i.vx, dt_i)));
  const Vector ry = hn::Sub(hn::Add(j.y, hn::Mul(j.vy, dt_j)), hn::Add(i.y, hn::Mul(i.vy, dt_i)));
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
  static constexpr int kPasses = (List::kRoom + kLanes - 1) / kLanes;
  static_assert(List::kRoom % 2 == 0 && List::kRoom >= kLanes);

  /// First entry of the list that a pass looks at: the last pass looks at some a second time, since the list ends.
  static constexpr int first_of(int pass) {
    return pass * kLanes + kLanes <= List::kRoom ? pass * kLanes : List::kRoom - kLanes;
  }

  template <bool kOneRadius>
  static HWY_INLINE Nearest nearest(const Record* records, Index k, const List& list) {
    const Doubles d;
    const Flights own = same_flights(records[k]);
    const Vector never = hn::Set(d, predict::kNever);
    const Vector own_sigma = hn::Add(own.radius, own.radius);
    Vector times[kPasses];
    Vector earliest = never;
    const int passes = (list.count + kLanes - 1) / kLanes;
    for (int pass = 0; pass < passes; ++pass) {
      const int first = first_of(pass);
      const Flights others = load_flights(records, list.near.data() + first);
      times[pass] = contacts(own, others, kOneRadius ? own_sigma : hn::Add(own.radius, others.radius));
      if (first != pass * kLanes) {
        const auto again = hn::FirstN(d, static_cast<std::size_t>(pass * kLanes - first));
        times[pass] = hn::IfThenElse(again, never, times[pass]);
      }
      earliest = hn::Min(earliest, times[pass]);
    }
    Nearest best;
    best.time = hn::GetLane(hn::MinOfLanes(d, earliest));
    if (!(best.time < predict::kNever)) return best;
    const Vector least = hn::Set(d, best.time);
    std::size_t found = 0;
    for (int pass = 0; pass < passes; ++pass) {
      const Lanes here = hn::Eq(times[pass], least);
      const std::size_t count = hn::CountTrue(d, here);
      if (count == 0) continue;
      found += count;
      best.partner = list.near[static_cast<std::size_t>(first_of(pass) + hn::FindFirstTrue(d, here))];
    }
    best.tied = found > 1;
    return best;
  }
};

}  // namespace carom::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
