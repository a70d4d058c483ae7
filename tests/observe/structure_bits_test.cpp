// Property: structure has the same bits whatever solver, threads and patches; sums that were saved go on as if never.
#include <gtest/gtest.h>

#include <cmath>

#include "frames.hpp"
#include "observed.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

const std::vector<ObserveSpec> kSpecs{{.name = "psi6"}, {.name = "rdf"}, {.name = "structure_factor"}};

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void expect_same(const Measurement& a, const Measurement& b) {
  ASSERT_EQ(a.estimates.size(), b.estimates.size());
  for (std::size_t k = 0; k < a.estimates.size(); ++k) {
    EXPECT_TRUE(same(a.estimates[k].value, b.estimates[k].value)) << a.estimates[k].name;
    EXPECT_EQ(a.estimates[k].error, b.estimates[k].error) << a.estimates[k].name;
  }
  ASSERT_EQ(a.tables.size(), b.tables.size());
  for (std::size_t t = 0; t < a.tables.size(); ++t) {
    ASSERT_EQ(a.tables[t].columns.size(), b.tables[t].columns.size());
    for (std::size_t c = 0; c < a.tables[t].columns.size(); ++c) {
      const Column& one = a.tables[t].columns[c];
      const Column& other = b.tables[t].columns[c];
      ASSERT_EQ(one.values.size(), other.values.size());
      for (std::size_t k = 0; k < one.values.size(); ++k) {
        EXPECT_TRUE(same(one.values[k], other.values[k])) << one.name << ' ' << k;
      }
    }
  }
}

TEST(Structure, HasTheSameBitsForAnySolverAndDivision) {
  const Scene scene = test::gas(150, 0.6);
  const test::Watch watch{.from = 1, .collisions = 20'000};
  const auto fast = test::observe(scene, kSpecs, watch);
  test::Watch other = watch;
  other.solver.kind = SolverKind::reference;
  const auto reference = test::observe(scene, kSpecs, other);
  other = watch;
  other.parallel.threads = 2;
  other.parallel.patches = {2, 2};
  const auto divided = test::observe(scene, kSpecs, other);
  for (const ObserveSpec& spec : kSpecs) {
    SCOPED_TRACE(spec.name);
    expect_same(test::measurement(*fast, spec.name), test::measurement(*reference, spec.name));
    expect_same(test::measurement(*fast, spec.name), test::measurement(*divided, spec.name));
  }
}

TEST(Structure, GoesOnFromSavedSums) {
  for (const ObserveSpec& spec : kSpecs) {
    SCOPED_TRACE(spec.name);
    Arrangement first = random_points(80, {6, 5}, 0);
    first.system.species[0].radius = 0.3;
    const auto whole = test::make(spec.name, first);
    const auto before = test::make(spec.name, first);
    const auto after = test::make(spec.name, first);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Arrangement points = random_points(80, {6, 5}, seed);
      whole->on_frame(points.system, points.frame);
      if (seed == 21) {
        before->on_frame(points.system, points.frame);
        SavedSums sums;
        before->exchange(SumsExchange(sums, SumsExchange::Direction::save));
        after->exchange(SumsExchange(sums, SumsExchange::Direction::load));
      } else {
        (seed < 21 ? before : after)->on_frame(points.system, points.frame);
      }
    }
    expect_same(whole->result(), after->result());
  }
}

}  // namespace
}  // namespace carom
