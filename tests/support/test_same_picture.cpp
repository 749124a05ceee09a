// expect_same_picture: what a failure says, and how doctest shows the course's types.
#include "support/same_picture.hpp"

#include <doctest.h>

#include "support/made_pictures.hpp"
#include "support/pictures.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("equal pictures have no report, and so do differences that are allowed") {
  const Image right = ramps(64, 48);
  Image other = right;
  expect_same_picture(right, right);
  CHECK(difference_report(right, right).empty());
  other.at(20, 30).r ^= 1;
  CHECK(difference_report(other, right, {.pixels = 1}).empty());
  CHECK(difference_report(other, right, {.levels = 1}).empty());
  CHECK_FALSE(difference_report(other, right).empty());
}

TEST_CASE("a report says how many pixels differ, in which box, and the first with both values") {
  const Image right(64, 48, {10, 20, 30});
  Image other = right;
  other.at(20, 30) = {11, 22, 33};
  other.at(7, 40) = {0, 0, 0};
  other.at(50, 31) = {0, 0, 0};
  CHECK(difference_report(other, right) ==
        "3 of 3072 pixels differ, in columns 7 to 50, rows 30 to 40\n"
        "  the first, in column 20 and row 30, is (11, 22, 33) and should be (10, 20, 30)");
  CHECK(difference_report(Image(64, 47), right) ==
        "the picture is 64 x 47 pixels, and should be 64 x 48");
}

TEST_CASE("a report names a known mistake, of the whole picture or of those that it is given") {
  const Image right = ramps(64, 48);
  CHECK(difference_report(upside_down(right), right).find("upside down") != std::string::npos);
  const Image own = noise(64, 48, 4);
  const auto wrong = [&] {
    return std::vector<WrongPicture>{{"own", "a mistake of its own", own}};
  };
  CHECK(difference_report(own, right, {}, wrong).ends_with("\n  a mistake of its own"));
  CHECK(difference_report(own, right).find("mistake") == std::string::npos);
}

TEST_CASE("a failure shows what it compared") {
  CHECK(doctest::toString(Rgb8{1, 2, 3}) == "(1, 2, 3)");
  CHECK(doctest::toString(Rgb{0.5, 0.25, 0.75}) == "(0.5, 0.25, 0.75)");
  CHECK(doctest::toString(Vec3d{1.5, -2.5, 3.5}) == "(1.5, -2.5, 3.5)");
  CHECK(doctest::toString(Uv<double>{0.5, 0.25}) == "(0.5, 0.25)");
  CHECK(doctest::toString(Image(4, 3)) == "a picture of 4 x 3 pixels");
  CHECK(doctest::toString(std::vector<int>(12, 7)) == "[7, 7, 7, 7, 7, 7, 7, 7, 7, 7, and 2 more]");
}
