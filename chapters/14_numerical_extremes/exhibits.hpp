// The exhibits of this chapter: small scenes at the limits of a number, each drawn with the seeds' formulas and with the
// course's.
#pragma once
#include <array>
#include <vector>

#include "floor.hpp"
#include "image_texture.hpp"
#include "mapped.hpp"
#include "painted.hpp"
#include "phong.hpp"
#include "rotation.hpp"
#include "seed_formulas.hpp"
#include "seed_sphere.hpp"
#include "seed_triangle.hpp"
#include "solid.hpp"
#include "solid_checkerboard.hpp"
#include "stage.hpp"

namespace texmap::chapter_14 {

/// Whose formulas draw.
enum class Care {
  plain,   ///< the seeds', as they wrote them
  robust,  ///< the course's, of the form that the scene needs
};

/// What one ray sees, and where on the texture it looks.
template <class Real>
struct Sight {
  Color<Real> color{};
  Uv<Real> uv{};  ///< of a hit on a textured thing
  bool hit = false;
  bool mapped = false;   ///< true if `uv` means anything
  Real round = Real(1);  ///< length of the circle of this v, compared with the equator's: near a pole, u counts for little
};

/// Drawn where a formula gives a place outside the texture, or no number at all.
inline constexpr Rgb no_texel{1, 0, 1};
/// Drawn beside the things on show.
inline constexpr Rgb background{0.1, 0.1, 0.15};
inline constexpr Rgb sky{0.6, 0.75, 1};

/// A camera that sees a circle of this radius round the world's origin from so many units in front of it.
[[nodiscard]] inline Camera towards_origin(Point eye, double radius) {
  return {.eye = eye, .target = {}, .fov_y_degrees = 360 / std::numbers::pi * std::atan(radius / length(eye))};
}

/// The shade of a texture of stripes: turns along u, rings along v. For looking at less than a texel.
struct Graticule {
  double sectors = 12;
  double rings = 16384;
  Rgb light{0.95, 0.9, 0.75};
  Rgb dark{0.15, 0.3, 0.65};

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const Real parity = cell_parity(uv.u * Real(sectors), Real(1)) + cell_parity(uv.v * Real(rings), Real(1));
    return select(parity == Real(1), number_cast<Real>(dark), number_cast<Real>(light));
  }
};

/// What a ray sees of a globe without light: the texture alone.
template <class Real, class Texture>
[[nodiscard]] Sight<Real> sight_of_globe(const Sphere& globe, const Texture& texture, const Ray<Real>& ray, Care care) {
  const Sphere sphere{globe.center, globe.radius, care == Care::plain ? SphereForm::plain : SphereForm::hybrid};
  const Real distance = distance_to(sphere, ray);
  if (!(distance < infinity<Real>())) return {number_cast<Real>(background)};
  const Hit<Real> hit = hit_at(sphere, ray, distance);
  const Uv<Real> uv = care == Care::plain ? seeds::uv_next_week_v4(hit.normal) : uv_rtiow(hit.normal);
  const bool on_texture = uv.u >= Real(0) && uv.u < Real(1) && uv.v >= Real(0) && uv.v <= Real(1);
  const Real round = sqrt(square(hit.normal.x) + square(hit.normal.z));
  return {on_texture ? texture(uv) : number_cast<Real>(no_texel), uv, true, on_texture, round};
}

/// A globe seen from outside.
template <class Texture>
struct Globe {
  const char* name;
  const char* caption;
  Camera camera;
  Sphere sphere;
  Texture texture;

  template <class Real>
  [[nodiscard]] Sight<Real> operator()(const Ray<Real>& ray, Care care) const {
    return sight_of_globe(sphere, texture, ray, care);
  }
};

