// A scene written as TOML reads back the same, bit for bit.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "carom/io/scene_file.hpp"

namespace carom {
namespace {

/// For all properties of this program, unless the environment says otherwise.
[[maybe_unused]] const int kSeedIsFixed = setenv("RC_PARAMS", "seed=20250101 max_success=200", 0);

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Any finite double: every exponent, both signs.
rc::Gen<double> any_double() {
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()),
                      [](std::uint64_t pattern) {
                        const auto value = std::bit_cast<double>(pattern);
                        return std::isfinite(value) ? value : static_cast<double>(pattern);
                      });
}

double any_positive() { return std::abs(*any_double()) + std::numeric_limits<double>::min(); }

std::optional<double> perhaps_positive() {
  return *rc::gen::arbitrary<bool>() ? std::optional(any_positive()) : std::nullopt;
}

Vec2 any_vector() { return {*any_double(), *any_double()}; }

double any_fraction() { return *rc::gen::inRange(0, 1001) / 1000.0; }

DiskSpec any_disk() {
  return {.position = any_vector(),
          .velocity = any_vector(),
          .radius = any_positive(),
          .mass = any_positive(),
          .place = {}};
}

GasSpec any_gas() {
  GasSpec gas;
  if (*rc::gen::arbitrary<bool>()) gas.count = *rc::gen::inRange<std::uint64_t>(1, 1u << 30);
  gas.packing_fraction = perhaps_positive();
  gas.radius = any_positive();
  gas.mass = any_positive();
  gas.temperature = std::abs(*any_double());
  gas.seed = *rc::gen::arbitrary<std::uint64_t>();
  gas.start = *rc::gen::element(GasStart::lattice, GasStart::random);
  return gas;
}

SceneFile any_scene_file() {
  const auto boundary = rc::gen::element(Boundary::periodic, Boundary::reflecting, Boundary::open);
  SceneFile file;
  Scene& scene = file.scene;
  scene.title = *rc::gen::element<std::string>("", "Gas", "a \"quoted\" \\ title", "tab\t, line\n, DEL \x7f, \x01, ü");
  scene.boundary = {*boundary, *boundary};
  if (*rc::gen::arbitrary<bool>()) {
    scene.size = Vec2{any_positive(), any_positive()};
  } else {
    scene.aspect = perhaps_positive();
  }
  for (int k = *rc::gen::inRange(0, 4); k > 0; --k) scene.disks.push_back(any_disk());
  for (int k = *rc::gen::inRange(0, 3); k > 0; --k) scene.gas.push_back(any_gas());
  scene.restitution = any_fraction();
  if (*rc::gen::arbitrary<bool>()) scene.wall_restitution = any_fraction();
  scene.t_c = perhaps_positive();
  file.run.until = perhaps_positive();
  if (*rc::gen::arbitrary<bool>()) file.run.collisions = *rc::gen::inRange<std::uint64_t>(1, 1000000000);
  file.run.equilibrate = any_fraction();
  file.run.every = perhaps_positive();
  file.run.trajectory = *rc::gen::element(TrajectoryFormat::none, TrajectoryFormat::xyz);
  for (int k = *rc::gen::inRange(0, 3); k > 0; --k) {
    file.run.observe.push_back({.name = *rc::gen::element<std::string>("pressure", "msd")});
    if (*rc::gen::arbitrary<bool>()) file.run.observe.back().options["interval"] = *any_double();
    if (*rc::gen::arbitrary<bool>()) file.run.observe.back().options["a-b"] = *any_double();
  }
  return file;
}

void expect_same(double a, double b) { RC_ASSERT(bits(a) == bits(b)); }

void expect_same(const std::optional<double>& a, const std::optional<double>& b) {
  RC_ASSERT(a.has_value() == b.has_value());
  if (a) expect_same(*a, *b);
}

void expect_same(Vec2 a, Vec2 b) {
  expect_same(a.x, b.x);
  expect_same(a.y, b.y);
}

void expect_same(const DiskSpec& a, const DiskSpec& b) {
  expect_same(a.position, b.position);
  expect_same(a.velocity, b.velocity);
  expect_same(a.radius, b.radius);
  expect_same(a.mass, b.mass);
}

void expect_same(const GasSpec& a, const GasSpec& b) {
  RC_ASSERT(a.count == b.count);
  expect_same(a.packing_fraction, b.packing_fraction);
  expect_same(a.radius, b.radius);
  expect_same(a.mass, b.mass);
  expect_same(a.temperature, b.temperature);
  RC_ASSERT(a.seed == b.seed);
  RC_ASSERT(a.start == b.start);
}

void expect_same(const Scene& a, const Scene& b) {
  RC_ASSERT(a.title == b.title);
  RC_ASSERT(a.size.has_value() == b.size.has_value());
  if (a.size) expect_same(*a.size, *b.size);
  expect_same(a.aspect, b.aspect);
  RC_ASSERT(a.boundary == b.boundary);
  RC_ASSERT(a.disks.size() == b.disks.size());
  for (std::size_t k = 0; k < a.disks.size(); ++k) expect_same(a.disks[k], b.disks[k]);
  RC_ASSERT(a.gas.size() == b.gas.size());
  for (std::size_t k = 0; k < a.gas.size(); ++k) expect_same(a.gas[k], b.gas[k]);
  expect_same(a.restitution, b.restitution);
  expect_same(a.wall_restitution, b.wall_restitution);
  expect_same(a.t_c, b.t_c);
}

RC_GTEST_PROP(SceneRoundTrip, TomlKeepsEveryBit, ()) {
  const SceneFile file = any_scene_file();
  const SceneFile read = parse_scene(to_toml(file), "s.toml");
  expect_same(file.scene, read.scene);
  expect_same(file.run.until, read.run.until);
  RC_ASSERT(file.run.collisions == read.run.collisions);
  expect_same(file.run.equilibrate, read.run.equilibrate);
  expect_same(file.run.every, read.run.every);
  RC_ASSERT(file.run.trajectory == read.run.trajectory);
  RC_ASSERT(file.run.observe.size() == read.run.observe.size());
  for (std::size_t k = 0; k < file.run.observe.size(); ++k) {
    RC_ASSERT(file.run.observe[k].name == read.run.observe[k].name);
    RC_ASSERT(file.run.observe[k].options == read.run.observe[k].options);
  }
}

TEST(SceneRoundTrip, NegativeZeroAndWholeNumbersStayFloats) {
  SceneFile file;
  file.scene.size = Vec2{10, 1e20};
  file.scene.disks.push_back({.position = {-0.0, 5}, .velocity = {}, .place = {}});
  const std::string text = to_toml(file);
  EXPECT_NE(text.find("position = [-0.0, 5.0]"), std::string::npos) << text;
  EXPECT_TRUE(std::signbit(parse_scene(text, "s.toml").scene.disks[0].position.x));
}

TEST(SceneRoundTrip, AnExplicitSceneHasTheDigestOfTheGasItCameFrom) {
  Scene gas;
  gas.gas.push_back({.count = 100, .packing_fraction = 0.4, .place = {}});
  gas.restitution = 0.9;
  gas.wall_restitution = 0.7;
  const carom::Setup setup = realize(gas);
  const carom::Setup again = realize(parse_scene(to_toml({explicit_scene(setup, "as run"), {}}), "s.toml").scene);
  EXPECT_EQ(digest(setup.system, setup.frame), digest(again.system, again.frame));
}

}  // namespace
}  // namespace carom
