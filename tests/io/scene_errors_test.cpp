// Everything wrong with a scene file is told at once: where, what and why.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "carom/io/checkpoint.hpp"
#include "carom/io/file.hpp"
#include "carom/io/scene_file.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

std::string refusal(const std::string& text, const std::string& name) {
  return message_of([&] { parse_scene(text, name); });
}

struct BadInput {
  const char* name;  // of the test
  const char* text;
  const char* message;
};

void PrintTo(const BadInput& input, std::ostream* out) { *out << input.name; }

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

TEST(TomlKeys, OfVeryManyPartsAreRefusedBeforeTheyFillTheStack) {
  const std::string reason = "a key of more than 64 parts";
  for (const std::string& text : {
           "a" + repeated(".b", 300000) + " = 1",
           "[a" + repeated(" . b", 300000) + "]",
           "a = { x = 1, b" + repeated(".b", 300000) + " = 1 }",
           "'a=,'" + repeated(".\"b#\\\"=,\"", 300000) + " = 1",
           "a = { x = \"\"\"\n\"\"\", b" + repeated(".b", 300000) + " = 1 }",
       }) {
    EXPECT_NE(refusal(text, "s.toml").find(reason), std::string::npos) << text.substr(0, 40);
  }
  EXPECT_EQ(refusal("\n  a" + repeated(".b", 64) + " = 1", "s.toml"), "s.toml:2:130: not valid TOML: " + reason);
}

TEST(TomlKeys, ManyDotsElsewhereAreNoKeys) {
  const std::string numbers = "[" + repeated("1.0, ", 300) + "1.0]";
  EXPECT_EQ(
      refusal("title = \"" + repeated("Once. ", 300) + "\"\n[box]\nsize = " + numbers + "\n", "s.toml").find("parts"),
      std::string::npos);
}

class BadToml : public testing::TestWithParam<BadInput> {};

TEST_P(BadToml, IsRefusedWithPlaceThingAndReason) { EXPECT_EQ(refusal(GetParam().text, "s.toml"), GetParam().message); }

#define SIZED "[box]\nsize = [9.0, 9.0]\n"
#define DISK "[[disk]]\nposition = [1.0, 1.0]\n"

