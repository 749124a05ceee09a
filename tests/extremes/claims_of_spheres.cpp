// Claims of common/geometry/sphere.hpp and sphere_forms.hpp: where a ray meets a sphere.
#include "claims.hpp"
#include "describe.hpp"
#include "dice.hpp"
#include "references.hpp"
#include "seed_sphere.hpp"
#include "shots.hpp"
#include "sphere.hpp"

namespace texmap::extremes {
namespace {

/// How far off the answer for a shot is, in one lane; 0 where the claim does not look.
template <class T>
using Judge = double (*)(const Shot<T>& shot, const ExactMeeting<Digits50>& exact, T distance, const Vec3<T>& normal);

/// Distance over radius, 1 at least.
template <class T>
double ratio_of(const Shot<T>& shot) {
  const Vec3<Digits50> f = shot.from_center();
  return std::max(1.0, static_cast<double>(sqrt(dot(f, f)) / Digits50(shot.radius)));
}

/// How far from grazing (impact 1) a ray was that was missed or met wrongly, in unit roundoffs times (distance / radius)^power.
template <class T, int power>
double misjudged_off(const Shot<T>& shot, const ExactMeeting<Digits50>& exact, T distance, const Vec3<T>&) {
  if ((distance < infinity<T>()) == exact.meets) return 0;
  const auto grazing = static_cast<double>(abs(exact.impact - 1) / roundoff<T>());
  return grazing / std::pow(ratio_of(shot), power);
}
/// How nearly a ray may graze the sphere before the hybrid form is not held to its answer, over the radius.
template <class T>
const char* const grazing_band = "2e-7";
template <>
const char* const grazing_band<double> = "1e-15";
template <>
const char* const grazing_band<long double> = "1e-18";

/// 1 for a ray that was missed or met wrongly and does not graze.
template <class T>
double misjudged(const Shot<T>&, const ExactMeeting<Digits50>& exact, T distance, const Vec3<T>&) {
  static const Digits50 band(grazing_band<T>);
  return (distance < infinity<T>()) != exact.meets && abs(exact.impact - 1) > band ? 1 : 0;
}
/// Rays that both find, and that do not graze.
template <class T>
bool is_judged(const ExactMeeting<Digits50>& exact, T distance) {
  return exact.meets && distance < infinity<T>() && exact.impact < 0.99;
}
template <class T>
double distance_off(const Shot<T>&, const ExactMeeting<Digits50>& exact, T distance, const Vec3<T>&) {
  return is_judged(exact, distance) ? ulps_off(distance, exact.distance) : 0;
}
/// In units in the last place of the distance or of the radius, whichever is larger.
template <class T>
double distance_off_coarsely(const Shot<T>& shot, const ExactMeeting<Digits50>& exact, T distance, const Vec3<T>&) {
  if (!is_judged(exact, distance)) return 0;
  const Vec3<Digits50> d = exactly<Digits50>(shot.ray.direction);
  const Digits50 radius = Digits50(shot.radius) / sqrt(dot(d, d));
  return units_off(distance, exact.distance, ulp_at<T>(exact.distance > radius ? exact.distance : radius));
}
template <class T, int power>
double normal_off(const Shot<T>& shot, const ExactMeeting<Digits50>& exact, T distance, const Vec3<T>& normal) {
  if (!is_judged(exact, distance)) return 0;
  return angle_off(normal, exact.normal) * texels_per_radian / std::pow(ratio_of(shot), power);
}
template <class T>
double length_off(const Shot<T>&, const ExactMeeting<Digits50>& exact, T distance, const Vec3<T>& normal) {
  if (!is_judged(exact, distance)) return 0;
  const Vec3<Digits50> n = exactly<Digits50>(normal);
  return static_cast<double>(abs(sqrt(dot(n, n)) - 1) / roundoff<T>());
}

/// What is made of many shots: the worst, or how many are at fault.
enum class Report { worst, count };

template <class Real>
auto worst_shot(SphereForm form, Shots shots, Judge<Scalar<Real>> judge, Report report = Report::worst) {
  using T = Scalar<Real>;
  return worst_over([=](Dice& dice, Worst& worst) {
    const Shared shared = draw_shared(dice, shots);
    const auto each = drawn<Real>([&] { return draw_shot<T>(dice, shots, shared); });
    const Vec3<T> center = each[0].center;
    const Sphere sphere{{static_cast<double>(center.x), static_cast<double>(center.y), static_cast<double>(center.z)},
                        static_cast<double>(each[0].radius),
                        form};
    const Ray<Real> ray = gathered_rays<Real>(each);
    const Real distance = distance_to(sphere, ray);
    const Hit<Real> hit = hit_at(sphere, ray, distance);
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Shot<T>& shot = each[k];
      const ExactMeeting<Digits50> exact = shot.meeting();
      if (!is_in_range(shot, exact)) continue;
      const double off = judge(shot, exact, lane(distance, k), lane_of(hit.normal, k));
      const auto where = [&] {
        return "center " + described(shot.center) + ", radius " + described(shot.radius) + ", ray " + described(shot.ray);
      };
      if (report == Report::count) {
        worst.count(off > 0, where);
      } else {
        worst.see(off, where);
      }
    }
  });
}

/// Rays of an ordinary picture: the cost of a form is that of such a ray and its hit.
template <class Real>
auto ordinary_rays() {
  const Shots shots{.nearest = 0.5L, .farthest = 1.0L, .around_surface = false};
  return inputs_of_cost<Real>([&](Dice& dice) {
    return gathered_rays<Real>(drawn<Real>([&] { return draw_shot<Scalar<Real>>(dice, shots, {1, {}, 0, 0}); }));
  });
}

template <class Real>
std::function<double()> casting(SphereForm form) {
  return working_through(ordinary_rays<Real>(), [form](const Ray<Real>& ray) {
    const Sphere sphere{{0, 0, 0}, 1, form};
    const Real distance = distance_to(sphere, ray);
    const Hit<Real> hit = hit_at(sphere, ray, smaller(distance, Real(10)));
    return hit.normal.x + hit.outside.y + hit.point.z;
  });
}

template <class Real>
Cost cost_of(SphereForm form) {
  return {"plain, double", casting<Real>(form), casting<double>(SphereForm::plain)};
}

/// The bounds of one form in one number.
struct Bounds {
  double misjudged;  ///< unit roundoffs times a power of distance over radius
  double distance;   ///< ulp
  double normal;     ///< texels, over a power of distance over radius
  double length;     ///< unit roundoffs
};

template <class Real>
void add_hybrid(std::vector<Claim>& claims, int scale, int direction, const char* range, const Bounds& bounds) {
  using T = Scalar<Real>;
  const Shots shots{.nearest = -6, .farthest = 7, .scale = scale, .direction = direction};
  const std::string domain =
      std::string("1e-6 to 1e7 radii from the center, also within 1e-7 of the surface; sizes and directions of ") + range;
  const std::string judged = domain + "; impact below 0.99 radius";
  const SphereForm form = SphereForm::hybrid;
  claims.push_back({.function = "hybrid, missed or met wrongly",
                    .number = name_of<Real>,
                    .domain = domain + "; impact off the radius by more than " + grazing_band<T> + " of it",
                    .unit = "rays",
                    .worst = worst_shot<Real>(form, shots, misjudged<T>, Report::count),
                    .cost = cost_of<Real>(form)});
  claims.push_back({.function = "hybrid, how nearly a misjudged ray grazes",
                    .number = name_of<Real>,
                    .domain = domain,
                    .bound = bounds.misjudged,
                    .unit = "u",
                    .worst = worst_shot<Real>(form, shots, misjudged_off<T, 0>)});
  claims.push_back({.function = "hybrid, distance",
                    .number = name_of<Real>,
                    .domain = judged,
                    .bound = bounds.distance,
                    .unit = "ulp",
                    .worst = worst_shot<Real>(form, shots, distance_off<T>)});
  claims.push_back({.function = "hybrid, normal",
                    .number = name_of<Real>,
                    .domain = judged,
                    .bound = bounds.normal,
                    .unit = "texel",
                    .worst = worst_shot<Real>(form, shots, normal_off<T, 0>)});
  claims.push_back({.function = "hybrid, length of the normal",
                    .number = name_of<Real>,
                    .domain = judged,
                    .bound = bounds.length,
                    .unit = "u",
                    .worst = worst_shot<Real>(form, shots, length_off<T>)});
  const Shots away{.nearest = -6, .farthest = 7, .scale = 20, .direction = 20, .centered = false};
  const std::string elsewhere =
      "center 1e-3 to 1e7 radii from the world's origin, rays from 1e-6 to 1e7 radii from it; sizes of 1e-6 to 1e6";
  claims.push_back({.function = "hybrid, missed or met wrongly, center elsewhere",
                    .number = name_of<Real>,
                    .domain = elsewhere + "; impact off the radius by more than " + grazing_band<T> + " of it",
                    .unit = "rays",
                    .worst = worst_shot<Real>(form, away, misjudged<T>, Report::count)});
  claims.push_back({.function = "hybrid, normal, center elsewhere",
                    .number = name_of<Real>,
                    .domain = elsewhere + "; impact below 0.99 radius",
                    .bound = bounds.normal,
                    .unit = "texel",
                    .worst = worst_shot<Real>(form, away, normal_off<T, 0>)});
}

template <class Real>
void add_robust(std::vector<Claim>& claims, int farthest, const char* far, int scale, const char* range, const Bounds& bounds) {
  using T = Scalar<Real>;
  const Shots shots{.nearest = -6, .farthest = static_cast<long double>(farthest), .scale = scale, .direction = scale};
  const std::string domain = std::string("1e-6 to ") + far + " radii from the center; sizes and directions of " + range;
  const std::string judged = domain + "; impact below 0.99 radius";
  const SphereForm form = SphereForm::robust;
  claims.push_back({.function = "robust, how nearly a misjudged ray grazes",
                    .number = name_of<Real>,
                    .domain = domain,
                    .bound = bounds.misjudged,
                    .unit = "u distance / radius",
                    .worst = worst_shot<Real>(form, shots, misjudged_off<T, 1>),
                    .cost = cost_of<Real>(form)});
  claims.push_back({.function = "robust, distance",
                    .number = name_of<Real>,
                    .domain = judged,
                    .bound = bounds.distance,
                    .unit = "ulp of distance or radius",
                    .worst = worst_shot<Real>(form, shots, distance_off_coarsely<T>)});
  claims.push_back({.function = "robust, normal",
                    .number = name_of<Real>,
                    .domain = judged,
                    .bound = bounds.normal,
                    .unit = "texel distance / radius",
                    .worst = worst_shot<Real>(form, shots, normal_off<T, 1>)});
  // The step of Newton's squares what is wrong with the length; beyond a thousand radii in float that is much.
  const bool near = std::numeric_limits<T>::digits < 30;
  Shots of_length = shots;
  if (near) of_length.farthest = 3;
  claims.push_back({.function = "robust, length of the normal",
                    .number = name_of<Real>,
                    .domain = near ? "as above, but to 1e3 radii" : "as above",
                    .bound = bounds.length,
                    .unit = "u",
                    .worst = worst_shot<Real>(form, of_length, length_off<T>)});
}

template <class Real>
void add_plain(std::vector<Claim>& claims, long double farthest, const char* far, int scale, const char* range,
               const Bounds& bounds) {
  using T = Scalar<Real>;
  const Shots shots{.nearest = -6, .farthest = farthest, .scale = scale, .direction = scale};
  const std::string domain = std::string("1e-6 to ") + far + " radii from the center; sizes and directions of " + range;
  const std::string judged = domain + "; impact below 0.99 radius";
  const SphereForm form = SphereForm::plain;
  claims.push_back({.function = "plain, how nearly a misjudged ray grazes",
                    .number = name_of<Real>,
                    .domain = domain,
                    .bound = bounds.misjudged,
                    .unit = "u (distance / radius)^2",
                    .worst = worst_shot<Real>(form, shots, misjudged_off<T, 2>),
                    .cost = cost_of<Real>(form)});
  claims.push_back({.function = "plain, normal",
                    .number = name_of<Real>,
                    .domain = judged,
                    .bound = bounds.normal,
                    .unit = "texel (distance / radius)^2",
                    .worst = worst_shot<Real>(form, shots, normal_off<T, 2>)});
}

/// What the seeds' form does where ours keeps its bound.
template <class T>
void add_lost_spheres(std::vector<Claim>& claims, long double ratio, const char* far) {
  const Shots shots{.nearest = ratio, .farthest = ratio, .around_surface = false};
  claims.push_back(
      {.function = "plain, missed or met wrongly",
       .number = name_of<T>,
       .domain = std::string(far) + " radii from the center; impact off the radius by more than " + grazing_band<T> + " of it",
       .unit = "rays",
       .worst = worst_shot<T>(SphereForm::plain, shots, misjudged<T>, Report::count),
       .expect = Expect::beyond});
}

}  // namespace

