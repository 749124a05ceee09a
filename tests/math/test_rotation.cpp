// Tests of common/math/rotation.hpp, turns about the vertical axis, in degrees; of math/circle.hpp,
// turns of the unit circle; and of math/vec3.hpp. How exact they are, tests/extremes searches.
#include <doctest.h>

#include "math/rotation.hpp"

namespace texmap::test {
namespace {

template <class Real>
bool equal(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

TEST_CASE_TEMPLATE("an angle that is no number gives no number", Real, float, double, long double) {
  for (const Real degrees :
       {std::numeric_limits<Real>::quiet_NaN(), infinity<Real>(), -infinity<Real>()}) {
    const OnCircle<Real> angle = on_circle_of_degrees(degrees);
    CHECK(angle.sine != angle.sine);
    CHECK(angle.cosine != angle.cosine);
  }
}

TEST_CASE_TEMPLATE("the lecture's matrix carries the axes round: +z to +x to -z to -x", Real, float,
                   double, long double) {
  const Vec3<Real> x{1, 0, 0};
  const Vec3<Real> y{0, 1, 0};
  const Vec3<Real> z{0, 0, 1};
  CHECK(equal(rotation_y(90)(z), x));
  CHECK(equal(rotation_y(90)(x), -z));
  CHECK(equal(rotation_y(90)(-z), -x));
  CHECK(equal(rotation_y(90)(-x), z));
  CHECK(equal(rotation_y(90)(y), y));
  CHECK(equal(rotation_y(180)(Vec3<Real>{1, 2, 3}), {-1, 2, -3}));
  CHECK(equal(rotation_y(270)(Vec3<Real>{1, 2, 3}), {-3, 2, 1}));
  CHECK(equal(rotation_y(-90)(Vec3<Real>{1, 2, 3}), {-3, 2, 1}));
  CHECK(equal(rotation_y(0)(Vec3<Real>{1, 2, 3}), {1, 2, 3}));
  CHECK(equal(rotation_y(-720)(Vec3<Real>{1, 2, 3}), {1, 2, 3}));
  CHECK(equal(RotationY{}(Vec3<Real>{1, 2, 3}), {1, 2, 3}));
}

TEST_CASE_TEMPLATE("cosine and sine of turns are the library's, and exact at quarters", T, float,
                   double, long double) {
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const OnCircle<T> at = on_circle(static_cast<T>(quarter) / 4);
    const int wrapped = ((quarter % 4) + 4) % 4;
    CAPTURE(quarter);
    CHECK(at.cosine == (wrapped == 0 ? 1 : wrapped == 2 ? -1 : 0));
    CHECK(at.sine == (wrapped == 1 ? 1 : wrapped == 3 ? -1 : 0));
  }
  // As far as 1 / (8 unit roundoffs), and a quarter turn beyond each whole number.
  for (T turns = 1; turns < 1 / (8 * unit_roundoff<T>()); turns *= 2) {
    CAPTURE(turns);
    CHECK(on_circle(turns + T(0.25)).sine == 1);
    CHECK(on_circle(turns + T(0.25)).cosine == 0);
    CHECK(on_circle(-turns - T(0.25)).sine == -1);
  }
}

TEST_CASE("a vector without a length has no direction") {
  const Vec3d none = normalize(Vec3d{0, 0, 0});
  CHECK((none.x != none.x && none.y != none.y && none.z != none.z));
}

}  // namespace
}  // namespace texmap::test
