// Claims of common/scene/hit.hpp and light.hpp: rays that leave a surface after a hit.
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

constexpr SphereForm all_forms[] = {SphereForm::plain, SphereForm::robust, SphereForm::hybrid};
const char* const names[] = {"plain", "robust", "hybrid"};
const char* name(SphereForm form) { return names[static_cast<std::size_t>(form)]; }

/// How far from a sphere the rays start that meet it, as a power of ten of its radius: as far as
/// the form holds, but the plain one, which fails at once.
template <class T>
long double farthest_origin(SphereForm form) {
  if (form == SphereForm::plain) return 2;
  return std::numeric_limits<T>::digits == 24 ? 4 : 7;
}

template <class T>
Scene<T> draw_scene(Dice& dice, SphereForm form, long double farthest) {
  const long double radius = dice.power_of_ten(-6, 6);
  const long double most = std::min(7.0L, farthest + std::log10(radius));
  const long double away = dice.once_in(8) ? 0 : dice.power_of_ten(most - 14, most);
  const Vec3<long double> center = dice.direction() * away;
  const long double from = dice.once_in(3)   ? 5.0L
                           : dice.once_in(3) ? dice.uniform(0, 0.999L)
                                             : dice.power_of_ten(0.01L, farthest_origin<T>(form));
  const Vec3<long double> eye = center + dice.direction() * (radius * from);
  const Vec3<long double> aim = center + dice.direction() * (radius * dice.uniform(0, 1));
  return {{number_cast<double>(center), static_cast<double>(radius), form},
          {rounded<T>(eye), rounded<T>(aim - eye)}};
}

/// A direction on the outer side of a surface, often nearly along it.
template <class T>
Vec3<T> outward(Dice& dice, const Vec3<T>& normal) {
  const auto n = number_cast<long double>(normal);
  Vec3<long double> direction = dice.direction();
  if (dice.once_in(3)) direction = dice.across(n) + n * dice.power_of_ten(-20, -1);
  const Vec3<T> result = rounded<T>(direction);
  return dot(result, normal) < T(0) ? -result : result;
}

enum class Fault { self_hit, lost };

/// Of rays that leave a sphere where another ray hit it: those outward that meet it again, or those
/// inward that find no far side.
template <class T>
auto count_faults(SphereForm form, long double farthest, Fault fault) {
  return worst_over(20, [=](Dice& dice, Worst& worst) {
    const auto [sphere, ray] = draw_scene<T>(dice, form, farthest);
    const T distance = distance_to(sphere, ray);
    if (!(distance < infinity<T>())) return;
    const Hit<T> hit = hit_at(sphere, ray, distance);
    const Vec3<T> out = outward(dice, hit.normal);
    const Vec3<T> onward = fault == Fault::self_hit ? out : -out;
    // Exactly along the surface is outward.
    if (fault == Fault::lost && !(dot(hit.normal, onward) < T(0))) return;
    const bool met = distance_to(sphere, ray_from(hit, onward)) < infinity<T>();
    worst.count(met == (fault == Fault::self_hit), [&, &sphere = sphere, &ray = ray] {
      return "center " + described(sphere.center) + ", radius " + described(sphere.radius) +
             ", ray " + described(ray) + ", onward " + described(onward);
    });
  });
}

template <class T>
void add_rays(Family& family, SphereForm form, long double farthest, const std::string& far) {
  const auto from = static_cast<int>(farthest_origin<T>(form));
  const std::string domain = "radius 1e-6 to 1e6, center to 1e7 away, but to " + far +
                             " radii; met from inside and from 1 to " +
                             (from == 2 ? "100" : "1e" + std::to_string(from)) +
                             " radii; all directions, also along the surface";
  const auto add = [&](const char* way, const char* unit, Fault fault) {
    family
        .add<T>(std::string("ray_from ") + way + ", " + name(form), domain, {0, unit},
                count_faults<T>(form, farthest, fault))
        .expect = form == SphereForm::plain ? Expect::beyond : Expect::within;
  };
  add("outward", "meet their own sphere", Fault::self_hit);
  add("inward", "find no far side", Fault::lost);
}

/// One object: the list that light.hpp asks for.
struct Ground {
  Sphere<> shape;
};

/// Where the light's ray starts.
enum class Start { lifted, from_point };

/// Points of the daily exercise's ground, seen from the stage's camera, that shadow themselves:
/// acne.
template <class T>
auto count_acne(SphereForm form, Start start) {
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
    if (start == Start::from_point) hit.outside = ray.origin + ray.direction * distance;
    const LightSample<T> light = sample_light(stage.light, ground, hit);
    // The light is clearly above the horizon of the point.
    const bool lit = dot(hit.normal, light.to_light) > T(1e-3L);
    worst.count(lit && !(light.cosine > T(0)), [&] { return described(ray); });
  });
}

/// Which way the light is, from what the hit point says.
template <class T>
auto worst_to_light() {
  const std::vector<Ground> nothing;
  return worst_over([=](Dice& dice, Worst& worst) {
    const Vec3<T> point = rounded<T>(dice.direction() * dice.power_of_ten(-6, 6));
    const Vec3<float> lamp = rounded<float>(dice.direction() * dice.power_of_ten(-6, 6));
    const PointLight light{number_cast<double>(lamp)};
    const Hit<T> hit{{T(0), T(1), T(0)}, point, point, point};
    const Vec3<T> got = sample_light(light, nothing, hit).to_light;
    worst.see(length_off(got, normalize(exactly(light.position) - exactly(point))),
              [&] { return described(point); });
  });
}

template <class T>
Claim& add_acne(Family& family, SphereForm form, Start start) {
  const std::string lift = start == Start::lifted ? "by the lift alone, " : "without the lift, ";
  return family.add<T>(
      "sample_light " + lift + name(form),
      "the daily exercise's ground (radius 1000) from its camera; the ground itself is asked",
      {0, "points in their own shadow"}, count_acne<T>(form, start));
}

}  // namespace

Family claims_of_secondary_rays() {
  Family family{
      "Rays that go on from a hit",
      "A ray that leaves a surface outward must not meet it again, or the surface shadows itself; "
      "a ray inward must find the far side. The plain form cannot do it: its c is a difference of "
      "squares. The last rows start at the point itself."};
  for (const SphereForm form : all_forms) {
    add_rays<float>(family, form, 5, "1e5");
    add_rays<double>(family, form, 13, "1e13");
    add_rays<long double>(family, form, 13, "1e13");
    add_acne<float>(family, form, Start::lifted);
    add_acne<double>(family, form, Start::lifted);
  }
  const auto add_light = [&]<class T>() {
    family.add<T>("sample_light, direction", "points and lamps 1e-6 to 1e6 from the origin",
                  {5.5, "u"}, worst_to_light<T>());
  };
  add_light.template operator()<float>();
  add_light.template operator()<double>();
  add_light.template operator()<long double>();
  add_acne<float>(family, SphereForm::plain, Start::from_point).expect = Expect::beyond;
  add_acne<double>(family, SphereForm::robust, Start::from_point).expect = Expect::beyond;
  return family;
}

}  // namespace texmap::extremes