INSTANTIATE_TEST_SUITE_P(
    Values, BadToml,
    testing::Values(
        BadInput{"UnknownKey", SIZED DISK "radus = 0.5",
                 "s.toml:5:1: unknown key 'radus' in [[disk]]: did you mean 'radius'?"},
        BadInput{"SwappedLetters", SIZED DISK "[run]\nuntli = 1",
                 "s.toml:6:1: unknown key 'untli' in [run]: did you mean 'until'?"},
        BadInput{
            "UnlikeAnyKey", SIZED DISK "[physics]\ncolour = 1",
            "s.toml:6:1: unknown key 'colour' in [physics]: the known ones are restitution, wall_restitution, t_c"},
        BadInput{"UnknownTable", "[boks]\nsize = [1, 1]", "s.toml:1:2: unknown table 'boks': did you mean 'box'?"},
        BadInput{"UnknownTables", "[[disks]]\nposition = [1, 1]",
                 "s.toml:1:3: unknown table 'disks': did you mean 'disk'?"},
        BadInput{"DiskAsTable", "[disk]\nposition = [1, 1]",
                 "s.toml:1:1: disk must be written [[disk]]: there can be several"},
        BadInput{"BoxAsNumber", "box = 2", "s.toml:1:7: box must be a table: write [box]"},
        BadInput{"NumberAsString", SIZED DISK "mass = \"1\"",
                 "s.toml:5:8: mass must be a number, e.g. 1.0, not a string"},
        BadInput{"OneNumberForTwo", SIZED "[[disk]]\nposition = 1.0",
                 "s.toml:4:12: position must be two numbers, e.g. [1.0, 2.0], not a decimal number"},
        BadInput{"ThreeNumbersForTwo", SIZED "[[disk]]\nposition = [1, 2, 3]",
                 "s.toml:4:12: position must be two numbers, e.g. [1.0, 2.0], not 3"},
        BadInput{"StringInPosition", SIZED "[[disk]]\nposition = [1, \"2\"]",
                 "s.toml:4:16: position must be two numbers, e.g. [1.0, 2.0], not a string"},
        BadInput{"NoPosition", SIZED "[[disk]]\nvelocity = [1, 2]",
                 "s.toml:3:1: this [[disk]] needs a position, e.g. position = [1.0, 2.0]"},
        BadInput{"NanPosition", SIZED "[[disk]]\nposition = [nan, 2]",
                 "s.toml:4:13: position is nan: it must be a finite number"},
        BadInput{"InfiniteVelocity", SIZED DISK "velocity = [0, -inf]",
                 "s.toml:5:16: velocity is -inf: it must be a finite number"},
        BadInput{"ZeroRadius", SIZED DISK "radius = 0", "s.toml:5:10: radius is 0: it must be greater than 0"},
        BadInput{"NegativeMass", SIZED DISK "mass = -2.5", "s.toml:5:8: mass is -2.5: it must be greater than 0"},
        BadInput{"NegativeSize", "[box]\nsize = [9, -1]\n" DISK, "s.toml:2:12: size is -1: it must be greater than 0"},
        BadInput{"SizeAndAspect", "[box]\nsize = [9, 9]\naspect = 1.0\n" DISK,
                 "s.toml:3:10: aspect is for a box without a size: leave one out"},
        BadInput{"UnknownBoundary", SIZED "boundary = \"peridic\"\n" DISK,
                 "s.toml:3:12: boundary is \"peridic\": it must be one of \"periodic\", \"reflecting\", \"open\""},
        BadInput{"ThreeBoundaries", SIZED "boundary = [\"open\", \"open\", \"open\"]\n" DISK,
                 "s.toml:3:12: boundary must be one name, or two: for x and for y"},
        BadInput{"RestitutionAboveOne", SIZED DISK "[physics]\nrestitution = 1.5",
                 "s.toml:6:15: restitution is 1.5: it must lie in [0, 1]"},
        BadInput{"NegativeWallRestitution", SIZED DISK "[physics]\nwall_restitution = -0.1",
                 "s.toml:6:20: wall_restitution is -0.1: it must lie in [0, 1]"},
        BadInput{"ZeroUntil", SIZED DISK "[run]\nuntil = 0", "s.toml:6:9: until is 0: it must be greater than 0"},
        BadInput{"NegativeEvery", SIZED DISK "[run]\nevery = -1.0",
                 "s.toml:6:9: every is -1: it must be greater than 0"},
        BadInput{"FractionalCollisions", SIZED DISK "[run]\ncollisions = 1.5",
                 "s.toml:6:14: collisions must be a whole number, e.g. 1000, not a decimal number"},
        BadInput{"ZeroCollisions", SIZED DISK "[run]\ncollisions = 0",
                 "s.toml:6:14: collisions is 0: it must be 1 or more"},
        BadInput{"OtherTrajectory", SIZED DISK "[run]\ntrajectory = \"mp4\"",
                 "s.toml:6:14: trajectory is \"mp4\": it must be one of \"xyz\", \"h5md\", \"none\""},
        BadInput{"ZeroCount", SIZED "[[gas]]\ncount = 0", "s.toml:4:9: count is 0: it must be 1 or more"},
        BadInput{"NegativePackingFraction", SIZED "[[gas]]\npacking_fraction = -0.5",
                 "s.toml:4:20: packing_fraction is -0.5: it must be greater than 0"},
        BadInput{"NegativeTemperature", SIZED "[[gas]]\ncount = 4\ntemperature = -1",
                 "s.toml:5:15: temperature is -1: it must be 0 or more"},
        BadInput{"NegativeSeed", SIZED "[[gas]]\ncount = 4\nseed = -1", "s.toml:5:8: seed is -1: it must be 0 or more"},
        BadInput{"OtherStart", SIZED "[[gas]]\ncount = 4\nstart = \"square\"",
                 "s.toml:5:9: start is \"square\": it must be one of \"lattice\", \"random\""},
        BadInput{"TitleIsANumber", "title = 3\n" SIZED DISK, "s.toml:1:9: title must be a string, not a whole number"}),
    [](const auto& test) { return std::string(test.param.name); });

