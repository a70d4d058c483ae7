// Property: a file's ending alone decides the format; any other name is refused with a message that names the file.
#include "carom/draw/format.hpp"

#include <gtest/gtest.h>

#include "carom/base/error.hpp"

namespace carom {
namespace {

TEST(PictureFormatOf, KnowsTheThreeEndings) {
  EXPECT_EQ(picture_format_of("a.svg"), PictureFormat::svg);
  EXPECT_EQ(picture_format_of("folder.png/a.b.pdf"), PictureFormat::pdf);
  EXPECT_EQ(picture_format_of("A.PNG"), PictureFormat::png);
}

TEST(PictureFormatOf, RefusesOthersByName) {
  for (const char* path : {"", "svg", "a.svg.gz", "a.jpg", "a.png/b", "a.pngx"}) {
    try {
      picture_format_of(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), "cannot draw to " + std::string(path) + ": give a name that ends in .svg, .png or .pdf");
    }
  }
}

}  // namespace
}  // namespace carom
