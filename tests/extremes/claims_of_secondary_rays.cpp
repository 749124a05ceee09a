// Claims of common/scene/sphere.hpp and light.hpp: rays that leave a surface after a hit.
#include "claims.hpp"
#include "scene/light.hpp"
#include "scene/sphere.hpp"
#include "scene/stage.hpp"

namespace texmap::extremes {
namespace {

/// A sphere somewhere, and a ray that meets it.
template <class T>
struct Scene {
  Sphere<> sphere;
  Ray<T> ray;
};

std::string name(SphereForm form) {
  return form == SphereForm::plain ? "plain" : form == SphereForm::robust ? "robust" : "hybrid";
}

/// How far from a sphere the rays start that meet it, as a power of ten of its radius: as far as
/// the form holds, but the plain one, which fails at once.
template <class T>
int farthest_origin(SphereForm form) {
  return form == SphereForm::plain ? 2 : by_number<T>(4, 7, 7);
}
/// How far from the origin a sphere is, as a power of ten of its radius.
template <class T>
constexpr int farthest_center = std::is_same_v<T, float> ? 5 : 13;

template <class T>
Scene<T> draw_scene(Dice& dice, SphereForm form) {
  const long double radius = dice.power_of_ten(-6, 6);
  const long double most = std::min(7.0L, farthest_center<T> + std::log10(radius));
  const long double away = dice.once_in(8) ? 0 : dice.power_of_ten(most - 14, most);
  const Vec3<long double> center = dice.direction() * away;
  const long double from = dice.once_in(3)   ? 5.0L
                           : dice.once_in(3) ? dice.uniform(0, 0.999L)
                                             : dice.power_of_ten(0.01L, farthest_origin<T>(form));
  const Vec3<long double> eye = center + dice.direction() * (radius * from);
  const Vec3<long double> aim = center + dice.direction() * (radius * dice.uniform(0, 1));
  return {{number_cast<double>(center), static_cast<double>(radius), form},
          {number_cast<T>(eye), number_cast<T>(aim - eye)}};
}

/// A direction on the outer side of a surface, often nearly along it.
template <class T>
Vec3<T> outward(Dice& dice, const Vec3<T>& normal) {
  const auto n = number_cast<long double>(normal);
  Vec3<long double> direction = dice.direction();
  if (dice.once_in(3)) direction = dice.across(n) + n * dice.power_of_ten(-20, -1);
  const Vec3<T> result = number_cast<T>(direction);
  return dot(result, normal) < T(0) ? -result : result;
}

/// Rays outward from where another ray hit a sphere that meet it again.
template <class T>
Measurement count_met_again(SphereForm form) {
  return worst_over(20, [=](Dice& dice, Worst& worst) {
    const auto [sphere, ray] = draw_scene<T>(dice, form);
    const T distance = distance_to(sphere, ray);
    if (!(distance < infinity<T>())) return;
    const Hit<T> hit = hit_at(sphere, ray, distance);
    const Vec3<T> onward = outward(dice, hit.normal);
    const T again = distance_to(sphere, Ray<T>{hit.outside, onward});
    worst.see(again < infinity<T>(), [&, &sphere = sphere, &ray = ray] {
      return "center " + described(sphere.center) + ", radius " + described(sphere.radius) +
             ", ray " + described(ray) + ", onward " + described(onward);
    });
  });
}

/// One object: the list that light.hpp asks for.
struct Ground {
  Sphere<> shape;
};

/// Points of the daily exercise's ground, seen from the stage's camera, that shadow themselves:
/// acne. The light's ray starts at the lifted point, or at the point itself.
template <class T>
Measurement count_acne(SphereForm form, bool lifted) {
  const Stage stage;
  const View<> view = view_of(stage.camera, 800, 600);
  const Ground ground[] = {{{{0, -1001, 0}, 1000, form}}};
  return worst_over(20, [=](Dice& dice, Worst& worst) {
    const auto column = static_cast<T>(dice.uniform(0, 800));
    const auto row = static_cast<T>(dice.uniform(0, 600));
    const Ray<T> ray = ray_through(view, column, row);
    const T distance = distance_to(ground[0].shape, ray);
    if (!(distance < infinity<T>())) return;
    Hit<T> hit = hit_at(ground[0].shape, ray, distance);
    if (!lifted) hit.outside = ray.origin + ray.direction * distance;
    const LightSample<T> light = sample_light(stage.light, ground, hit);
    // The light is clearly above the horizon of the point.
    const bool lit = dot(hit.normal, light.to_light) > T(1e-3L);
    worst.see(lit && !(light.cosine > T(0)), [&] { return described(ray); });
  });
}

/// Which way the light is, from what the hit point says.
template <class T>
Measurement worst_to_light() {
  const std::vector<Ground> nothing;
  return worst_over(1, [=](Dice& dice, Worst& worst) {
    const Vec3<T> point = number_cast<T>(dice.direction() * dice.power_of_ten(-6, 6));
    const Vec3<float> lamp = number_cast<float>(dice.direction() * dice.power_of_ten(-6, 6));
    const PointLight light{number_cast<double>(lamp)};
    const Hit<T> hit{{T(0), T(1), T(0)}, point, point};
    const Vec3<T> got = sample_light(light, nothing, hit).to_light;
    worst.see(length_off(got, normalize(exactly(light.position) - exactly(point))),
              [&] { return described(point); });
  });
}

template <class T>
void add_rays(Family& family, SphereForm form) {
  const int from = farthest_origin<T>(form);
  const std::string domain =
      "radius 1e-6 to 1e6, center to 1e7 away, but to 1e" + std::to_string(farthest_center<T>) +
      " radii; met from inside and from 1 to " + (from == 2 ? "100" : "1e" + std::to_string(from)) +
      " radii; all directions, also along the surface";
  family
      .add<T>("rays outward from a hit, " + name(form), domain, {0, "meet their own sphere"},
              count_met_again<T>(form))
      .expect = form == SphereForm::plain ? Expect::beyond : Expect::within;
}

template <class T>
Claim& add_acne(Family& family, SphereForm form, bool lifted) {
  return family.add<T>(
      (lifted ? "sample_light by the lift alone, " : "sample_light without the lift, ") +
          name(form),
      "the daily exercise's ground (radius 1000) from its camera; the ground itself is asked",
      {0, "points in their own shadow"}, count_acne<T>(form, lifted));
}

}  // namespace

Family claims_of_secondary_rays() {
  Family family{
      "Rays that go on from a hit",
      "A ray that leaves a surface outward must not meet it again, or the surface shadows itself. "
      "The plain form cannot do it: its c is a difference of squares. The last rows start at the "
      "point itself."};
  for (const SphereForm form : {SphereForm::plain, SphereForm::robust, SphereForm::hybrid}) {
    for_each<float, double, long double>([&]<class T>() { add_rays<T>(family, form); });
    for_each<float, double>([&]<class T>() { add_acne<T>(family, form, true); });
  }
  for_each<float, double, long double>([&]<class T>() {
    family.add<T>("sample_light, direction", "points and lamps 1e-6 to 1e6 from the origin",
                  {5.5, "u"}, worst_to_light<T>());
  });
  add_acne<float>(family, SphereForm::plain, false).expect = Expect::beyond;
  add_acne<double>(family, SphereForm::robust, false).expect = Expect::beyond;
  return family;
}

}  // namespace texmap::extremes
