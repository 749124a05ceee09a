// Tests of common/texture/encoded.hpp: light as the channels of a picture.
#include "texture/encoded.hpp"

#include <doctest.h>

#include "math/srgb.hpp"

namespace texmap::test {
namespace {

TEST_CASE_TEMPLATE("it is the curve of math/srgb.hpp, and meets both ends exactly", Real, float,
                   double, long double) {
  CHECK(encoded(Real(0)) == 0);
  CHECK(encoded(Real(1)) == 1);
  CHECK(encoded(Real(-1)) == 0);
  CHECK(encoded(std::numeric_limits<Real>::quiet_NaN()) == 0);
  for (int i = 1; i < 3000; ++i) {
    const Real light = Real(i) / Real(3000);
    CHECK(abs(encoded(light) - srgb_encode(light)) <= Real(8) * unit_roundoff<Real>());
  }
}

TEST_CASE("every byte of a file comes back, if half a byte is added before it is cut off") {
  int wrong = 0, wrong_without = 0;
  for (int byte = 0; byte < 256; ++byte) {
    const double back = encoded(srgb_decode(byte / 255.0)) * 255;
    wrong += static_cast<int>(back + 0.5) != byte ? 1 : 0;
    wrong_without += static_cast<int>(back) != byte ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(wrong_without > 0);
}

}  // namespace
}  // namespace texmap::test