class BrokenText : public testing::TestWithParam<BadInput> {};

TEST_P(BrokenText, IsRefusedWithOneMessageThatNamesTheLine) {
  const std::string message = refusal(GetParam().text, "s.toml");
  EXPECT_EQ(message.rfind(GetParam().message, 0), 0u) << message;
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
}

INSTANTIATE_TEST_SUITE_P(Texts, BrokenText,
                         testing::Values(BadInput{"Empty", " \n\n", "s.toml: the file is empty"},
                                         BadInput{"NoValue", "a = 1\nb =\n", "s.toml:2:"},
                                         BadInput{"CutOff", "[box]\nsize = [1.0, 2", "s.toml:2:"},
                                         BadInput{"SameKeyTwice", "[box]\nsize = [1, 1]\nsize = [1, 1]", "s.toml:3:"},
                                         BadInput{"TooLargeNumber", "[box]\nsize = [1e400, 1]", "s.toml:2:"},
                                         BadInput{"TooLargeInteger", "[[gas]]\nseed = 99999999999999999999",
                                                  "s.toml:2:"},
                                         BadInput{"InvalidUtf8", "title = \"\xff\xfe\"", "s.toml:1:"},
                                         BadInput{"Binary",
                                                  "\x7f"
                                                  "ELF\x02\x01\x01",
                                                  "s.toml:1:"},
                                         BadInput{"Hdf5", "\x89HDF\r\n\x1a\n",
                                                  has_checkpoints() ? "s.toml: is not a sound HDF5 file"
                                                                    : "s.toml: this carom was built without HDF5"}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BrokenText, ANulByteIsNotText) {
  EXPECT_EQ(refusal(std::string("a = 1\nb\0c", 9), "s.toml"), "s.toml:2: this is not a text file: it has a NUL byte");
}

TEST(BrokenText, EveryTruncationOfASceneIsReadOrRefused) {
  const std::string whole = "title = \"gas ü\"\n" SIZED DISK "velocity = [1e-3, -2.0]\n[run]\nuntil = 10.0\n";
  for (std::size_t size = 0; size < whole.size(); ++size) {
    try {
      parse_scene(whole.substr(0, size), "s.toml");
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("s.toml", 0), 0u) << error.what();
    }
  }
}

class BadAlgs4 : public testing::TestWithParam<BadInput> {};

TEST_P(BadAlgs4, IsRefusedWithPlaceThingAndReason) { EXPECT_EQ(refusal(GetParam().text, "s.txt"), GetParam().message); }

#define ROW "0.5 0.5 0 0 0.1 1 0 0 255\n"

