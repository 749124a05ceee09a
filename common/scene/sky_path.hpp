// Paths of light between matte and mirroring surfaces under a sky that is a picture.
#pragma once
#include <iterator>

#include "scene/path.hpp"
#include "scene/phong.hpp"

namespace texmap {

/// How a matte surface finds light in the sky. To add one, name it here and in sky_options.cpp. One
/// without directions has a branch of its own in light_under_sky, as `coefficients` has. Its law is
/// a row of `sampled_ways` in tests/scene/test_sky_path.cpp.
enum class SkyLighting {
  uniform,       ///< directions from the whole sphere, all equally likely
  cosine,        ///< likely where Lambert's cosine is large
  importance,    ///< likely where the sky is bright; one in eight by the cosine
  mis,           ///< one by the cosine and one by the sky: multiple importance sampling
  coefficients,  ///< nine numbers of the sky, and no direction; without shadows
};

/// How matte surfaces are lit.
struct MatteLight {
  SkyLighting way = SkyLighting::cosine;
  bool caustics = false;  ///< what mirrors throw on them, found by chance: few, very bright dots
};

/// A paint of one color on a matte surface or on a mirror.
struct Coat {
  Rgb color;
  bool mirrors = false;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>&) const {
    return number_cast<Real>(color);
  }
};

/// A direction in which a path goes on.
template <class Real>
struct Scattered {
  Vec3<Real> direction;  ///< of unit length
  Real weight;           ///< cosine / pi / density of the direction: a factor on its light
};

/// The weight in `mis` of a direction that the cosine and the sky both draw: cosine / pi over the
/// sum of the two densities, whichever of them drew it.
/// Source: Veach and Guibas (1995), the balance heuristic.
template <class Real>
[[nodiscard]] Real weight_of_both(const Real& cosine, const Real& density) {
  const Real both = cosine + pi<Real>() * density;
  return select(both > Real(0), cosine / both, Real(0));
}

/// The next direction of a path at a matte surface. The mean of weight times light over many of
/// them is the light that a white surface sends out; `mis` has weight_of_both for the sky's light.
///
/// @param normal, place  of unit length; u and v in [0, 1)
/// `importance` takes one in eight by the cosine: a ball before a black sky sends light, too.
template <class Real, class Sky>
[[nodiscard]] Scattered<Real> scatter(SkyLighting lighting, const Sky& sky,
                                      const Vec3<Real>& normal, const Point2<Real>& place) {
  switch (lighting) {
    case SkyLighting::cosine:
    case SkyLighting::mis:
      return {cosine_direction(normal, place), Real(1)};
    case SkyLighting::uniform: {
      const OnCircle<Real> around = on_circle(place.u);
      const Real y = Real(1) - Real(2) * place.v;
      const Real radius = Real(2) * sqrt(place.v * (Real(1) - place.v));
      const Vec3<Real> direction = {radius * around.cosine, y, radius * around.sine};
      return {direction, Real(4) * max(dot(normal, direction), Real(0))};
    }
    case SkyLighting::importance:
    case SkyLighting::coefficients:
      break;
  }
  const Real share = Real(0.125);  // of directions that the cosine draws
  const Mask<Real> by_cosine = place.u < share;
  const Point2<Real> spread = {
      select(by_cosine, place.u / share, (place.u - share) / (Real(1) - share)), place.v};
  const Vec3<Real> direction =
      select(by_cosine, cosine_direction(normal, spread), sky.draw(false, spread).direction);
  const Real cosine = max(dot(normal, direction), Real(0));
  const Real both =
      share * cosine + (Real(1) - share) * pi<Real>() * sky.density(false, sky.toward(direction));
  return {direction, select(both > Real(0), cosine / both, Real(0))};
}

/// True where an object hides the sky from a ray that starts outward at the object `leaving`: it is
/// is_occluded with an index in each lane.
// A function of its own: with such an index the shadows of chapter 01 would take 3 % longer.
template <class Real, class Objects>
[[nodiscard]] Mask<Real> is_hidden(const Objects& objects, const Ray<Real>& ray,
                                   const Real& leaving) {
  Real first = infinity<Real>();
  for (double index = 0; const auto& object : objects) {
    const Mask<Real> other = !(leaving == Real(index++));
    const Mask<Real> may_hide = other || mask_of<Real>(!object.shape.convex());
    if (any(may_hide))
      first = min(select(may_hide, distance_to(object.shape, ray), infinity<Real>()), first);
  }
  return first < infinity<Real>();
}

