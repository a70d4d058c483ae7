// The program carom_bench: `carom_bench --benchmark_filter=rule`, `carom_bench --help`.
#include <benchmark/benchmark.h>

#include "benchmarks.hpp"

int main(int count, char** words) {
  carom::bench::register_rule_benchmarks();
  carom::bench::register_window_benchmarks();
  benchmark::Initialize(&count, words);
  if (benchmark::ReportUnrecognizedArguments(count, words)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
