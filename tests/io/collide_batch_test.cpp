// A table of pairs comes back with the velocities after the collision, and every bad row is named.
#include "carom/io/collide_batch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "carom/rule/collision.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

#define HEADER "x1,y1,vx1,vy1,m1,x2,y2,vx2,vy2,m2"
#define AFTER ",vx1_after,vy1_after,vx2_after,vy2_after"

TEST(CollideBatch, EqualMassesExchangeNormalVelocities) {
  EXPECT_EQ(collide_batch(HEADER "\n0,0,1,0,1,1,0,0,0,1\n0,0,1,0.5,1,1,0,-1,0.25,1", "a.csv", 1),
            HEADER AFTER "\n0,0,1,0,1,1,0,0,0,1,0,0,1,0\n0,0,1,0.5,1,1,0,-1,0.25,1,-1,0.5,1,0.25\n");
}

TEST(CollideBatch, RestitutionAndSeparatingPairs) {
  EXPECT_EQ(collide_batch(HEADER "\n0,0,1,0,1,1,0,0,0,1\n0,0,-1,0,1,1,0,0,0,1\n", "a.csv", 0),
            HEADER AFTER "\n0,0,1,0,1,1,0,0,0,1,0.5,0,0.5,0\n0,0,-1,0,1,1,0,0,0,1,-1,0,0,0\n");
}

TEST(CollideBatch, KeepsOtherColumnsQuotesLineEndsAndAnyOrder) {
  EXPECT_EQ(collide_batch("\xEF\xBB\xBFname,m2,vy2,vx2,y2,x2,m1,vy1,vx1,\"y1\", x1\r\n"
                          "\"a, \"\"b\"\"\r\nc\",1,0,0,0,1,1,0,\"1\",0, 0\r\n\r\n",
                          "a.csv", 1),
            "name,m2,vy2,vx2,y2,x2,m1,vy1,vx1,\"y1\", x1" AFTER
            "\r\n\"a, \"\"b\"\"\r\nc\",1,0,0,0,1,1,0,\"1\",0, 0,0,0,1,0\r\n");
}

TEST(CollideBatch, AHeaderAloneGivesAHeader) { EXPECT_EQ(collide_batch(HEADER, "a.csv", 1), HEADER AFTER "\n"); }

RC_GTEST_PROP(CollideBatch, GivesTheBitsOfTheRule, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000000, 1000000) / 12345.0; };
  const double x2 = 1 + std::abs(number());
  const rule::Velocities before{{number(), number()}, {number(), number()}};
  const double m2 = 0.1 + std::abs(number());
  const double e = *rc::gen::inRange(0, 11) / 10.0;
  const std::string row = fmt::format("0,0,{},{},1,{},0.5,{},{},{}", before.first.x, before.first.y, x2,
                                      before.second.x, before.second.y, m2);
  const rule::Velocities after = rule::collide({{x2, 0.5}, before, 1, m2, e});
  RC_ASSERT(collide_batch(HEADER "\n" + row, "a.csv", e) == fmt::format(HEADER AFTER "\n{},{},{},{},{}\n", row,
                                                                        after.first.x, after.first.y, after.second.x,
                                                                        after.second.y));
}

struct BadTable {
  const char* name;
  const char* text;
  const char* message;
};

void PrintTo(const BadTable& table, std::ostream* out) { *out << table.name; }

class BadCsv : public testing::TestWithParam<BadTable> {};

TEST_P(BadCsv, IsRefusedWithPlaceThingAndReason) {
  EXPECT_EQ(message_of([] { collide_batch(GetParam().text, "a.csv", 1); }), GetParam().message);
}

#define GOOD "0,0,1,0,1,1,0,0,0,1\n"

