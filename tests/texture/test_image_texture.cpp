// Tests of common/texture/texel.hpp and image_texture.hpp: which texel of a picture a coordinate
// shows, one that is safe to index with. Places outside 0 to 1, tests/extremes searches.
#include <doctest.h>

#include "published/uv.hpp"
#include "support/whole_numbers.hpp"
#include "texture/image_texture.hpp"
#include "texture/texel.hpp"

namespace texmap::test {
namespace {

TEST_CASE_TEMPLATE("texels are half-open: each holds its lower edge", Real, float, double,
                   long double) {
  struct Row {
    double u;
    int n, index;
  };
  const Row table[] = {
      {0, 4, 0},     {0.125, 4, 0}, {0.25, 4, 1},  {0.375, 4, 1}, {0.5, 4, 2}, {0.75, 4, 3},
      {0.875, 4, 3}, {0, 1, 0},     {0.999, 1, 0}, {0.5, 2, 1},   {0.5, 3, 1}, {0.75, 3, 2},
  };
  for (const Row& row : table) {
    CAPTURE(row.u);
    CHECK(test::texel_index(static_cast<Real>(row.u), row.n) == static_cast<Real>(row.index));
  }
  CHECK(test::texel_index(std::nextafter(Real(0.25), Real(0)), 4) == Real(0));
  CHECK(test::texel_index(std::nextafter(Real(0.75), Real(0)), 4) == Real(2));
  for (int k = 0; k < 4096; ++k)
    REQUIRE(test::texel_index(static_cast<Real>(k) / Real(4096), 4096) == static_cast<Real>(k));
}

TEST_CASE_TEMPLATE("no coordinate leaves the image: NaN gives 0 and the rest is clamped", Real,
                   float, double, long double) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const int n : {1, 2, 8192, 1 << 24}) {
    const auto last = static_cast<Real>(n - 1);
    CHECK(test::texel_index(nan, n) == Real(0));
    CHECK(test::texel_index(-infinity<Real>(), n) == Real(0));
    CHECK(test::texel_index(infinity<Real>(), n) == last);
    CHECK(clamp_number(nan, n) == 0);
    CHECK(clamp_number(static_cast<Real>(n), n) == n - 1);
  }
}

TEST_CASE("the lecture's rounding is that of its program") {
  for (int i = 0; i <= 100000; ++i) {
    const double v = i / 100000.0;
    REQUIRE(4095 - static_cast<int>(test::texel_index(v, 4096, TexelRounding::lecture)) ==
            published::row_lecture(v, 4096));
  }
}

/// 3 x 2 texels, all channels different: red 10 column, green 20 row, blue 100 + column + 3 row.
Image small_image() {
  return image_of(3, 2, [](int column, int row) {
    return Rgb8{static_cast<std::uint8_t>(10 * column), static_cast<std::uint8_t>(20 * row),
                static_cast<std::uint8_t>(100 + column + 3 * row)};
  });
}

template <class Real>
bool shows(const Color<Real>& color, const Rgb8& texel) {
  return color.r == static_cast<Real>(texel.r) / Real(255) &&
         color.g == static_cast<Real>(texel.g) / Real(255) &&
         color.b == static_cast<Real>(texel.b) / Real(255);
}

TEST_CASE_TEMPLATE(
    "each texel is shown at its center and from its lower corner on, for both axes of v", Real,
    float, double, long double) {
  const Image image = small_image();
  const ImageTexture up{image, VAxis::up};
  const ImageTexture down{image, VAxis::down};
  const Real third = std::nextafter(Real(1) / Real(3), Real(1));  // floor(3 u) is 1 from here on
  const Real two_thirds = std::nextafter(Real(2) / Real(3), Real(1));  // and 2 from here on
  const Real lower[] = {0, third, two_thirds};
  for (int column = 0; column < 3; ++column) {
    for (int step = 0; step < 2; ++step) {
      CAPTURE(column);
      CAPTURE(step);
      const Real center_u = (static_cast<Real>(column) + Real(0.5)) / Real(3);
      const Real center_v = (static_cast<Real>(step) + Real(0.5)) / Real(2);
      const Real lower_v = static_cast<Real>(step) / Real(2);
      CHECK(shows(down(Uv<Real>{center_u, center_v}), image.at(column, step)));
      CHECK(shows(up(Uv<Real>{center_u, center_v}), image.at(column, 1 - step)));
      CHECK(shows(down(Uv<Real>{lower[column], lower_v}), image.at(column, step)));
      CHECK(shows(up(Uv<Real>{lower[column], lower_v}), image.at(column, 1 - step)));
    }
  }
}

TEST_CASE_TEMPLATE("the lecture's rounding reaches the last row and column at 1 alone", Real, float,
                   double, long double) {
  const Image image = small_image();
  const ImageTexture down{image, VAxis::down, TexelRounding::lecture};
  const ImageTexture up{image, VAxis::up, TexelRounding::lecture};
  CHECK(shows(down(Uv<Real>{0, 0}), image.at(0, 0)));
  CHECK(shows(down(Uv<Real>{Real(0.5), Real(0.75)}), image.at(1, 0)));
  CHECK(shows(down(Uv<Real>{below_one<Real>(), below_one<Real>()}), image.at(1, 0)));
  CHECK(shows(down(Uv<Real>{1, 1}), image.at(2, 1)));
  CHECK(shows(up(Uv<Real>{0, 0}), image.at(0, 1)));
  CHECK(shows(up(Uv<Real>{Real(0.25), Real(0.75)}), image.at(0, 1)));
  CHECK(shows(up(Uv<Real>{1, 1}), image.at(2, 0)));
  for (const Image& empty : {Image{}, Image(0, 5), Image(5, 0)})
    CHECK(shows(ImageTexture{empty}(Uv<Real>{Real(0.5), Real(0.5)}), {0, 0, 0}));
}

}  // namespace
}  // namespace texmap::test
