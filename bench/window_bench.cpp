// Parts of the fast solver: the prediction kernel beside the scalar function, the calendar beside a binary heap, and
// what it takes to find out who is near whom.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <queue>
#include <string>
#include <vector>

#include "benchmarks.hpp"
#include "carom/base/random.hpp"
#include "carom/base/simd.hpp"
#include "carom/state/scene.hpp"
#include "stopwatch.hpp"
#include "window/fast/calendar.hpp"
#include "window/fast/cells.hpp"
#include "window/fast/lists.hpp"
#include "window/fast/loops.hpp"

namespace carom::bench {
namespace {

using namespace carom::fast;

/// Times of two ways to do the same, taken in turns.
class Beside {
 public:
  void add(double seconds, double other_seconds) {
    seconds_ += seconds;
    other_seconds_ += other_seconds;
    ratios_.push_back(other_seconds / seconds);
  }
  [[nodiscard]] double seconds() const noexcept { return seconds_; }
  [[nodiscard]] double other_seconds() const noexcept { return other_seconds_; }
  /// How many times faster than the other one; the median of all turns.
  [[nodiscard]] double ratio() const {
    std::vector<double> sorted = ratios_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  }

 private:
  double seconds_ = 0;
  double other_seconds_ = 0;
  std::vector<double> ratios_;
};

// --- the kernel -----------------------------------------------------------------------------------------------

constexpr int kPerList = 8;
constexpr int kPadding = 8;

/// Disks that fly about in a gas, each with a list of others around it.
struct Gas {
  Array<Record> records;
  std::vector<std::array<Index, kPerList + kPadding>> lists;
  Shifts shifts;

  explicit Gas(std::size_t disks) {
    RandomStream random(1, 0, 0);
    for (std::size_t k = 0; k < disks; ++k) {
      const auto place = static_cast<double>(k);
      records.push_back({place + random.normal(), 4 * random.normal(), random.normal(), random.normal(),
                         random.uniform(), 0.5, predict::kNever, kNobody, 0});
    }
    lists.resize(disks);
    for (std::size_t k = 0; k < disks; ++k) {
      lists[k].fill(static_cast<Index>(k));
      for (std::size_t m = 0; m < kPerList; ++m) lists[k][m] = static_cast<Index>((k + 1 + m) % disks);
    }
    for (int m = 0; m < kPerList + kPadding; ++m) shifts.set(m, {}, true, {});
  }

  /// All contact times of all lists, by `kernel`; `times` has room for those of one list.
  template <class Kernel>
  void predict(Kernel kernel, double* times) const {
    for (Index k = 0; k < static_cast<Index>(lists.size()); ++k) {
      kernel(records.data(), k, lists[k].data(), kPerList, shifts, times);
      benchmark::DoNotOptimize(times);
      benchmark::ClobberMemory();
    }
  }
};

void contact_times_one_by_one(const Record* records, Index k, const Index* near, int count, const Shifts& /*none*/,
                              double* times) {
  const predict::Flight own = records[k].flight();
  for (int m = 0; m < count; ++m) {
    const Record& other = records[near[m]];
    times[m] = predict::contact_of_disks(own, other.flight(), {}, records[k].radius + other.radius);
  }
}

void kernel_beside_function(benchmark::State& state, Simd simd) {
  const Gas gas(static_cast<std::size_t>(state.range(0)));
  const auto kernel = loops_for(simd, Neighbourhood::lists, true).contact_times;
  std::array<double, kPerList + kPadding> times;
  Beside beside;
  for ([[maybe_unused]] auto _ : state) {
    const double by_function = seconds_of([&] { gas.predict(contact_times_one_by_one, times.data()); });
    const double by_kernel = seconds_of([&] { gas.predict(kernel, times.data()); });
    state.SetIterationTime(by_kernel);
    beside.add(by_kernel, by_function);
  }
  const double lists = static_cast<double>(gas.lists.size()) * static_cast<double>(state.iterations());
  state.counters["ns/pair"] = 1e9 * beside.seconds() / (lists * kPerList);
  state.counters["ns/list"] = 1e9 * beside.seconds() / lists;
  state.counters["function_ns/list"] = 1e9 * beside.other_seconds() / lists;
  state.counters["kernel/function"] = beside.ratio();
}

// --- the calendar ---------------------------------------------------------------------------------------------

constexpr double kEventsPerBucket = 7;
constexpr double kEventsPerDisk = 8;  // in a window

/// How long disks wait for their next events: 1 in the mean, and the same in whatever order events are taken.
class Waits {
 public:
  Waits() {
    RandomStream random(2, 0, 0);
    for (double& wait : waits_) wait = -std::log1p(-random.uniform());
  }
  [[nodiscard]] double operator()(Index k, double now) const noexcept {
    const std::uint64_t mixed = (std::bit_cast<std::uint64_t>(now) + static_cast<std::uint64_t>(k)) * kOdd;
    return waits_[mixed >> 48];
  }