INSTANTIATE_TEST_SUITE_P(
    Texts, BadAlgs4,
    testing::Values(BadInput{"NoDisks", "0\n", "s.txt:1:1: the number of disks is 0: there must be at least one"},
                    BadInput{"TooFewRows", "3\n" ROW ROW, "s.txt:3: the file ends after 2 of 3 disks"},
                    BadInput{"TooManyRows", "1\n" ROW "\n" ROW, "s.txt:4:1: text after the last of 1 disks"},
                    BadInput{"EightColumns", "1\n0.5 0.5 0 0 0.1 1 0 0\n",
                             "s.txt:2:1: 8 columns: there must be 9, rx ry vx vy radius mass r g b"},
                    BadInput{"NotANumber", "1\n0.5 0.5 0 O 0.1 1 0 0 0\n", "s.txt:2:11: vy 'O' is not a number"},
                    BadInput{"Nan", "1\nnan 0.5 0 0 0.1 1 0 0 0\n", "s.txt:2:1: rx 'nan' is not a finite number"},
                    BadInput{"Overflow", "1\n 1e400 0.5 0 0 0.1 1 0 0 0\n",
                             "s.txt:2:2: rx '1e400' is too large for a number (over 1.8e308)"},
                    BadInput{"Comma", "1\n0,5 0.5 0 0 0.1 1 0 0 0\n", "s.txt:2:1: rx '0,5' is not a number"},
                    BadInput{"ZeroMass", "1\n0.5 0.5 0 0 0.1 0 0 0 0\n",
                             "s.txt:2:17: mass is 0: it must be greater than 0"},
                    BadInput{"TwoBadRows", "2\n0.5 a 0 0 0.1 1 0 0 0\n0.5 b 0 0 0.1 1 0 0 0\n",
                             "s.txt:2:5: ry 'a' is not a number\ns.txt:3:5: ry 'b' is not a number"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Problems, AllOfAFileAreToldAtOnceInItsOrder) {
  const std::string message = refusal(
      "titel = \"x\"\n[box]\nsize = [10.0, inf]\n[[disk]]\nposition = [1.0]\n[[disk]]\nradius = 0\n"
      "[physics]\nrestitution = 2\n[run]\nuntil = -1\n",
      "s.toml");
  std::vector<std::string> places;
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) places.push_back(line.substr(0, line.find(' ')));
  const std::vector<std::string> expected{
      "s.toml:1:1:", "s.toml:3:15:", "s.toml:5:12:", "s.toml:6:1:", "s.toml:7:10:", "s.toml:9:15:", "s.toml:11:9:"};
  EXPECT_EQ(places, expected) << message;
}

TEST(Problems, TooManyToReadAreCounted) {
  std::string text = SIZED;
  for (int k = 0; k < 1000; ++k) text += "[[disk]]\nposition = [1.0, 1.0]\nmass = 0\n";
  const std::string message = refusal(text, "s.toml");
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 100);
  EXPECT_TRUE(message.ends_with("s.toml: … and 900 more problems")) << message;
}

std::vector<std::string> checked(const std::string& text) {
  const Scratch scratch;
  write_file(scratch / "s.toml", text);
  std::vector<std::string> messages;
  for (const Problem& problem : problems_in(scratch / "s.toml")) {
    messages.push_back(to_string(problem).substr(scratch.path().size() + 1));
  }
  return messages;
}

using Messages = std::vector<std::string>;

TEST(Problems, OfReadingAndOfTheSceneStandTogetherOnceEach) {
  EXPECT_EQ(checked(SIZED "[[disk]]\nposition = [1.0, 1.0]\n[[disk]]\nposition = [1.5, 1.0]\n"
                          "[[disk]]\nradius = 0 \n position = [1.0, 1.0]\n[[disk]]\nposition = [11.0, 5.0]\n"),
            (Messages{"s.toml:8:10: radius is 0: it must be greater than 0",
                      "s.toml:10:1: disk 3 is outside the box: it reaches 2 past the right edge",
                      "s.toml:5:1: disk 0 and disk 1 overlap by 0.5 (contact distance 1)"}));
}

TEST(Problems, AFaultyBoxDoesNotHideOverlaps) {
  EXPECT_EQ(checked("[box]\nsize = [0, 9]\n" DISK DISK),
            (Messages{"s.toml:2:9: size is 0: it must be greater than 0",
                      "s.toml:5:1: disk 0 and disk 1 have the same centre"}));
}

TEST(Problems, AFaultyGasIsNotComplainedOfTwice) {
  EXPECT_EQ(
      checked(SIZED DISK DISK "[[gas]]\ncount = 0\n"),
      (Messages{"s.toml:8:9: count is 0: it must be 1 or more", "s.toml:5:1: disk 0 and disk 1 have the same centre"}));
}

TEST(Problems, AnImpossibleGasIsToldWithItsPlace) {
  const Messages messages = checked(SIZED "[[gas]]\ncount = 1000\n");
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].rfind("s.toml:3:1: ", 0), 0u) << messages[0];
}

TEST(Problems, WithoutDisksTheFileIsNamed) {
  const Messages messages = checked(SIZED);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].rfind("s.toml", 0), 0u) << messages[0];
}

TEST(Problems, AGoodSceneHasNone) { EXPECT_EQ(checked(SIZED DISK), Messages{}); }

TEST(Problems, OfAMissingFileAreReportedNotThrown) {
  const std::vector<Problem> problems = problems_in("/nowhere/s.toml");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(to_string(problems[0]), "/nowhere/s.toml: cannot be read: No such file or directory");
}

}  // namespace
}  // namespace carom
