// Properties: a plot is a whole file of its format, the same bytes twice, without numbers that are none, whatever
// stands in its series; marks stand where the numbers are; tables become panels by unit with their errors and theory.
#include "carom/draw/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "carom/base/error.hpp"
#include "picture_bytes.hpp"

namespace carom {
namespace {

using test::filled_paths;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::string kFirstFill = "rgb(0%,44.705882%,69.803922%)";
const std::string kSecondFill = "rgb(83.529412%,36.862745%,0%)";

Plot plot_of(Series series, bool logarithmic = false) {
  Plot plot{"Title", {"x", logarithmic}, {}};
  plot.panels.push_back({{"y", logarithmic}, {std::move(series)}});
  return plot;
}

std::string svg_of(const Plot& plot) { return picture_of_plot(plot, PictureFormat::svg); }

void expect_sound(const Plot& plot) {
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(test::is_well_formed_xml(svg));
  EXPECT_FALSE(test::has_numbers_that_are_none(svg));
}

TEST(Plot, IsAWholeFileOfItsFormatAndTheSameTwice) {
  const Plot plot = plot_of({Series::Style::measured, "a", {1, 2, 3}, {2, 4, 8}, {0.1, 0.2, 0.3}});
  for (const PictureFormat format : {PictureFormat::svg, PictureFormat::png, PictureFormat::pdf}) {
    EXPECT_EQ(picture_of_plot(plot, format), picture_of_plot(plot, format));
  }
  EXPECT_TRUE(test::is_well_formed_xml(svg_of(plot)));
  EXPECT_TRUE(test::is_png(picture_of_plot(plot, PictureFormat::png)));
  EXPECT_TRUE(test::is_pdf(picture_of_plot(plot, PictureFormat::pdf)));
}

TEST(Plot, MarksStandWhereTheNumbersAre) {
  const auto marks = filled_paths(svg_of(plot_of({Series::Style::measured, "a", {0, 1, 3}, {0, 2, 1}})), kFirstFill);
  ASSERT_EQ(marks.size(), 3u);
  EXPECT_NEAR((marks[2].x - marks[0].x) / (marks[1].x - marks[0].x), 3, 0.01);
  EXPECT_NEAR((marks[1].y - marks[0].y) / (marks[2].y - marks[0].y), 2, 0.01);
  EXPECT_LT(marks[1].y, marks[0].y);  // larger numbers stand higher
}

TEST(Plot, LogarithmicAxesSpaceDecadesEvenly) {
  const Plot plot = plot_of({Series::Style::measured, "a", {0.01, 1, 1000}, {1e-5, 1e-3, 1}}, true);
  const auto marks = filled_paths(svg_of(plot), kFirstFill);
  ASSERT_EQ(marks.size(), 3u);
  EXPECT_NEAR((marks[2].x - marks[1].x) / (marks[1].x - marks[0].x), 1.5, 0.01);
  EXPECT_NEAR((marks[2].y - marks[1].y) / (marks[1].y - marks[0].y), 1.5, 0.01);
}

TEST(Plot, NumbersWithoutAPlaceAreGaps) {
  const Series gaps{Series::Style::measured, "a", {1, kNaN, 3, 4, kInfinity, 6}, {1, 2, kNaN, -kInfinity, 5, 6}};
  EXPECT_EQ(filled_paths(svg_of(plot_of(gaps)), kFirstFill).size(), 2u);
  const Series not_positive{Series::Style::measured, "a", {0, -1, 3, 4}, {1, 2, 0, 4}};
  EXPECT_EQ(filled_paths(svg_of(plot_of(not_positive, true)), kFirstFill).size(), 1u);
}

TEST(Plot, CanBeMadeOfAnyNumbers) {
  const std::vector<std::vector<double>> awkward{{},
                                                 {5},
                                                 {0, 0, 0},
                                                 {kNaN, kNaN},
                                                 {-1e308, 1e308},
                                                 {1e-308, 2e-308},
                                                 {1, 1 + 1e-15, 1},
                                                 {-3, kInfinity, 2},
                                                 {1e9, 1e9 + 1}};
  for (const auto& x : awkward) {
    for (const auto& y : awkward) {
      if (x.size() != y.size()) continue;
      for (const auto style : {Series::Style::measured, Series::Style::bars, Series::Style::theory}) {
        for (const bool logarithmic : {false, true}) expect_sound(plot_of({style, "a", x, y, y}, logarithmic));
      }
    }
  }
}

TEST(Plot, ManyPointsAreALineOfModestLength) {
  Series series{Series::Style::measured, "a", {}, {}};
  for (int k = 0; k < 200000; ++k) {
    series.x.push_back(k);
    series.y.push_back(k % 2 == 0 ? 1 : -1);
  }
  const std::string svg = svg_of(plot_of(series));
  EXPECT_TRUE(test::is_well_formed_xml(svg));
  EXPECT_LT(svg.size(), 200000u);
}

TEST(Plot, TextsMayHoldAnything) {
  Plot plot = plot_of({Series::Style::measured, "\xff\xfe</svg>", {1}, {1}});
  plot.title = "a\n\t\x01<script>&\xc3(\xed\xa0\x80 \u03c8\u2086";
  plot.x.label = "$(rm -rf /); `x` 'y' \"z\"";
  plot.panels.front().series.push_back({Series::Style::theory, "", {1, 2}, {1, 2}});
  expect_sound(plot);
}

TEST(Plot, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(svg_of(Plot{}), Error);
  EXPECT_THROW(svg_of(plot_of({Series::Style::measured, "a", {1, 2}, {1}})), Error);
  EXPECT_THROW(svg_of(plot_of({Series::Style::measured, "a", {1, 2}, {1, 2}, {0.1}})), Error);
}

Table table(std::vector<Column> columns) {
  Table made;
  made.name = "rdf";
  made.title = "Pair distribution";
  made.columns = std::move(columns);
  return made;
}

TEST(PlotOfTable, TakesErrorsAndTheoryFromTheirColumns) {
  const Plot plot = plot_of_table(table({{"r", "distance r", "length", {1, 2}},
                                         {"g", "g(r)", "", {3, 4}},
                                         {"g_error", "", "", {0.1, 0.2}},
                                         {"g_theory", "", "", {3.5, 4.5}}}));
  EXPECT_EQ(plot.title, "Pair distribution");
  EXPECT_EQ(plot.x.label, "distance r (length)");
  ASSERT_EQ(plot.panels.size(), 1u);
  EXPECT_EQ(plot.panels[0].y.label, "g(r)");
  ASSERT_EQ(plot.panels[0].series.size(), 2u);
  EXPECT_EQ(plot.panels[0].series[0].error, (std::vector{0.1, 0.2}));
  EXPECT_EQ(plot.panels[0].series[1].style, Series::Style::theory);
  EXPECT_EQ(plot.panels[0].series[1].y, (std::vector{3.5, 4.5}));
  expect_sound(plot);
}

TEST(PlotOfTable, PutsColumnsOfAUnitIntoAPanelUnlessTheirSizesDiffer) {
  const Plot plot = plot_of_table(table({{"t", "", "", {1, 2}},
                                         {"a", "", "energy", {1, 2}},
                                         {"b", "", "length", {1, 2}},
                                         {"c", "", "energy", {3, 4}},
                                         {"d", "", "energy", {3000, 4000}}}));
  ASSERT_EQ(plot.panels.size(), 3u);
  EXPECT_EQ(plot.panels[0].series.size(), 2u);
  EXPECT_EQ(filled_paths(svg_of(plot), kSecondFill).size(), 2u + 1u);  // squares of c, and its sample in the legend
}

TEST(PlotOfTable, OddTablesAreEmptyAxes) {
  expect_sound(plot_of_table(table({})));
  expect_sound(plot_of_table(table({{"t", "", "", {}}})));
  expect_sound(plot_of_table(table({{"t", "", "", {}}, {"a", "", "", {}}})));
  // A column of errors without its column, columns of unequal length, one row, a histogram of one bar.
  expect_sound(plot_of_table(table({{"t", "", "", {1}}, {"a_error", "", "", {1, 2}}})));
  Table short_one = table({{"t", "", "", {1, 2, 3}}, {"a", "", "", {1}}, {"a_error", "", "", {}}});
  short_one.bars = true;
  expect_sound(plot_of_table(short_one));
}

}  // namespace
}  // namespace carom
