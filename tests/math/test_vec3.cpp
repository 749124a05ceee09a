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
}

TEST_CASE_TEMPLATE("the scalar product obeys its table", Real, float, double, long double) {
  const Vec3<Real> x{1, 0, 0};
  const Vec3<Real> y{0, 1, 0};
  const Vec3<Real> z{0, 0, 1};
  CHECK(dot(Vec3<Real>{1, 2, 3}, {4, -5, 6}) == Real(12));
  CHECK(dot(x, x) == Real(1));
  CHECK(dot(y, y) == Real(1));
  CHECK(dot(z, z) == Real(1));
  CHECK(dot(x, y) == Real(0));
  CHECK(dot(y, z) == Real(0));
  CHECK(dot(z, x) == Real(0));
}

TEST_CASE_TEMPLATE("the vector product follows the right-hand rule", Real, float, double,
                   long double) {
  const Vec3<Real> x{1, 0, 0};
  const Vec3<Real> y{0, 1, 0};
  const Vec3<Real> z{0, 0, 1};
  CHECK(equal(cross(x, y), z));
  CHECK(equal(cross(y, z), x));
  CHECK(equal(cross(z, x), y));
  CHECK(equal(cross(y, x), -z));
  CHECK(equal(cross(Vec3<Real>{1, 2, 3}, {4, -5, 6}), {27, 6, -13}));
}

TEST_CASE_TEMPLATE(
    "the vector product is at a right angle to both, to the last bit for small whole numbers", Real,
    float, double, long double) {
  for (int i = 0; i < 1000; ++i) {
    const auto digit = [i](int k) { return static_cast<Real>((i * k) % 19 - 9); };
    const Vec3<Real> a{digit(1), digit(3), digit(7)};
    const Vec3<Real> b{digit(11), digit(5), digit(13)};
    const Vec3<Real> c = cross(a, b);
    REQUIRE(dot(a, c) == Real(0));
    REQUIRE(dot(b, c) == Real(0));
    REQUIRE(dot(c, c) == dot(a, a) * dot(b, b) - square(dot(a, b)));  // Lagrange's identity
  }
}

TEST_CASE_TEMPLATE("lengths of whole boxes are whole", Real, float, double, long double) {
  CHECK(length(Vec3<Real>{2, 3, 6}) == Real(7));
  CHECK(length(Vec3<Real>{-1, 2, -2}) == Real(3));
  CHECK(length(Vec3<Real>{0, -5, 0}) == Real(5));
  CHECK(length(Vec3<Real>{0, 0, 0}) == Real(0));
}

TEST_CASE("a length is within 2.5 unit roundoffs, and hardly less") {
  // Both squares and both sums are rounded down, and so is the root.
  const Vec3<float> a{0x1.6a8106p-1F, 0x1.6a21ep-1F, 0x1p-12F};
  const double off = 1 - length(a) / length(number_cast<double>(a));
  CHECK(off < 2.5 * 0x1p-24);
  CHECK(off > 2.49 * 0x1p-24);
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
  for (int i = 1; i <= 1000; ++i) {
    const Vec3<Real> a{static_cast<Real>(i), static_cast<Real>(i * i % 101 - 50),
                       static_cast<Real>(i * 7 % 89 - 44)};
    const Vec3<Real> unit = normalize(a);
    REQUIRE(abs(length(unit) - Real(1)) <= Real(3) * eps);
    REQUIRE(length(cross(a, unit)) <= Real(4) * eps * length(a));
    REQUIRE(dot(a, unit) > Real(0));
  }
}

TEST_CASE_TEMPLATE("the zero vector has no direction", Real, float, double, long double) {
  const Vec3<Real> n = normalize(Vec3<Real>{0, 0, 0});
  CHECK(n.x != n.x);
  CHECK(n.y != n.y);
  CHECK(n.z != n.z);
}

TEST_CASE_TEMPLATE("select takes whole vectors", Real, float, double, long double) {
  CHECK(equal(select(true, Vec3<Real>{1, 2, 3}, Vec3<Real>{4, 5, 6}), {1, 2, 3}));
  CHECK(equal(select(false, Vec3<Real>{1, 2, 3}, Vec3<Real>{4, 5, 6}), {4, 5, 6}));
}

TEST_CASE_TEMPLATE("number_cast keeps each coordinate in its place and rounds once", Real, float,
                   double, long double) {
  CHECK(equal(number_cast<Real>(Point{0.1, 0.2, 0.3}),
              {static_cast<Real>(0.1), static_cast<Real>(0.2), static_cast<Real>(0.3)}));
}

}  // namespace
}  // namespace texmap::test
