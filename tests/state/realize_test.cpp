// Property: a scene becomes one system and one frame, the same bits for the same seed; or every reason why not, with
// its place, and a refusal says what would work.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "carom/state/scene.hpp"
#include "carom/state/validate.hpp"
#include "make_system.hpp"

namespace carom {
namespace {

Scene gas_scene(std::uint64_t count, double packing, std::array<Boundary, 2> boundary = kPeriodic) {
  Scene scene;
  scene.boundary = boundary;
  scene.gas.push_back({.count = count, .packing_fraction = packing});
  return scene;
}

std::string refusal(const Scene& scene) {
  try {
    realize(scene);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string digest_of(const Scene& scene) {
  const auto setup = realize(scene);
  return digest(setup.system, setup.frame);
}

// --- a gas --------------------------------------------------------------------------------------------------------

TEST(Realize, SmallGasIsGolden) {
  // A change of these is a change of every scene's start: say so where users are told what changed.
  EXPECT_EQ(digest_of(gas_scene(16, 0.5)), "e20d370bf021f189");
  Scene random = gas_scene(16, 0.3, kReflecting);
  random.gas[0].start = GasStart::random;
  EXPECT_EQ(digest_of(random), "18645e039af50ecd");
}

TEST(Realize, PackingFractionSetsTheBox) {
  Scene scene = gas_scene(100, 0.6);
  scene.aspect = 0.5;
  const auto setup = realize(scene);
  EXPECT_NEAR(packing_fraction(setup.system), 0.6, 1e-14);
  EXPECT_NEAR(setup.system.box.size.y / setup.system.box.size.x, 0.5, 1e-15);
}

TEST(Realize, PackingFractionSetsTheCount) {
  Scene scene;
  scene.size = Vec2{20, 10};
  scene.gas.push_back({.packing_fraction = 0.5});
  EXPECT_EQ(realize(scene).system.size(), 127u);  // 0.5 · 200 / (π/4) = 127.3
}

TEST(Realize, CountAndSizeOutrankThePackingFraction) {
  Scene scene = gas_scene(16, 0.7);
  scene.size = Vec2{10, 10};
  const auto setup = realize(scene);
  EXPECT_EQ(setup.system.size(), 16u);
  EXPECT_EQ(setup.system.box.size, (Vec2{10, 10}));
}

TEST(Realize, TemperatureAndMomentumAreExact) {
  for (const auto& boundary : {kPeriodic, kReflecting, kMixed, kOpen}) {
    for (const std::uint64_t count : {2u, 3u, 16u, 1000u}) {
      Scene scene = gas_scene(count, 0.3, boundary);
      scene.gas[0].temperature = 2.5;
      scene.gas[0].mass = 3;
      const auto setup = realize(scene);
      EXPECT_NEAR(temperature(setup.system, setup.frame), 2.5, 2.5e-12);
      EXPECT_LT(length(momentum(setup.system, setup.frame)), 1e-14 * momentum_scale(setup.system, setup.frame));
    }
  }
}

TEST(Realize, SameSeedSameBitsOtherSeedOtherBits) {
  for (const GasStart start : {GasStart::lattice, GasStart::random}) {
    Scene scene = gas_scene(50, 0.3);
    scene.gas[0].start = start;
    const std::string first = digest_of(scene);
    EXPECT_EQ(digest_of(scene), first);
    scene.gas[0].seed = 2;
    EXPECT_NE(digest_of(scene), first);
  }
}

// --- several gases, gases among disks -------------------------------------------------------------------------------

Scene mixture() {
  Scene scene;
  scene.gas.push_back({.count = 60, .packing_fraction = 0.2});
  scene.gas.push_back({.count = 40, .packing_fraction = 0.1, .radius = 0.25, .mass = 4});
  return scene;
}

TEST(Realize, MixtureIsMixed) {
  const auto setup = realize(mixture());
  ASSERT_EQ(setup.system.size(), 100u);
  EXPECT_EQ(setup.system.radius(59), 0.5);
  EXPECT_EQ(setup.system.radius(60), 0.25);
  EXPECT_NEAR(temperature(setup.system, setup.frame), 1, 1e-12);
  int upper_half = 0;
  for (std::size_t k = 0; k < 60; ++k) upper_half += setup.frame.y[k] > 0.5 * setup.system.box.size.y;
  EXPECT_GT(upper_half, 15);
  EXPECT_LT(upper_half, 45);
}

TEST(Realize, EverySeedOfAMixtureMatters) {
  const std::string first = digest_of(mixture());
  for (const std::size_t g : {0u, 1u}) {
    Scene scene = mixture();
    scene.gas[g].seed = 17;
    EXPECT_NE(digest_of(scene), first) << "gas " << g;
  }
}

TEST(Realize, LatticeAndRandomStartsTogether) {
  Scene scene = mixture();
  scene.gas[1].start = GasStart::random;
  const auto setup = realize(scene);
  EXPECT_EQ(setup.system.size(), 100u);
  EXPECT_TRUE(validate(setup.system, setup.frame).empty());
}

TEST(Realize, GasFlowsAroundADisk) {
  for (const GasStart start : {GasStart::lattice, GasStart::random}) {
    Scene scene;
    scene.size = Vec2{40, 40};
    scene.disks.push_back({.position = {39, 20}, .velocity = {1, 0}, .radius = 8, .mass = 100});
    scene.gas.push_back({.count = 500, .start = start});
    const auto setup = realize(scene);
    ASSERT_EQ(setup.system.size(), 501u);
    EXPECT_EQ(setup.system.radius(0), 8) << "explicit disks come first";
    EXPECT_EQ(setup.frame.velocity(0), (Vec2{1, 0}));
    EXPECT_TRUE(validate(setup.system, setup.frame).empty());
  }
}

// --- refusals -----------------------------------------------------------------------------------------------------

TEST(Refusal, SaysWhichPackingFractionCanBePlaced) {
  for (const auto& boundary : {kPeriodic, kReflecting, kMixed}) {
    for (const std::uint64_t count : {1u, 2u, 5u, 16u, 100u, 1001u}) {
      const std::string text = refusal(gas_scene(count, 0.99, boundary));
      double wanted = 0, possible = 0;
      unsigned long disks = 0;
      ASSERT_EQ(std::sscanf(text.c_str(),
                            "%lu disks at a packing fraction of %lf do not fit on a lattice in this box: up to %lf can",
                            &disks, &wanted, &possible),
                3)
          << text;
      EXPECT_EQ(disks, count);
      EXPECT_EQ(refusal(gas_scene(count, possible, boundary)), "");
      EXPECT_NE(refusal(gas_scene(count, possible + 2e-4, boundary)), "");
    }
  }
}

void expect_true_refusal(Scene scene) {
  const std::string text = refusal(scene);
  unsigned long disks = 0, possible = 0;
  const std::size_t number = text.find(": ");
  ASSERT_NE(number, std::string::npos) << text;
  ASSERT_EQ(std::sscanf(text.c_str(), "%lu disks do not fit on a lattice", &disks), 1) << text;
  ASSERT_EQ(std::sscanf(text.c_str() + number, ": %lu can be placed", &possible), 1) << text;
  EXPECT_EQ(disks, *scene.gas[0].count);
  ASSERT_GT(possible, 0u);
  scene.gas[0].count = possible;
  EXPECT_EQ(refusal(scene), "");
}

TEST(Refusal, SaysHowManyDisksCanBePlaced) {
  Scene scene;
  scene.size = Vec2{10, 10};
  scene.gas.push_back({.count = 120});
  expect_true_refusal(scene);
  scene.boundary = kReflecting;
  expect_true_refusal(scene);
}

TEST(Refusal, SaysHowManyFitBesideOtherDisks) {
  Scene scene;
  scene.size = Vec2{20, 20};
  scene.disks.push_back({.position = {10, 10}, .radius = 7});
  scene.gas.push_back({.count = 300});
  EXPECT_NE(refusal(scene).find("beside the other disks"), std::string::npos);
  expect_true_refusal(scene);
  scene.gas[0].count = 500;  // more than the empty box would hold
  expect_true_refusal(scene);
}

TEST(Refusal, OfARandomStartSaysHowFarItCame) {
  Scene scene = gas_scene(200, 0.65);
  scene.gas[0].start = GasStart::random;
  scene.gas[0].place = {"s.toml", 7};
  unsigned long placed = 0, wanted = 0;
  const std::string text = refusal(scene);
  ASSERT_EQ(std::sscanf(text.c_str(), "s.toml:7: %lu of %lu disks could be placed at random", &placed, &wanted), 2)
      << text;
  EXPECT_GT(placed, 140u);
  EXPECT_LT(placed, 190u);
  EXPECT_NE(text.find("use start = \"lattice\""), std::string::npos);
}

TEST(Refusal, NamesWhatIsWrongWithAGas) {
  const auto expect = [](auto change, std::string_view message) {
    Scene scene = gas_scene(16, 0.5);
    scene.gas[0].place = {"s.toml", 7};
    change(scene);
    const std::string text = refusal(scene);
    EXPECT_NE(text.find("s.toml:7: "), std::string::npos) << text;
    EXPECT_NE(text.find(message), std::string::npos) << text;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect([](Scene& s) { s.gas[0].radius = 0; }, "radius of this gas is 0: it must be a number above 0");
  expect([&](Scene& s) { s.gas[0].mass = nan; }, "mass of this gas is nan");
  expect([](Scene& s) { s.gas[0].temperature = -1; }, "temperature of this gas is -1: it must be a number, 0 or more");
  expect([](Scene& s) { s.gas[0].packing_fraction = -0.5; }, "packing_fraction of this gas is -0.5");
  expect([](Scene& s) { s.gas[0].packing_fraction = 1.5; }, "up to 0.7853 can be placed");
  expect([](Scene& s) { s.gas[0].count = 0; }, "count of this gas is 0");
  expect([](Scene& s) { s.gas[0].count.reset(); }, "this gas needs a count");
  expect([](Scene& s) { s.gas[0].count = 5'000'000'000; }, "too");
  expect(
      [](Scene& s) {
        s.size = Vec2{10, 10}, s.gas[0].count.reset(), s.gas[0].packing_fraction = 1e-9;
      },
      "leaves no disk");
  expect([](Scene& s) { s.size = Vec2{1e9, 1e9}, s.gas[0].count.reset(); }, "too many");
}

TEST(Refusal, NamesWhatIsWrongWithTheBox) {
  const auto expect = [](auto change, std::string_view message) {
    Scene scene = gas_scene(16, 0.5);
    scene.box_place = {"s.toml", 1};
    change(scene);
    EXPECT_EQ(refusal(scene), "s.toml:1: " + std::string(message));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect([](Scene& s) { s.gas[0].packing_fraction.reset(); },
         "the box needs a size, or a gas with a packing_fraction that sets it");
  expect([](Scene& s) { s.aspect = -1; }, "aspect of the box is -1: it must be a number above 0");
  expect([&](Scene& s) { s.aspect = nan; }, "aspect of the box is nan: it must be a number above 0");
  expect([](Scene& s) { s.size = Vec2{-1, 10}; }, "the box's width is -1: it must be greater than 0");
  expect([&](Scene& s) { s.size = Vec2{10, nan}; }, "the box's height is nan: it must be a finite number");
  expect([](Scene& s) { s.size = Vec2{0, 0}, s.boundary = kOpen; }, "the box needs a width and a height to hold a gas");
}

TEST(Refusal, ListsAllProblemsWithTheirPlaces) {
  Scene scene;
  scene.size = Vec2{10, 10};
  scene.restitution = 2;
  scene.physics_place = {"s.toml", 20};
  scene.disks.push_back({.position = {5, 5}, .place = {"s.toml", 3}});
  scene.disks.push_back({.position = {5, 5}, .radius = -1, .place = {"s.toml", 6}});
  scene.gas.push_back({.count = 0, .place = {"s.toml", 9}});
  const std::string text = refusal(scene);
  EXPECT_NE(text.find("s.toml:9: count of this gas is 0"), std::string::npos) << text;
  EXPECT_NE(text.find("s.toml:6: radius of disk 1 is -1"), std::string::npos) << text;
  EXPECT_NE(text.find("s.toml:20: restitution is 2"), std::string::npos) << text;
  EXPECT_NE(text.find("s.toml:20: wall_restitution is 2"), std::string::npos) << text;
  EXPECT_EQ(problems_of(scene).size(), 4u);
}

TEST(Refusal, OverlapIsPlacedAtTheLaterDisk) {
  Scene scene;
  scene.size = Vec2{10, 10};
  scene.disks.push_back({.position = {5, 5}, .place = {"s.toml", 3}});
  scene.disks.push_back({.position = {5.5, 5}, .place = {"s.toml", 6}});
  EXPECT_EQ(refusal(scene), "s.toml:6: disk 0 and disk 1 overlap by 0.5 (contact distance 1)");
}

// Obstacles with impossible numbers once went into the grid that places the gas, and hung or crashed it.
TEST(Refusal, ImpossibleDisksAreRefusedBeforeAGasIsPlacedAroundThem) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const DiskSpec& disk :
       {DiskSpec{.position = {nan, 5}}, DiskSpec{.position = {1e300, 5}}, DiskSpec{.position = {5, 5}, .radius = 1e12},
        DiskSpec{.position = {5, 5}, .radius = nan}}) {
    for (const GasStart start : {GasStart::lattice, GasStart::random}) {
      Scene scene;
      scene.size = Vec2{10, 10};
      scene.disks.push_back(disk);
      scene.gas.push_back({.count = 5, .start = start});
      EXPECT_NE(refusal(scene), "");
    }
  }
}

TEST(Refusal, OfNothing) {
  EXPECT_NE(refusal(Scene{}), "");
  Scene scene;
  scene.size = Vec2{10, 10};
  EXPECT_EQ(refusal(scene), "there are no disks: give [[disk]] or [[gas]] sections");
}

TEST(Problems, AreEmptyForWhatCanBeSimulated) { EXPECT_TRUE(problems_of(gas_scene(16, 0.5)).empty()); }

// --- physics ------------------------------------------------------------------------------------------------------

TEST(Realize, WallsRestituteLikeDisksUnlessSaidOtherwise) {
  Scene scene = gas_scene(16, 0.3);
  scene.restitution = 0.9;
  EXPECT_EQ(realize(scene).system.physics.wall_restitution, 0.9);
  scene.wall_restitution = 0.5;
  EXPECT_EQ(realize(scene).system.physics.wall_restitution, 0.5);
}

TEST(Realize, ChoosesATimeOfContactWhereRestitutionIsBelowOne) {
  Scene scene = gas_scene(16, 0.3);
  EXPECT_EQ(realize(scene).system.physics.t_c, 0);
  scene.restitution = 0.9;
  const auto setup = realize(scene);
  // A millionth of diameter 1 over the root mean square speed, √(2E/N m) = √(f kT/N m).
  EXPECT_NEAR(setup.system.physics.t_c, 1e-6 / std::sqrt(30.0 / 16), 1e-15);
  scene.t_c = 0.25;
  EXPECT_EQ(realize(scene).system.physics.t_c, 0.25);
  scene.t_c.reset();
  scene.gas[0].temperature = 0;
  EXPECT_EQ(realize(scene).system.physics.t_c, 0) << "nothing moves";
}

}  // namespace
}  // namespace carom
