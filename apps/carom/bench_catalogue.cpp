#include "bench_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "command.hpp"

namespace carom::program {
namespace {

constexpr std::uint64_t kMostDisksOfShortOnes = 100'000;

/// Enough collisions for a steady rate on a machine that computes some millions a second, and at least 10 a disk.
double collisions_per_disk_for(std::uint64_t disks) { return std::max(10.0, 4e6 / static_cast<double>(disks)); }

/// A number of disks, and how it stands in names.
struct Size {
  const char* name;
  std::uint64_t disks;
};

constexpr Size kSizes[] = {{"1e3", 1'000}, {"1e4", 10'000}, {"1e5", 100'000}, {"1e6", 1'000'000}, {"1e7", 10'000'000}};

/// Adds scenes of one size that differ in their packing fractions.
void add(std::vector<Benchmark>& list, const std::string& family, const std::string& description, const Size& size,
         std::initializer_list<double> packings, GasPreset gas) {
  gas.disks = size.disks;
  for (const double packing : packings) {
    gas.packing = packing;
    list.push_back({fmt::format("{}-{}-{:.2f}", family, size.name, packing), description, gas,
                    collisions_per_disk_for(gas.disks)});
  }
}

/// How much of two names is the same, from the front and from the back.
std::size_t likeness(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  const auto front = std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin();
  const auto back = std::mismatch(a.rbegin(), a.rend() - front, b.rbegin()).first - a.rbegin();
  return static_cast<std::size_t>(front + back);
}

[[noreturn]] void refuse_name(const std::string& name, std::vector<Benchmark> known) {
  constexpr std::size_t kClosest = 3;
  std::stable_sort(known.begin(), known.end(), [&](const Benchmark& a, const Benchmark& b) {
    return likeness(name, a.name) > likeness(name, b.name);
  });
  std::vector<std::string> closest;
  for (std::size_t k = 0; k < kClosest; ++k) closest.push_back(known[k].name);
  throw UsageError(fmt::format("there is no benchmark '{}'; close to it are {}; 'carom bench --list' lists all", name,
                               fmt::join(closest, ", ")));
}

}  // namespace

std::vector<Benchmark> all_benchmarks() {
  GasPreset walls;
  walls.boundary = Boundary::reflecting;
  GasPreset masses;
  masses.mass_ratio = 10;
  GasPreset bidisperse;
  bidisperse.radius_ratio = 1.4;

  std::vector<Benchmark> list;
  for (const Size& size : kSizes) {
    add(list, "gas", "equal disks, periodic box", size, {0.05, 0.20, 0.50, 0.70, 0.80}, {});
    if (size.disks != 10'000 && size.disks != 1'000'000) continue;
    add(list, "bidisperse", "half of the disks 1.4 times as large, periodic box", size, {0.20, 0.50, 0.65}, bidisperse);
    add(list, "masses-10", "half of the disks 10 times as heavy, periodic box", size, {0.20, 0.50, 0.70}, masses);
    add(list, "walls", "equal disks, reflecting walls", size, {0.20, 0.50, 0.70}, walls);
  }
  return list;
}

std::vector<Benchmark> short_benchmarks() {
  std::vector<Benchmark> list = all_benchmarks();
  std::erase_if(list, [](const Benchmark& benchmark) { return benchmark.gas.disks > kMostDisksOfShortOnes; });
  return list;
}

std::vector<Benchmark> benchmarks_named(const std::string& name) {
  const std::vector<Benchmark> known = all_benchmarks();
  if (name.empty()) throw UsageError("the benchmark's name is empty; 'carom bench --list' lists them");
  if (name == "all") return known;
  std::vector<Benchmark> found;
  std::copy_if(known.begin(), known.end(), std::back_inserter(found),
               [&](const Benchmark& benchmark) { return benchmark.name.starts_with(name); });
  if (found.empty()) refuse_name(name, known);
  return found;
}

Benchmark benchmark_of_gas(std::uint64_t disks, double packing) {
  if (disks < 2) throw UsageError(fmt::format("--disks {}: give at least 2, or nothing ever collides", disks));
  Benchmark benchmark;
  benchmark.name = fmt::format("gas-{}-{}", disks, packing);
  benchmark.description = "equal disks, periodic box";
  benchmark.gas.disks = disks;
  benchmark.gas.packing = packing;
  benchmark.collisions_per_disk = collisions_per_disk_for(disks);
  return benchmark;
}

}  // namespace carom::program
