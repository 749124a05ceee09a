// The exhibits' scenes, at the limits of a number: with the published formulas and the course's.
#pragma once
#include <array>
#include <numbers>
#include <tuple>
#include <vector>

#include "exhibit.hpp"
#include "math/rotation.hpp"
#include "published/sphere.hpp"
#include "published/triangle.hpp"
#include "published/uv.hpp"
#include "scene/edge_function.hpp"
#include "scene/floor.hpp"
#include "scene/paint.hpp"
#include "scene/phong.hpp"
#include "scene/stage.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/solid_checkerboard.hpp"
#include "texture_exhibits.hpp"

namespace texmap::chapter_14 {

/// A camera at `eye` that sees a circle of this radius around the world's origin.
[[nodiscard]] inline Camera towards_origin(Point eye, double radius) {
  return {.eye = eye,
          .target = {},
          .fov_y_degrees = 360 / std::numbers::pi * atan2(radius, length(eye))};
}

/// A texture of sectors along u and rings along v, for looking at less than a texel.
struct Graticule {
  double sectors = 12;
  double rings = 16384;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const Real parity =
        cell_parity(uv.u * Real(sectors), Real(1)) + cell_parity(uv.v * Real(rings), Real(1));
    return number_cast<Real>(parity == Real(1) ? dark_cell : light_cell);
  }
};

/// A globe without light: its texture alone.
template <class Texture>
struct Globe : Placed {
  Sphere<> sphere;
  Texture texture;

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    const bool as_published = formulas == Formulas::published;
    const Sphere<> globe{sphere.center, sphere.radius,
                         as_published ? SphereForm::plain : SphereForm::hybrid};
    const Real distance = distance_to(globe, ray);
    if (!(distance < infinity<Real>())) return {number_cast<Real>(background)};
    const Hit<Real> hit = hit_at(globe, ray, distance);
    const Uv<Real> uv =
        as_published ? published::uv_next_week_v4(hit.normal) : uv_rtiow(hit.normal);
    const bool on_texture = uv.u >= Real(0) && uv.u < Real(1) && uv.v >= Real(0) && uv.v <= Real(1);
    const Real round = sqrt(square(hit.normal.x) + square(hit.normal.z));
    return {on_texture ? texture(uv) : number_cast<Real>(no_texel), uv, true, on_texture, round};
  }
};

/// The stage with its plain spheres, in some unit and on some ground. The source documents start a
/// shadow ray at the computed hit and ignore hits nearer than 0.001; the course starts it off the
/// surface by a bound on the rounding errors.
struct Shadows : Placed {
  double unit;  ///< all lengths are multiplied by it
  double ground_radius;
  PointLight light{.position = {5 * unit, 5 * unit, 5 * unit}};
  std::vector<Painted<Solid>> objects = {
      {{{0, 0, 0}, unit}, {{0.9, 0.9, 0.9}}},
      {{{-2.5 * unit, 0, unit}, 0.8 * unit}, {{1.0, 0.3, 0.3}}},
      {{{2.5 * unit, 0, unit}, 0.8 * unit}, {{0.2, 0.2, 0.8}}},
      {{{0, -(ground_radius + 1) * unit, 0}, ground_radius* unit, SphereForm::hybrid},
       {{0.9, 0.9, 0.9}}},
  };

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    SurfacePoint<Real> point{number_cast<Real>(sky)};
    if (formulas == Formulas::robust) {
      point.color = color_along(
          objects, ray, [&](const auto&) { return point.color; },
          [&](const auto& object, const auto& hit) {
            point.hit = true;
            return object.paint(hit) * lambert(Lambertian{}, sample_light(light, objects, hit));
          });
      return point;
    }
    Real nearest = infinity<Real>();
    const Painted<Solid>* seen = nullptr;
    for (const auto& object : objects) {
      const Real distance = published::distance_half_b(object.shape, ray);
      if (distance < nearest) seen = &object;
      nearest = min(distance, nearest);
    }
    if (seen == nullptr) return point;
    const Vec3<Real> position = ray.origin + ray.direction * nearest;
    const Vec3<Real> normal =
        (position - number_cast<Real>(seen->shape.center)) * (Real(1) / Real(seen->shape.radius));
    const Vec3<Real> path = number_cast<Real>(light.position) - position;
    const Real away = length(path);
    const Vec3<Real> to_light = path * (Real(1) / away);
    Real cosine = max(dot(normal, to_light), Real(0));
    for (const auto& object : objects) {
      if (published::distance_half_b(object.shape, Ray<Real>{position, to_light}) < away)
        cosine = Real(0);
    }
    return {number_cast<Real>(seen->paint.color) * (Real(0.2) + Real(0.8) * cosine), {}, true};
  }
};

