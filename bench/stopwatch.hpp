// The time that a piece of work takes.
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>

namespace carom::bench {

template <typename Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  benchmark::ClobberMemory();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace carom::bench
