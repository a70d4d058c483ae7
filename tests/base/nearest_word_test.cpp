// The nearest word is the one with fewest letters changed, and none if all are far.
#include "carom/base/nearest_word.hpp"

#include <gtest/gtest.h>

#include <string>

namespace carom {
namespace {

TEST(NearestWord, IsWhatWasMeant) {
  const std::vector<std::string_view> words{"pressure", "rate", "speeds", "msd"};
  EXPECT_EQ(nearest_word("presure", words), "pressure");
  EXPECT_EQ(nearest_word("mds", words), "msd");
  EXPECT_EQ(nearest_word("speed", words), "speeds");
  EXPECT_EQ(nearest_word("rate", words), "rate");
}

TEST(NearestWord, IsNoneWhereNothingResembles) {
  EXPECT_EQ(nearest_word("xyz", {"pressure", "rate"}), "");
  EXPECT_EQ(nearest_word("anything", {}), "");
  EXPECT_EQ(nearest_word(std::string(1000, 'a'), {"aaa"}), "");
}

}  // namespace
}  // namespace carom
