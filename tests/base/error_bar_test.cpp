// A number and its error are printed such that both can be read off again, rounded to the digits that the error leaves.
#include "carom/base/error_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace carom {
namespace {

TEST(ErrorBar, ShowsTwoDigitsOfAnErrorThatBeginsWithOneOrTwoElseOne) {
  EXPECT_EQ(with_error(9.12934, 0.00171), "9.1293(17)");
  EXPECT_EQ(with_error(9.12934, 0.0029), "9.1293(29)");
  EXPECT_EQ(with_error(9.12934, 0.0032), "9.129(3)");
  EXPECT_EQ(with_error(-0.5, 0.01), "-0.500(10)");
  EXPECT_EQ(with_error(12.2, 3), "12(3)");
  EXPECT_EQ(with_error(12.25, 1.2), "12.2(12)");
  EXPECT_EQ(with_error(123456, 15), "123456(15)");
}

TEST(ErrorBar, RoundsTheErrorUpToAnotherDigit) {
  EXPECT_EQ(with_error(0.0095, 0.00099999), "0.0095(10)");
  EXPECT_EQ(with_error(0.0095, 0.00096), "0.0095(10)");
  EXPECT_EQ(with_error(0.0095, 0.00094), "0.0095(9)");
  EXPECT_EQ(with_error(1, 0.0296), "1.00(3)");
  EXPECT_EQ(with_error(1, 0.0294), "1.000(29)");
  EXPECT_EQ(with_error(1, 0.996), "1.0(10)");
}

TEST(ErrorBar, RoundsTheValueUpToAnotherDigit) {
  EXPECT_EQ(with_error(9.99996, 0.0003), "10.0000(3)");
  EXPECT_EQ(with_error(0.99996, 0.0004), "1.0000(4)");
  EXPECT_EQ(with_error(9.99996e9, 3e5), "1.00000(3)e10");
}

TEST(ErrorBar, UsesExponentsWhereZerosWouldFill) {
  EXPECT_EQ(with_error(12345, 300), "1.23(3)e4");
  EXPECT_EQ(with_error(12345, 150), "1.234(15)e4");
  EXPECT_EQ(with_error(1.2345e-12, 3e-14), "1.23(3)e-12");
  EXPECT_EQ(with_error(-6.02214e23, 1.3e19), "-6.02214(13)e23");
  EXPECT_EQ(with_error(0.00012345, 0.000001), "0.0001234(10)");
}

TEST(ErrorBar, ShowsErrorsLargerThanTheValue) {
  EXPECT_EQ(with_error(0.004, 0.17), "0.00(17)");
  EXPECT_EQ(with_error(0, 0.5), "0.0(5)");
  EXPECT_EQ(with_error(12, 5000), "0(5)e3");
  EXPECT_EQ(with_error(12, 1500), "0.0(15)e3");
  EXPECT_EQ(with_error(0, 2e-9), "0.0(20)e-9");
}

TEST(ErrorBar, HasNoBracketsWithoutAnError) {
  EXPECT_EQ(with_error(1.0 / 3, {}), "0.333333");
  EXPECT_EQ(with_error(2, 0.0), "2");
  EXPECT_EQ(with_error(1.00000000000000089, 1.3e-16), "1");
  EXPECT_EQ(with_error(2, std::nan("")), "2");
  EXPECT_EQ(with_error(2, INFINITY), "2");
  EXPECT_EQ(with_error(std::nan(""), 1.0), "nan");
}

TEST(ErrorBar, TakesExtremes) {
  EXPECT_EQ(with_error(std::numeric_limits<double>::max(), 1e300), "1.797693135(10)e308");
  EXPECT_EQ(with_error(5e-324, 5e-324), "5(5)e-324");
}

}  // namespace
}  // namespace carom
