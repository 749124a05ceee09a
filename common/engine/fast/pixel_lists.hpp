// The pixels of some rows, sorted by how their samples are drawn. A probe tells how smooth each is.
#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "engine/fast/kernel_plan.hpp"
#include "engine/fast/prepared_scene.hpp"
#include "math/color.hpp"

namespace texmap {

/// What a probe of a pixel tells about a sphere.
template <class Real>
struct PixelProbe {
  Mask<Real> misses;     ///< every ray through the pixel misses the sphere
  Real curvature_error;  ///< third-order error of places; +infinity at the limb and the poles
  Real normal_error;     ///< second-order error of normals; the same
};

/// Probes a sphere with axis y through the centers of pixels. With half a pixel's width h at the
/// sphere, the cosine c of the angle between ray and normal, and the normal's distance a from the
/// axis, all in radii:
///     curvature_error = ((h / c^2)^3 + (h / (a c))^3) c / max(a, c),  normal_error = h^2 / c^3.
/// @param smoothing  false: the errors are not computed, and are infinite
/// Source: derivatives of asin and atan2; the factors in Smoothing are measured.
template <class Real>
[[nodiscard]] PixelProbe<Real> probe_pixel(const View<Real>& view,
                                           const PreparedSphere<Real>& sphere, const Real& column,
                                           const Real& row, bool smoothing = true) {
  const Ray<Real> ray{view.eye, direction_through(view, column, row)};
  const Vec3<Real> to_center = sphere.center - ray.origin;
  const Vec3<Real> moment = cross(to_center, ray.direction);
  const Real squared = dot(ray.direction, ray.direction);
  const Real to_foot = dot(to_center, ray.direction) / squared;
  const Real width = view.pixel * to_foot;
  const Real reach = sphere.radius + width;  // half a pixel's diagonal is 0.71 widths
  const Mask<Real> misses = to_foot > Real(0) && dot(moment, moment) > squared * square(reach);
  if (!smoothing || !any(!misses)) return {misses, infinity<Real>(), infinity<Real>()};

  const Real distance = distance_to(sphere, ray);
  const Mask<Real> met = distance < infinity<Real>();
  if (!any(met)) return {misses, infinity<Real>(), infinity<Real>()};
  const Vec3<Real> normal = normal_at(sphere, ray, select(met, distance, Real(1)));
  const Real h = Real(0.5) * width * sphere.inverse;
  const Real c = -dot(normal, ray.direction) / sqrt(squared);
  const Real a = sqrt(square(normal.x) + square(normal.z));
  const Real to_limb = h / square(c);
  const Real to_pole = h / (a * c);
  const Mask<Real> known = met && c > Real(0) && to_limb + to_pole < Real(0.1);
  const Real cubes = square(to_limb) * to_limb + square(to_pole) * to_pole;
  return {misses, select(known, cubes * c / max(a, c), infinity<Real>()),
          select(known, square(to_limb) * c, infinity<Real>())};
}

/// What is known of the picture of a lone sphere before a sample is drawn.
struct ViewBounds {
  std::optional<Rgb> light;  ///< of the sky, if it is uniform
  Smoothing smoothing = {};  ///< which pixels may be patches

  /// True if the height of a sky ray may be a polynomial of degree 1.
  [[nodiscard]] bool smooths_sky(const View<>& view) const {
    return square(view.pixel / 2) <= smoothing.most_normal_error;
  }
};

/// A pixel of a picture, counted from its left and its upper edge.
struct Pixel {
  int column, row;
};

/// Pixels in three lists. Packs take neighbors of a list, wherever they are in the picture.
struct PixelLists {
  std::vector<Pixel> misses;   ///< every ray misses the sphere
  std::vector<Pixel> patches;  ///< every ray meets it where it is smooth enough
  std::vector<Pixel> others;
};

/// With fewer samples per pixel than this, a patch costs more than it saves.
inline constexpr int least_samples_of_patch = 12;

/// Adds the pixels of a row, each to its list; the result is the same for any number of lanes.
///
/// @param scene   with one sphere, if there are bounds
/// @param bounds  nothing: all pixels are `others`
template <class Real, class Scene>
void add_row(PixelLists& lists, int row, int width, const Scene& scene,
             const std::optional<ViewBounds>& bounds) {
  constexpr int step = static_cast<int>(lanes<Real>);
  const std::array kinds{&lists.others, &lists.patches, &lists.misses};
  for (int first = 0; first < width; first += step) {
    std::array<Scalar<Real>, lanes<Real>> kind{};
    if (bounds) {
      const Real columns = from_lanes<Real>(
          [&](std::size_t i) { return static_cast<Scalar<Real>>(first + static_cast<int>(i)); });
      const PixelProbe<Real> look =
          probe_pixel(scene.view, scene.objects.front().shape, columns, Real(row),
                      bounds->smoothing.most_curvature_error > 0);
      Mask<Real> smooth = look.curvature_error <= Real(bounds->smoothing.most_curvature_error);
      if (!scene.sky.is_constant())
        smooth = smooth && look.normal_error <= Real(bounds->smoothing.most_normal_error);
      kind = all_lanes(select(look.misses, Real(2), select(smooth, Real(1), Real(0))));
    }
    for (int i = 0; i < std::min(step, width - first); ++i) {
      kinds[static_cast<std::size_t>(kind[static_cast<std::size_t>(i)])]->push_back(
          {first + i, row});
    }
  }
}

}  // namespace texmap
