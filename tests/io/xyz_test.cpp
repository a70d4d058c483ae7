// Frames in extended XYZ have the columns that OVITO expects and read back to the same bits; malformed ones are
// refused.
#include "carom/io/xyz.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>

#include "carom/io/file.hpp"
#include "carom/io/scene_file.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

Setup two_disks(std::array<Boundary, 2> boundary) {
  carom::Setup setup;
  setup.system.box = {.size = {10, 20}, .boundary = boundary};
  setup.system.add_disk({0.5, 1});
  setup.system.add_disk({0.25, 3});
  setup.frame.add_disk({1, 2}, {0.1, -0.0});
  setup.frame.add_disk({3, 4}, {0, 1e-300});
  setup.frame.time = 1.5;
  return setup;
}

TEST(XyzFrame, IsTheTextThatOvitoReads) {
  const carom::Setup setup = two_disks({Boundary::periodic, Boundary::reflecting});
  EXPECT_EQ(xyz_frame(setup.system, setup.frame),
            "2\n"
            "Lattice=\"10 0.0 0.0 0.0 20 0.0 0.0 0.0 1\" "
            "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1 Time=1.5 pbc=\"T F F\" "
            "boundary=\"periodic reflecting\"\n"
            "H 1 2 0 0.10000000000000001 -0 0 0.5 1 0\n"
            "He 3 4 0 0 1e-300 0 0.25 3 1\n");
}

TEST(XyzFrame, AnOpenPlaneIsAsLargeAsWhatTheDisksCover) {
  carom::Setup setup = two_disks({Boundary::open, Boundary::open});
  setup.system.box.size = {};
  const std::string text = xyz_frame(setup.system, setup.frame);
  EXPECT_NE(text.find("Lattice=\"2.75 0.0 0.0 0.0 2.75 0.0 0.0 0.0 1\" Origin=\"0.5 1.5 0.0\""), std::string::npos)
      << text;
  EXPECT_NE(text.find("pbc=\"F F F\" boundary=\"open open\" box=\"0 0\""), std::string::npos) << text;
}

TEST(XyzFrame, SpeciesAreNamedAsElementsWhileThereAreAny) {
  carom::Setup setup;
  setup.system.box.size = {100, 100};
  for (int k = 0; k < 120; ++k) {
    setup.system.add_disk({0.1, 1.0 + k});
    setup.frame.add_disk({1.0 + k, 1}, {});
  }
  const std::string text = xyz_frame(setup.system, setup.frame);
  EXPECT_NE(text.find("\nLi 3 "), std::string::npos);
  EXPECT_NE(text.find("\nOg 118 "), std::string::npos);
  EXPECT_NE(text.find("\nX 119 "), std::string::npos);
  EXPECT_NE(text.find("\nX 120 "), std::string::npos);
}

