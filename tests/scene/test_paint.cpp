// Tests of scene/paint.hpp and texture/mapped.hpp, paints, and one of several paints; and of
// scene/sky.hpp, the gradient that a ray sees which hits nothing.
#include <doctest.h>

#include "scene/paint.hpp"
#include "scene/sky.hpp"
#include "texture/mapped.hpp"

namespace texmap::test {
namespace {

/// A paint that shows the normal.
struct NormalPaint {
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
    return {hit.normal.x, hit.normal.y, hit.normal.z};
  }
};

/// A texture that shows its coordinates.
struct UvTexture {
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    return {uv.u, uv.v, Real(0)};
  }
};

using Either = AnyOf<Solid, NormalPaint, Mapped<RtiowMapping, UvTexture>>;

template <class Real>
bool equal(const Color<Real>& a, const Color<Real>& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

TEST_CASE_TEMPLATE("of several paints the one that is there is asked", Real, float, double,
                   long double) {
  const Hit<Real> hit{{0, 0, -1}, {1, 1, 1}, {1, 1, 1}};
  CHECK(equal(Either{Solid{{0.25, 0.5, 1}}}(hit), {Real(0.25), Real(0.5), 1}));
  CHECK(equal(Either{NormalPaint{}}(hit), {0, 0, -1}));
  CHECK(equal(Either{Mapped<RtiowMapping, UvTexture>{}}(hit), {Real(0.75), Real(0.5), 0}));
  CHECK(equal(Either{}(hit), {0, 0, 0}));  // the first kind, as it is when nobody says more
  Painted<Either> object{{{1, 2, 3}, 4}, NormalPaint{}};
  object.paint = Solid{{0.5, 0.5, 0.5}};
  CHECK(equal(object.paint(hit), {Real(0.5), Real(0.5), Real(0.5)}));
}

TEST_CASE_TEMPLATE("a sky of one color has it to the bit", Real, float, double, long double) {
  const GradientSky plain{.below = {0.3, 0.6, 0.9}, .above = {0.3, 0.6, 0.9}};
  CHECK(plain.is_constant());
  CHECK_FALSE(GradientSky{.below = {1, 1, 1}, .above = {1, 1, 0.5}}.is_constant());
  CHECK(plain(Ray<Real>{{0, 0, 0}, {0, Real(0.1L), 0}}).g == Real(0.6));
}

}  // namespace
}  // namespace texmap::test
