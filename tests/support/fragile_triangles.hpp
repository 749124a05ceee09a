// Formulas for triangles that fail, measured: Heron's areas, and the usual test of a ray.
#pragma once
#include <algorithm>
#include <cmath>

#include "published/mesh_weights.hpp"
#include "published/triangle_hit.hpp"
#include "support/mesh_rays.hpp"

namespace texmap::test {

/// Rays at a needle from (0, 0, 0) to (1, 0, 0), 1 / aspect wide; u = 0, 1, 0 in its corners. How
/// far off u is with each formula, in unit roundoffs, compared with that of long double.
template <class Real>
struct NeedleErrors {
  double signed_areas = 0, heron = 0;
};
template <class Real>
[[nodiscard]] NeedleErrors<Real> needle_errors(double aspect, int tries) {
  Dice dice;
  NeedleErrors<Real> worst;
  for (int i = 0; i < tries; ++i) {
    TexturedMesh one;
    const double foot = dice.between(0.2, 0.8);
    const auto rounded = [](double x) { return static_cast<double>(static_cast<Real>(x)); };
    one.mesh.points = {{0, 0, 0}, {1, 0, 0}, {rounded(foot), 0, rounded(-1 / aspect)}};
    one.mesh.triangles.push_back({0, 1, 2});
    one.mapping.corners.push_back({{{0, 0}, {1, 0}, {0, 1}}});
    const double b = dice.between(0.1, 0.6);
    const double c = dice.between(0.1, 0.3);
    const auto& p = one.mesh.points;
    const Point at = p[0] * (1 - b - c) + p[1] * b + p[2] * c;
    const Ray<Real> ray = aimed<Real>(
        [&] {
          return Point{dice.between(-1, 2), dice.between(1, 2), dice.between(-1, 1)};
        },
        [&] { return at; });
    const MeshHit<Real> hit = first_hit(one.mesh, ray);
    if (!hit.met) continue;
    const MeshHit<long double> exact =
        first_hit(one.mesh, Ray<long double>{number_cast<long double>(ray.origin),
                                             number_cast<long double>(ray.direction)});
    if (!exact.met) continue;
    const auto off = [&](Real u) {
      return static_cast<double>(std::abs(static_cast<long double>(u) - exact.b) /
                                 static_cast<long double>(unit_roundoff<Real>()));
    };
    const Real by_heron = one.mapping(published::weighted_by_heron(one.mesh, hit)).u;
    worst.signed_areas = std::max(worst.signed_areas, off(one.mapping(hit).u));
    worst.heron = std::max(worst.heron, off(by_heron));  // which a NaN leaves as it is
  }
  return worst;
}

/// Rays from inside a cube, aimed at edges and corners, that meet none of its triangles by Moeller
/// and Trumbore's test, or more than one.
struct InsideLeaks {
  long cracks = 0, doubles = 0;
};
template <class Real>
[[nodiscard]] InsideLeaks leaks_of_usual_test(int rays) {
  Dice dice;
  InsideLeaks leaks;
  for (int i = 0; i < rays; ++i) {
    const Mesh cube = turned_cube(dice);
    const Ray<Real> ray = aimed<Real>([&] { return point_within(dice, 0.5); },
                                      [&] { return point_on_edge(dice, cube); });
    int met = 0;
    for (int k = 0; k < 12; ++k) {
      const auto corner = [&](int number) { return number_cast<Real>(cube.corner(k, number)); };
      met += published::meets_triangle(corner(0), corner(1), corner(2), ray) ? 1 : 0;
    }
    leaks.cracks += met == 0 ? 1 : 0;
    leaks.doubles += met > 1 ? 1 : 0;
  }
  return leaks;
}

}  // namespace texmap::test
