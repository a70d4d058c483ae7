// The digest does not depend on the vector instructions, nor on how the fast solver finds neighbours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom::test {
namespace {

constexpr std::array kAll{Simd::scalar, Simd::sse4, Simd::avx2, Simd::avx512};

bool is_available(Simd simd) {
  const std::vector<Simd> available = available_simd();
  return std::find(available.begin(), available.end(), simd) != available.end();
}

/// Digest, counts and sums of a thousand disks after 200,000 collisions.
std::string result_of(double packing, const SolverOptions& options) {
  Simulation simulation(realize(gas(1000, packing)), options);
  while (simulation.books().collisions < 200'000) simulation.run_window();
  const Summary summary = summarize(simulation);
  return fmt::format("{} {} {} {:a}", summary.digest, summary.collisions, summary.ties, *summary.pressure);
}

class SimdDigest : public testing::TestWithParam<double> {};

TEST_P(SimdDigest, IsTheSameForEveryInstructionSetAndNeighbourhood) {
  const std::string expected = result_of(GetParam(), {.simd = Simd::scalar, .neighbourhood = Neighbourhood::lists});
  for (const Simd simd : kAll) {
    if (!is_available(simd)) {
      fmt::print("this processor has no {}: left out\n", name_of(simd));
      continue;
    }
    for (const Neighbourhood neighbourhood : {Neighbourhood::lists, Neighbourhood::cells}) {
      EXPECT_EQ(result_of(GetParam(), {.simd = simd, .neighbourhood = neighbourhood}), expected)
          << name_of(simd) << (neighbourhood == Neighbourhood::lists ? ", lists" : ", cells");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AtPacking, SimdDigest, testing::Values(0.2, 0.7),
                         [](const auto& packing) { return packing.param < 0.5 ? "dilute" : "dense"; });

TEST(Simd, TheSolverSaysWhatItUses) {
  const carom::Setup setup = realize(gas(10, 0.2));
  for (const Simd simd : kAll) {
    const SolverOptions options{.simd = simd};
    if (is_available(simd)) {
      EXPECT_EQ(make_fast_solver(setup.system, options)->simd(), name_of(simd));
    } else {
      EXPECT_ANY_THROW(make_fast_solver(setup.system, options));
    }
  }
  EXPECT_EQ(make_fast_solver(setup.system)->simd(), name_of(fastest_simd()));
  EXPECT_EQ(make_fast_solver(setup.system)->name(), "fast");
  EXPECT_EQ(make_solver(setup.system, {.kind = SolverKind::reference})->name(), "reference");
}

}  // namespace
}  // namespace carom::test
