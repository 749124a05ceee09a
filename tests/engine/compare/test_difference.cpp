// SSIM of two pictures as other programs compute it. All other figures: test_compare_program.
#include <doctest.h>

#include <cmath>

#include "engine/compare/difference.hpp"
#include "support/made_pictures.hpp"

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