/// The stage with its plain spheres, in some unit and on some ground. Seeds start a shadow ray where the eye's ray ended and
/// look beyond 0.001; the course starts it off the surface by a bound on the rounding errors.
struct Shadows {
  const char* name;
  const char* caption;
  double unit = 1;  ///< all lengths are multiplied by it
  double ground_radius = 1000;
  Camera camera{.eye = {0, 2 * unit, 8 * unit}, .target = {0, 0, 0}};
  PointLight light{.position = {5 * unit, 5 * unit, 5 * unit}};
  std::vector<Painted<Solid>> objects = {
      {{{0, 0, 0}, unit}, {{0.9, 0.9, 0.9}}},
      {{{-2.5 * unit, 0, unit}, 0.8 * unit}, {{1.0, 0.3, 0.3}}},
      {{{2.5 * unit, 0, unit}, 0.8 * unit}, {{0.2, 0.2, 0.8}}},
      {{{0, -(ground_radius + 1) * unit, 0}, ground_radius* unit, SphereForm::hybrid}, {{0.9, 0.9, 0.9}}},
  };

  template <class Real>
  [[nodiscard]] Sight<Real> operator()(const Ray<Real>& ray, Care care) const {
    Sight<Real> sight{number_cast<Real>(sky)};
    if (care == Care::robust) {
      sight.color = color_along(
          objects, ray, [&](const auto&) { return sight.color; },
          [&](const auto& object, const auto& hit) {
            sight.hit = true;
            return object.paint(hit) * lambert(Matt{}, illumination(light, objects, hit));
          });
      return sight;
    }
    Real nearest = infinity<Real>();
    const Painted<Solid>* seen = nullptr;
    for (const auto& object : objects) {
      const Real distance = seeds::distance_half_b(object.sphere, ray);
      if (distance < nearest) seen = &object;
      nearest = smaller(distance, nearest);
    }
    if (seen == nullptr) return sight;
    const Vec3<Real> point = ray.origin + ray.direction * nearest;
    const Vec3<Real> normal = (point - number_cast<Real>(seen->sphere.center)) * (Real(1) / Real(seen->sphere.radius));
    const Vec3<Real> path = number_cast<Real>(light.position) - point;
    const Real away = length(path);
    const Vec3<Real> to_light = path * (Real(1) / away);
    Real cosine = larger(dot(normal, to_light), Real(0));
    for (const auto& object : objects) {
      if (seeds::distance_half_b(object.sphere, Ray<Real>{point, to_light}) < away) cosine = Real(0);
    }
    return {number_cast<Real>(seen->paint.color) * (Real(0.2) + Real(0.8) * cosine), {}, true};
  }
};

/// A picture on a triangle 10,000 times as high as wide, drawn as if it were as wide as high.
struct Needle {
  const char* name = "needle";
  const char* caption = "a needle 10,000 times higher than wide";
  Camera camera = towards_origin({0, 0, 1}, 0.55);
  double half_width = 0.00005;
  ImageTexture texture;

  template <class Real>
  [[nodiscard]] Sight<Real> operator()(const Ray<Real>& ray, Care care) const {
    const Triangle triangle{{-half_width, -0.5, 0}, {half_width, -0.5, 0}, {0, 0.5, 0}};
    const Real x = ray.direction.x / -ray.direction.z;
    const Real y = ray.direction.y / -ray.direction.z;
    const Vec3<Real> p{x * Real(2 * half_width), y, Real(0)};
    // Where the triangle is, is not the question here: only the weights are.
    if (!(abs(y) < Real(0.5) && abs(x) < (Real(0.5) - y) * Real(0.5))) return {number_cast<Real>(background)};
    const Barycentric<Real> weights = care == Care::plain ? seeds::barycentric_heron(triangle, p) : barycentric(triangle, p);
    const Uv<Real> uv{weights.b + weights.c * Real(0.5), weights.c};
    const bool number = uv.u == uv.u && uv.v == uv.v;
    return {number ? texture(uv) : number_cast<Real>(no_texel), uv, true, number};
  }
};