/// A picture on a triangle 10,000 times as high as wide, drawn as if it were as wide as high.
struct Needle : Placed {
  ImageTexture texture;
  double half_width = 0.00005;

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    const Real x = ray.direction.x / -ray.direction.z;
    const Real y = ray.direction.y / -ray.direction.z;
    // Where the triangle is, is not the question here: only the weights are.
    if (!(abs(y) < Real(0.5) && abs(x) < (Real(0.5) - y) * Real(0.5)))
      return {number_cast<Real>(background)};
    const Vec3<Real> p{x * Real(2 * half_width), y, Real(0)};
    const Vec3<Real> a{Real(-half_width), Real(-0.5), Real(0)}, b{-a.x, a.y, Real(0)};
    const Vec3<Real> c{Real(0), Real(0.5), Real(0)};
    const RaySpace<Real> space(Ray<Real>{p, {Real(0), Real(0), Real(-1)}});
    const Crossing<Real> found =
        crossing(space, seen_along(space, a), seen_along(space, b), seen_along(space, c));
    const published::Barycentric<Real> weights =
        formulas == Formulas::published ? published::barycentric_heron(a, b, c, p)
                                        : published::Barycentric<Real>{found.a, found.b, found.c};
    const Uv<Real> uv{weights.b + weights.c * Real(0.5), weights.c};
    const bool number = uv.u == uv.u && uv.v == uv.v;
    return {number ? texture(uv) : number_cast<Real>(no_texel), uv, true, number};
  }
};

/// A floor of cubes, ten million cells from the world's origin. The robust form counts cells from a
/// nearby corner, an even number of cells away, where digits for parts of a cell remain.
struct FarFloor : Placed {
  SolidCheckerboard board{.even = {0.95, 0.95, 0.9}, .odd = {0.2, 0.25, 0.3}, .cell = 1};

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    const Floor floor{};
    const Real distance = distance_to(floor, ray);
    if (!(distance < Real(60))) return {number_cast<Real>(sky)};
    if (formulas == Formulas::published)
      return {board(ray.origin + ray.direction * distance), {}, true};
    // The camera's place is the scene's and known in double.
    const double pair = 2 * board.cell;
    const Point corner{pair * std::floor(camera.eye.x / pair), 0,
                       pair * std::floor(camera.eye.z / pair)};
    return {board(point_on(floor, Ray<Real>{number_cast<Real>(camera.eye - corner), ray.direction},
                           distance)),
            {},
            true};
  }
};

/// A globe after a million turns of 0.1 degrees: the angles summed, or multiplied and reduced.
struct ManyTurns : Placed {
  ImageTexture texture;

  /// The angle added up step by step, as an animation does it.
  template <class Real>
  [[nodiscard]] static Real sum_of_steps() {
    Real sum = Real(0);
    for (int i = 0; i < 1000000; ++i) sum = sum + Real(0.1L);
    return sum;
  }

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    static const Real sum = sum_of_steps<Real>();
    static const Real radians = sum * pi<Real>() / Real(180);
    static const OnCircle<Real> summed{cos(radians), sin(radians)};
    // A million tenths are 100,000 degrees, and that is 280 beyond whole turns.
    static const OnCircle<Real> reduced = on_circle_of_degrees(Real(1000000) / Real(10));
    const OnCircle<Real>& turn = formulas == Formulas::published ? summed : reduced;

    const Sphere<> globe{{}, 1};
    const Real distance = distance_to(globe, ray);
    if (!(distance < infinity<Real>())) return {number_cast<Real>(background)};
    const Vec3<Real> n = hit_at(globe, ray, distance).normal;
    const Uv<Real> uv = uv_rtiow(
        Vec3<Real>{n.x * turn.cosine + n.z * turn.sine, n.y, n.z * turn.cosine - n.x * turn.sine});
    return {texture(uv), uv, true, true};
  }
};

/// The lecture's globe with an odd exponent: the highlight has the wrong sign. Even ones hide it.
struct OddExponent : Placed {
  PhongMaterial material{.lambertian = {}, .specular = 1, .shininess = 101};

