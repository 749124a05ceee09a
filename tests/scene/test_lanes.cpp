// The law of packs for math, sampling and scene: each lane computes what a plain number computes.
#include <doctest.h>

#include "sampling/sampled_numbers.hpp"
#include "scene/floor.hpp"
#include "scene/lens.hpp"
#include "scene/light.hpp"
#include "scene/paint.hpp"
#include "scene/path.hpp"
#include "scene/phong.hpp"
#include "scene/sky.hpp"
#include "scene/triangle.hpp"
#include "support/lanes.hpp"
#include "support/mesh_rays.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::test {
namespace {

const View<> view = view_of({.eye = {0, 2, 8}, .target = {0, 0, 0}}, 31, 17);
const Floor ground{0.25};
const GradientSky one_color{.below = {1, 0.5, 0.25}, .above = {1, 0.5, 0.25}};
const GradientSky fading{.below = {1, 1, 1}, .above = {0.5, 0.75, 1}};
const std::vector<Painted<Solid>> spheres = {{{{0, 0, -5}, 1}, {{0.5, 0.25, 1}}},
                                             {{{0, 0, 5}, 1}, {{0.25, 1, 0.5}}},
                                             {{{3, 0, 0}, 2}, {{0.75, 0.5, 0.25}}}};
const std::vector<Painted<Solid>> one_sphere = {spheres[0]};
const Triangle triangles[] = {{{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0.2}},              // ordinary,
                              {{0, 0, 0}, {1, 0.5, 0.25}, {0.3, 0.1501, 0.075}},  // thin,
                              {{1, 2, 3}, {1, 2, 3}, {4, 5, 7}}};                 // none
const Mesh ring = torus(12, 6).mesh;

template <class Real>
Real number_of(const Mask<Real>& mask) {
  return select(mask, Real(1), Real(0));
}

/// What a ray meets, and nothing where it meets nothing.
template <class Real>
auto met_on(const Sphere<>& sphere, const Ray<Real>& ray) {
  const Real distance = distance_to(sphere, ray);
  const Hit<Real> hit = hit_at(sphere, ray, select(distance < infinity<Real>(), distance, Real(1)));
  return std::tuple(distance, hit.normal, hit.point, hit.outside, hit.inside);
}

TEST_CASE_TEMPLATE("each lane computes what a plain number computes", Many, Pack<float>,
                   Pack<double>, Pack2<Pack<double>>) {
  Dice dice;
  const auto number = [&dice](double low, double high) {
    return [=, &dice] { return any_pack<Many>(dice, low, high); };
  };
  const auto vector = [&dice](double reach) {
    return [=, &dice] { return any_vectors<Many>(dice, -reach, reach); };
  };
  const auto unit = [&dice] { return normalize(any_vectors<Many>(dice, -1, 1)); };
  const auto ray = [&dice](double reach, double wide) {
    return [=, &dice] {
      return Ray<Many>{any_vectors<Many>(dice, -reach, reach),
                       any_vectors<Many>(dice, -wide, wide)};
    };
  };
  // Halves: edges through the ray, and corners in one place, are often among them.
  const auto halves = [&dice] {
    const auto half = [&] {
      return from_lanes<Many>(
          [&](std::size_t) { return static_cast<Scalar<Many>>(dice.within(-3, 3)) / 2; });
    };
    const Many x = half(), y = half();
    return Vec3<Many>{x, y, half()};
  };
  const auto at_edge = [&dice] {
    return aimed<Many>([&] { return point_within(dice, 3); },
                       [&] { return point_on_edge(dice, ring); });
  };
  const auto law = [](const std::string& what, int times, const auto& function,
                      const auto&... draw) {
    CAPTURE(what);
    for (int i = 0; i < times; ++i) check_each_lane<Many>(function, draw()...);
  };
  law(
      "direction_rtiow", 200,
      []<class Real>(const Real& u, const Real& v) {
        return direction_rtiow(Uv<Real>{u, v});
      },
      number(-2, 2), number(0, 1));
  law(
      "cosine_direction", 200,
      []<class Real>(const Vec3<Real>& normal, const Real& u, const Real& v) {
        return cosine_direction(normal, Point2<Real>{u, v});
      },
      unit, number(0, 1), number(0, 1));
  law(
      "Lens", 100,
      []<class Real>(const Real& column, const Real& row) {
        const Lens lens{.defocus_degrees = 3, .focus_distance = 8, .shift = 0.5};
        SampledNumbers<Real> random{{SamplerKind::sobol, 64}, 5};
        return lens.ray(number_cast<Real>(view), PixelPlace<Real>{column, row}, random);
      },
      number(0, 31), number(0, 17));
  law(
      "Floor", 1000,
      []<class Real>(const Ray<Real>& in) {
        const Real distance = distance_to(ground, in);
        const Mask<Real> met = distance < infinity<Real>();
        return std::tuple(distance, point_on(ground, in, select(met, distance, Real(1))));
      },
      ray(1, 1));
  for (const SphereForm form : {SphereForm::plain, SphereForm::robust, SphereForm::hybrid}) {
    law(
        "Sphere", 500,
        [&](const auto& in) {
          return met_on({{0.5, -0.25, 1}, 1.25, form}, in);
        },
        ray(2, 1));
  }
  for (const Triangle& triangle : triangles) {
    law(
        "barycentric", 500,
        [&]<class Real>(const Vec3<Real>& p) {
          const Vec3<Real> at{p.x, p.y, p.z / floor(abs(p.x))};  // in many lanes nowhere
          const Barycentric<Real> w = barycentric(triangle, at);
          return std::tuple(w.a, w.b, w.c, number_of<Real>(w.degenerate));
        },
        vector(2));
  }
  law(
      "crossing", 2000,
      []<class Real>(const Vec3<Real>& from, const Vec3<Real>& along, const Vec3<Real>& a,
                     const Vec3<Real>& b, const Vec3<Real>& c) {
        const RaySpace<Real> space(Ray<Real>{from, along});
        const Crossing<Real> at =
            crossing(space, seen_along(space, a), seen_along(space, b), seen_along(space, c));
        return std::tuple(number_of<Real>(at.met), number_of<Real>(at.front),
                          select(at.met, at.a, Real(0)), select(at.met, at.distance, Real(0)));
      },
      halves, halves, halves, halves, halves);
  law(
      "first_hit", 500,
      []<class Real>(const Ray<Real>& in) {
        const MeshHit<Real> hit = first_hit(ring, in);
        const Vec3<Real> none{};
        return std::tuple(number_of<Real>(hit.met), select(hit.met, hit.point, none),
                          select(hit.met, hit.normal, none), select(hit.met, hit.triangle, Real(0)),
                          select(hit.met, hit.b, Real(0)));
      },
      at_edge);
  law(
      "color_along", 500,
      []<class Real>(const Ray<Real>& in) {
        return color_along(
            spheres, in, [](const auto& seen) { return gray(seen.direction.x); },
            [](const auto& object, const auto& hit) { return object.paint(hit); });
      },
      ray(4, 1));
  law(
      "sample_light, lambert", 500,
      []<class Real>(const Vec3<Real>& p, const Vec3<Real>& normal) {
        const LightSample<Real> light =
            sample_light(PointLight{{0, 4, 0}}, spheres, Hit<Real>{normal, p, p, p});
        return std::tuple(light.to_light, light.cosine, lambert(Lambertian{}, light));
      },
      vector(5), unit);
  law(
      "highlight_of_the_slides", 200,
      []<class Real>(const Vec3<Real>& normal, const Vec3<Real>& to_eye) {
        const LightSample<Real> light{{Real(0), Real(1), Real(0)}, Real(1)};
        return highlight_of_the_slides(PhongMaterial{{}, 1, 100}, light, normal, to_eye);
      },
      unit, unit);
  for (const GradientSky& sky : {one_color, fading}) {
    for (const auto& scene : {one_sphere, spheres}) {
      law(
          "light_along", 500,
          [&]<class Real>(const Real& x, const Real& y) {
            SampledNumbers<Real> random{{SamplerKind::random, 64}, 5};
            return light_along(scene, Ray<Real>{{}, {x, y, Real(-1)}}, sky, 8, random);
          },
          number(-1, 3), number(-1, 1));
    }
  }
}

}  // namespace
}  // namespace texmap::test
