// carom bench: the project's own benchmarks.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench_catalogue.hpp"
#include "bench_measurement.hpp"
#include "carom/carom.hpp"
#include "command.hpp"
#include "environment.hpp"
#include "interrupt.hpp"
#include "options.hpp"

namespace carom::program {
namespace {

struct BenchOptions {
  bool list = false;
  std::optional<std::string> name;
  SolverKind solver = SolverKind::fast;
  ParallelOptions parallel;
  std::optional<std::uint64_t> disks;
  std::optional<double> packing;
  std::optional<double> collisions_per_disk;
  bool json = false;
};

/// One benchmark with what was measured.
struct Result {
  Benchmark benchmark;
  Measurement measured;

  [[nodiscard]] double collisions_per_second() const {
    return static_cast<double>(measured.collisions) / measured.seconds;
  }
  [[nodiscard]] double ns_per_collision() const { return 1e9 / collisions_per_second(); }
};

void check_options(const BenchOptions& options) {
  const bool runs = options.name || options.disks || options.packing || options.collisions_per_disk;
  if (options.list && (runs || options.json)) throw UsageError("--list goes alone");
  if (options.disks.has_value() != options.packing.has_value())
    throw UsageError("--disks and --packing go together: they make a scene of their own");
  if (options.disks && options.name) {
    throw UsageError(fmt::format("{} has its own disks: --disks and --packing make another scene", *options.name));
  }
  if (options.collisions_per_disk && !(*options.collisions_per_disk > 0)) {
    throw UsageError(fmt::format("--collisions-per-disk {}: it must be greater than 0", *options.collisions_per_disk));
  }
}

std::string list_of_benchmarks() {
  std::string text;
  for (const Benchmark& benchmark : all_benchmarks()) {
    text += fmt::format("{:<20} {}\n", benchmark.name, benchmark.description);
  }
  return text;
}

/// Leaves out, and says so, what this machine has not the memory for.
void drop_too_large(std::vector<Benchmark>& benchmarks) {
  std::string dropped;
  std::erase_if(benchmarks, [&](const Benchmark& benchmark) {
    const bool too_large = static_cast<double>(benchmark.gas.disks) > most_disks();
    if (too_large) dropped += (dropped.empty() ? "" : ", ") + benchmark.name;
    return too_large;
  });
  if (dropped.empty()) return;
  const std::string reason = fmt::format("{}: this machine's memory holds about {:.2g} disks", dropped, most_disks());
  if (benchmarks.empty()) throw Error(reason);
  tell("left out " + reason);
}

std::vector<Benchmark> chosen(const BenchOptions& options) {
  std::vector<Benchmark> benchmarks;
  if (options.disks) {
    benchmarks = {benchmark_of_gas(*options.disks, *options.packing)};
  } else {
    benchmarks = options.name ? benchmarks_named(*options.name) : short_benchmarks();
  }
  for (Benchmark& benchmark : benchmarks) {
    benchmark.collisions_per_disk = options.collisions_per_disk.value_or(benchmark.collisions_per_disk);
  }
  drop_too_large(benchmarks);
  return benchmarks;
}

nlohmann::ordered_json as_json(const Result& result) {
  const Measurement& measured = result.measured;
  const Summary& summary = measured.summary;
  return {{"name", result.benchmark.name},
          {"disks", summary.disks},
          {"packing_fraction", *summary.packing_fraction},
          {"collisions", measured.collisions},
          {"wall_collisions", measured.wall_collisions},
          {"seconds", measured.seconds},
          {"collisions_per_second", result.collisions_per_second()},
          {"ns_per_collision", result.ns_per_collision()},
          {"load_seconds", measured.load_seconds},
          {"first_window_seconds", measured.first_window_seconds},
          {"energy_drift", summary.energy_drift},
          {"bytes_per_disk", std::rint(measured.bytes_per_disk)},
          {"solver", summary.solver},
          {"simd", summary.simd},
          {"threads", summary.threads},
          {"patches", summary.patches},
          {"patches_repaired", summary.patches_repaired},
          {"duplicated_work", summary.duplicated_work},
          {"digest", summary.digest}};
}

std::string as_json(const std::vector<Result>& results) {
  nlohmann::ordered_json json;
  json["version"] = version();
  json["compiler"] = compiler();
  json["command"] = command_line();
  json["benchmarks"] = nlohmann::ordered_json::array();
  for (const Result& result : results) json["benchmarks"].push_back(as_json(result));
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string heading(const Result& first) {
  const Summary& summary = first.measured.summary;
  return fmt::format(
      "carom {}, {}, solver {}, {}, {} thread{}\n\n{:<20} {:>8} {:>7} {:>11} {:>8} {:>11} {:>9} {:>8} {:>8} {:>10} "
      "{:>9}  {}\n",
      version(), compiler(), summary.solver, summary.simd, summary.threads, summary.threads == 1 ? "" : "s",
      "benchmark", "disks", "packing", "collisions", "seconds", "per second", "ns each", "load s", "window s",
      "bytes/disk", "drift", "digest");
}

std::string row_of(const Result& result) {
  const Measurement& measured = result.measured;
  const Summary& summary = measured.summary;
  return fmt::format(
      "{:<20} {:>8} {:>7.4f} {:>11} {:>8.3f} {:>11.0f} {:>9.1f} {:>8.3f} {:>8.3f} {:>10.0f} {:>9.1e}  {}\n",
      result.benchmark.name, summary.disks, *summary.packing_fraction, measured.collisions, measured.seconds,
      result.collisions_per_second(), result.ns_per_collision(), measured.load_seconds, measured.first_window_seconds,
      measured.bytes_per_disk, summary.energy_drift, summary.digest);
}

/// Says what keeps a result from being trusted; true if nothing does.
bool holds(const Result& result) {
  const std::vector<std::string> broken = violations(result.measured.summary);
  for (const std::string& violation : broken) {
    tell(fmt::format("DO NOT TRUST {}: {}", result.benchmark.name, violation));
  }
  return broken.empty();
}

/// Runs one after the other. Rows are printed as they are known, JSON at the end; interrupted, of those finished.
int run_benchmarks(const std::vector<Benchmark>& benchmarks, const BenchOptions& options) {
  SolverOptions solver;
  solver.kind = options.solver;
  solver.simd = simd_from_environment();
  const std::atomic<bool>& interrupt = catch_interrupts();
  std::vector<Result> results;
  int code = kSuccess;
  try {
    for (const Benchmark& benchmark : benchmarks) {
      results.push_back({benchmark, measure(benchmark, solver, options.parallel, interrupt)});
      if (!holds(results.back())) code = kFailure;
      if (options.json) continue;
      if (results.size() == 1) print(heading(results.front()));
      print(row_of(results.back()));
    }
  } catch (const Interrupted&) {
    tell(fmt::format("interrupted; {} of {} benchmarks are done", results.size(), benchmarks.size()));
    code = kInterrupted;
  }
  if (options.json) print(as_json(results));
  return code;
}

int bench_command(const BenchOptions& options) {
  check_options(options);
  if (options.list) {
    print(list_of_benchmarks());
    return kSuccess;
  }
  return run_benchmarks(chosen(options), options);
}

}  // namespace

void add_bench(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "bench", "Time the simulation of standard scenes",
                                  "carom bench --disks 100 --packing 0.5 --collisions-per-disk 20");
  mention_simd_variable(*command);
  const auto options = std::make_shared<BenchOptions>();
  command
      ->add_option("NAME", options->name,
                   "a benchmark, the beginning of some benchmarks' names, or all; without it those of up to 1e5 disks")
      ->type_name("");
  command->add_flag("--list", options->list, "list the benchmarks");
  add_solver(*command, options->solver);
  add_parallel(*command, options->parallel);
  add_count(*command, "--disks", options->disks, "time a gas of so many equal disks instead, at --packing");
  add_number(*command, "--packing", options->packing, "its packing fraction");
  add_number(*command, "--collisions-per-disk", options->collisions_per_disk,
             "how long to measure, each collision counted for both of its disks");
  command->add_flag("--json", options->json, "print the results as one JSON object");
  command->callback([options, &action] { action = [options] { return bench_command(*options); }; });
}

}  // namespace carom::program
