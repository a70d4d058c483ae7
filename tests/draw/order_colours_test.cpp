// Properties: a picture by ψ6 gives disks of one crystal one colour, and another one after it is turned; a picture by
// density gives equal cells one colour; pictures that share a scale have one size; and a film is whole or not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "carom/base/error.hpp"
#include "carom/draw/movie.hpp"
#include "carom/draw/state.hpp"
#include "carom/state/scene.hpp"
#include "io/scratch.hpp"
#include "picture_bytes.hpp"

namespace carom {
namespace {

// A triangular lattice in a periodic box, or the same with its axes exchanged: turned by 90°, so 6θ differs by π.
Setup crystal(bool turned) {
  Setup setup;
  const double height = 6 * std::sqrt(3.0);
  setup.system.box.size = turned ? Vec2{height, 10} : Vec2{10, height};
  for (int row = 0; row < 12; ++row) {
    for (int column = 0; column < 10; ++column) {
      const Vec2 p{column + 0.5 * (row % 2) + 0.25, (row + 0.5) * 0.5 * std::sqrt(3.0)};
      setup.system.add_disk({0.4, 1});
      setup.frame.add_disk(turned ? Vec2{p.y, p.x} : p, {});
    }
  }
  return setup;
}

// Colours of the disks' outlines are darker shades; what is filled most often is what disks are filled with.
std::string commonest_fill(const std::string& svg) {
  std::map<std::string, int> fills;
  for (std::size_t at = svg.find(";fill:rgb("); at != std::string::npos; at = svg.find(";fill:rgb(", at + 1)) {
    ++fills[svg.substr(at, svg.find(')', at) - at)];
  }
  fills.erase(";fill:rgb(100%,100%,100%");
  const auto most =
      std::max_element(fills.begin(), fills.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  EXPECT_GE(most->second, 120);
  return most->first;
}

std::string svg_by(ColourBy colour, const Setup& setup) {
  StatePicture picture;
  picture.colour = colour;
  const std::string svg = picture_of_state(setup.system, setup.frame, picture, PictureFormat::svg);
  EXPECT_TRUE(test::is_well_formed_xml(svg));
  EXPECT_FALSE(test::has_numbers_that_are_none(svg));
  return svg;
}

TEST(OrderColours, TellHowACrystalIsTurned) {
  const std::string upright = commonest_fill(svg_by(ColourBy::psi6, crystal(false)));
  EXPECT_EQ(upright, commonest_fill(svg_by(ColourBy::psi6, crystal(false))));
  EXPECT_NE(upright, commonest_fill(svg_by(ColourBy::psi6, crystal(true))));
}

TEST(OrderColours, EqualCellsHaveOneDensity) { commonest_fill(svg_by(ColourBy::density, crystal(false))); }

TEST(SharedScale, GivesPicturesOneSizeAndOneMeaning) {
  carom::Setup first;  // a test has a Setup of its own
  first.system.box = {{}, {Boundary::open, Boundary::open}};
  first.system.add_disk({0.5, 1});
  first.system.add_disk({0.5, 1});
  first.frame.add_disk({0, 0}, {1, 0});
  first.frame.add_disk({3, 1}, {0, 0.5});
  carom::Setup second = first;
  second.frame.time = 1234.5678;
  second.frame.x = {40, -7};
  second.frame.vx = {5, 0};
  StatePicture picture;
  picture.colour = ColourBy::speed;
  picture.velocities = true;
  SharedScale scale;
  include_in_scale(first.system, first.frame, picture, scale);
  include_in_scale(second.system, second.frame, picture, scale);
  EXPECT_EQ(scale.largest_speed, std::hypot(5, 0));
  EXPECT_EQ(scale.low.x, -7.5);
  EXPECT_EQ(scale.high.x, 40.5);
  picture.shared = scale;
  const auto size = [&](const carom::Setup& setup) {
    return test::size_of_png(picture_of_state(setup.system, setup.frame, picture, PictureFormat::png));
  };
  EXPECT_EQ(size(first).width, size(second).width);
  EXPECT_EQ(size(first).height, size(second).height);
}

class MovieTest : public testing::Test {
 protected:
  void SetUp() override { std::signal(SIGPIPE, SIG_IGN); }

  // In the place of the program: what it is called with does not matter to these tests.
  void install_ffmpeg(const std::string& script) {
    std::filesystem::create_directory(scratch_ / "bin");
    std::ofstream(scratch_ / "bin/ffmpeg") << "#!/bin/sh\n" << script;
    std::filesystem::permissions(scratch_ / "bin/ffmpeg", std::filesystem::perms::owner_all);
    const std::string old = std::getenv("PATH");
    setenv("PATH", (scratch_ / "bin").c_str(), 1);
    old_path_ = old;
  }
  void TearDown() override {
    if (!old_path_.empty()) setenv("PATH", old_path_.c_str(), 1);
  }

  Scratch scratch_;
  std::string old_path_;
};

TEST_F(MovieTest, IsWhatFfmpegMadeOfThePictures) {
  install_ffmpeg("for last; do :; done\n/bin/cat > \"${last#file:}\"\n");
  {
    Movie movie(scratch_ / "film.mp4", 25);
    movie.add("first ");
    movie.add("second");
    EXPECT_FALSE(std::filesystem::exists(scratch_ / "film.mp4"));
    movie.finish();
  }
  std::ifstream film(scratch_ / "film.mp4");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(film), {}), "first second");
  EXPECT_EQ(scratch_.entries(), 2u);  // and the directory of the program
}

TEST_F(MovieTest, ReportsTheLastLineOfAFailureAndLeavesNothing) {
  install_ffmpeg("/bin/cat > /dev/null\necho one >&2\necho 'no such codec' >&2\nexit 1\n");
  {
    Movie movie(scratch_ / "film.mp4", 25);
    movie.add("picture");
    const std::string message = message_of([&] { movie.finish(); });
    EXPECT_NE(message.find("ffmpeg failed: no such codec"), std::string::npos) << message;
  }
  EXPECT_EQ(scratch_.entries(), 1u);
}

TEST_F(MovieTest, NoticesThatFfmpegHasEnded) {
  install_ffmpeg("echo 'gone' >&2\nexit 3\n");
  {
    Movie movie(scratch_ / "film.gif", 25);
    const std::string picture(1 << 22, 'x');
    EXPECT_NE(message_of([&] { movie.add(picture); }).find("gone"), std::string::npos);
  }
  EXPECT_EQ(scratch_.entries(), 1u);
}

TEST_F(MovieTest, LeavesNothingWhereItIsGivenUp) {
  install_ffmpeg("for last; do :; done\n/bin/cat > \"${last#file:}\"\n");
  { Movie(scratch_ / "film.mp4", 25).add("picture"); }
  EXPECT_EQ(scratch_.entries(), 1u);
}

TEST_F(MovieTest, SaysThatFfmpegIsMissing) {
  install_ffmpeg("");
  std::filesystem::remove(scratch_ / "bin/ffmpeg");
  EXPECT_NE(message_of([&] { Movie(scratch_ / "film.mp4", 25); }).find("ffmpeg, which is not installed"),
            std::string::npos);
  EXPECT_EQ(scratch_.entries(), 1u);
}

TEST_F(MovieTest, RefusesOtherEndingsAndRates) {
  EXPECT_THROW(movie_format_of("film.avi"), Error);
  EXPECT_EQ(movie_format_of("film.GIF"), MovieFormat::gif);
  EXPECT_THROW(Movie(scratch_ / "film.mp4", 0), Error);
  EXPECT_EQ(scratch_.entries(), 0u);
}

}  // namespace
}  // namespace carom
