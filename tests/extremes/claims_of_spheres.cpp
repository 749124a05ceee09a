// Claims of common/scene/sphere.hpp and sphere_forms.hpp: where a ray meets a sphere.
#include "claims.hpp"
#include "references.hpp"
#include "scene/sphere.hpp"
#include "shots.hpp"

namespace texmap::extremes {
namespace {

/// How far off the answer for a shot is, in one lane; 0 where the claim does not look.
template <class T>
using Off = double (*)(const Shot<T>& shot, const ExactMeeting<Digits50>& exact, T distance,
                       const Vec3<T>& normal);

/// Distance over radius, 1 at least.
template <class T>
double ratio_of(const Shot<T>& shot) {
  return std::max(1.0, static_cast<double>(length(shot.from_center()) / Digits50(shot.radius)));
}

/// How far from grazing (impact 1) a wrongly missed or hit ray was, in unit roundoffs times
/// (distance / radius)^power.
template <class T, int power>
double grazing_off(const Shot<T>& shot, const ExactMeeting<Digits50>& exact, T distance,
                   const Vec3<T>&) {
  if ((distance < infinity<T>()) == exact.meets) return 0;
  const auto grazing = static_cast<double>(abs(exact.impact - 1) / roundoff<T>());
  return grazing / std::pow(ratio_of(shot), power);
}
/// Rays that graze closer than this, over the radius, may be hit or missed by the hybrid form.
template <class T>
const char* const grazing_band = "2e-7";
template <>
const char* const grazing_band<double> = "1e-15";
template <>
const char* const grazing_band<long double> = "1e-18";

/// 1 for a ray that was missed or met wrongly and does not graze.
template <class T>
double wrong(const Shot<T>&, const ExactMeeting<Digits50>& exact, T distance, const Vec3<T>&) {
  static const Digits50 band(grazing_band<T>);
  return (distance < infinity<T>()) != exact.meets && abs(exact.impact - 1) > band ? 1 : 0;
}
/// Rays that both find, and that do not graze.
template <class T>
bool is_compared(const ExactMeeting<Digits50>& exact, T distance) {
  return exact.meets && distance < infinity<T>() && exact.impact < 0.99;
}
template <class T>
double distance_off(const Shot<T>&, const ExactMeeting<Digits50>& exact, T distance,
                    const Vec3<T>&) {
  return is_compared(exact, distance) ? ulps_off(distance, exact.distance) : 0;
}
/// In units in the last place of the distance or of the radius, whichever is larger.
template <class T>
double distance_off_coarsely(const Shot<T>& shot, const ExactMeeting<Digits50>& exact, T distance,
                             const Vec3<T>&) {
  if (!is_compared(exact, distance)) return 0;
  const Digits50 radius = Digits50(shot.radius) / length(exactly(shot.ray.direction));
  return units_off(distance, exact.distance,
                   ulp_at<T>(exact.distance > radius ? exact.distance : radius));
}
template <class T, int power>
double normal_off(const Shot<T>& shot, const ExactMeeting<Digits50>& exact, T distance,
                  const Vec3<T>& normal) {
  if (!is_compared(exact, distance)) return 0;
  return angle_off(normal, exact.normal) * texels_per_radian / std::pow(ratio_of(shot), power);
}
template <class T>
double normal_length_off(const Shot<T>&, const ExactMeeting<Digits50>& exact, T distance,
                         const Vec3<T>& normal) {
  if (!is_compared(exact, distance)) return 0;
  return static_cast<double>(abs(length(exactly(normal)) - 1) / roundoff<T>());
}

template <class Real>
auto worst_shot(SphereForm form, Shots shots, Off<Scalar<Real>> off_of) {
  using T = Scalar<Real>;
  return worst_over([=](Dice& dice, Worst& worst) {
    const Shared shared = draw_shared(dice, shots);
    const auto each = drawn<Real>([&] { return draw_shot<T>(dice, shots, shared); });
    const Sphere<> sphere{number_cast<double>(each[0].center), static_cast<double>(each[0].radius),
                          form};
    const Ray<Real> ray = packed<Real>([&](std::size_t i) { return each[i].ray; }, each[0].ray);
    const Real distance = distance_to(sphere, ray);
    const Hit<Real> hit = hit_at(sphere, ray, distance);
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Shot<T>& shot = each[k];
      const ExactMeeting<Digits50> exact = shot.meeting();
      if (!is_in_range(shot, exact)) continue;
      worst.see(off_of(shot, exact, lane(distance, k), lane_of(hit.normal, k)), [&] {
        return "center " + described(shot.center) + ", radius " + described(shot.radius) +
               ", ray " + described(shot.ray);
      });
    }
  });
}

/// Casts rays of an ordinary picture: the cost of a form is that of such a ray and its hit.
template <class Real>
std::function<double()> casting(SphereForm form) {
  const Shots shots{.nearest = 0.5L, .farthest = 1.0L, .around_surface = false};
  const auto rays = inputs_of_cost<Real>([&](Dice& dice) {
    return drawn_pack<Real>([&] {
      return draw_shot<Scalar<Real>>(dice, shots, {1, {}, 0, 0}).ray;
    });
  });
  return working_through(rays, [form](const Ray<Real>& ray) {
    const Sphere<> sphere{{0, 0, 0}, 1, form};
    const Hit<Real> hit = hit_at(sphere, ray, min(distance_to(sphere, ray), Real(10)));
    return hit.normal.x + hit.outside.y + hit.point.z;
  });
}

template <class Real>
Cost cost_of(SphereForm form) {
  return {"plain, double", casting<Real>(form), casting<double>(SphereForm::plain)};
}

/// Which spheres are met, and what the page calls them.
struct Domain {
  long double farthest;  ///< power of ten of distance over radius
  const char* far;
  int scale;  ///< power of two
  int direction;
  const char* range;

