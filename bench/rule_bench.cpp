// rule::collide_batch beside memcpy: how close the rule comes to the speed of memory.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks.hpp"
#include "carom/base/random.hpp"
#include "carom/base/simd.hpp"
#include "carom/rule/batch.hpp"
#include "stopwatch.hpp"

namespace carom::bench {
namespace {

// Ten arrays are read, of which the four of velocities are written. memcpy writes as much as it reads.
constexpr std::size_t kBytesMovedPerPair = (10 + 4) * sizeof(double);
constexpr std::size_t kBytesCopiedPerPair = kBytesMovedPerPair / 2;

enum class Masses { equal, unequal };

/// Touching disks, all of them approaching.
struct Pairs {
  std::vector<double> x1, y1, m1, x2, y2, m2, vx1, vy1, vx2, vy2;

  Pairs(std::size_t count, Masses masses) {
    RandomStream random(1, 0, 0);
    const auto mass = [&] { return masses == Masses::equal ? 1.0 : 0.5 + random.uniform(); };
    for (std::size_t k = 0; k < count; ++k) {
      const double x = random.normal();
      const double y = random.normal();
      add({&x1, &y1, &m1, &x2, &y2, &m2}, {x, y, mass(), x + random.normal(), y + random.normal(), mass()});
      const double vx = random.normal();
      const double vy = random.normal();
      const bool approaching = vx * (x2[k] - x1[k]) + vy * (y2[k] - y1[k]) > 0;
      add({&vx1, &vy1, &vx2, &vy2}, {approaching ? vx : -vx, approaching ? vy : -vy, 0, 0});
    }
  }

  /// After a collision the pairs fly apart. Seen with the two centres exchanged they approach again, and an elastic
  /// collision gives them back the velocities they had: so every call has as much to do as the first.
  void exchange_centres() noexcept {
    std::swap(x1, x2);
    std::swap(y1, y2);
  }

  [[nodiscard]] rule::PairSpans spans() noexcept {
    return {.x1 = x1, .y1 = y1, .m1 = m1, .x2 = x2, .y2 = y2, .m2 = m2, .vx1 = vx1, .vy1 = vy1, .vx2 = vx2, .vy2 = vy2};
  }

 private:
  static void add(std::initializer_list<std::vector<double>*> arrays, std::initializer_list<double> values) {
    auto value = values.begin();
    for (std::vector<double>* array : arrays) array->push_back(*value++);
  }
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Alternates the rule and a copy of as many bytes. Counters: bytes per second of both, and the median of the rule's
/// over the copy's, pair by pair.
void collide_beside_memcpy(benchmark::State& state, Masses masses, Simd simd) {
  const auto count = static_cast<std::size_t>(state.range(0));
  Pairs pairs(count, masses);
  const std::vector<char> source(count * kBytesCopiedPerPair, 1);
  std::vector<char> copy(source.size());

  double rule_seconds = 0;
  double copy_seconds = 0;
  std::vector<double> ratios;
  for ([[maybe_unused]] auto _ : state) {
    const double copying = seconds_of([&] { std::memcpy(copy.data(), source.data(), source.size()); });
    const double colliding = seconds_of([&] { rule::collide_batch(pairs.spans(), 1, simd); });
    pairs.exchange_centres();
    state.SetIterationTime(colliding);
    rule_seconds += colliding;
    copy_seconds += copying;
    ratios.push_back(copying / colliding);
  }
  const double bytes = static_cast<double>(count * kBytesMovedPerPair) * static_cast<double>(state.iterations());
  state.counters["rule_bytes/s"] = bytes / rule_seconds;
  state.counters["memcpy_bytes/s"] = bytes / copy_seconds;
  state.counters["rule/memcpy"] = median(ratios);
  state.counters["ns/pair"] =
      1e9 * rule_seconds / (static_cast<double>(count) * static_cast<double>(state.iterations()));
}

}  // namespace

void register_rule_benchmarks() {
  for (const auto& [masses, name] : {std::pair{Masses::equal, "equal_masses"}, {Masses::unequal, "unequal_masses"}}) {
    for (const Simd simd : available_simd()) {
      const std::string title = std::string("rule/") + name + "/" + std::string(name_of(simd));
      benchmark::RegisterBenchmark(title.c_str(), collide_beside_memcpy, masses, simd)
          ->Arg(1'000)
          ->Arg(1'000'000)
          ->UseManualTime()
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace carom::bench