 private:
  static constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;
  std::vector<double> waits_ = std::vector<double>(1 << 16);
};

/// A window in which every event is followed by another of its disk. Returns how many there were.
std::uint64_t play_with_calendar(Array<Record>& records, const Waits& waits, Calendar& calendar) {
  const auto disks = static_cast<double>(records.size());
  calendar.start(kEventsPerDisk, kEventsPerBucket / disks, records.size() / 2 + 64);
  std::uint64_t events = 0;
  const auto enter = [&](Index k, double now) {
    const double time = now + waits(k, now);
    records[k].next = time < kEventsPerDisk ? time : predict::kNever;
    if (time < kEventsPerDisk) calendar.push(k, time);
  };
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) enter(k, 0);
  while (!calendar.empty() || calendar.turn(records)) {
    const Due due = calendar.first();
    calendar.drop_first();
    if (records[due.disk].next != due.time) continue;
    ++events;
    enter(due.disk, due.time);
  }
  return events;
}

std::uint64_t play_with_heap(std::size_t disks, const Waits& waits) {
  const auto later = [](const Due& a, const Due& b) { return a.time > b.time; };
  std::priority_queue<Due, std::vector<Due>, decltype(later)> heap(later);
  std::uint64_t events = 0;
  const auto enter = [&](Index k, double now) {
    const double time = now + waits(k, now);
    if (time < kEventsPerDisk) heap.push({time, k});
  };
  for (Index k = 0; k < static_cast<Index>(disks); ++k) enter(k, 0);
  while (!heap.empty()) {
    const Due due = heap.top();
    heap.pop();
    ++events;
    enter(due.disk, due.time);
  }
  return events;
}

void calendar_beside_heap(benchmark::State& state) {
  const auto disks = static_cast<std::size_t>(state.range(0));
  const Waits waits;
  Array<Record> records(disks, Record{0, 0, 0, 0, 0, 0.5, predict::kNever, kNobody, 0});
  Calendar calendar;
  Beside beside;
  double events = 0;
  for ([[maybe_unused]] auto _ : state) {
    std::uint64_t by_heap = 0;
    std::uint64_t by_calendar = 0;
    const double heap_seconds = seconds_of([&] { by_heap = play_with_heap(disks, waits); });
    const double calendar_seconds = seconds_of([&] { by_calendar = play_with_calendar(records, waits, calendar); });
    if (by_heap != by_calendar) state.SkipWithError("the two do not give the same events");
    state.SetIterationTime(calendar_seconds);
    beside.add(calendar_seconds, heap_seconds);
    events += static_cast<double>(by_calendar);
  }
  state.counters["ns/event"] = 1e9 * beside.seconds() / events;
  state.counters["heap_ns/event"] = 1e9 * beside.other_seconds() / events;
  state.counters["calendar/heap"] = beside.ratio();
}

// --- who is near whom -----------------------------------------------------------------------------------------

/// A gas as a solver holds it, in the order of its lattice.
struct Neighbourhoods {
  Setup setup;
  Array<Record> records;
  Array<DiskId> ids;

  Neighbourhoods(std::size_t disks, double packing) {
    Scene scene;
    GasSpec gas;
    gas.count = disks;
    gas.packing_fraction = packing;
    scene.gas.push_back(gas);
    setup = realize(scene);
    ids.resize(disks);
    std::iota(ids.begin(), ids.end(), 0U);
    for (const DiskId id : ids) {
      const Vec2 place = setup.frame.position(id);
      records.push_back({place.x, place.y, 0, 0, 0, setup.system.radius(id), predict::kNever, kNobody, 0});
    }
  }
};

void cells_beside_lists(benchmark::State& state, double packing) {
  constexpr double kSlack = 1e-9;
  const Neighbourhoods near(static_cast<std::size_t>(state.range(0)), packing);
  const auto disks = static_cast<double>(near.records.size());
  const Vec2 size = near.setup.system.box.size;
  const double reach = std::sqrt(7.5 * size.x * size.y / (disks * kPi));  // of lists with 7.5 disks, as the solver's
  const double cell = std::sqrt(0.8 * size.x * size.y / disks);           // of cells with 0.8 disks
  Beside beside;
  for ([[maybe_unused]] auto _ : state) {
    const double lists_seconds = seconds_of([&] {
      const Lists lists(near.setup.system, {{0, 0}, size}, std::max(reach - 1, 0.1), kSlack, near.records, near.ids,
                        loops_for(usable_simd(std::nullopt), Neighbourhood::lists, true).list_steps);
      benchmark::DoNotOptimize(&lists[0]);
    });
    const double cells_seconds = seconds_of([&] {
      const Cells cells(near.setup.system, {}, cell, kSlack, near.records, near.ids);
      benchmark::DoNotOptimize(cells.slots(0, 0));
    });
    state.SetIterationTime(lists_seconds + cells_seconds);
    beside.add(cells_seconds, lists_seconds);
  }
  const double made = disks * static_cast<double>(state.iterations());
  state.counters["lists_ns/disk"] = 1e9 * beside.other_seconds() / made;
  state.counters["cells_ns/disk"] = 1e9 * beside.seconds() / made;
  state.counters["cells/lists"] = beside.ratio();
}

}  // namespace

void register_window_benchmarks() {
  for (const Simd simd : available_simd()) {
    const std::string title = "window/kernel/" + std::string(name_of(simd));
    // With fewer disks the processor learns by heart which pairs meet, and the function's branches cost nothing.
    benchmark::RegisterBenchmark(title.c_str(), kernel_beside_function, simd)
        ->Arg(10'000)
        ->Arg(1'000'000)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  }
  benchmark::RegisterBenchmark("window/calendar", calendar_beside_heap)
      ->Arg(1'000)
      ->Arg(100'000)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
  for (const double packing : {0.2, 0.7}) {
    const std::string title = "window/neighbours/packing_" + std::to_string(static_cast<int>(100 * packing + 0.5));
    benchmark::RegisterBenchmark(title.c_str(), cells_beside_lists, packing)
        ->Arg(100'000)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace carom::bench
