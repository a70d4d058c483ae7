// Property: an error's text names place, thing and reason, one line per problem, as far as the place is known.
#include "carom/base/error.hpp"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(Place, IsWrittenAsFarAsItIsKnown) {
  EXPECT_EQ(to_string(Place{}), "");
  EXPECT_EQ(to_string(Place{"gas.toml"}), "gas.toml");
  EXPECT_EQ(to_string(Place{"gas.toml", 3}), "gas.toml:3");
  EXPECT_EQ(to_string(Place{"gas.toml", 3, 14}), "gas.toml:3:14");
}

TEST(Place, WithoutLineHasNoColumn) { EXPECT_EQ(to_string(Place{"gas.toml", 0, 14}), "gas.toml"); }

TEST(Place, WithoutFileIsNoPlace) { EXPECT_EQ(to_string(Place{"", 3, 14}), ""); }

TEST(Problem, StandsBehindItsPlace) {
  EXPECT_EQ(to_string(Problem{"radius must be greater than 0", {"gas.toml", 3, 14}}),
            "gas.toml:3:14: radius must be greater than 0");
  EXPECT_EQ(to_string(Problem{"no such file", {"gas.toml"}}), "gas.toml: no such file");
  EXPECT_EQ(to_string(Problem{"there are no disks", {}}), "there are no disks");
}

TEST(Error, OfOneProblem) {
  const Error error("radius must be greater than 0", {"gas.toml", 3, 14});
  EXPECT_STREQ(error.what(), "gas.toml:3:14: radius must be greater than 0");
  ASSERT_EQ(error.problems().size(), 1u);
  EXPECT_EQ(error.problems()[0].message, "radius must be greater than 0");
  EXPECT_EQ(error.problems()[0].place.line, 3);
}

TEST(Error, OfSeveralProblemsHasALineEach) {
  const Error error({{"first", {"a", 1, 2}}, {"second", {}}, {"third", {"b"}}});
  EXPECT_STREQ(error.what(), "a:1:2: first\nsecond\nb: third");
  EXPECT_EQ(error.problems().size(), 3u);
}

TEST(Error, IsCaughtAsAStandardException) { EXPECT_THROW(throw Error("no"), std::runtime_error); }

}  // namespace
}  // namespace carom
