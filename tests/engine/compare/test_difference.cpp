// SSIM of two pictures as other programs compute it; all other figures: test_compare_program. The
// map of differences, as a picture that was looked at: its scale, its legend, and that it lies
// where the pictures do. With TEXMAP_COLLECT=1 the suite writes the picture again. And
// expect_same_picture: what a failure says, and how doctest shows the course's types.
#include <doctest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "engine/compare/difference.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "support/made_pictures.hpp"
#include "support/pictures.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

namespace texmap::test {

TEST_CASE("SSIM is that of other programs, in every run, and only where it is asked for") {
  const Image right_half = image_of(30, 16, [](int column, int) {
    return column < 15 ? Rgb8{} : Rgb8{255, 255, 255};
  });
  const struct {
    Image a, b, mask;
    double ssim;
  } pairs[] = {
      // scikit-image 0.19, see docs/numerics.md.
      {noise(97, 61, 16), noise(97, 61, 17), {}, 0.007323859550020152},
      {ramps(120, 90), ramps(120, 90, 1), {}, 0.5693023480677195},
      // By a sum over each window. No window lies inside a picture of ten rows: then all count.
      {noise(40, 10, 9), noise(40, 10, 10), {}, 0.056781586082690766},
      {noise(3, 2, 5), noise(3, 2, 6), {}, 0.23723056631458642},
      {noise(30, 16, 18), noise(30, 16, 19), right_half, -0.00217450787128225},
  };
  for (const auto& [a, b, mask, ssim] : pairs) {
    const Figures all = measure(a, b, mask);
    CHECK(std::abs(all.structural_similarity - ssim) < 1e-13);
    CHECK(measure(a, b, mask).structural_similarity == all.structural_similarity);
    CHECK(std::isnan(measure(a, b, mask, Detail::pixels).structural_similarity));
    CHECK(measure(a, a, mask, Detail::pixels).structural_similarity == 1);
  }
}

TEST_CASE("pictures without pixels are not compared") {
  CHECK_THROWS_WITH_AS((void)measure(Image(), Image()), "the pictures are empty", DifferenceError);
}

TEST_CASE("each level has its color at its place, and the legend says which") {
  const Image a(256, 24, {255, 128, 0});
  Image b = a, mask(256, 24, {255, 255, 255});
  for (int level = 0; level < 256; ++level) {
    for (int row = 0; row < 12; ++row) {
      b.at(level, row).r = static_cast<std::uint8_t>(255 - level);
      b.at(level, row + 12).b = static_cast<std::uint8_t>(level);
      if (level >= 40 && level < 80) mask.at(level, row + 6) = {};
    }
  }
  for (const auto& [name, left_out] :
       {std::pair{"difference_map", Image()}, {"difference_map_with_mask", mask}}) {
    const std::string file = std::string(TEXMAP_TESTS_DIR "/engine/compare/") + name + ".png";
    const Image map = difference_map(a, b, left_out);
    if (std::getenv("TEXMAP_COLLECT") != nullptr) save_png(map, file);
    expect_same_picture(map, load_image(file), {.pixels = 0, .levels = 1});
  }
}

TEST_CASE("as high as a file may be a map has no legend, and of other sizes there is none") {
  const Image a(2, static_cast<int>(max_image_side), {9, 9, 9});
  CHECK(difference_map(a, a).width == 2);
  CHECK(difference_map(a, a).height == a.height);
  CHECK_THROWS_AS((void)difference_map(Image(2, 3), Image(3, 2)), DifferenceError);
  CHECK_THROWS_AS((void)difference_map(Image(2, 3), Image(2, 3), Image(2, 2)), DifferenceError);
}

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

}  // namespace texmap::test
