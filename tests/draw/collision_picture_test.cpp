// Properties: a picture of a collision is a whole file of its format, the same bytes for the same collision; its arrows
// are the velocities, all on one scale; and it can be made of any finite collision whatever its scale.
#include "carom/draw/collision.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "carom/base/error.hpp"
#include "carom/rule/collision.hpp"
#include "picture_bytes.hpp"

namespace carom {
namespace {

using test::filled_paths;

constexpr std::array kFormats{PictureFormat::svg, PictureFormat::png, PictureFormat::pdf};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const std::string kVelocityFill = "rgb(0%,44.705882%,69.803922%)";
const std::string kNormalFill = "rgb(83.529412%,36.862745%,0%)";
const std::string kTangentFill = "rgb(0%,61.960784%,45.098039%)";
const std::string kCentreFill = "rgb(25.098039%,25.098039%,25.098039%)";
constexpr double kCentreDot = 2.6;  // pixels of radius: a circle's path begins at its right

CollisionPicture collision_of(const rule::Contact& contact, double r1 = 0.5, double r2 = 0.5) {
  const rule::Velocities after = rule::collide(contact);
  CollisionPicture picture;
  picture.first = {{0, 0}, contact.v.first, after.first, r1, contact.m1};
  picture.second = {contact.r, contact.v.second, after.second, r2, contact.m2};
  picture.restitution = contact.restitution;
  picture.approaching = rule::approach(contact.r, contact.v) < 0;
  return picture;
}

CollisionPicture oblique() { return collision_of({{0.8, 0.6}, {{2, 0.3}, {-1, 0.7}}, 1, 2, 1}); }

std::string svg_of(const CollisionPicture& picture) { return picture_of_collision(picture, PictureFormat::svg); }

// Heads of arrows of one colour, without the one that explains the colour.
std::size_t arrows(const std::string& svg, const std::string& fill) { return filled_paths(svg, fill).size() - 1; }

TEST(CollisionPicture, IsAWholeFileOfItsFormat) {
  EXPECT_TRUE(test::is_well_formed_xml(svg_of(oblique())));
  EXPECT_TRUE(test::is_pdf(picture_of_collision(oblique(), PictureFormat::pdf)));
  const std::string png = picture_of_collision(oblique(), PictureFormat::png);
  ASSERT_TRUE(test::is_png(png));
  EXPECT_EQ(test::size_of_png(png).width, 2376u);
}

TEST(CollisionPicture, GivesTheSameBytesTwice) {
  for (const PictureFormat format : kFormats) {
    EXPECT_EQ(picture_of_collision(oblique(), format), picture_of_collision(oblique(), format));
  }
}

TEST(CollisionPicture, ArrowsAreTheVelocitiesOnOneScale) {
  const CollisionPicture picture = oblique();
  const std::string svg = svg_of(picture);
  const auto tips = filled_paths(svg, kVelocityFill);
  const auto centres = filled_paths(svg, kCentreFill);
  ASSERT_EQ(tips.size(), 7u);
  ASSERT_EQ(centres.size(), 6u);
  const std::array<Vec2, 6> velocities{picture.first.before,  picture.second.before, picture.first.before,
                                       picture.second.before, picture.first.after,   picture.second.after};
  const double scale = (tips[0].x - (centres[0].x - kCentreDot)) / velocities[0].x;
  EXPECT_GT(scale, 5);
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    EXPECT_NEAR(tips[k].x - (centres[k].x - kCentreDot), scale * velocities[k].x, 0.05) << k;
    EXPECT_NEAR(centres[k].y - tips[k].y, scale * velocities[k].y, 0.05) << k;
  }
}

TEST(CollisionPicture, PartsAreDrawnForBothDisksBeforeAndAfter) {
  const std::string svg = svg_of(oblique());
  EXPECT_EQ(arrows(svg, kNormalFill), 4u);
  EXPECT_EQ(arrows(svg, kTangentFill), 4u);
}

TEST(CollisionPicture, WhatIsZeroHasNoArrow) {
  const std::string svg = svg_of(collision_of({{1, 0}, {{1, 0}, {0, 0}}}));
  EXPECT_EQ(arrows(svg, kVelocityFill), 1u);  // v1 before; what lies along the normal is drawn as its normal part
  EXPECT_EQ(arrows(svg, kNormalFill), 2u);    // v1 before, v2 after
  EXPECT_EQ(arrows(svg, kTangentFill), 0u);
  EXPECT_EQ(arrows(svg_of(collision_of({{1, 0}, {}})), kVelocityFill), 0u);
}

TEST(CollisionPicture, DisksThatDoNotApproachKeepTheirVelocities) {
  CollisionPicture picture = collision_of({{1, 0}, {{-1, 0.5}, {1, 0.25}}});
  ASSERT_FALSE(picture.approaching);
  const std::string svg = svg_of(picture);
  picture.first.after = {7, 7};
  EXPECT_EQ(svg_of(picture), svg);
  picture.approaching = true;
  EXPECT_NE(svg_of(picture), svg);
}

TEST(CollisionPicture, DisksOfAnyRadiiStayVisible) {
  for (const double ratio : {1.0, 10.0, 100.0, 1e12}) {
    const std::string svg = svg_of(collision_of({{ratio + 1, 0}, {{1, 1}, {-1, 0}}}, ratio, 1));
    const std::string second_disk = "rgb(97.254902%,89.458824%,72%)";
    const auto rims = filled_paths(svg, second_disk);
    const auto centres = filled_paths(svg, kCentreFill);
    ASSERT_EQ(rims.size(), 3u);
    EXPECT_GT(rims[0].x - (centres[1].x - kCentreDot), 15) << ratio;
  }
}

TEST(CollisionPicture, CanBeMadeAtAnyScale) {
  std::mt19937_64 random(20240611);
  std::uniform_real_distribution<double> part(-1, 1);
  std::uniform_real_distribution<double> exponent(-12, 12);
  for (int trial = 0; trial < 300; ++trial) {
    const auto scale = [&] { return std::pow(10, exponent(random)); };
    const auto vector = [&] { return scale() * Vec2{part(random), part(random)}; };
    const rule::Contact contact{vector(), {vector(), vector()}, scale(), scale(), trial % 3 / 2.0};
    const std::string svg = svg_of(collision_of(contact, scale(), scale()));
    EXPECT_TRUE(test::is_well_formed_xml(svg)) << trial;
    EXPECT_FALSE(test::has_numbers_that_are_none(svg)) << trial;
  }
}

TEST(CollisionPicture, AWallsInfiniteMassCanBeDrawn) {
  EXPECT_TRUE(test::is_well_formed_xml(svg_of(collision_of({{1, 0}, {{1, 1}, {0, 0}}, 1, kInfinity, 1}))));
}

TEST(CollisionPicture, RefusesWhatIsNoCollision) {
  const auto refused = [](auto&& spoil) {
    CollisionPicture picture = oblique();
    spoil(picture);
    EXPECT_THROW(svg_of(picture), Error);
  };
  refused([](CollisionPicture& p) { p.second.position = p.first.position; });
  refused([](CollisionPicture& p) { p.first.radius = 0; });
  refused([](CollisionPicture& p) { p.second.mass = -1; });
  refused([](CollisionPicture& p) { p.first.before.x = kInfinity; });
  refused([](CollisionPicture& p) { p.second.position.y = std::nan(""); });
  refused([](CollisionPicture& p) { p.restitution = 1.5; });
  refused([](CollisionPicture& p) { p.first.position.x = -1.5e308, p.second.position.x = 1.5e308; });
}

}  // namespace
}  // namespace carom
