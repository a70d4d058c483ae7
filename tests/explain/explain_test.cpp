// Every line of a derivation can be redone from the numbers printed above it, in all three formats.
#include "carom/explain/explain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/rule/collision.hpp"
#include "redo.hpp"

namespace {

using carom::ExplainedCollision;
using carom::ExplainedDisk;
using carom::ExplainFormat;

ExplainedDisk disk(double x, double y, double vx, double vy, double mass = 1) {
  return {{x, y}, {vx, vy}, mass, std::nullopt};
}

ExplainedCollision source_example() { return {disk(0, 0, 1, 0), disk(0.6, 0.8, 0, 0)}; }
ExplainedCollision unequal_example() { return {disk(0, 0, 2, 1, 3), disk(1, 1, -1, 0.5, 1.5)}; }

std::string text_of(const ExplainedCollision& collision) { return carom::explain(collision, ExplainFormat::text); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

carom::rule::Velocities in_doubles(const ExplainedCollision& c) {
  return carom::rule::collide({c.second.position - c.first.position,
                               {c.first.velocity, c.second.velocity},
                               c.first.mass,
                               c.second.mass,
                               c.restitution});
}

// Kinds of numbers that people and programs put in.
enum class Flavour { nice, equal_masses, inelastic, tiny, huge, uneven_masses, full_doubles, at_contact, count };

class Scenarios {
 public:
  ExplainedCollision next(Flavour flavour) {
    flavour_ = flavour;
    ExplainedCollision c{any_disk(), any_disk()};
    if (flavour == Flavour::equal_masses || whole(3) == 0) c.second.mass = c.first.mass;
    if (flavour == Flavour::inelastic || whole(4) == 0) c.restitution = static_cast<double>(whole(21)) / 20;
    if (flavour == Flavour::at_contact) c.time_of_contact = std::abs(coordinate()) + 0.001;
    if (c.first.position == c.second.position) c.second.position.x += 1;
    if (carom::dot(c.second.position - c.first.position, c.second.velocity - c.first.velocity) > 0 && whole(8) != 0)
      std::swap(c.first.velocity, c.second.velocity);
    return c;
  }

 private:
  std::uint64_t whole(std::uint64_t bound) { return bits_() % bound; }
  double fraction() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

  double coordinate() {
    const double decimals[] = {1, 10, 100, 1000};
    const double nice = (static_cast<double>(whole(2001)) - 1000) / decimals[whole(4)] / 10;
    switch (flavour_) {
      case Flavour::tiny: return nice * 1e-9;
      case Flavour::huge: return nice * 1e9;
      case Flavour::at_contact:
      case Flavour::full_doubles: return 20 * fraction() - 10;
      default: return nice;
    }
  }
  double mass() {
    const double nice = static_cast<double>(1 + whole(100)) / (whole(2) == 0 ? 1 : 20);
    if (flavour_ == Flavour::uneven_masses) return whole(2) == 0 ? nice * 1e-6 : nice * 1e4;
    return flavour_ == Flavour::full_doubles ? 0.1 + fraction() : nice;
  }
  ExplainedDisk any_disk() {
    const double x = coordinate();
    const double y = coordinate();
    const double vx = coordinate();
    const double vy = coordinate();
    return disk(x, y, vx, vy, mass());
  }

  std::mt19937_64 bits_{20240229};
  Flavour flavour_ = Flavour::nice;
};

std::vector<ExplainedCollision> scenarios() {
  std::vector<ExplainedCollision> all{source_example(), unequal_example()};
  Scenarios scenarios;
  for (int k = 0; k < 30 * static_cast<int>(Flavour::count); ++k)
    all.push_back(scenarios.next(static_cast<Flavour>(k % static_cast<int>(Flavour::count))));
  return all;
}

void expect_velocities(const redo::Report& report, const carom::rule::Velocities& expected, const std::string& text) {
  const double doubles[] = {expected.first.x, expected.first.y, expected.second.x, expected.second.y};
  const std::string names[] = {"v1f", "v2f"};
  double largest = 0;
  for (const double v : doubles) largest = std::max(largest, std::abs(v));
  for (std::size_t k = 0; k < 4; ++k) {
    const double shown = report.values.at(names[k / 2]).at(k % 2).convert_to<double>();
    EXPECT_NEAR(shown, doubles[k], 6e-7 * largest) << text;
  }
}

TEST(Explain, EveryLineAddsUpAsPrinted) {
  int checked = 0;
  for (const ExplainedCollision& collision : scenarios()) {
    const std::string text = text_of(collision);
    const redo::Report report = redo::redo(text);
    for (const std::string& mistake : report.mistakes) ADD_FAILURE() << mistake << "\nin\n" << text;
    expect_velocities(report, in_doubles(collision), text);
    checked += report.relations;
    if (HasFailure()) return;
  }
  EXPECT_GT(checked, 10000);
}

TEST(Explain, TheStudentOfThisTestNoticesAWrongDigit) {
  const std::string text = text_of(unequal_example());
  ASSERT_TRUE(redo::redo(text).mistakes.empty());
  int noticed = 0;
  int changed = 0;
  // From the first result on: what is given cannot be checked. To the end of step 8: the rest is not mathematics.
  for (std::size_t k = text.find("Δx"); k < text.find("\n9."); ++k) {
    const bool digit_of_number = std::isdigit(text[k]) && k > 1 && text[k - 1] == '.';
    if (!digit_of_number) continue;
    std::string wrong = text;
    wrong[k] = text[k] == '9' ? '1' : static_cast<char>(text[k] + 1);
    ++changed;
    noticed += !redo::redo(wrong).mistakes.empty();
  }
  EXPECT_GT(changed, 60);
  EXPECT_EQ(noticed, changed);
}

TEST(Explain, TheSourceTextsExampleGivesItsVelocities) {
  const std::string text = text_of(source_example());
  const redo::Report report = redo::redo(text);
  EXPECT_EQ(report.values.at("v1f"), (redo::Value{redo::Number("0.64"), redo::Number("-0.48")}));
  EXPECT_EQ(report.values.at("v2f"), (redo::Value{redo::Number("0.36"), redo::Number("0.48")}));
  EXPECT_EQ(report.tags, (std::vector<std::string>{"1", "2", "3", "4", "5", "6", "A", "B", "C", "D"}));
  EXPECT_FALSE(contains(text.substr(text.find("2. The")), "≈"));
}

TEST(Explain, TheSourceTextsExampleReadsAsItShould) {
  std::ifstream file(CAROM_EXPLAIN_GOLDEN);
  std::stringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(text_of(source_example()), golden.str());
}

TEST(Explain, EquationsAToDStandThereExactlyForEqualMassesAndElasticCollisions) {
  for (const ExplainedCollision& collision : scenarios()) {
    const std::string text = text_of(collision);
    const redo::Report report = redo::redo(text);
    const bool collides = contains(text, "so they collide");
    const bool a_to_d = collides && collision.first.mass == collision.second.mass && collision.restitution == 1;
    EXPECT_EQ(std::count(report.tags.begin(), report.tags.end(), "A") == 1, a_to_d);
    EXPECT_EQ(std::count(report.tags.begin(), report.tags.end(), "D") == 1, a_to_d);
    EXPECT_EQ(std::count(report.tags.begin(), report.tags.end(), "5") == 1, collides && collision.restitution == 1);
  }
}

TEST(Explain, EqualMassesExchangeTheirNormalVelocitiesToTheLastDigit) {
  Scenarios scenarios;
  for (int k = 0; k < 100; ++k) {
    ExplainedCollision collision = scenarios.next(Flavour::full_doubles);
    collision.second.mass = collision.first.mass;
    collision.restitution = 1;
    const redo::Report report = redo::redo(text_of(collision));
    if (report.tags.empty()) continue;
    EXPECT_EQ(report.values.at("v1nf"), report.values.at("v2n"));
    EXPECT_EQ(report.values.at("v2nf"), report.values.at("v1n"));
  }
}

TEST(Explain, DisksThatDoNotApproachKeepTheirVelocities) {
  const ExplainedCollision parting{disk(0, 0, -1, 0.5), disk(0.6, 0.8, 2, 1)};
  const std::string text = text_of(parting);
  EXPECT_TRUE(contains(text, "< 0"));
  EXPECT_TRUE(contains(text, "v1f = v1 = ⟨v1x, v1y⟩ = ⟨-1, 0.5⟩"));
  EXPECT_TRUE(contains(text, "v2f = v2 = ⟨v2x, v2y⟩ = ⟨2, 1⟩"));
  EXPECT_FALSE(contains(text, "(1)"));

  const ExplainedCollision sliding{disk(0, 0, 0.8, -0.6), disk(0.6, 0.8, 0, 0)};
  EXPECT_TRUE(contains(text_of(sliding), "slide along each other"));
}

TEST(Explain, ASlowApproachAmongLargeSpeedsIsSeen) {
  const ExplainedCollision slow{disk(0, 0, 1000.000000001, 3), disk(1, 0, 1000, -2)};
  EXPECT_TRUE(contains(text_of(slow), "v1n - v2n = 1000.000000001 - 1000 = 1e-9 > 0"));
}

TEST(Explain, LostEnergyIsAccountedFor) {
  ExplainedCollision collision = source_example();
  collision.restitution = 0.5;
  const redo::Report report = redo::redo(text_of(collision));
  EXPECT_TRUE(report.mistakes.empty());
  EXPECT_EQ(report.values.at("Q"), redo::Value{redo::Number("0.0675")});
  EXPECT_EQ(report.values.at("K_f"), redo::Value{redo::Number("0.4325")});
  EXPECT_EQ(report.values.at("v1f"), (redo::Value{redo::Number("0.73"), redo::Number("-0.36")}));
  EXPECT_EQ(report.tags, (std::vector<std::string>{"1", "3"}));
}

TEST(Explain, TimeAndRadiiAreTold) {
  ExplainedCollision collision{disk(2.4000000000000004, 0, 1, 0), disk(3, 0.8, 0, 0)};
  collision.time_of_contact = 2.4000000000000004;
  collision.first.radius = collision.second.radius = 0.5;
  const std::string text = text_of(collision);
  EXPECT_TRUE(contains(text, "t_c ≈ 2.4;"));
  EXPECT_TRUE(contains(text, "(x1, y1) ≈ (2.4, 0)"));
  EXPECT_TRUE(contains(text, "R1 + R2 = 0.5 + 0.5 = 1"));
  EXPECT_TRUE(contains(text, "the disks touch."));
}

// All numbers in the order of reading; indices, exponents of squares and equation numbers left out.
std::vector<std::string> numbers_in(std::string text) {
  static const std::vector<std::pair<std::regex, std::string>> kLeftOut = {
      {std::regex("\\\\(begin|end)\\{[a-z*]*\\}|\\\\tag\\{[0-9A-D]\\}"), " "},
      {std::regex(" \\\\times 10\\^\\{(-?[0-9]+)\\}"), "e$1"},
      {std::regex("\\n\\([1-6A-D]\\) "), "\n"},
      {std::regex("_\\{[0-9a-z]*\\}|_[0-9a-z]|\\^2|²|velocity[12]"), " "},
      {std::regex("[A-Za-z|]+[0-9][a-z]*"), " "}};
  const std::size_t body = text.find("\\section");
  if (body != std::string::npos) text = text.substr(body);
  for (const auto& [pattern, replacement] : kLeftOut) text = std::regex_replace(text, pattern, replacement);
  static const std::regex kNumber("[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?");
  std::vector<std::string> numbers;
  for (std::sregex_iterator match(text.begin(), text.end(), kNumber), end; match != end; ++match)
    numbers.push_back(match->str());
  return numbers;
}

TEST(Explain, AllFormatsHoldTheSameNumbers) {
  for (const ExplainedCollision& collision : scenarios()) {
    const std::vector<std::string> text = numbers_in(text_of(collision));
    ASSERT_EQ(numbers_in(carom::explain(collision, ExplainFormat::markdown)), text) << text_of(collision);
    ASSERT_EQ(numbers_in(carom::explain(collision, ExplainFormat::latex)), text) << text_of(collision);
  }
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t k = text.find(part); k != std::string::npos; k = text.find(part, k + part.size())) ++count;
  return count;
}

TEST(Explain, LatexIsADocumentWithBalancedBracesAndEnvironments) {
  for (const ExplainedCollision& collision : scenarios()) {
    const std::string latex = carom::explain(collision, ExplainFormat::latex);
    EXPECT_EQ(latex.rfind("\\documentclass{article}", 0), 0u);
    EXPECT_EQ(latex.substr(latex.size() - 15), "\\end{document}\n");
    EXPECT_EQ(occurrences(latex, "{"), occurrences(latex, "}"));
    EXPECT_EQ(occurrences(latex, "$") % 2, 0u);
    EXPECT_TRUE(std::all_of(latex.begin(), latex.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    for (const char* environment : {"document", "equation*", "aligned", "verbatim"})
      EXPECT_EQ(occurrences(latex, std::string("\\begin{") + environment + "}"),
                occurrences(latex, std::string("\\end{") + environment + "}"));
    if (HasFailure()) return;
  }
}

TEST(Explain, MarkdownFencesAreBalanced) {
  for (const ExplainedCollision& collision : {source_example(), unequal_example()}) {
    const std::string markdown = carom::explain(collision, ExplainFormat::markdown);
    EXPECT_EQ(markdown.rfind("# ", 0), 0u);
    EXPECT_EQ(occurrences(markdown, "$$") % 2, 0u);
    EXPECT_EQ(occurrences(markdown, "```"), 2u);
    EXPECT_EQ(occurrences(markdown, "\\begin{aligned}"), occurrences(markdown, "\\end{aligned}"));
  }
}

TEST(Explain, TextFitsEightyColumns) {
  for (const ExplainedCollision& collision : scenarios()) {
    std::istringstream lines(text_of(collision));
    for (std::string line; std::getline(lines, line);) {
      const auto columns = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
      EXPECT_LE(columns, 80) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
  }
}

TEST(Explain, NumbersThatCannotBeAreRefused) {
  const auto message_of = [](const ExplainedCollision& collision) -> std::string {
    try {
      (void)text_of(collision);
    } catch (const carom::Error& error) {
      return error.what();
    }
    return "";
  };
  ExplainedCollision collision = source_example();
  collision.second.position = {0, 0};
  EXPECT_EQ(message_of(collision), "disk 1 and disk 2 both have their centre at (0, 0): there is no normal");
  collision = source_example();
  collision.second.mass = -2;
  EXPECT_EQ(message_of(collision), "disk 2: mass -2 is not positive");
  collision = source_example();
  collision.restitution = 1.5;
  EXPECT_EQ(message_of(collision), "restitution 1.5 is not between 0 and 1");
  collision = source_example();
  collision.first.velocity.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of(collision), "disk 1: velocity along y nan is not a finite number");
}

}  // namespace