  template <class Real>
  [[nodiscard]] SurfacePoint<Real> operator()(const Ray<Real>& ray, Formulas formulas) const {
    const std::array<Painted<Solid>, 1> globe{{{{{}, 1}, {{0.75, 0.45, 0.1}}}}};
    const Real distance = distance_to(globe[0].shape, ray);
    if (!(distance < infinity<Real>())) return {number_cast<Real>(background)};
    const Hit<Real> hit = hit_at(globe[0].shape, ray, distance);
    const LightSample<Real> light = sample_light(PointLight{{3, 2, 2}}, globe, hit);
    const HighlightFormula formula =
        formulas == Formulas::published ? HighlightFormula::lecture : HighlightFormula::phong;
    const Real gloss = highlight(formula, material, light, hit.normal, -ray.direction);
    return {globe[0].paint(hit) * lambert(material.lambertian, light) + gray(gloss), {}, true};
  }
};

/// A scene with one of its formulas, as a lesson that a picture is drawn of.
template <class Scene>
struct SceneWith {
  const Scene& scene;
  Formulas formulas;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return scene(ray, formulas).color;
  }
};

/// All exhibits, in the order of the sheet.
[[nodiscard]] inline auto exhibit_scenes(const SharedImage& earth, const SharedImage& labels) {
  const Sphere<> globe{{0, 0, 0}, 1};
  const ImageTexture texture{earth};
  const auto from = [&](const char* name, const char* caption, double radii) {
    return Globe<ImageTexture>{
        {name, caption, towards_origin({0, 0, radii}, 1.15)}, globe, texture};
  };
  const auto shadows = [&](const char* name, const char* caption, double unit,
                           double ground_radius) {
    const Camera camera{.eye = {0, 2 * unit, 8 * unit}, .target = {0, 0, 0}};
    return Shadows{{name, caption, camera}, unit, ground_radius};
  };
  return std::tuple{
      from("from-10", "a globe from 10 radii", 10),
      from("from-1e3", "a globe from 1,000 radii", 1e3),
      from("from-1e5", "a globe from 100,000 radii", 1e5),
      from("from-1e7", "a globe from 10,000,000 radii", 1e7),
      Globe<Graticule>{{"pole", "the pole, rings of 1/4 texel", above_the_pole}, globe, {}},
      Globe<Graticule>{{"seam", "the seam, 1e-7 wide", towards_origin({-3, 0, 0}, 3e-7)},
                       globe,
                       {.sectors = 2, .rings = 1}},
      Globe<ImageTexture>{{"far-home",
                           "a globe at 100,000 radii from 0",
                           {.eye = {100000, 0, 5}, .target = {100000, 0, 0}, .fov_y_degrees = 26}},
                          {{100000, 0, 0}, 1},
                          texture},
      Globe<ImageTexture>{
          {"units", "a globe of radius 1e-25", towards_origin({0, 0, 1e-24}, 1.15e-25)},
          {{0, 0, 0}, 1e-25},
          texture},
      shadows("acne", "shadows, ground of radius 100,000", 1, 1e5),
      shadows("small", "shadows, the stage 1e-4 as large", 1e-4, 1000),
      Needle{{"needle", "a needle 10,000 times higher than wide", towards_origin({0, 0, 1}, 0.55)},
             {labels}},
      FarFloor{{"far-floor",
                "a checkerboard 1e7 cells away",
                {.eye = {10000000.25, 2, 10000003.25},
                 .target = {10000000.25, 0, 9999996.25},
                 .fov_y_degrees = 50}}},
      ManyTurns{{"turns", "after 1e6 turns of 0.1 degrees", towards_origin({0, 1, 3}, 1.15)},
                texture},
      OddExponent{{"highlight",
                   "a highlight with exponent 101",
                   {.eye = {0, 0, 4}, .target = {0, 0, 0}, .fov_y_degrees = 36}}},
      Cracks{{"cracks", "rays at the edges of triangles", towards_origin({0.3, 0.2, 2.7}, 0.8)}},
      MapMiddle{{"map-middle", "the pole of an equal-area map", above_the_pole}},
      SeamFootprint{{"footprint",
                     "a filtered globe, at its seam",
                     {.eye = {-3, 0.8, 0.4}, .target = {0, 0, 0}, .fov_y_degrees = 44}},
                    {.pyramid = pyramid_of({earth, TexelLight::encoded}),
                     .filter = Filter::trilinear,
                     .wrap = Wrap::spherical}},
      MirrorWrap{{"mirror", "8 texels, mirrored at 0", straight_on}},
      OneRow{{"one-row",
              "a texture of 64 x 1 texels",
              {.eye = {0, 1, 0}, .target = {0, 0.6, -1}, .fov_y_degrees = 50}}},
      NoNumber{{"no-number", "squares with NaN and infinity in (u, v)", straight_on}},
  };
}

}  // namespace texmap::chapter_14
