// What a layout does to a picture: its shape, and how it distorts.
#pragma once
#include <array>

#include "number/dual.hpp"
#include "texture/projections.hpp"

namespace texmap {

/// What is fixed for a projection.
struct ProjectionFacts {
  Projection projection;
  const char* word;   ///< on the command line
  double aspect;      ///< width / height of the picture: as published, or as the middle is not
                      ///< stretched; 1.5 is taken for a cube's six faces (convert_projection)
  bool fills;         ///< its picture; else `shows` finds the outline by unproject
  double mean_texel;  ///< steradians of a mean texel, times the number of texels
};

inline constexpr double four_pi = 4 * static_cast<double>(pi_digits);
/// All projections, in the order of `Projection`.
inline constexpr std::array<ProjectionFacts, 7> projections = {{
    {Projection::equirect, "equirect", 2, true, four_pi},
    {Projection::plane, "plane", 1, false, 8},  // half the sphere on pi / 4 of the square
    {Projection::cylinder, "cylinder", static_cast<double>(pi_digits), true, four_pi},
    {Projection::cube, "cube", 1.5, true, four_pi},
    {Projection::equi_angular, "equi-angular", 1.5, true, four_pi},
    {Projection::octahedral, "octahedral", 1, true, four_pi},
    {Projection::equal_area, "equal-area", 1, true, four_pi},
}};
static_assert(
    [] {
      for (std::size_t i = 0; i < projections.size(); ++i)
        if (projections[i].projection != static_cast<Projection>(i)) return false;
      return true;
    }(),
    "the rows are in the order of Projection");
[[nodiscard]] inline const ProjectionFacts& facts_of(Projection projection) {
  return projections[static_cast<std::size_t>(projection)];
}

/// Where a layout shows something: where project leads back from the direction.
///
/// @param margin  also so far outside, as a part of the picture's width or height
[[nodiscard]] inline bool shows(Projection projection, const Uv<double>& uv, double margin = 0) {
  if (facts_of(projection).fills) return true;
  const Uv<double> back = project(projection, unproject(projection, uv));
  return sqrt(square(uv.u - back.u) + square(uv.v - back.v)) <= margin + 1e-9;
}

/// How a picture is distorted at a place.
template <class Real>
struct Distortion {
  Real area;     ///< the solid angle of a texel here / that of a mean texel
  Real stretch;  ///< 1 or more: the axes of the ellipse of a small circle, long / short
};

/// Texture coordinates of a direction, and how they change for two steps along the sphere that are
/// perpendicular to each other: no derivative of a projection is written by hand.
///
/// @param n  of unit length, not on a seam, an edge or a pole
template <class Real>
[[nodiscard]] Uv<Dual<Real>> project_two_steps(Projection projection, const Vec3<Real>& n) {
  const Mask<Real> steep = abs(n.y) > Real(0.7);
  const Vec3<Real> axis{select(steep, Real(1), Real(0)), select(steep, Real(0), Real(1)), Real(0)};
  const Vec3<Real> first = normalize(cross(axis, n));
  const Vec3<Real> second = cross(n, first);
  return project(projection,
                 Vec3<Dual<Real>>{
                     {n.x, first.x, second.x}, {n.y, first.y, second.y}, {n.z, first.z, second.z}});
}

/// The distortion at a direction, in a picture of the projection's own aspect.
///
/// @param n  as for project_two_steps
/// Bound: 1e-14 of themselves in double.
/// Textbook: s^2 + t^2 = the sum of squares of the Jacobian, a quadratic equation for s / t. Its
/// root loses half the digits where s is near t; s + t and |s - t| are lengths and do not.
template <class Real>
[[nodiscard]] Distortion<Real> distortion(Projection projection, const Vec3<Real>& n) {
  const Uv<Dual<Real>> uv = project_two_steps(projection, n);
  const ProjectionFacts& facts = facts_of(projection);
  const Real wide = Real(facts.aspect);
  const Real determinant = abs(difference_of_products(uv.u.dx, uv.v.dy, uv.u.dy, uv.v.dx));
  const auto length_of = [](const Real& a, const Real& b) { return sqrt(square(a) + square(b)); };
  const Real twice_long = length_of(wide * uv.u.dx + uv.v.dy, wide * uv.u.dy - uv.v.dx) +
                          length_of(wide * uv.u.dx - uv.v.dy, wide * uv.u.dy + uv.v.dx);
  return {Real(1) / (Real(facts.mean_texel) * determinant),
          max(square(twice_long) / (Real(4) * wide * determinant), Real(1))};
}

}  // namespace texmap