/// The light that arrives along a ray from matte and mirroring objects under a sky: one path.
///
/// @param objects, bounces  paints are Coats; after `bounces` >= 1 a path brings no light
/// @param sky               as SkyLight; a constant one over a lone object needs no direction
/// Without `caustics` a mirror is matte to paths that come from a matte surface: Kaplanyan and
/// Dachsbacher (2013).
template <class Real, class Objects, class Sky, class Random>
[[nodiscard]] Color<Real> light_under_sky(const Objects& objects, Ray<Real> ray, const Sky& sky,
                                          const MatteLight& matte, int bounces, Random& random) {
  if (std::empty(objects) ||
      (sky.is_constant() && std::size(objects) == 1 && std::begin(objects)->shape.convex()))
    return light_along(objects, ray, sky, bounces, random);
  ray.direction = normalize(ray.direction);
  Color<Real> carried = gray(Real(1));
  const Color<Real> black = gray(Real(0));
  Color<Real> light = black;
  Mask<Real> under_way = mask_of<Real>(true);
  Mask<Real> sharp = under_way;  // mirrors are mirrors
  Mask<Real> escaped = !under_way;
  Mask<Real> shared = escaped;  // what the ray sees of the sky has been drawn by the sky, too
  Real cosine = Real(1);        // at the surface that a shared ray leaves
  for (int bounce = 0;; ++bounce) {
    Nearest<Real> nearest = find_nearest(objects, ray);
    nearest.index = select(under_way, nearest.index, Real(-1));
    const Mask<Real> met = nearest.index >= Real(0);
    escaped = escaped || (under_way && !met);
    under_way = met;
    if (bounce == bounces || !any(under_way)) break;

    // Every path draws as many numbers: packs and single numbers then follow the same paths.
    Point2<Real> place{}, in_sky{};
    if (matte.way != SkyLighting::coefficients) place = random.next_2d();
    if (matte.way == SkyLighting::mis) in_sky = random.next_2d();
    Ray<Real> next = ray;
    Vec3<Real> normal = ray.direction;  // where the path scatters
    Mask<Real> scatters = mask_of<Real>(false);
    const auto follow = [&](const auto& object, const Hit<Real>& hit, const Mask<Real>& here) {
      carried = select(here, carried * object.paint(hit), carried);
      next.origin = select(here, hit.outside, next.origin);
      normal = select(here, hit.normal, normal);
      Mask<Real> dull = here;
      if (object.paint.mirrors) {
        next.direction = select(here && sharp, mirror(-ray.direction, hit.normal), next.direction);
        dull = here && !sharp;
      }
      scatters = scatters || dull;
    };
    for_each_hit(objects, ray, nearest, follow);
    if (matte.way == SkyLighting::coefficients) {
      light = select(scatters, carried * sky.reflected(normal), light);
      under_way = under_way && !scatters;
    } else if (any(scatters)) {
      const Scattered<Real> next_way = scatter(matte.way, sky, normal, place);
      carried = select(scatters, carried * next_way.weight, carried);
      next.direction = select(scatters, next_way.direction, next.direction);
      under_way = under_way && !(scatters && next_way.weight <= Real(0));
      if (matte.way == SkyLighting::mis) {
        const auto drawn = sky.draw(true, in_sky);
        const Ray<Real> to_sky = {next.origin, drawn.direction};
        const Real toward = dot(normal, to_sky.direction);
        Mask<Real> lit = scatters && toward > Real(0);
        if (any(lit)) lit = lit && !is_hidden(objects, to_sky, nearest.index);
        if (any(lit)) {
          const Real weight = weight_of_both(toward, sky.density(true, drawn));
          light = light + select(lit, carried * sky.picture.at(drawn.uv) * weight, black);
        }
        cosine = select(scatters, dot(normal, next_way.direction), cosine);
      }
      if (!matte.caustics) sharp = sharp && !scatters;
    }
    shared = (shared && !under_way) || scatters;
    ray = next;
  }
  // The sky, as the rays that escaped see it.
  if (any(escaped)) {
    const auto place = sky.toward(ray.direction);
    Color<Real> seen = carried * sky.picture.at(place.uv);
    if (matte.way == SkyLighting::mis && any(shared)) {
      const Real weight = weight_of_both(cosine, sky.density(true, place));
      seen = select(shared, seen * weight, seen);
    }
    light = light + select(escaped, seen, black);
  }
  return light;
}

}  // namespace texmap
