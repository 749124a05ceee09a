// SSIM of two pictures as other programs compute it; all other figures: test_compare_program. The
// map of differences, as a picture that was looked at: its scale, its legend, and that it lies
// where the pictures do. With TEXMAP_COLLECT=1 the suite writes the picture again.
#include <doctest.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "engine/compare/difference.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/made_pictures.hpp"
#include "support/same_picture.hpp"

using namespace texmap;
using namespace texmap::test;

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