INSTANTIATE_TEST_SUITE_P(
    Tables, BadCsv,
    testing::Values(
        BadTable{"Empty", "", "a.csv: there is no header: it must name x1,y1,vx1,vy1,m1,x2,y2,vx2,vy2,m2"},
        BadTable{"MissingColumns", "\nx1,y1,vx1,vy1,m1,x2,y2,vx2\n",
                 "a.csv:2: the header has no column 'vy2'\na.csv:2: the header has no column 'm2'"},
        BadTable{"ColumnTwice", HEADER ",x1\n" GOOD, "a.csv:1:35: column 'x1' is there twice"},
        BadTable{"ResultColumn", HEADER ",vx1_after\n" GOOD,
                 "a.csv:1:35: column 'vx1_after' is there already: it is one of the results"},
        BadTable{"TooFewFields", HEADER "\n" GOOD "0,0,1\n", "a.csv:3:1: 3 fields: the header has 10"},
        BadTable{"NotANumber", HEADER "\n" GOOD "0,0,1, \"a\" ,1,1,0,0,0,1\n", "a.csv:3:8: vy1 'a' is not a number"},
        BadTable{"Nothing", HEADER "\n0,0,,0,1,1,0,0,0,1\n", "a.csv:2:5: vx1 is missing"},
        BadTable{"Nan", HEADER "\n0,0,1,0,1,1,0,0,NaN,1\n", "a.csv:2:17: vy2 'NaN' is not a finite number"},
        BadTable{"Overflow", HEADER "\n0,0,1e999,0,1,1,0,0,0,1\n",
                 "a.csv:2:5: vx1 '1e999' is too large for a number (over 1.8e308)"},
        BadTable{"ZeroMass", HEADER "\n0,0,1,0,0,1,0,0,0,-1\n",
                 "a.csv:2:9: m1 is 0: it must be greater than 0\na.csv:2:19: m2 is -1: it must be greater than 0"},
        BadTable{"SameCentre", HEADER "\n1,2,1,0,1,1,2,0,0,1\n",
                 "a.csv:2:1: both disks have the same centre: there is no normal to collide along"},
        BadTable{"CentresTooClose", HEADER "\n0,0,1,0,1,1e-200,0,0,0,1\n",
                 "a.csv:2:1: the centres are 1e-200 apart: too close to compute with"},
        BadTable{"ResultOverflows", HEADER "\n0,0,1e308,0,1,1e100,0,-1e308,0,1\n",
                 "a.csv:2:1: the numbers are too large to compute with"},
        BadTable{"StrayQuote", HEADER "\n" GOOD "0,0,1\"2,0,1,1,0,0,0,1\n",
                 "a.csv:3:6: a quotation mark stands where CSV allows none"},
        BadTable{"OpenQuote", HEADER "\n" GOOD "0,0,\"1,0,1,1,0,0,0,1\n",
                 "a.csv:3: a quotation mark is not closed before the file's end"},
        BadTable{"LineAfterQuotedLineEnd", HEADER ",note\n0,0,1,0,1,1,0,0,0,1,\"a\nb\"\n0,0,x,0,1,1,0,0,0,1,c\n",
                 "a.csv:4:5: vx1 'x' is not a number"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(BadCsv, TwentyProblemsAreToldAndTheRestCounted) {
  std::string text = HEADER "\n";
  for (int k = 0; k < 50; ++k) text += "0,0,x,0,1,1,0,0,0,1\n";
  const std::string message = message_of([&] { collide_batch(text, "a.csv", 1); });
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 20);
  EXPECT_TRUE(message.ends_with("a.csv: … and 30 more problems")) << message;
}

TEST(BadCsv, AHeaderOfVeryManyColumnsIsReadInOneGo) {
  constexpr int kColumns = 300'000;  // each compared with all others would take minutes
  std::string text = HEADER;
  for (int k = 0; k < kColumns; ++k) text += ",x1";
  const std::string message = message_of([&] { collide_batch(text, "a.csv", 1); });
  EXPECT_TRUE(message.ends_with("a.csv: … and 299980 more problems")) << message.substr(message.size() - 100);
}

TEST(BadCsv, RestitutionOutsideItsRangeIsRefused) {
  EXPECT_EQ(message_of([] { collide_batch(HEADER "\n", "a.csv", 1.5); }), "restitution is 1.5: it must lie in [0, 1]");
}

}  // namespace
}  // namespace carom
