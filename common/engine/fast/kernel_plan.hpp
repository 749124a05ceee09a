// The kernels of a picture, chosen once from its budget, and the paints that use them.
#pragma once
#include <string>
#include <vector>

#include "engine/fast/budget.hpp"
#include "engine/fast/fetched_pyramid.hpp"
#include "engine/fast/fetched_texels.hpp"
#include "engine/fast/power_kernel.hpp"
#include "engine/fast/root_texture.hpp"
#include "engine/fast/turns.hpp"
#include "number/compiler.hpp"
#include "scene/paint.hpp"
#include "texture/conventions.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"

namespace texmap {

/// Polynomials for (u, v) that keep a budget, or the exact formula.
struct Polynomial {
  int terms = 0;            ///< the degree of the arc tangent; 0: exact
  double worst_texels = 0;  ///< largest error of a place
  double worst_levels = 0;  ///< of a color, 255 a texel, filtered, u and v together
  std::string text{};       ///< a sentence that says all this, and the time
};

/// The worst error of the kernel of a degree, in float or in double; 0 of the reference formula.
[[nodiscard]] UvError worst_uv_error(int degree, bool in_float);
/// The cheapest kernel for (u, v) with a worst case within the budget, for a filtered texture.
/// With the nearest texel, places that close to an edge can get the neighboring texel.
///
/// @param width, height  in texels, 1 or more
/// Errors: std::invalid_argument for a size below 1.
[[nodiscard]] Polynomial choose_uv_kernel(const Budget& budget, int width, int height);

/// Limits on the error estimates of a PixelProbe; zeros switch smoothing off.
struct Smoothing {
  double most_curvature_error = 0;  ///< for places from a polynomial of degree 2
  double most_normal_error = 0;     ///< for directions from a polynomial of degree 1

  // The largest errors that follow, in units of the estimates; a test holds them.
  static constexpr double turns_per_curvature_error = 0.03;       ///< in longitude
  static constexpr double half_turns_per_curvature_error = 0.05;  ///< in latitude
  static constexpr double direction_per_normal_error = 1.4;  ///< in a cosine_direction's coordinate
};

/// The kernels of a picture. The default is the reference formulas.
struct KernelPlan {
  int uv_degree = 0;               ///< of the arc tangent; 0 for the formula in texture/uv.hpp
  bool floats_are_enough = false;  ///< the arc tangent was chosen for float
  Smoothing smoothing = {};        ///< which pixels are patches
  bool root_texels = false;        ///< texels as ten-bit roots of light
  int power_terms = 0;             ///< of Phong's power; 0 for the formula in scene/phong.hpp
  std::string text;                ///< what was chosen, and its largest error: a line each
};

/// The plan for a textured surface with many samples per pixel.
///
/// @param reads  how many texels the picture reads at most
/// Domain, in levels: a sky that is nowhere darker than half of its brightest place. A sample
/// at the edge of a texel may read the neighbor, which is not counted.
[[nodiscard]] KernelPlan plan_surface(const Budget& budget, const Image& texture, double reads);
/// The plan for a surface with a highlight and one ray per pixel.
[[nodiscard]] KernelPlan plan_highlight(const Budget& budget);

/// draw(mapping) with the mapping for that degree; all results must have one type.
/// A switch, because it is in the innermost loop: degree 35 took a third longer by comparisons.
template <class Draw>
decltype(auto) with_uv_mapping(int degree, const Draw& draw) {
  switch (degree) {
    case 5:
      return draw(FastUnitMapping<5>{});
    case 9:
      return draw(FastUnitMapping<9>{});
    case 17:
      return draw(FastUnitMapping<17>{});
    case 23:
      return draw(FastUnitMapping<23>{});
    case 35:
      return draw(FastUnitMapping<35>{});
    default:
      return draw(RtiowMapping{});
  }
}

/// The (u, v) of unit vectors by the plan's kernel.
struct PlannedMapping {
  int degree = 0;  ///< as KernelPlan::uv_degree
  Convention convention = Convention::rtiow;
  RotationY rotation = {};

  template <class Real>
  [[nodiscard]] Uv<Real> operator()(Vec3<Real> p) const {
    if (rotation.sine != 0 || rotation.cosine != 1) p = rotation(p);
    return in_convention(convention, degree == 0 ? uv_rtiow(p) : by_polynomial(p));
  }

 private:
  /// Out of line: five mappings inlined into every loop take minutes to compile.
  template <class Real>
  [[nodiscard]] TEXMAP_NOINLINE Uv<Real> by_polynomial(const Vec3<Real>& p) const {
    return with_uv_mapping(degree, [&p](const auto& mapping) { return mapping(p); });
  }
};
/// A texture by the plan's kernel: roots of light if the plan made them, else the image.
struct PlannedTexture {
  const LightTexture* exact;  ///< not owned
  RootTexture roots = {};

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    return roots.texels.pixels.empty() ? (*exact)(uv) : roots(uv);
  }
};

/// Phong's power by the plan's kernel.
struct PlannedPower {
  int terms;  ///< 3 or 6
  double exponent;

  /// @param versine  1 - cos, 0 or more
  template <class Real>
  [[nodiscard]] Real operator()(const Real& versine) const {
    return terms == 3 ? PowerKernel<3>(exponent)(versine) : PowerKernel<6>(exponent)(versine);
  }
};

/// The paint that plans are made for.
using GlobePaint = Mapped<Rotated<ConventionMapping>, LightTexture>;
/// A scene's objects with the plan's paints. Other kinds of paint stay as they are.
[[nodiscard]] inline std::vector<Painted<Mapped<PlannedMapping, PlannedTexture>>> planned_objects(
    const KernelPlan& plan, const std::vector<Painted<GlobePaint>>& objects) {
  std::vector<Painted<Mapped<PlannedMapping, PlannedTexture>>> planned;
  planned.reserve(objects.size());
  for (const auto& [shape, paint] : objects) {
    planned.push_back(
        {shape,
         {{plan.uv_degree, paint.mapping.mapping.convention, paint.mapping.rotation},
          {&paint.texture, plan.root_texels ? RootTexture(paint.texture) : RootTexture()}}});
  }
  return planned;
}
template <class Paint>
[[nodiscard]] const std::vector<Painted<Paint>>& planned_objects(
    const KernelPlan& /*plan*/, const std::vector<Painted<Paint>>& objects) {
  return objects;
}

}  // namespace texmap