  [[nodiscard]] Shots shots() const {
    return {.nearest = -6, .farthest = farthest, .scale = scale, .direction = direction};
  }
  /// @param more  where else the rays start
  [[nodiscard]] std::string text(const std::string& more = "") const {
    return std::string("1e-6 to ") + far + " radii from the center" + more +
           "; sizes and directions of " + range;
  }
};

const std::string compared = "; impact below 0.99 radius";
template <class T>
const std::string off_grazing =
    std::string("; impact off the radius by more than ") + grazing_band<T> + " of it";

template <class Real>
void add_hybrid(Family& family, const Domain& domain, double texels) {
  using T = Scalar<Real>;
  const auto add = [&](const std::string& what, const std::string& where, const Bound& bound,
                       const Shots& shots, Off<T> off) -> Claim& {
    return family.add<Real>("hybrid, " + what, where, bound,
                            worst_shot<Real>(SphereForm::hybrid, shots, off));
  };
  const Shots shots = domain.shots();
  const std::string text = domain.text(", also within 1e-7 of the surface");
  add("missed or met wrongly", text + off_grazing<T>, {0, "rays"}, shots, wrong<T>).cost =
      cost_of<Real>(SphereForm::hybrid);
  add("how nearly a misjudged ray grazes", text, {3, "u"}, shots, grazing_off<T, 0>);
  add("distance", text + compared, {16, "ulp"}, shots, distance_off<T>);
  add("normal", text + compared, {texels, "texel"}, shots, normal_off<T, 0>);
  add("length of the normal", text + compared, {4, "u"}, shots, normal_length_off<T>);
  const Shots away{.nearest = -6, .farthest = 7, .scale = 20, .direction = 20, .centered = false};
  const std::string elsewhere =
      "center 1e-3 to 1e7 radii from the world's origin, rays from 1e-6 to 1e7 radii from it; "
      "sizes of 1e-6 to 1e6";
  add("missed or met wrongly, center elsewhere", elsewhere + off_grazing<T>, {0, "rays"}, away,
      wrong<T>);
  add("normal, center elsewhere", elsewhere + compared, {texels, "texel"}, away, normal_off<T, 0>);
}

template <class Real>
void add_robust(Family& family, const Domain& domain, double texels) {
  using T = Scalar<Real>;
  const auto add = [&](const std::string& what, const std::string& where, const Bound& bound,
                       const Shots& shots, Off<T> off) -> Claim& {
    return family.add<Real>("robust, " + what, where, bound,
                            worst_shot<Real>(SphereForm::robust, shots, off));
  };
  const Shots shots = domain.shots();
  const std::string text = domain.text();
  add("how nearly a misjudged ray grazes", text, {3, "u distance / radius"}, shots,
      grazing_off<T, 1>)
      .cost = cost_of<Real>(SphereForm::robust);
  add("distance", text + compared, {24, "ulp of distance or radius"}, shots,
      distance_off_coarsely<T>);
  add("normal", text + compared, {texels, "texel distance / radius"}, shots, normal_off<T, 1>);
  add("length of the normal", text + compared, {4, "u"}, shots, normal_length_off<T>);
}

template <class T>
void add_plain(Family& family, const Domain& domain, double texels) {
  const SphereForm form = SphereForm::plain;
  family
      .add<T>("plain, how nearly a misjudged ray grazes", domain.text(),
              {4, "u (distance / radius)^2"},
              worst_shot<T>(form, domain.shots(), grazing_off<T, 2>))
      .cost = cost_of<T>(form);
  family.add<T>("plain, normal", domain.text() + compared, {texels, "texel (distance / radius)^2"},
                worst_shot<T>(form, domain.shots(), normal_off<T, 2>));
}

/// What the published form does where ours keeps its bound.
template <class T>
void add_lost_spheres(Family& family, long double ratio, const std::string& far) {
  const Shots shots{.nearest = ratio, .farthest = ratio, .around_surface = false};
  family
      .add<T>("plain, missed or met wrongly", far + " radii from the center" + off_grazing<T>,
              {0, "rays"}, worst_shot<T>(SphereForm::plain, shots, wrong<T>))
      .expect = Expect::beyond;
}

}  // namespace

