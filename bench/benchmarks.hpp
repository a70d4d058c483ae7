// What carom_bench can time; each file of the folder registers its own with Google Benchmark.
#pragma once

namespace carom::bench {

/// The rule for many pairs, beside memcpy, with every instruction set of this processor.
void register_rule_benchmarks();

/// The fast solver's kernel, calendar, lists and cells, each beside another way to do the same.
void register_window_benchmarks();

}  // namespace carom::bench
