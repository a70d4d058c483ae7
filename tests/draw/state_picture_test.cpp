// Properties: a picture of a state is a whole file of its format, the same bytes for the same state; it shows every
// disk where it is, with a copy wherever it reaches over a periodic edge; and it can be made of any finite state.
#include "carom/draw/state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "carom/base/error.hpp"
#include "carom/state/scene.hpp"
#include "picture_bytes.hpp"

namespace carom {
namespace {

using test::filled_paths;

constexpr std::array kFormats{PictureFormat::svg, PictureFormat::png, PictureFormat::pdf};
const std::string kFirstSpeciesFill = "rgb(33.72549%,70.588235%,91.372549%)";

Setup box(Boundary boundary, Vec2 size = {10, 10}) {
  Setup setup;
  setup.system.box = {size, {boundary, boundary}};
  return setup;
}

void add(Setup& setup, Vec2 position, Vec2 velocity = {}, double radius = 0.5) {
  setup.system.add_disk({radius, 1});
  setup.frame.add_disk(position, velocity);
}

std::string svg_of(const Setup& setup, const StatePicture& picture = {}) {
  return picture_of_state(setup.system, setup.frame, picture, PictureFormat::svg);
}

// Disks of the first species, without the one that explains the colour.
std::size_t disks(const std::string& svg) { return filled_paths(svg, kFirstSpeciesFill).size() - 1; }

Setup gas(std::uint64_t count) {
  Scene scene;
  GasSpec gas;
  gas.count = count;
  gas.packing_fraction = 0.5;
  scene.gas.push_back(gas);
  return realize(scene);
}

TEST(StatePicture, IsAWholeFileOfItsFormatAndTheSameTwice) {
  const auto setup = gas(50);
  StatePicture picture;
  picture.velocities = true;
  picture.title = "A <gas> & more";
  for (const PictureFormat format : kFormats) {
    const std::string bytes = picture_of_state(setup.system, setup.frame, picture, format);
    EXPECT_EQ(bytes, picture_of_state(setup.system, setup.frame, picture, format));
    if (format == PictureFormat::svg) {
      EXPECT_TRUE(test::is_well_formed_xml(bytes));
    }
    if (format == PictureFormat::png) {
      EXPECT_TRUE(test::is_png(bytes));
    }
    if (format == PictureFormat::pdf) {
      EXPECT_TRUE(test::is_pdf(bytes));
    }
  }
}

TEST(StatePicture, ShowsADiskWhereItIs) {
  auto setup = box(Boundary::reflecting, {20, 10});
  add(setup, {1, 2});
  add(setup, {11, 8});
  const auto paths = filled_paths(svg_of(setup), kFirstSpeciesFill);
  ASSERT_EQ(paths.size(), 3u);
  const double scale = 960.0 / 20;  // pixels per length: the default width without its margins
  EXPECT_NEAR(paths[0].x, 20 + scale * 1.5, 0.1);
  EXPECT_NEAR(paths[0].y, 20 + scale * 8, 0.1);
  EXPECT_NEAR(paths[1].x - paths[0].x, scale * 10, 0.1);
  EXPECT_NEAR(paths[0].y - paths[1].y, scale * 6, 0.1);
}

TEST(StatePicture, CopiesDisksOverPeriodicEdges) {
  auto inside = box(Boundary::periodic);
  add(inside, {5, 5});
  EXPECT_EQ(disks(svg_of(inside)), 1u);

  auto seams = box(Boundary::periodic);
  add(seams, {0.2, 5});    // one edge: 2
  add(seams, {9.8, 9.9});  // a corner: 4
  add(seams, {5, 0.3});    // one edge: 2
  add(seams, {25.2, -5});  // not wrapped: the middle, 1
  EXPECT_EQ(disks(svg_of(seams)), 9u);

  seams.system.box.boundary = {Boundary::periodic, Boundary::reflecting};
  seams.frame.y[3] = 5;
  EXPECT_EQ(disks(svg_of(seams)), 2u + 2u + 1u + 1u);
}

TEST(StatePicture, SmallDisksAreAllThere) {
  const auto setup = gas(50000);
  const std::string svg = svg_of(setup);
  std::size_t dots = 0;
  for (std::size_t at = svg.find("stroke-linecap:round"); at != std::string::npos;
       at = svg.find("stroke-linecap:round", at + 1)) {
    dots += test::count(std::string_view(svg).substr(at, svg.find('>', at) - at), "M ");
  }
  EXPECT_GE(dots, 50000u);
  EXPECT_LE(dots, 52000u);  // with copies at the edges
}

TEST(StatePicture, IsOfSensibleSizeForAnyShape) {
  for (const double aspect : {1e-6, 0.025, 1.0, 40.0, 1e6}) {
    auto setup = box(Boundary::periodic, {100, 100 * aspect});
    add(setup, {50, 50 * aspect}, {}, 1e-5);
    StatePicture picture;
    picture.width_px = 500;
    const auto [width, height] =
        test::size_of_png(picture_of_state(setup.system, setup.frame, picture, PictureFormat::png));
    EXPECT_LE(width, 500u) << aspect;
    EXPECT_GE(width, 200u) << aspect;
    EXPECT_LE(height, 800u) << aspect;
    EXPECT_GE(height, 50u) << aspect;
  }
}

TEST(StatePicture, OpenPlanesShowEveryDisk) {
  auto setup = box(Boundary::open, {});
  add(setup, {-300, 1000}, {1, 0});
  add(setup, {500, -2000}, {0, 5});
  StatePicture picture;
  picture.velocities = true;
  const std::string svg = svg_of(setup, picture);
  EXPECT_EQ(test::count(svg, "stroke-linecap:round"), 1u);  // both are dots at this scale, in one stroke
  EXPECT_TRUE(test::is_well_formed_xml(svg));
}

TEST(StatePicture, CanBeMadeOfAnyFiniteState) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  constexpr std::array kBoundaries{Boundary::periodic, Boundary::reflecting, Boundary::open};
  for (const double scale : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    for (const Boundary boundary : kBoundaries) {
      for (const ColourBy colour : {ColourBy::species, ColourBy::speed}) {
        auto setup = box(boundary, {scale, scale});
        for (int k = 0; k < 10; ++k) {
          const Vec2 position = k < 3 ? Vec2{0.5 * scale, 0.5 * scale} : scale * Vec2{part(random), part(random)};
          add(setup, position, k % 2 == 0 ? Vec2{} : scale * Vec2{part(random), -part(random)}, scale * 0.05 * (k + 1));
        }
        const std::string svg = svg_of(setup, {.colour = colour, .velocities = true, .title = ""});
        EXPECT_TRUE(test::is_well_formed_xml(svg)) << scale;
        EXPECT_FALSE(test::has_numbers_that_are_none(svg)) << scale;
      }
    }
  }
}

TEST(StatePicture, ADiskAloneAndADiskAtRest) {
  for (const Vec2 place : {Vec2{0, 0}, Vec2{1e9, -1e9}, Vec2{1e308, -1e308}}) {
    auto setup = box(Boundary::open, {});
    add(setup, place, {}, 1e-9);
    const std::string svg = svg_of(setup, {.colour = ColourBy::speed, .velocities = true, .title = ""});
    EXPECT_FALSE(test::has_numbers_that_are_none(svg)) << place.x;
  }
}

TEST(StatePicture, EvenStatesThatCannotBeSimulatedCanBeSeen) {
  auto setup = box(Boundary::reflecting, {1, 1});
  add(setup, {0.5, 0.5}, {1, 0}, 1e300);
  add(setup, {1e300, -1e300}, {0, 1});
  EXPECT_TRUE(test::is_well_formed_xml(svg_of(setup, {.velocities = true, .title = ""})));
  setup.system.box.boundary = {Boundary::periodic, Boundary::periodic};
  EXPECT_TRUE(test::is_well_formed_xml(svg_of(setup, {.velocities = true, .title = ""})));
}

TEST(StatePicture, RefusesWhatCannotBeDrawn) {
  auto setup = box(Boundary::periodic);
  EXPECT_THROW(svg_of(setup), Error);
  add(setup, {5, 5});
  EXPECT_THROW(svg_of(setup, {.width_px = 10, .title = ""}), Error);
  EXPECT_THROW(svg_of(setup, {.width_px = std::nan(""), .title = ""}), Error);
  auto no_box = setup;
  no_box.system.box.size = {0, 1};
  EXPECT_THROW(svg_of(no_box), Error);
  auto no_number = setup;
  no_number.frame.vy[0] = std::nan("");
  EXPECT_THROW(svg_of(no_number), Error);
  setup.frame.add_disk({1, 1}, {});
  EXPECT_THROW(svg_of(setup), Error);
}

}  // namespace
}  // namespace carom
