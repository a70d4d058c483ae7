// Property: the fluid has no bond-orientational order and the crystal has it; contact value and compressibility of the
// fluid are those of its equation of state.
#include <gtest/gtest.h>

#include "carom/observe/observable_set.hpp"
#include "observed.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::estimate;
using test::observe;

/// Within four standard errors of what theory says.
void expect_theory(const Estimate& found, double largest_error) {
  ASSERT_TRUE(found.error && found.theory) << found.name;
  EXPECT_NEAR(found.value, *found.theory, 4 * *found.error) << found.name;
  EXPECT_LT(*found.error, largest_error * *found.theory) << found.name;
}

// The transition lies between packing fractions 0.70 and 0.72 (Bernard and Krauth, Phys. Rev. Lett. 107, 155704
// (2011)).
TEST(StructurePhysics, TheFluidHasNoOrder) {
  const auto set = observe(test::gas(4096, 0.60), {{.name = "psi6"}}, {.from = 25, .collisions = 1'000'000});
  EXPECT_LT(estimate(*set, "psi6", "psi6_global").value, 0.1);
  EXPECT_NEAR(estimate(*set, "psi6", "psi6_local").value, 0.49, 0.02);
  const Table g6 = test::table(*set, "psi6", "g6");
  EXPECT_LT(test::column(g6, "g6").back(), 0.05);
}

TEST(StructurePhysics, TheCrystalHasOrder) {
  const auto set = observe(test::gas(4096, 0.78), {{.name = "psi6"}}, {.from = 4, .collisions = 500'000});
  EXPECT_GT(estimate(*set, "psi6", "psi6_global").value, 0.8);
  EXPECT_GT(estimate(*set, "psi6", "sixfold").value, 0.95);
  const Table g6 = test::table(*set, "psi6", "g6");
  EXPECT_GT(test::column(g6, "g6").back(), 0.6);
}

TEST(StructurePhysics, ContactValueAndCompressibilityOfTheFluid) {
  for (const double eta : {0.3, 0.5}) {
    SCOPED_TRACE(eta);
    const auto set = observe(test::gas(1024, eta),
                             {{.name = "rdf", .options = {{"r_max", 1.6}, {"interval", 0.5}}},
                              {.name = "structure_factor", .options = {{"k_max", 2.2}, {"interval", 1}}}},
                             {.from = 50, .collisions = 1'200'000});
    expect_theory(estimate(*set, "rdf", "contact_value"), 0.02);
    expect_theory(estimate(*set, "rdf", "Z"), 0.02);
    expect_theory(estimate(*set, "structure_factor", "S_0"), 0.05);
  }
}

}  // namespace
}  // namespace carom
