// The fast solver gives the reference's bits: in every generated scene the same events in the same order, the same
// states at probes and window ends and the same books, however the fast solver goes about it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "generated_scenes.hpp"
#include "recording.hpp"

namespace carom::test {
namespace {

constexpr SolverOptions kReference{.kind = SolverKind::reference};

struct Variant {
  std::string name;
  SolverOptions options;
};

std::string described(const SolverOptions& options) {
  const char* neighbourhood = !options.neighbourhood                           ? "chosen by density"
                              : *options.neighbourhood == Neighbourhood::lists ? "lists"
                                                                               : "cells";
  return fmt::format("{}, shell {}, cell_size {}, bucket_width {}, {}", neighbourhood, options.shell, options.cell_size,
                     options.bucket_width, options.simd ? name_of(*options.simd) : "fastest");
}

/// Lengths and times that options are varied by.
struct Scales {
  double diameter;  // of the largest disk
  double window;    // length of the first window
  double flight;    // of the fastest disk in that window
};

Scales scales_of(const Setup& setup) {
  const double window = Simulation(setup, kReference).window_start().clock.length;
  double fastest = 0;
  for (std::size_t k = 0; k < setup.frame.size(); ++k) fastest = std::max(fastest, length(setup.frame.velocity(k)));
  return {2 * setup.system.largest_radius(), window, fastest * window};
}

/// Options for the k-th scene: the default ones, lists and cells; what else can be chosen cycles with k.
std::vector<Variant> variants(const Setup& setup, std::size_t k) {
  constexpr std::array kShells{0.0, 0.01, 0.37, 3.0};          // in diameters
  constexpr std::array kCellSizes{0.0, 1.37, 2.9, 0.61, 7.3};  // in diameters
  constexpr std::array kBuckets{0.0, 1e-5, 0.0137, 10.0};      // in windows
  static const std::vector<Simd> simd = available_simd();
  const Scales scales = scales_of(setup);
  const auto bucket = [&](std::size_t n) { return kBuckets[n % kBuckets.size()] * scales.window; };

  // A list is renewed every half a shell: a shell far below the free path would only take time.
  const double asked_shell = kShells[k % kShells.size()] * scales.diameter;
  const double shell = asked_shell > 0 ? std::max(asked_shell, 1e-3 * scales.flight) : 0;

  std::vector<SolverOptions> chosen{{}};
  chosen.push_back({.simd = simd[k % simd.size()],
                    .neighbourhood = Neighbourhood::lists,
                    .shell = shell,
                    .bucket_width = bucket(k / 4)});
  chosen.push_back({.simd = simd[(k / 2 + 1) % simd.size()],
                    .neighbourhood = Neighbourhood::cells,
                    .cell_size = kCellSizes[k % kCellSizes.size()] * scales.diameter,
                    .bucket_width = bucket(k / 3 + 1)});
  std::vector<Variant> named;
  for (const SolverOptions& options : chosen) named.push_back({described(options), options});
  return named;
}

/// What goes wrong, if anything does, when the fast solver repeats `expected`.
std::optional<std::string> disagreement(const Setup& setup, const SolverOptions& options, const Recording& expected) {
  try {
    return first_difference(expected, record(setup, options));
  } catch (const std::exception& error) {
    return fmt::format("thrown: {}", error.what());
  }
}

class Agreement : public testing::TestWithParam<SceneGroup> {};

TEST_P(Agreement, FastGivesTheBitsOfTheReference) {
  const GeneratedScenes scenes = GetParam().make();
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const GeneratedScene& scene = scenes[k];
    const Recording expected = record(scene.setup, kReference);
    fmt::print("{}: {} windows, {} events\n", scene.name, expected.windows.size(), expected.books().events());
    std::fflush(stdout);  // so that a crash has a name
    for (const Variant& variant : variants(scene.setup, k)) {
      const auto found = disagreement(scene.setup, variant.options, expected);
      EXPECT_FALSE(found) << "scene: " << scene.name << "\nfast solver: " << variant.name << "\n" << *found;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Agreement, testing::ValuesIn(scene_groups().begin(), scene_groups().end()),
                         [](const auto& group) { return std::string(group.param.name); });

}  // namespace
}  // namespace carom::test
