// Bumps: the normal of a surface that a height has raised, without raising it.
#pragma once
#include "scene/steps.hpp"

namespace texmap {

/// A height at a point and its slopes along the two vectors of a frame.
template <class Real>
struct Slope {
  Real height, right, up;
};

/// Where the slopes come from. To add a way, name it in slope_of, too.
enum class SlopeFrom {
  duals,    ///< the height's own code, run with numbers that know their derivatives: exact
  forward,  ///< (h(step) - h(0)) / step: off by about h'' step / 2
  central,  ///< (h(step) - h(-step)) / (2 step): off by about h''' step^2 / 6
};

/// Which normal the slopes give.
enum class BumpForm {
  flat,   ///< the surface's own: no bumps
  blinn,  ///< Blinn 1978, who drops the term h dn: slopes too large by the factor 1 + h / radius
  exact,  ///< that of the raised surface
};

/// The height at a hit and its slopes.
///
/// @param height  a paint: the red channel of its color is the height
/// @param step    for differences, above 0, in units of the scene
template <class Real, class Height>
[[nodiscard]] Slope<Real> slope_of(const Height& height, const Hit<Real>& hit,
                                   const Frame<Real>& frame, const Real& curvature, SlopeFrom from,
                                   const Real& step) {
  const auto at = [&](const Vec3<Real>& offset) { return height(moved(hit, offset, curvature)).r; };
  switch (from) {
    case SlopeFrom::duals: {
      const Dual<Real> h = height(with_steps(hit, frame, curvature)).r;
      return {h.value, h.dx, h.dy};
    }
    case SlopeFrom::forward: {
      const Real here = height(hit).r;
      return {here, (at(frame.right * step) - here) / step, (at(frame.up * step) - here) / step};
    }
    case SlopeFrom::central:
      break;
  }
  const auto slope = [&](const Vec3<Real>& along) {
    return (at(along * step) - at(along * -step)) / (step + step);
  };
  return {height(hit).r, slope(frame.right), slope(frame.up)};
}

/// The unit normal of the raised surface: it leans downhill.
///
/// The surface point + height n has the tangents (1 + h / R) right + h_right n and
/// (1 + h / R) up + h_up n; their vector product is a multiple of (1 + h / R) n - gradient of h.
/// Where the slopes are 0, NaN or too large to square: `normal` itself.
/// Source: Blinn (1978); Mikkelsen (2010, 2020).
template <class Real>
[[nodiscard]] Vec3<Real> raised_normal(const Vec3<Real>& normal, const Frame<Real>& frame,
                                       const Slope<Real>& slope, const Real& curvature,
                                       BumpForm form) {
  if (form == BumpForm::flat) return normal;
  const Real stretch = form == BumpForm::exact ? Real(1) + slope.height * curvature : Real(1);
  const Vec3<Real> gradient = frame.right * slope.right + frame.up * slope.up;
  const Real steepness = dot(gradient, gradient);
  const Mask<Real> bends = steepness > Real(0) && steepness < infinity<Real>();
  return select(bends, normalize(normal * stretch - gradient), normal);
}

/// Bumps on a surface.
template <class Height>
struct Bumps {
  Height height;      ///< a paint: the red channel of its color is a height
  double relief = 1;  ///< what a height of 1 is, in units of the scene
  BumpForm form = BumpForm::exact;
  SlopeFrom slopes = SlopeFrom::duals;
  double step = 1e-3;  ///< of differences, in units of the scene

  /// The normal of the bumps at a hit.
  ///
  /// @param curvature  of the surface: 1 / radius on a sphere, 0 on a plane
  template <class Real>
  [[nodiscard]] Vec3<Real> operator()(const Hit<Real>& hit, const Real& curvature) const {
    if (form == BumpForm::flat) return hit.normal;
    const Frame<Real> frame = frame_about(hit.normal);
    const Slope<Real> unit = slope_of(height, hit, frame, curvature, slopes, Real(step));
    const Real scale = Real(relief);
    const Slope<Real> slope{unit.height * scale, unit.right * scale, unit.up * scale};
    return raised_normal(hit.normal, frame, slope, curvature, form);
  }
};

}  // namespace texmap
