// A scene file means what its format says, and the format is told by ending and content.
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "carom/io/scene_file.hpp"
#include "carom/io/xyz.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

TEST(TomlScene, EveryKeyArrivesWhereItBelongs) {
  const SceneFile file = parse_scene(R"(
title = "Gas"
[box]
size = [120, 60.5]
boundary = ["periodic", "open"]
[[disk]]
position = [10.0, 11.0]
velocity = [1.0, -2]
radius = 0.25
mass = 3.0
[[gas]]
count = 100
packing_fraction = 0.5
radius = 0.75
mass = 2.0
temperature = 0.5
seed = 7
start = "random"
[physics]
restitution = 0.9
wall_restitution = 0.8
t_c = 1e-6
[run]
until = 100.0
collisions = 5000
equilibrate = 10.0
every = 0.5
trajectory = "xyz"
)",
                                     "s.toml");
  const Scene& scene = file.scene;
  EXPECT_EQ(scene.title, "Gas");
  EXPECT_EQ(scene.size, (Vec2{120, 60.5}));
  EXPECT_EQ(scene.boundary, (std::array{Boundary::periodic, Boundary::open}));
  ASSERT_EQ(scene.disks.size(), 1u);
  EXPECT_EQ(scene.disks[0].position, (Vec2{10, 11}));
  EXPECT_EQ(scene.disks[0].velocity, (Vec2{1, -2}));
  EXPECT_EQ(scene.disks[0].radius, 0.25);
  EXPECT_EQ(scene.disks[0].mass, 3);
  EXPECT_EQ(to_string(scene.disks[0].place), "s.toml:6:1");
  ASSERT_EQ(scene.gas.size(), 1u);
  EXPECT_EQ(scene.gas[0].count, 100u);
  EXPECT_EQ(scene.gas[0].packing_fraction, 0.5);
  EXPECT_EQ(scene.gas[0].radius, 0.75);
  EXPECT_EQ(scene.gas[0].mass, 2);
  EXPECT_EQ(scene.gas[0].temperature, 0.5);
  EXPECT_EQ(scene.gas[0].seed, 7u);
  EXPECT_EQ(scene.gas[0].start, GasStart::random);
  EXPECT_EQ(scene.restitution, 0.9);
  EXPECT_EQ(scene.wall_restitution, 0.8);
  EXPECT_EQ(scene.t_c, 1e-6);
  EXPECT_EQ(file.run.until, 100);
  EXPECT_EQ(file.run.collisions, 5000u);
  EXPECT_EQ(file.run.equilibrate, 10);
  EXPECT_EQ(file.run.every, 0.5);
  EXPECT_EQ(file.run.trajectory, TrajectoryFormat::xyz);
}

TEST(TomlScene, WhatIsNotSaidIsAtItsDefault) {
  const SceneFile file = parse_scene("[box]\naspect = 0.5\n[[gas]]\ncount = 4\npacking_fraction = 0.1\n", "-");
  EXPECT_EQ(file.scene.boundary, (std::array{Boundary::periodic, Boundary::periodic}));
  EXPECT_FALSE(file.scene.size);
  EXPECT_EQ(file.scene.aspect, 0.5);
  EXPECT_EQ(file.scene.gas[0].seed, 1u);
  EXPECT_EQ(file.scene.gas[0].start, GasStart::lattice);
  EXPECT_FALSE(file.scene.wall_restitution);
  EXPECT_FALSE(file.scene.t_c);
  EXPECT_FALSE(file.run.until);
  EXPECT_EQ(file.run.trajectory, TrajectoryFormat::none);
}

TEST(Algs4Scene, IsABoxOfSizeOneWithWalls) {
  const Scene scene =
      parse_scene("2\r\n0.25 0.5 1e-2 0 0.05 0.5 0 0 0\r\n\r\n .75 0.5 -0.01 +1 0.05 2 255 0 0\r\n", "in.txt").scene;
  EXPECT_EQ(scene.size, (Vec2{1, 1}));
  EXPECT_EQ(scene.boundary, (std::array{Boundary::reflecting, Boundary::reflecting}));
  ASSERT_EQ(scene.disks.size(), 2u);
  EXPECT_EQ(scene.disks[0].velocity, (Vec2{0.01, 0}));
  EXPECT_EQ(scene.disks[1].position, (Vec2{0.75, 0.5}));
  EXPECT_EQ(scene.disks[1].velocity, (Vec2{-0.01, 1}));
  EXPECT_EQ(scene.disks[1].radius, 0.05);
  EXPECT_EQ(scene.disks[1].mass, 2);
  EXPECT_EQ(to_string(scene.disks[1].place), "in.txt:4:2");
}

TEST(SceneFormat, IsToldByContentWhereTheNameSaysNothing) {
  EXPECT_EQ(parse_scene("1\n0.5 0.5 0 0 0.1 1 0 0 0\n", "<stdin>").scene.size, (Vec2{1, 1}));
  EXPECT_EQ(parse_scene("[box]\nsize = [3.0, 4.0]\n", "<stdin>").scene.size, (Vec2{3, 4}));
  EXPECT_EQ(
      parse_scene("1\nLattice=\"5 0 0 0 6 0 0 0 1\" Properties=pos:R:2:velo:R:2:radius:R:1\n1 1 0 0 0.5\n", "<stdin>")
          .scene.size,
      (Vec2{5, 6}));
}

TEST(SceneFormat, TheLastFrameOfATrajectoryIsTheScene) {
  const std::string head = "Lattice=\"5 0 0 0 6 0 0 0 1\" Properties=pos:R:2:velo:R:2:radius:R:1 pbc=\"T F F\"\n";
  const Scene scene = parse_scene("1\n" + head + "1 1 0 0 0.5\n1\n" + head + "2 2 0 0 0.5\n\n", "t.xyz").scene;
  ASSERT_EQ(scene.disks.size(), 1u);
  EXPECT_EQ(scene.disks[0].position, (Vec2{2, 2}));
  EXPECT_EQ(to_string(scene.disks[0].place), "t.xyz:6:1");
  EXPECT_EQ(scene.boundary, (std::array{Boundary::periodic, Boundary::reflecting}));
}

TEST(SceneFormat, AByteOrderMarkIsPassedOver) {
  EXPECT_EQ(parse_scene("\xEF\xBB\xBF[box]\nsize = [3.0, 4.0]\n", "s.toml").scene.size, (Vec2{3, 4}));
}

TEST(SceneSize, AMillionLinesAreReadInSeconds) {
  std::string algs4 = "200000\n";
  std::string toml = "[box]\nsize = [1.0, 1.0]\n";
  for (int k = 0; k < 200000; ++k) {
    algs4 += "0.123456789012345 0.5 0.1234567 -0.98765 0.0001 1.0 0 0 0\n";
    toml += "[[disk]]\nposition = [0.123456789012345, 0.5]\nvelocity = [0.1, -0.9]\nradius = 0.1\nmass = 1.0\n";
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(parse_scene(algs4, "a.txt").scene.disks.size(), 200000u);
  EXPECT_EQ(parse_scene(toml, "a.toml").scene.disks.size(), 200000u);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

}  // namespace
}  // namespace carom
