// Bumps: slopes from duals and from differences, the normals they give, and scene/steps.hpp, a hit
// with derivatives along the surface. Normal maps: frames that follow (u, v), and colors that hold
// normals.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/color.hpp"
#include "support/dice.hpp"
#include "support/shown_values.hpp"
#include "texture/bilinear.hpp"
#include "texture/bump.hpp"
#include "texture/normal_map.hpp"

namespace texmap::test {
namespace {

/// Half of how far an ellipsoid with half-axes a, b, c lies outside the unit sphere, along its
/// normal: with a relief of 2 it is the ellipsoid.
struct EllipsoidHeight {
  double a = 1.5, b = 0.75, c = 1.25;

  template <class Real>
  Color<Real> operator()(const Hit<Real>& hit) const {
    const Vec3<Real> n = hit.normal;
    const Real x = n.x / Real(a);
    const Real y = n.y / Real(b);
    const Real z = n.z / Real(c);
    return gray((Real(1) / sqrt(x * x + y * y + z * z) - Real(1)) * Real(0.5));
  }
  /// The ellipsoid's normal where the ray from its center along `n` leaves it.
  template <class Real>
  Vec3<Real> normal(const Vec3<Real>& n) const {
    return normalize(Vec3<Real>{n.x / (Real(a) * Real(a)), n.y / (Real(b) * Real(b)),
                                n.z / (Real(c) * Real(c))});
  }
};

template <class Real>
Hit<Real> hit_with(const Vec3<Real>& normal) {
  return {normal, normal, normal};
}
template <class Real>
Hit<Real> hit_with(const Vec3<long double>& normal) {
  const Vec3<Real> n = normalize(Vec3<Real>{
      number_cast<Real>(normal.x), number_cast<Real>(normal.y), number_cast<Real>(normal.z)});
  return hit_with(n);
}

/// The angle between two unit vectors, without a loss of digits where it is small.
template <class Real>
double angle(const Vec3<Real>& p, const Vec3<Real>& q) {
  const Vec3<long double> a{static_cast<long double>(p.x), static_cast<long double>(p.y),
                            static_cast<long double>(p.z)};
  const Vec3<long double> b{static_cast<long double>(q.x), static_cast<long double>(q.y),
                            static_cast<long double>(q.z)};
  return static_cast<double>(std::atan2(length(cross(a, b)), dot(a, b)));
}

/// The largest angle to the ellipsoid's normal over many directions.
template <class Real>
double worst_on_ellipsoid() {
  Dice dice(11);
  const Bumps<EllipsoidHeight> bumps{.height = {}, .relief = 2};
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Hit<Real> hit = hit_with<Real>(dice.direction());
    worst = std::max(worst, angle(bumps(hit, Real(1)), bumps.height.normal(hit.normal)));
  }
  return worst;
}

TEST_CASE("a sphere raised to an ellipsoid has the ellipsoid's normal") {
  CHECK(worst_on_ellipsoid<float>() < 1e-6);
  CHECK(worst_on_ellipsoid<double>() < 2e-15);
  CHECK(worst_on_ellipsoid<long double>() < 2e-18 + 2e-15 * (sizeof(long double) == 8));
}

TEST_CASE("without the term h dn the slope is too large by exactly 1 + h / R") {
  Dice dice(12);
  for (const double radius : {0.5, 1.0, 20.0}) {
    for (int i = 0; i < 500; ++i) {
      const Hit<double> hit = hit_with<double>(dice.direction());
      const Bumps<EllipsoidHeight> exact{.height = {}, .relief = 2};
      Bumps<EllipsoidHeight> blinn = exact;
      blinn.form = BumpForm::blinn;
      const double h = 2 * exact.height(hit).r;
      const double lean = std::tan(angle(exact(hit, 1 / radius), hit.normal));
      const double lean_of_blinn = std::tan(angle(blinn(hit, 1 / radius), hit.normal));
      CHECK(lean_of_blinn == doctest::Approx((1 + h / radius) * lean).epsilon(1e-12));
    }
  }
}

TEST_CASE("slopes that are not numbers, or too large to square, leave the normal alone") {
  const Vec3d n{0, 0, 1};
  const Frame<double> frame = frame_about(n);
  const double infinite = infinity<double>();
  for (const double slope : {std::nan(""), infinite, -infinite, 1e200}) {
    for (const Slope<double>& bad : {Slope<double>{0, slope, 0}, Slope<double>{0, 1, slope}}) {
      CHECK(largest(raised_normal(n, frame, bad, 1.0, BumpForm::exact) - n) == 0);
    }
  }
  CHECK(raised_normal(n, frame, {0.0, 1.0, 0.0}, 1.0, BumpForm::exact).x ==
        doctest::Approx(-std::sqrt(0.5)));
}

TEST_CASE("on a sphere, the normal with steps is what the point with steps gives") {
  const auto by_x = [](const Vec3<Dual<double>>& p) { return Vec3d{p.x.dx, p.y.dx, p.z.dx}; };
  const auto by_y = [](const Vec3<Dual<double>>& p) { return Vec3d{p.x.dy, p.y.dy, p.z.dy}; };
  Dice dice(1);
  for (const double radius : {0.25, 1.0, 40.0}) {
    for (int i = 0; i < 300; ++i) {
      const Vec3d normal = dice.direction<double>();
      const Hit<double> hit{normal, normal * radius, {}};
      const Frame<double> frame = frame_about(normal);
      const Hit<Dual<double>> moving = with_steps(hit, frame, 1 / radius);
      const Vec3<Dual<double>> expected = normalize(moving.point);
      CHECK(largest(by_x(moving.normal) - by_x(expected)) < 1e-15 / radius);
      CHECK(largest(by_y(moving.normal) - by_y(expected)) < 1e-15 / radius);
      // One step of length 1 along each vector of the frame.
      CHECK(largest(by_x(moving.point) - frame.right) == 0);
      CHECK(largest(by_y(moving.point) - frame.up) == 0);
      CHECK(moving.normal.x.value == normal.x);
    }
  }
}

TEST_CASE_TEMPLATE(
    "on a sphere dP/du and dP/dv are those of the closed form; by every rule tangent, bitangent "
    "and "
    "normal form a right-handed frame of unit vectors",
    Real, float, double, long double) {
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
    for (const TangentRule rule :
         {TangentRule::from_uv, TangentRule::crossed, TangentRule::fixed}) {
      const TangentFrame<Real> along = tangents(rule, n, by_uv);
      CHECK(std::abs(length(along.tangent) - Real(1)) < bound);
      CHECK(largest(cross(along.tangent, along.bitangent) - n) < bound);
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

}  // namespace
}  // namespace texmap::test
