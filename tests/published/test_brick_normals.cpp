// The daily exercise's bricks: what is wrong with them.
#include "published/brick_normals.hpp"

#include <doctest.h>

#include "published/uv.hpp"
#include "support/dice.hpp"
#include "texture/bump.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// The exercise's coordinates, computed with any number.
template <class Real>
Uv<Real> daily_uv(const Vec3<Real>& p) {
  const Uv<Real> uv = uv_rtiow(Vec3<Real>{p.x, p.y, -p.z});
  return {uv.u, Real(1) - uv.v};
}

/// A height that grows with u and with v of the exercise.
struct Rising {
  double by_u, by_v;

  template <class Real>
  Color<Real> operator()(const Hit<Real>& hit) const {
    const Uv<Real> uv = daily_uv(hit.normal);
    return gray(uv.u * Real(by_u) + uv.v * Real(by_v));
  }
};

}  // namespace

TEST_CASE("19 % of the bricks' normals point into the globe") {
  // A grid of 1200 x 1200 holds each brick's 100 x 200 points; no point lies on an edge.
  int inward = 0, outward = 0;
  for (int row = 0; row < 1200; ++row) {
    for (int column = 0; column < 1200; ++column) {
      const Vec3d normal = published::brick_normal({(column + 0.5) / 1200, (row + 0.5) / 1200});
      inward += normal.z == -1 ? 1 : 0;
      outward += normal.z > 0.98 ? 1 : 0;
    }
  }
  CHECK(inward + outward == 1200 * 1200);
  CHECK(inward == doctest::Approx(0.19 * 1200 * 1200).epsilon(1e-12));
}

TEST_CASE("the bricks' tangents run along -dP/du and -dP/dv") {
  Dice dice(1);
  for (int i = 0; i < 500; ++i) {
    const Vec3d normal = dice.direction<double>();
    if (std::abs(normal.y) > 0.999) continue;
    const Frame<double> frame = frame_about(normal);
    const Hit<double> hit{normal, normal, normal, normal};
    const Uv<Dual<double>> uv = daily_uv(with_steps(hit, frame, 1.0).normal);
    const TangentFrame<double> by_uv =
        tangents(TangentRule::from_uv, normal, point_by_uv(frame, uv));
    const TangentFrame<double> published = published::brick_tangents(normal);
    CHECK(largest(published.tangent + by_uv.tangent) < 1e-12);
    CHECK(largest(published.bitangent + by_uv.bitangent) < 1e-12);
    // The coordinates are the exercise's.
    const Uv<double> its = published::uv_daily(normal);
    CHECK(std::abs(its.u - uv.u.value) < 1e-12);
    CHECK(std::abs(its.v - uv.v.value) < 1e-7);
  }
}

TEST_CASE("with the bricks' tangents a bump comes out as a dent: its normals lean uphill") {
  Dice dice(2);
  for (int i = 0; i < 300; ++i) {
    const Vec3d normal = dice.direction<double>();
    if (std::abs(normal.y) > 0.99) continue;
    const Hit<double> hit{normal, normal, normal, normal};
    const Bumps<Rising> bumps{.height = {dice.between(-1, 1), dice.between(-1, 1)},
                              .relief = 0.2,
                              .form = BumpForm::blinn};
    const Vec3d right_one = bumps(hit, 1.0);
    // The map that a correct program reads, and what the exercise makes of it.
    const Frame<double> frame = frame_about(normal);
    const TangentFrame<double> by_uv =
        tangents(TangentRule::from_uv, normal,
                 point_by_uv(frame, daily_uv(with_steps(hit, frame, 1.0).normal)));
    const Vec3d in_map{dot(right_one, by_uv.tangent), dot(right_one, by_uv.bitangent),
                       dot(right_one, normal)};
    const TangentFrame<double> its = published::brick_tangents(normal);
    const Vec3d shown = its.tangent * in_map.x + its.bitangent * in_map.y + normal * in_map.z;
    const Vec3d dent = Bumps<Rising>{bumps.height, -0.2, BumpForm::blinn}(hit, 1.0);
    CHECK(largest(shown - dent) < 1e-12);
  }
}
