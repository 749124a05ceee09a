// Tests of common/math/vec3.hpp: the operations on points and directions.
#include <doctest.h>

#include "math/vec3.hpp"

namespace texmap::test {
namespace {

template <class Real>
bool equal(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

TEST_CASE_TEMPLATE("lengths of whole boxes are whole", Real, float, double, long double) {
  CHECK(length(Vec3<Real>{2, 3, 6}) == Real(7));
  CHECK(length(Vec3<Real>{-1, 2, -2}) == Real(3));
  CHECK(length(Vec3<Real>{0, -5, 0}) == Real(5));
  CHECK(length(Vec3<Real>{0, 0, 0}) == Real(0));
}

TEST_CASE("a length is exact over the range its comment promises") {
  CHECK(length(Point{3e150, 0, 4e150}) == doctest::Approx(5e150).epsilon(1e-15));
  CHECK(length(Point{3e-150, 4e-150, 0}) == doctest::Approx(5e-150).epsilon(1e-15));
}

TEST_CASE_TEMPLATE("largest finds the largest coordinate in size, whatever its sign and place",
                   Real, float, double, long double) {
  const Real max = std::numeric_limits<Real>::max();
  CHECK(largest(Vec3<Real>{-7, 2, 3}) == Real(7));
  CHECK(largest(Vec3<Real>{2, -7, 3}) == Real(7));
  CHECK(largest(Vec3<Real>{2, 3, -7}) == Real(7));
  CHECK(largest(Vec3<Real>{2, 7, 3}) == Real(7));
  CHECK(largest(Vec3<Real>{0, 0, 0}) == Real(0));
  CHECK(largest(Vec3<Real>{-max, max, -max}) == max);
}

TEST_CASE_TEMPLATE("a normalized vector has unit length and its direction", Real, float, double,
                   long double) {
  const Real eps = std::numeric_limits<Real>::epsilon();
  const Vec3<Real> n = normalize(Vec3<Real>{0, -3, 4});
  CHECK(n.x == Real(0));
  CHECK(abs(n.y + Real(0.6L)) <= eps);
  CHECK(abs(n.z - Real(0.8L)) <= eps);
  CHECK(equal(normalize(Vec3<Real>{0, 0, -4}), {0, 0, -1}));
  const Vec3<Real> none = normalize(Vec3<Real>{0, 0, 0});
  CHECK((none.x != none.x && none.y != none.y && none.z != none.z));
}

}  // namespace
}  // namespace texmap::test