/// Any double that a system may hold: up to 1e75.
double any_double() {
  const auto value = std::bit_cast<double>(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
  return std::abs(value) <= 1e75 ? value : std::isnan(value) ? 0.1 : 1 / value;
}

Setup any_setup() {
  const auto boundary = rc::gen::element(Boundary::periodic, Boundary::reflecting, Boundary::open);
  carom::Setup setup;
  setup.system.box = {.size = {std::abs(any_double()), std::abs(any_double())}, .boundary = {*boundary, *boundary}};
  setup.system.physics = {.restitution = *rc::gen::inRange(0, 11) / 10.0,
                          .wall_restitution = *rc::gen::inRange(0, 11) / 10.0,
                          .t_c = std::abs(any_double())};
  for (int k = *rc::gen::inRange(1, 20); k > 0; --k) {
    setup.system.add_disk({std::abs(any_double()), std::abs(any_double())});
    setup.frame.add_disk({any_double(), any_double()}, {any_double(), any_double()});
  }
  setup.frame.time = any_double();
  return setup;
}

RC_GTEST_PROP(XyzFrame, ReadsBackToTheSameBits, ()) {
  const carom::Setup setup = any_setup();
  const Scratch scratch;
  OutputStream stream(scratch / "a.xyz");
  stream.write(xyz_frame(setup.system, setup.frame));
  stream.close();
  const carom::Setup read = read_last_frame(scratch / "a.xyz");
  RC_ASSERT(digest(read.system, read.frame) == digest(setup.system, setup.frame));
  RC_ASSERT(read.system.box.boundary == setup.system.box.boundary);
}

TEST(XyzReader, TellsEveryFrameInTurn) {
  const Scratch scratch;
  carom::Setup setup = two_disks({Boundary::periodic, Boundary::periodic});
  std::string text;
  for (const double time : {0.0, 0.5, 1.0}) {
    setup.frame.time = time;
    setup.frame.x[0] = 1 + time;
    text += xyz_frame(setup.system, setup.frame);
  }
  write_file(scratch / "t.xyz", text);
  XyzReader reader(scratch / "t.xyz");
  const auto first = reader.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->frame.x[0], 1);
  const auto second = reader.skip();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->disks, 2u);
  EXPECT_EQ(second->time, 0.5);
  const auto third = reader.next();
  ASSERT_TRUE(third);
  EXPECT_EQ(third->frame.time, 1);
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.skip());
}

TEST(XyzReader, TakesColumnsInAnyOrderAndDisksById) {
  const SceneFile file = parse_scene(
      "2\nProperties=id:I:1:mass:R:1:tag:S:2:radius:R:1:vel:R:3:pos:R:3 Time=3 Lattice=\"8 0 0 0 9 0 0 0 1\"\n"
      "7 2.0 x y 0.5 1 2 0 3 4 0\n3 1.0 x y 0.25 5 6 0 7 8 0\n",
      "a.xyz");
  const Scene& scene = file.scene;
  ASSERT_EQ(scene.disks.size(), 2u);
  EXPECT_EQ(scene.disks[0].position, (Vec2{7, 8}));
  EXPECT_EQ(scene.disks[0].velocity, (Vec2{5, 6}));
  EXPECT_EQ(scene.disks[0].radius, 0.25);
  EXPECT_EQ(scene.disks[1].mass, 2);
  EXPECT_EQ(to_string(scene.disks[0].place), "a.xyz:4:1");
  EXPECT_EQ(scene.boundary, (std::array{Boundary::periodic, Boundary::periodic}));
}

TEST(XyzReader, WithoutALatticeThePlaneIsOpen) {
  const Scene scene = parse_scene("1\nProperties=pos:R:2:velo:R:2:radius:R:1\n1 2 0 0 0.5\n", "a.xyz").scene;
  EXPECT_EQ(scene.boundary, (std::array{Boundary::open, Boundary::open}));
  EXPECT_EQ(problems_of(scene).size(), 0u);
}

struct BadFrame {
  const char* name;
  const char* text;
  const char* message;
};

void PrintTo(const BadFrame& frame, std::ostream* out) { *out << frame.name; }

class BadXyz : public testing::TestWithParam<BadFrame> {};

TEST_P(BadXyz, IsRefusedWithPlaceThingAndReason) {
  EXPECT_EQ(message_of([] { parse_scene(GetParam().text, "a.xyz"); }), GetParam().message);
}

#define COLUMNS "Properties=pos:R:3:velo:R:3:radius:R:1:id:I:1"
#define ROW "1 1 0 0 0 0 0.5 0\n"

