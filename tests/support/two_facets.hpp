// A shading normal as two facets, which lose no light and gain none.
#pragma once
#include "math/vec3.hpp"

namespace texmap {

/// A rough surface of two kinds of facets: one has the shading normal; the other stands upright on
/// the surface and faces the other way, so that the mean of all facets is the true normal.
/// Source: Schüssler, Heitz, Hanika, Dachsbacher, "Microfacet-Based Normal Mapping" (2017).
template <class Real>
struct TwoFacets {
  Vec3<Real> normal;   ///< of the surface itself
  Vec3<Real> bent;     ///< the shading normal, less than 90 degrees from it
  Vec3<Real> upright;  ///< at a right angle to `normal`
  Real bent_area;      ///< of the bent facets per area of surface: 1 / cos(lean)
  Real upright_area;   ///< tan(lean)
};

/// The two facets of a shading normal; both are `normal` itself where it does not lean.
template <class Real>
[[nodiscard]] TwoFacets<Real> two_facets(const Vec3<Real>& normal, const Vec3<Real>& shading) {
  const Real cosine = dot(normal, shading);
  const Vec3<Real> along = normal * cosine - shading;
  const Real sine = length(along);
  const Mask<Real> leans = sine > Real(0);
  const Vec3<Real> upright = along * (Real(1) / select(leans, sine, Real(1)));
  return {normal, shading, select(leans, upright, normal), Real(1) / cosine, sine / cosine};
}

/// The areas of the facets that are seen from a direction above the surface, per area of surface.
template <class Real>
struct SeenAreas {
  Real bent, upright;
};
template <class Real>
[[nodiscard]] SeenAreas<Real> seen_areas(const TwoFacets<Real>& facets, const Vec3<Real>& toward) {
  return {facets.bent_area * max(dot(facets.bent, toward), Real(0)),
          facets.upright_area * max(dot(facets.upright, toward), Real(0))};
}

/// The chance that light leaving a facet in a direction is not stopped by the other facets.
///
/// @return  0 to 1; 0 below the surface
template <class Real>
[[nodiscard]] Real chance_to_leave(const TwoFacets<Real>& facets, const Vec3<Real>& toward) {
  const Real above = dot(facets.normal, toward);
  const SeenAreas<Real> seen = seen_areas(facets, toward);
  const Real all = seen.bent + seen.upright;
  const Mask<Real> leaves = above > Real(0) && all > Real(0);
  return select(leaves, min(Real(1), above / select(leaves, all, Real(1))), Real(0));
}

}  // namespace texmap
