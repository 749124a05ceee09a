// Normal maps: frames that follow (u, v), and colors that hold normals.
#include "texture/normal_map.hpp"

#include <doctest.h>
#include <numbers>

#include <cmath>

#include "support/dice.hpp"
#include "support/shown_values.hpp"
#include "texture/bilinear.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

template <class Real>
Hit<Real> hit_with(const Vec3<Real>& normal) {
  return {normal, normal, normal, normal};
}

template <class Real>
TangentFrame<Real> rtiow_frame(const Vec3<Real>& normal, TangentRule rule) {
  const Frame<Real> frame = frame_about(normal);
  const auto uv = uv_rtiow(with_steps(hit_with(normal), frame, Real(1)).normal);
  return tangents(rule, normal, point_by_uv(frame, uv));
}

}  // namespace

TEST_CASE_TEMPLATE("on a sphere dP/du and dP/dv are those of the closed form", Real, float, double,
                   long double) {
  Dice dice(1);
  const Real bound = Real(400) * unit_roundoff<Real>();
  for (int i = 0; i < 500; ++i) {
    const Vec3<Real> n = dice.direction<Real>();
    if (std::abs(n.y) > Real(0.99)) continue;
    const Frame<Real> frame = frame_about(n);
    const TangentFrame<Real> by_uv =
        point_by_uv(frame, uv_rtiow(with_steps(hit_with(n), frame, Real(1)).normal));
    // P = (sin t cos f, -cos t, sin t sin f) with t = pi v and f = pi - 2 pi u.
    const Real turn = Real(2) * pi<Real>();
    const Real from_axis = sqrt(n.x * n.x + n.z * n.z);
    const Vec3<Real> by_u{n.z * turn, Real(0), -n.x * turn};
    const Vec3<Real> by_v{-n.y * n.x / from_axis * pi<Real>(), from_axis * pi<Real>(),
                          -n.y * n.z / from_axis * pi<Real>()};
    CHECK(largest(by_uv.tangent - by_u) < bound);
    CHECK(largest(by_uv.bitangent - by_v) < bound);
  }
}

TEST_CASE(
    "tangent, bitangent and normal form a right-handed frame of unit vectors, by every rule") {
  Dice dice(2);
  for (const TangentRule rule : {TangentRule::from_uv, TangentRule::crossed, TangentRule::fixed}) {
    for (int i = 0; i < 300; ++i) {
      const Vec3d n = dice.direction<double>();
      if (std::abs(n.y) > 0.9999) continue;
      const TangentFrame<double> along = rtiow_frame(n, rule);
      CHECK(std::abs(length(along.tangent) - 1) < 1e-12);
      CHECK(std::abs(dot(along.tangent, n)) < 1e-12);
      CHECK(largest(cross(along.tangent, along.bitangent) - n) < 1e-11);
    }
  }
}

TEST_CASE("at the pole itself the surface's own normal is used, without NaN") {
  const BilinearTexture leaning{Image(2, 2, {200, 90, 230})};
  const NormalMap<RtiowMapping, BilinearTexture> map{.mapping = {}, .texture = leaning};
  for (const double y : {-1.0, 1.0}) {
    CHECK(largest(map(hit_with(Vec3d{0, y, 0}), 1.0) - Vec3d{0, y, 0}) == 0);
  }
  CHECK(map(hit_with(Vec3d{0, 0, 1}), 1.0).x > 0.3);
}

TEST_CASE("a color holds a normal to 1/255 in each part; the flat color leans by 0.32 degrees") {
  Dice dice(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d normal = dice.direction<double>();
    const Rgb8 c = color_of_normal(normal);
    const Vec3d back = normal_of_color(Rgb{c.r / 255.0, c.g / 255.0, c.b / 255.0});
    CHECK(largest(back - normal) <= 1 / 255.0 + 1e-12);
  }
  const Rgb8 flat = color_of_normal({0, 0, 1});
  CHECK(flat == Rgb8{128, 128, 255});
  const Vec3d lean = normalize(normal_of_color(Rgb{128 / 255.0, 128 / 255.0, 1}));
  const double degrees = std::acos(lean.z) * 180 / std::numbers::pi;
  CHECK(degrees == doctest::Approx(0.3178).epsilon(1e-3));
}
