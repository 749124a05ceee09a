// Claims of common/geometry/hit.hpp and common/shading/light.hpp: rays that leave the surface which another ray has met.
#include "claims.hpp"
#include "describe.hpp"
#include "dice.hpp"
#include "digits.hpp"
#include "light.hpp"
#include "sphere.hpp"
#include "stage.hpp"

namespace texmap::extremes {
namespace {

/// Which spheres are drawn.
struct Spheres {
  long double farthest;  ///< power of ten of |center| over radius, to
};

/// A sphere somewhere, and a ray that meets it.
template <class T>
struct Scene {
  Sphere sphere;
  Ray<T> ray;
};

template <class T>
Scene<T> draw_scene(Dice& dice, SphereForm form, long double farthest) {
  const long double radius = dice.power_of_ten(-6, 6);
  const long double most = std::min(7.0L, farthest + std::log10(radius));
  const long double away = dice.once_in(8) ? 0 : dice.power_of_ten(most - 14, most);
  const Vec3<long double> center = dice.direction() * away;
  const long double from = dice.once_in(3) ? 5.0L : dice.once_in(3) ? dice.uniform(0, 0.999L) : dice.power_of_ten(0.01L, 2);
  const Vec3<long double> eye = center + dice.direction() * (radius * from);
  const Vec3<long double> aim = center + dice.direction() * (radius * dice.uniform(0, 1));
  const Sphere sphere{{static_cast<double>(center.x), static_cast<double>(center.y), static_cast<double>(center.z)},
                      static_cast<double>(radius),
                      form};
  return {sphere, {rounded<T>(eye), rounded<T>(aim - eye)}};
}

/// A direction on the outer side of a surface, often nearly along it.
template <class T>
Vec3<T> outward(Dice& dice, const Vec3<T>& normal) {
  const Vec3<long double> n{static_cast<long double>(normal.x), static_cast<long double>(normal.y),
                            static_cast<long double>(normal.z)};
  Vec3<long double> direction = dice.direction();
  if (dice.once_in(3)) direction = dice.across(n) + n * dice.power_of_ten(-20, -1);
  Vec3<T> result = rounded<T>(direction);
  return dot(result, normal) < T(0) ? -result : result;
}

enum class Fault { self_hit, lost };

/// Of rays that leave a sphere where another ray has met it: those outward that meet it again, or those inward that find no far
/// side.
template <class T>
auto count_faults(SphereForm form, Spheres spheres, Fault fault) {
  return worst_over(20, [=](Dice& dice, Worst& worst) {
    const Scene<T> scene = draw_scene<T>(dice, form, spheres.farthest);
    const T distance = distance_to(scene.sphere, scene.ray);
    if (!(distance < infinity<T>())) return;
    const Hit<T> hit = hit_at(scene.sphere, scene.ray, distance);
    const Vec3<T> direction = outward(dice, hit.normal);
    const auto where = [&] {
      return "center " + described(scene.sphere.center) + ", radius " + described(scene.sphere.radius) + ", ray " +
             described(scene.ray) + ", outward " + described(direction);
    };
    if (fault == Fault::self_hit) {
      worst.count(distance_to(scene.sphere, ray_from(hit, direction)) < infinity<T>(), where);
    } else {
      const Vec3<T> inward = -direction;
      if (!(dot(hit.normal, inward) < T(0))) return;  // exactly along the surface: that is outward
      worst.count(!(distance_to(scene.sphere, ray_from(hit, inward)) < infinity<T>()), where);
    }
  });
}

const char* name(SphereForm form) {
  return form == SphereForm::plain ? "plain" : form == SphereForm::robust ? "robust" : "hybrid";
}

template <class T>
void add_rays(std::vector<Claim>& claims, SphereForm form, long double farthest, const char* far) {
  const std::string domain = std::string("radius 1e-6 to 1e6, center to 1e7 away, but to ") + far +
                             " radii; met from inside and from 1 to 100 radii; all directions, also along the surface";
  const Expect expect = form == SphereForm::plain ? Expect::beyond : Expect::within;
  claims.push_back({.function = std::string("ray_from outward, ") + name(form),
                    .number = name_of<T>,
                    .domain = domain,
                    .unit = "meet their own sphere",
                    .worst = count_faults<T>(form, {farthest}, Fault::self_hit),
                    .expect = expect});
  claims.push_back({.function = std::string("ray_from inward, ") + name(form),
                    .number = name_of<T>,
                    .domain = domain,
                    .unit = "find no far side",
                    .worst = count_faults<T>(form, {farthest}, Fault::lost),
                    .expect = expect});
}

/// One object: the list that light.hpp asks for.
struct Ground {
  Sphere sphere;
};

/// Where the light's ray starts.
enum class Start { lifted, from_point };

/// Points of seed 0's ground, seen from the stage's camera, that lie in their own shadow: acne.
template <class T>
auto count_acne(SphereForm form, Start start) {
  const Stage stage;
  const View view = view_of(stage.camera, 800, 600);
  const Ground ground[] = {{{{0, -1001, 0}, 1000, form}}};
  return worst_over(20, [=](Dice& dice, Worst& worst) {
    const auto column = static_cast<T>(dice.uniform(0, 800));
    const auto row = static_cast<T>(dice.uniform(0, 600));
    const Ray<T> ray = ray_through(view, column, row);
    const T distance = distance_to(ground[0].sphere, ray);
    if (!(distance < infinity<T>())) return;
    Hit<T> hit = hit_at(ground[0].sphere, ray, distance);
    hit.sphere = nullptr;  // or the ground would not be asked at all, and the lift not be tried
    if (start == Start::from_point) hit.outside = ray.origin + ray.direction * distance;
    const Illumination<T> lamp = illumination(stage.light, ground, hit);
    // The lamp stands clearly above the horizon of the point.
    const bool lit = dot(hit.normal, lamp.to_light) > T(1e-3L);
    worst.count(lit && !(lamp.cosine > T(0)), [&] { return described(ray); });
  });
}

/// Which way the lamp is, from what the hit point says.
template <class T>
auto worst_to_light() {
  const std::vector<Ground> nothing;
  return worst_over([=](Dice& dice, Worst& worst) {
    const Vec3<T> point = rounded<T>(dice.direction() * dice.power_of_ten(-6, 6));
    const Vec3<long double> lamp = dice.direction() * dice.power_of_ten(-6, 6);
    const PointLight light{{static_cast<double>(static_cast<float>(lamp.x)), static_cast<double>(static_cast<float>(lamp.y)),
                            static_cast<double>(static_cast<float>(lamp.z))}};
    const Hit<T> hit{{T(0), T(1), T(0)}, point, point, point};
    const Vec3<T> got = illumination(light, nothing, hit).to_light;
    Vec3<Digits50> path = exactly<Digits50>(light.position) - exactly<Digits50>(point);
    path = path * Digits50(1 / sqrt(dot(path, path)));
    const Vec3<Digits50> off = exactly<Digits50>(got) - path;
    worst.see(static_cast<double>(sqrt(dot(off, off)) / roundoff<T>()), [&] { return described(point); });
  });
}

template <class T>
void add_light(std::vector<Claim>& claims, double bound) {
  claims.push_back({.function = "illumination, direction",
                    .number = name_of<T>,
                    .domain = "points and lamps 1e-6 to 1e6 from the origin",
                    .bound = bound,
                    .unit = "u",
                    .worst = worst_to_light<T>()});
}

template <class T>
void add_acne(std::vector<Claim>& claims, SphereForm form) {
  claims.push_back({.function = std::string("illumination by the lift alone, ") + name(form),
                    .number = name_of<T>,
                    .domain = "seed 0's ground (radius 1000) from its camera; the ground itself is asked",
                    .unit = "points in their own shadow",
                    .worst = count_acne<T>(form, Start::lifted)});
}

}  // namespace

Family claims_of_secondary_rays() {
  Family family{"Rays that go on from a hit",
                "A ray that leaves a surface outward must not meet it again, or the surface shadows itself; a ray inward must "
                "find the far side. The plain form cannot do it: its c is a difference of squares. The last rows start at the "
                "point itself.",
                {}};
  std::vector<Claim>& claims = family.claims;
  for (const SphereForm form : {SphereForm::plain, SphereForm::robust, SphereForm::hybrid}) {
    add_rays<float>(claims, form, 5, "1e5");
    add_rays<double>(claims, form, 13, "1e13");
    add_rays<long double>(claims, form, 13, "1e13");
    add_acne<float>(claims, form);
    add_acne<double>(claims, form);
  }
  add_light<float>(claims, 4);
  add_light<double>(claims, 4);
  add_light<long double>(claims, 4);
  claims.push_back({.function = "illumination without the lift, plain",
                    .number = name_of<float>,
                    .domain = "seed 0's ground (radius 1000) from its camera; the ground itself is asked",
                    .unit = "points in their own shadow",
                    .worst = count_acne<float>(SphereForm::plain, Start::from_point),
                    .expect = Expect::beyond});
  claims.push_back({.function = "illumination without the lift, robust",
                    .number = name_of<double>,
                    .domain = "seed 0's ground (radius 1000) from its camera; the ground itself is asked",
                    .unit = "points in their own shadow",
                    .worst = count_acne<double>(SphereForm::robust, Start::from_point),
                    .expect = Expect::beyond});
  return family;
}

}  // namespace texmap::extremes