Family claims_of_spheres() {
  Family family{
      "Rays and spheres",
      "The sphere's center is the origin unless the row says otherwise. The ray is what the "
      "number holds after rounding, and the exact answer is that ray's. Exact: the quadratic "
      "equation in 50 digits, checked against half chords in 100. u is the unit roundoff, half "
      "the distance from 1 to the next number."};
  const auto far = [](int scale, int direction, const char* range) {
    return Domain{7, "1e7", scale, direction, range};
  };
  const Domain hybrid_float = far(100, 122, "1e-30 to 1e30 and 1e-37 to 1e37");
  const Domain hybrid_double = far(980, 995, "1e-295 to 1e295 and 1e-300 to 1e300");
  add_hybrid<float>(family, hybrid_float, 0.002);
  add_hybrid<double>(family, hybrid_double, 4e-12);
  add_hybrid<long double>(family, far(980, 16000, "1e-295 to 1e295 and 1e-4800 to 1e4800"), 2e-15);
  add_hybrid<Pack<float>>(family, hybrid_float, 0.002);
  add_hybrid<Pack<double>>(family, hybrid_double, 4e-12);
  const Domain robust_float{4, "1e4", 13, 13, "1e-4 to 1e4"};
  const Domain robust_double = far(220, 220, "1e-66 to 1e66");
  add_robust<float>(family, robust_float, 2e-3);
  add_robust<double>(family, robust_double, 4e-12);
  add_robust<long double>(family, far(980, 980, "1e-295 to 1e295"), 2e-15);
  add_robust<Pack<float>>(family, robust_float, 2e-3);
  add_robust<Pack<double>>(family, robust_double, 4e-12);
  add_plain<float>(family, {1.5L, "30", 13, 13, "1e-4 to 1e4"}, 2.5e-3);
  add_plain<double>(family, {5, "1e5", 220, 220, "1e-66 to 1e66"}, 5e-12);
  add_plain<long double>(family, {5, "1e5", 980, 980, "1e-295 to 1e295"}, 2.5e-15);
  add_lost_spheres<float>(family, 4, "1e4");
  add_lost_spheres<double>(family, 7, "1e7");
  return family;
}

}  // namespace texmap::extremes
