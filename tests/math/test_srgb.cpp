// The sRGB curve.
#include <doctest.h>

#include "math/srgb.hpp"

using texmap::srgb_decode;
using texmap::srgb_encode;

// Reference values were computed with 50 digits from the standard's formulas.
TEST_CASE("the curve goes through its exact points") {
  struct Point {
    double encoded, linear;
  };
  const Point points[] = {
      {0.0, 0.0},
      {0.01, 0.00077399380804953560},
      {0.04, 0.00309597523219814241},
      {0.05, 0.00393593950408896507},
      {0.1, 0.01002282557486903355},
      {0.25, 0.05087608817155679056},
      {0.5, 0.21404114048223244240},
      {0.75, 0.52252155396839181772},
      {1.0, 1.0},
  };
  for (const Point& point : points) {
    CAPTURE(point.encoded);
    CHECK(std::abs(srgb_decode(point.encoded) - point.linear) <= 1e-15 * point.linear);
    CHECK(std::abs(srgb_encode(point.linear) - point.encoded) <= 8e-16);
  }
}

TEST_CASE("both pieces of the curve meet at the standard's two thresholds") {
  const double below = srgb_decode(0.04045);
  const double above = srgb_decode(std::nextafter(0.04045, 1.0));
  CHECK(below == 0.04045 / 12.92);
  CHECK(above > below);
  CHECK(above - below < 2e-7);
  const double dark = srgb_encode(0.0031308);
  const double bright = srgb_encode(std::nextafter(0.0031308, 1.0));
  CHECK(dark == 0.0031308 * 12.92);
  CHECK(std::abs(bright - dark) < 2e-7);
}

TEST_CASE("NaN stays NaN in both curves") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(srgb_decode(nan)));
  CHECK(std::isnan(srgb_encode(nan)));
}