/// A floor of cubes, ten million cells from the world's origin. Robust is to count the cells from a corner nearby that is an
/// even number of cells away: there the number still has digits for a part of a cell.
struct FarFloor {
  const char* name = "far-floor";
  const char* caption = "a checkerboard 1e7 cells away";
  Camera camera{.eye = {10000000.25, 2, 10000003.25}, .target = {10000000.25, 0, 9999996.25}, .fov_y_degrees = 50};
  SolidCheckerboard board{.even = {0.95, 0.95, 0.9}, .odd = {0.2, 0.25, 0.3}, .cell = 1};

  template <class Real>
  [[nodiscard]] Sight<Real> operator()(const Ray<Real>& ray, Care care) const {
    const Floor floor{};
    const Real distance = distance_to(floor, ray);
    if (!(distance < Real(60))) return {number_cast<Real>(sky)};
    if (care == Care::plain) return {board(ray.origin + ray.direction * distance), {}, true};
    // The camera's place is the scene's and known in double.
    const double pair = 2 * board.cell;
    const Point corner{pair * std::floor(camera.eye.x / pair), 0, pair * std::floor(camera.eye.z / pair)};
    return {board(point_on(floor, Ray<Real>{number_cast<Real>(camera.eye - corner), ray.direction}, distance)), {}, true};
  }
};

/// A globe after a million turns of a tenth of a degree: the angle added up, or multiplied and reduced in degrees.
struct ManyTurns {
  const char* name = "turns";
  const char* caption = "after 1e6 turns of 0.1 degrees";
  Camera camera = towards_origin({0, 1, 3}, 1.15);
  ImageTexture texture;

  /// The angle added up step by step, as an animation does it.
  template <class Real>
  [[nodiscard]] static Real sum_of_steps() {
    Real sum = Real(0);
    for (int i = 0; i < 1000000; ++i) sum = sum + Real(0.1L);
    return sum;
  }

  template <class Real>
  [[nodiscard]] Sight<Real> operator()(const Ray<Real>& ray, Care care) const {
    static const Real sum = sum_of_steps<Real>();
    static const Real radians = sum * pi<Real>() / Real(180);
    static const SineCosine<Real> plain{sin(radians), cos(radians)};
    // A million tenths are 100,000 degrees, and that is 280 beyond whole turns.
    static const SineCosine<Real> robust = sine_cosine_of_degrees(Real(1000000) / Real(10));
    const SineCosine<Real>& turn = care == Care::plain ? plain : robust;

    const Sphere globe{{}, 1};
    const Real distance = distance_to(globe, ray);
    if (!(distance < infinity<Real>())) return {number_cast<Real>(background)};
    const Vec3<Real> n = hit_at(globe, ray, distance).normal;
    const Uv<Real> uv = uv_rtiow(Vec3<Real>{n.x * turn.cosine + n.z * turn.sine, n.y, n.z * turn.cosine - n.x * turn.sine});
    return {texture(uv), uv, true, true};
  }
};

/// The lecture's globe with an odd exponent: its highlight has the wrong sign, and an even exponent hides it.
struct OddExponent {
  const char* name = "highlight";
  const char* caption = "a highlight with exponent 101";
  Camera camera{.eye = {0, 0, 4}, .target = {0, 0, 0}, .fov_y_degrees = 36};
  Finish finish{.matt = {}, .specular = 1, .shininess = 101};

  template <class Real>
  [[nodiscard]] Sight<Real> operator()(const Ray<Real>& ray, Care care) const {
    const std::array<Painted<Solid>, 1> globe{{{{{}, 1}, {{0.75, 0.45, 0.1}}}}};
    const Real distance = distance_to(globe[0].sphere, ray);
    if (!(distance < infinity<Real>())) return {number_cast<Real>(background)};
    const Hit<Real> hit = hit_at(globe[0].sphere, ray, distance);
    const Illumination<Real> lamp = illumination(PointLight{{3, 2, 2}}, globe, hit);
    const HighlightFormula formula = care == Care::plain ? HighlightFormula::lecture : HighlightFormula::phong;
    const Real gloss = highlight(formula, finish, lamp, hit.normal, -ray.direction);
    return {globe[0].paint(hit) * lambert(finish.matt, lamp) + gray(gloss), {}, true};
  }
};

}  // namespace texmap::chapter_14
