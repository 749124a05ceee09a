// Tests of common/math/vec3.hpp: the operations on points and directions.
#include <doctest.h>

#include "math/vec3.hpp"

namespace texmap::test {
namespace {

template <class Real>
bool equal(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

TEST_CASE_TEMPLATE("vectors add, subtract, turn round and stretch coordinate by coordinate", Real,
                   float, double, long double) {
  const Vec3<Real> a{1, 2, 3};
  const Vec3<Real> b{4, -5, 6};
  CHECK(equal(a + b, {5, -3, 9}));
  CHECK(equal(a - b, {-3, 7, -3}));
  CHECK(equal(-b, {-4, 5, -6}));
  CHECK(equal(b * Real(0.5), {2, Real(-2.5), 3}));
  CHECK(equal(select(true, a, b), a));
  CHECK(equal(select(false, a, b), b));
  CHECK(equal(number_cast<Real>(Point{0.1, 0.2, 0.3}), {Real(0.1), Real(0.2), Real(0.3)}));
}

TEST_CASE_TEMPLATE("the vector product follows the right-hand rule", Real, float, double,
                   long double) {
  const Vec3<Real> axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 3; ++i) {
    const Vec3<Real>& x = axes[i];
    const Vec3<Real>& y = axes[(i + 1) % 3];
    CHECK(equal(cross(x, y), axes[(i + 2) % 3]));
    CHECK(equal(cross(y, x), -axes[(i + 2) % 3]));
    CHECK(dot(x, x) == Real(1));
    CHECK(dot(x, y) == Real(0));
  }
  CHECK(dot(Vec3<Real>{1, 2, 3}, {4, -5, 6}) == Real(12));
  CHECK(equal(cross(Vec3<Real>{1, 2, 3}, {4, -5, 6}), {27, 6, -13}));
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