INSTANTIATE_TEST_SUITE_P(
    Texts, BadXyz,
    testing::Values(
        BadFrame{"Empty", "\n", "a.xyz: the file is empty"},
        BadFrame{"NoCount", "two\n" COLUMNS "\n", "a.xyz:1:1: here must stand the number of disks of a frame, alone"},
        BadFrame{"NoDisks", "0\n" COLUMNS "\n", "a.xyz:1:1: the number of disks is 0: there must be at least one"},
        BadFrame{"HugeCount", "4000000000000\n" COLUMNS "\n" ROW,
                 "a.xyz:3: the file ends after 1 of 4000000000000 disks"},
        BadFrame{"NoComment", "1\n", "a.xyz:1: the file ends before the frame's comment line"},
        BadFrame{"CutOff", "2\n" COLUMNS "\n" ROW, "a.xyz:3: the file ends after 1 of 2 disks"},
        BadFrame{"SecondFrameCutOff", "1\n" COLUMNS "\n" ROW "1\n" COLUMNS "\n",
                 "a.xyz:5: the file ends after 0 of 1 disks"},
        BadFrame{"NoProperties", "1\nTime=1\n" ROW, "a.xyz:2: no Properties: they say what the columns are"},
        BadFrame{"NoVelocity", "1\nProperties=pos:R:3:radius:R:1\n1 1 0 0.5\n",
                 "a.xyz:2:12: Properties has no velo:R:3"},
        BadFrame{"BrokenProperties", "1\nProperties=pos:R:x\n" ROW,
                 "a.xyz:2:12: Properties must be name:type:columns, again and again"},
        BadFrame{"TiltedLattice", "1\nLattice=\"5 0 0 1 5 0 0 0 1\" " COLUMNS "\n" ROW,
                 "a.xyz:2:10: Lattice must be a rectangular box along the axes: \"Lx 0 0 0 Ly 0 0 0 Lz\""},
        BadFrame{"ShortLattice", "1\nLattice=\"5 0 0\" " COLUMNS "\n" ROW,
                 "a.xyz:2:10: Lattice must be 9 finite numbers"},
        BadFrame{"BadTime", "1\nTime=nan " COLUMNS "\n" ROW, "a.xyz:2:6: Time must be 1 finite number"},
        BadFrame{"BadPbc", "1\n" COLUMNS " pbc=\"T X F\"\n" ROW,
                 "a.xyz:2:52: pbc must be T or F for each axis, e.g. \"T T F\""},
        BadFrame{"BadBoundary", "1\n" COLUMNS " boundary=\"soft open\"\n" ROW,
                 "a.xyz:2:57: boundary must be two of periodic, reflecting, open"},
        BadFrame{"MissingColumn", "1\n" COLUMNS "\n1 1 0 0 0 0 0.5\n", "a.xyz:3:1: 7 columns: Properties says 8"},
        BadFrame{"TwoBadRows", "2\n" COLUMNS "\n1 x 0 0 0 0 0.5 0\n1 1 0 nan 0 0 0.5 1\n",
                 "a.xyz:3:3: y 'x' is not a number\na.xyz:4:7: vx 'nan' is not a finite number"},
        BadFrame{"LeavesThePlane", "1\n" COLUMNS "\n1 1 0 0 0 2 0.5 0\n",
                 "a.xyz:3:11: vz is not 0: the disks move in a plane"},
        BadFrame{"SameIdTwice", "2\n" COLUMNS "\n" ROW ROW, "a.xyz:4:1: there are two disks 0"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(BadXyz, ABadRadiusIsToldByTheSceneWithItsLine) {
  const Scene scene = parse_scene("1\n" COLUMNS "\n1 1 0 0 0 0 -0.5 0\n", "a.xyz").scene;
  const std::vector<Problem> problems = problems_of(scene);
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(to_string(problems[0]), "a.xyz:3:1: radius of disk 0 is -0.5: it must be greater than 0");
}

TEST(BadXyz, AMissingFileAndADirectoryAreRefused) {
  const Scratch scratch;
  EXPECT_EQ(message_of([&] { XyzReader reader(scratch / "none.xyz"); }),
            scratch / "none.xyz" + ": cannot be read: No such file or directory");
  EXPECT_EQ(message_of([&] { XyzReader reader(scratch.path()); }),
            scratch.path() + ": cannot be read: it is a directory");
}

}  // namespace
}  // namespace carom
