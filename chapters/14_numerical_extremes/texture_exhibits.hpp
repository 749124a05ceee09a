// Exhibits of chapters 08 to 10: edges of triangles, footprints, wrapping, the middle of a map, and
// a texture without a height or a place.
#pragma once
#include "exhibit.hpp"
#include "number/dual.hpp"
#include "published/equal_area.hpp"
#include "published/mip_map.hpp"
#include "published/triangle_hit.hpp"
#include "published/uv.hpp"
#include "scene/camera.hpp"
#include "scene/mesh.hpp"
#include "scene/sphere.hpp"
#include "texture/filters.hpp"
#include "texture/image_texture.hpp"

namespace texmap::chapter_14 {

/// Cells that are counted, and where the pole is seen from.
inline constexpr Rgb light_cell{0.95, 0.9, 0.75}, dark_cell{0.15, 0.3, 0.65};
inline constexpr Camera above_the_pole{
    .eye = {0, 1.1, 0.01}, .target = {0, 1, 0}, .fov_y_degrees = 1.5};
/// What looks straight at a picture.
inline constexpr Camera straight_on{.eye = {0, 0, 1}, .target = {0, 0, 0}, .fov_y_degrees = 75};

/// A turned board of triangles. Rays that pass an edge within a pixel are aimed at the edge.
struct Cracks : Placed {
  Rgb crack{1, 0, 1};
  Mesh mesh = board();

  static constexpr int cells = 6;  ///< in each direction, two triangles each
  static constexpr double sine = 0.28, cosine = 0.96;

  [[nodiscard]] static Mesh board() {
    Mesh mesh;
    for (int cell = 0; cell < cells * cells; ++cell) {
      const int a = 4 * cell;
      for (int corner = 0; corner < 4; ++corner) {
        const int column = cell % cells + corner % 2, row = cell / cells + corner / 2;
        const double x = 2.0 * column / cells - 1, y = 2.0 * row / cells - 1;
        mesh.points.push_back({x * cosine - y * sine, x * sine + y * cosine, 0});
      }
      mesh.triangles.push_back({a, a + 1, a + 3});
      mesh.triangles.push_back({a, a + 3, a + 2});
    }
    return mesh;
  }

  template <class Real>
  [[nodiscard]] bool is_met(const Ray<Real>& ray, Formulas formulas) const {
    if (formulas == Formulas::robust) return first_hit(mesh, ray).met;
    for (int k = 0; k < static_cast<int>(mesh.triangles.size()); ++k) {
      const auto corner = [&](int number) { return number_cast<Real>(mesh.corner(k, number)); };
      if (published::meets_triangle(corner(0), corner(1), corner(2), ray)) return true;
    }
    return false;
  }

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    // The place on the board in cells, moved to the nearest edge if that is within 0.06 cells.
    const Real away = ray.origin.z / -ray.direction.z;
    const Real px = ray.origin.x + ray.direction.x * away;
    const Real py = ray.origin.y + ray.direction.y * away;
    const Real half = Real(cells) / Real(2);
    Real x = (px * Real(cosine) + py * Real(sine) + Real(1)) * half;
    Real y = (py * Real(cosine) - px * Real(sine) + Real(1)) * half;
    if (!(x > Real(0.1) && y > Real(0.1) && x < Real(cells - 0.1) && y < Real(cells - 0.1)))
      return {number_cast<Real>(background)};
    const Real column = floor(x + Real(0.5)), row = floor(y + Real(0.5));
    const Real diagonal = (x - y) - floor(x - y + Real(0.5));
    if (abs(x - column) < Real(0.06)) {
      x = column;
    } else if (abs(y - row) < Real(0.06)) {
      y = row;
    } else if (abs(diagonal) < Real(0.06)) {
      y = y + diagonal;
    }
    const Real across = x / half - Real(1), up = y / half - Real(1);
    const Vec3<Real> target{across * Real(cosine) - up * Real(sine),
                            across * Real(sine) + up * Real(cosine), Real(0)};
    const bool met = is_met(Ray<Real>{ray.origin, target - ray.origin}, formulas);
    const Real shade = Real(0.45) + Real(0.09) * x;
    return {met ? gray(shade) : number_cast<Real>(crack), {}, met};
  }
};

/// The middle of the equal-area octahedral map, its pole, with rings of half a texel of 4096.
struct MapMiddle : Placed {
  Sphere<> sphere{.center = {}, .radius = 1, .form = SphereForm::hybrid};

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    const Real distance = distance_to(sphere, ray);
    if (!(distance < infinity<Real>())) return {};
    const Vec3<Real> n = hit_at(sphere, ray, distance).normal;
    const Uv<Real> uv =
        formulas == Formulas::published ? published::uv_equal_area(n) : uv_equal_area(n);
    const Real from_middle = abs(uv.u - Real(0.5)) + abs(uv.v - Real(0.5));
    const Real ring = floor(from_middle * Real(8192) + Real(0.5));
    const bool is_number = uv.u == uv.u && uv.v == uv.v;
    return {number_cast<Real>(is_even(ring) ? light_cell : dark_cell), uv, true, is_number};
  }
};

/// How a ray's direction changes over a hundredth of the picture.
template <class Real>
struct PixelSteps {
  Vec3<Real> right, down;

