// Tests of common/math/vec3.hpp: sizes of vectors. How exact its operations are, tests/extremes
// searches.
#include <doctest.h>

#include "math/vec3.hpp"

namespace texmap::test {
namespace {

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

TEST_CASE("a vector without a length has no direction") {
  const Vec3d none = normalize(Vec3d{0, 0, 0});
  CHECK((none.x != none.x && none.y != none.y && none.z != none.z));
}

}  // namespace
}  // namespace texmap::test