Family claims_of_spheres() {
  Family family{"Rays and spheres",
                "The sphere's center is the origin unless the row says otherwise. The ray is what the "
                "number holds after rounding, and the exact answer is that ray's. Exact: the quadratic equation in 50 digits, "
                "checked against half chords in 100. u is the unit roundoff, half the distance from 1 to the next number.",
                {}};
  std::vector<Claim>& claims = family.claims;
  add_hybrid<float>(claims, 100, 122, "1e-30 to 1e30 and 1e-37 to 1e37", {3, 6, 0.0015, 4});
  add_hybrid<double>(claims, 980, 995, "1e-295 to 1e295 and 1e-300 to 1e300", {3, 6, 3e-12, 4});
  add_hybrid<long double>(claims, 980, 16000, "1e-295 to 1e295 and 1e-4800 to 1e4800", {3, 6, 1.5e-15, 4});
#ifdef TEXMAP_HAVE_PACKS
  add_hybrid<Pack<float>>(claims, 100, 122, "1e-30 to 1e30 and 1e-37 to 1e37", {3, 6, 0.0015, 4});
  add_hybrid<Pack<double>>(claims, 980, 995, "1e-295 to 1e295 and 1e-300 to 1e300", {3, 6, 3e-12, 4});
#endif
  add_robust<float>(claims, 4, "1e4", 13, "1e-4 to 1e4", {3, 16, 1.5e-3, 4});
  add_robust<double>(claims, 7, "1e7", 220, "1e-66 to 1e66", {3, 16, 3e-12, 4});
  add_robust<long double>(claims, 7, "1e7", 980, "1e-295 to 1e295", {3, 16, 1.5e-15, 4});
#ifdef TEXMAP_HAVE_PACKS
  add_robust<Pack<float>>(claims, 4, "1e4", 13, "1e-4 to 1e4", {3, 16, 1.5e-3, 4});
  add_robust<Pack<double>>(claims, 7, "1e7", 220, "1e-66 to 1e66", {3, 16, 3e-12, 4});
#endif
  add_plain<float>(claims, 1.5L, "30", 13, "1e-4 to 1e4", {3, 0, 1.5e-3, 0});
  add_plain<double>(claims, 5, "1e5", 220, "1e-66 to 1e66", {3, 0, 3e-12, 0});
  add_plain<long double>(claims, 5, "1e5", 980, "1e-295 to 1e295", {3, 0, 1.5e-15, 0});
  add_lost_spheres<float>(claims, 4, "1e4");
  add_lost_spheres<double>(claims, 7, "1e7");
  return family;
}

}  // namespace texmap::extremes