  explicit PixelSteps(const Camera& camera) {
    const View<> view = view_of(camera, 100, 100);
    right = number_cast<Real>(view.right * view.pixel);
    down = number_cast<Real>(view.up * -view.pixel);
  }
  /// The ray with these derivatives.
  [[nodiscard]] Ray<Dual<Real>> along(const Ray<Real>& ray) const {
    const Vec3<Real>& d = ray.direction;
    return {number_cast<Dual<Real>>(ray.origin),
            {Dual<Real>{d.x, right.x, down.x}, Dual<Real>{d.y, right.y, down.y},
             Dual<Real>{d.z, right.z, down.z}}};
  }
};

/// A globe around its seam, filtered. The published footprint is the difference of (u, v) between
/// neighboring pixels; at the seam that is the whole texture.
struct SeamFootprint : Placed {
  FilteredTexture texture;
  Sphere<> sphere{.center = {}, .radius = 1};

  /// (u, v) where a ray meets the globe.
  template <class Real>
  [[nodiscard]] Uv<Real> uv_along(const Ray<Real>& ray) const {
    return uv_rtiow(normal_at(sphere, ray, distance_to(sphere, ray)));
  }

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    if (!(distance_to(sphere, ray) < infinity<Real>())) return {number_cast<Real>(background)};
    const PixelSteps<Real> steps(camera);
    const Uv<Real> here = uv_along(ray);
    Uv<Dual<Real>> uv;
    if (formulas == Formulas::published) {
      const Uv<Real> next = uv_along(Ray<Real>{ray.origin, ray.direction + steps.right});
      const Uv<Real> below = uv_along(Ray<Real>{ray.origin, ray.direction + steps.down});
      uv = {{here.u, next.u - here.u, below.u - here.u},
            {here.v, next.v - here.v, below.v - here.v}};
    } else {
      uv = uv_along(steps.along(ray));
    }
    return {texture.filtered(uv), here, true, true};
  }
};

/// Eight colors, apart from each other.
inline constexpr std::array<Rgb, 8> eight_texels{{{0.9, 0.2, 0.2},
                                                  {0.95, 0.6, 0.1},
                                                  {0.95, 0.9, 0.2},
                                                  {0.4, 0.8, 0.2},
                                                  {0.2, 0.7, 0.7},
                                                  {0.2, 0.4, 0.9},
                                                  {0.5, 0.2, 0.8},
                                                  {0.9, 0.9, 0.9}}};

/// A texture of 8 texels that goes on as its mirror image, from u = -1 to 1.
struct MirrorWrap : Placed {
  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    const Real u = ray.direction.x / -ray.direction.z;
    const int n = static_cast<int>(eight_texels.size());
    const Real robust = mirrored(floor(u * Real(n)), Real(n));
    const int texel = static_cast<int>(
        formulas == Formulas::published ? Real(published::index_triangle(u, n)) : robust);
    return {number_cast<Real>(eight_texels[static_cast<std::size_t>(texel)]), {}, true};
  }
};

/// A picture of so many texels, each unlike its neighbors: the texture of the next two.
[[nodiscard]] inline FilteredTexture colored_texels(int width, int height, Wrap wrap) {
  const LightImage texels = image_of(width, height, [](int column, int row) {
    return number_cast<float>(eight_texels[static_cast<std::size_t>(column + 3 * row) % 8]);
  });
  return {.pyramid = pyramid_of(texels),
          .filter = Filter::trilinear,
          .wrap = wrap,
          .v_axis = VAxis::down};
}

/// Its color, with the published footprint or the course's.
template <class Real>
[[nodiscard]] Color<Real> color_of(const FilteredTexture& texture, const Uv<Dual<Real>>& uv,
                                   Formulas formulas) {
  return formulas == Formulas::published ? published::trilinear(texture, uv) : texture.filtered(uv);
}

/// A floor of stripes: a picture one texel high. The published footprint is measured in (u, v),
/// where one texel's height is as much as 64 texels' width.
struct OneRow : Placed {
  FilteredTexture texture = colored_texels(64, 1, Wrap::repeat);

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    const Ray<Dual<Real>> moving = PixelSteps<Real>(camera).along(ray);
    const Dual<Real> distance = moving.origin.y / -moving.direction.y;
    if (!(distance > Real(0) && distance < Real(60))) return {number_cast<Real>(sky)};
    const Uv<Dual<Real>> uv{moving.direction.x * distance * Real(1.0 / 16),
                            moving.direction.z * distance * Real(0.2)};
    return {color_of(texture, uv, formulas), {}, true};
  }
};

/// A picture in squares: in some u is NaN, in some v is infinite, in some a derivative is NaN. The
/// course reads the picture's edge there, or its mean.
struct NoNumber : Placed {
  FilteredTexture texture = colored_texels(8, 4, Wrap::clamp);

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    const Vec3<Dual<Real>> d = PixelSteps<Real>(camera).along(ray).direction;
    Uv<Dual<Real>> uv{Real(0.5) - d.x / d.z * Real(0.48), Real(0.5) + d.y / d.z * Real(0.64)};
    const Real column = floor(uv.u.value * Real(6)), row = floor(uv.v.value * Real(4));
    const Real kind = remainder_of(column * Real(2) + row, Real(7));
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    if (kind == Real(0)) uv.u.value = nan;
    if (kind == Real(1)) uv.v.value = infinity<Real>();
    if (kind == Real(2)) uv.u.dx = nan;
    const Color<Real> color = color_of(texture, uv, formulas);
    const bool number = color.r == color.r;
    return {number ? color : number_cast<Real>(no_texel), {}, true};
  }
};

}  // namespace texmap::chapter_14
