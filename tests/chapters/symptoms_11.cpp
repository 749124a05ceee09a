// Chapter 11's symptoms: normals that lean downhill, from heights and from colors, with the word.
#include "support/symptoms.hpp"
#include "texture/bump.hpp"
#include "texture/normal_map.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

const Vec3d towards_us{0, 0, 1};
constexpr Frame<double> frame{{1, 0, 0}, {0, 1, 0}};

/// A color everywhere, and coordinates that follow the surface: u along x, v along y.
struct OneColor {
  Rgb color;
  template <class Real>
  Color<Real> operator()(const Uv<Real>&) const {
    return number_cast<Real>(color);
  }
};
struct AlongTheSurface {
  template <template <class> class AnyHit, class Real>
  Uv<Real> operator()(const AnyHit<Real>& hit) const {
    return {hit.point.x, hit.point.y};
  }
};

Vec3d normal_from(const Rgb& color, Green green) {
  Hit<double> hit;
  hit.normal = towards_us;
  return NormalMap<AlongTheSurface, OneColor>{{}, {color}, green}(hit, 0.0);
}

}  // namespace

TEST_CASE("the normal of a slope leans downhill") {
  const Vec3d normal =
      raised_normal(towards_us, frame, Slope<double>{0, 1, 0}, 0.0, BumpForm::exact);
  const double half = std::sqrt(0.5);
  expect_number("x of the normal where the height grows by 1 per unit to the right", normal.x,
                -half,
                {{half, "it leans uphill: dents in place of bumps"},
                 {-1, "the normal was not made a unit vector"},
                 {0, "the slope to the right was not used"}});
  const Vec3d up = raised_normal(towards_us, frame, Slope<double>{0, 0, 1}, 0.0, BumpForm::exact);
  expect_number("y of the normal where the height grows by 1 per unit upward", up.y, -half,
                {{half, "it leans uphill: dents in place of bumps"},
                 {0, "the slope upward was not used, or the two slopes are exchanged"}});
}

TEST_CASE("a color means a normal: each channel from 0 to 1 is -1 to 1") {
  const Vec3d flat = normal_of_color<double>({0.5, 0.5, 1});
  expect_number("x of the color (1/2, 1/2, 1)", flat.x, 0,
                {{0.5, "2c - 1 is missing: every normal leans to the upper right"}});
  expect_number("z of the color (1/2, 1/2, 1)", flat.z, 1,
                {{0, "red and blue are exchanged (BGR)"}});
}

TEST_CASE("red leans to the right, green leans up, or down where the file says so") {
  const Rgb right{0.8, 0.5, 0.9}, upward{0.5, 0.8, 0.9};
  expect_that(normal_from(right, Green::up).x > 0.1, "more red leans to the right",
              "u runs the other way (mirrored)");
  expect_that(normal_from(upward, Green::up).y > 0.1, "more green leans up",
              "green counts the other way: dents in place of bumps");
  expect_that(normal_from(upward, Green::down).y < -0.1,
              "more green leans down in a file whose green points down",
              "green counts the other way: dents in place of bumps");
}
