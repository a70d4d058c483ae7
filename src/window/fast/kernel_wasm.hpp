// The earliest contact with the disks of a plain list, two at a time, with WebAssembly's vectors. Highway 1.0 has none
// of doubles there.
//
// Each lane does what predict::contact_of_disks does, operation for operation; see kernel-inl.hpp.
#pragma once

#include <wasm_simd128.h>

#include "kernel_scalar.hpp"

namespace carom::fast {

struct WasmKernel : ScalarKernel {
  /// The flights of two disks, one disk per lane.
  struct Flights {
    v128_t x, y, vx, vy, t, radius;
  };

  static inline Flights load_flights(const Record& a, const Record& b) noexcept {
    const auto low = [](v128_t one, v128_t two) { return wasm_i64x2_shuffle(one, two, 0, 2); };
    const auto high = [](v128_t one, v128_t two) { return wasm_i64x2_shuffle(one, two, 1, 3); };
    const v128_t place_a = wasm_v128_load(&a.x), place_b = wasm_v128_load(&b.x);
    const v128_t speed_a = wasm_v128_load(&a.vx), speed_b = wasm_v128_load(&b.vx);
    const v128_t rest_a = wasm_v128_load(&a.t), rest_b = wasm_v128_load(&b.t);
    return {low(place_a, place_b),  high(place_a, place_b), low(speed_a, speed_b),
            high(speed_a, speed_b), low(rest_a, rest_b),    high(rest_a, rest_b)};
  }

  /// predict::contact_of_disks in both lanes; infinity where there is no contact.
  static inline v128_t contacts(const Flights& i, const Flights& j, v128_t sigma) noexcept {
    const v128_t zero = wasm_f64x2_const(0, 0);
    const auto times = [](v128_t a, v128_t b) { return wasm_f64x2_mul(a, b); };
    const v128_t start = wasm_f64x2_max(i.t, j.t);
    const v128_t dt_i = wasm_f64x2_sub(start, i.t);
    const v128_t dt_j = wasm_f64x2_sub(start, j.t);
    const v128_t rx = wasm_f64x2_sub(wasm_f64x2_add(j.x, times(j.vx, dt_j)), wasm_f64x2_add(i.x, times(i.vx, dt_i)));
    const v128_t ry = wasm_f64x2_sub(wasm_f64x2_add(j.y, times(j.vy, dt_j)), wasm_f64x2_add(i.y, times(i.vy, dt_i)));
    const v128_t vx = wasm_f64x2_sub(j.vx, i.vx);
    const v128_t vy = wasm_f64x2_sub(j.vy, i.vy);
    const v128_t b = wasm_f64x2_add(times(rx, vx), times(ry, vy));
    const v128_t sigma_squared = times(sigma, sigma);
    const v128_t c = wasm_f64x2_sub(wasm_f64x2_add(times(rx, rx), times(ry, ry)), sigma_squared);
    const v128_t twist = wasm_f64x2_sub(times(rx, vy), times(ry, vx));
    const v128_t v_squared = wasm_f64x2_add(times(vx, vx), times(vy, vy));
    const v128_t discriminant = wasm_f64x2_sub(times(v_squared, sigma_squared), times(twist, twist));
    const v128_t hit = wasm_v128_or(wasm_f64x2_ge(discriminant, zero), wasm_f64x2_le(c, zero));
    const v128_t meet = wasm_v128_and(wasm_f64x2_lt(b, zero), hit);
    const v128_t never = wasm_f64x2_splat(predict::kNever);
    if (!wasm_v128_any_true(meet)) return never;
    const v128_t root = wasm_f64x2_sqrt(wasm_f64x2_max(discriminant, zero));
    const v128_t wait = wasm_f64x2_div(wasm_f64x2_max(c, zero), wasm_f64x2_sub(root, b));  // 0 if they touch already
    return wasm_v128_bitselect(wasm_f64x2_add(start, wait), never, meet);
  }

  /// `near` goes on beyond `count` with k itself, which it never meets.
  template <bool kOneRadius>
  static Nearest nearest(const Record* records, Index k, const Index* near, int count) noexcept {
    const Flights own = load_flights(records[k], records[k]);
    Nearest best;
    const auto look_at = [&best](double time, Index partner) {
      if (time < best.time) {
        best = {time, partner, false};
      } else if (time == best.time && time < predict::kNever) {
        best.tied = true;
      }
    };
    for (int m = 0; m < count; m += 2) {
      const Flights others = load_flights(records[near[m]], records[near[m + 1]]);
      const v128_t times = contacts(own, others, wasm_f64x2_add(own.radius, others.radius));
      look_at(wasm_f64x2_extract_lane(times, 0), near[m]);
      look_at(wasm_f64x2_extract_lane(times, 1), near[m + 1]);
    }
    return best;
  }

  /// Without branches that could be guessed wrong.
  template <int kCount>
  static bool collect(const Index* slots, std::ptrdiff_t step, Index k, Index* near, int& size) noexcept {
    Index largest = Slot::kEmpty;
    for (int part = 0; part < 3; ++part, slots += step) {
      for (int m = 0; m < kCount; ++m) {
        near[size] = slots[m];
        size += static_cast<int>(slots[m] >= 0) & static_cast<int>(slots[m] != k);
        largest = slots[m] > largest ? slots[m] : largest;
      }
    }
    return largest < Slot::kMarked;
  }

  static void pad(Index k, Index* near, int size) noexcept { near[size] = k; }
};

}  // namespace carom::fast
