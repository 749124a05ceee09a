// Claims of common/scene/sphere.hpp and sphere_forms.hpp: where a ray meets a sphere, from near and
// far, from inside, straight at it, grazing it and past it.
#include <numbers>

#include "claims.hpp"
#include "references.hpp"
#include "scene/sphere.hpp"

namespace texmap::extremes {
namespace {

/// Which shots are drawn.
struct Shots {
  long double nearest = -6;  ///< power of ten of distance over radius, from
  long double farthest = 7;  ///< to
  int scale = 0;  ///< sizes are multiplied by powers of two up to this one and down to its inverse
  int direction = 0;           ///< and lengths of directions likewise
  bool around_surface = true;  ///< some start from 0.1 to a roundoff off the surface, some graze it
  bool centered = true;  ///< the sphere's center is the origin, else up to 1e7 radii away from it
};

template <class T>
struct Shot {
  Ray<T> ray;
  Vec3<T> center;
  T radius;

  /// The ray's origin as seen from the center.
  [[nodiscard]] Vec3<Digits50> from_center() const { return exactly(ray.origin) - exactly(center); }
  [[nodiscard]] ExactMeeting meeting() const {
    return exact_meeting(from_center(), exactly(ray.direction), Digits50(radius));
  }
};

/// What all lanes of a pack share.
struct Shared {
  double radius;  ///< before scaling
  Point center;   ///< likewise; floats, so that every number holds them
  int scale;      ///< powers of two
  int direction;
};

Shared draw_shared(Dice& dice, const Shots& shots) {
  const auto radius = static_cast<double>(
      static_cast<float>(dice.uniform(1, 2)));  // a float, so that every number holds it
  const Vec3<float> center = shots.centered
                                 ? Vec3<float>{}
                                 : number_cast<float>(dice.direction() * dice.power_of_ten(-3, 7));
  return {radius, number_cast<double>(center), dice.within(-shots.scale, shots.scale),
          dice.within(-shots.direction, shots.direction)};
}

/// A ray along an axis that passes the center a few numbers more or less than one radius away: only
/// along an axis does a ray still graze after its coordinates are rounded.
template <class T>
Shot<T> draw_grazing_shot(Dice& dice, const Shots& shots, const Shared& shared) {
  T coordinates[3] = {static_cast<T>(shared.radius), 0,
                      static_cast<T>(shared.radius * dice.power_of_ten(0, shots.farthest))};
  for (int steps = dice.below(6); steps > 0; --steps)
    coordinates[0] = std::nextafter(coordinates[0], static_cast<T>(dice.once_in(2) ? 0 : 4));
  // The same circle of impacts, met off the axes.
  if (dice.once_in(2)) {
    const long double turn = dice.uniform(0, 6.283185307179586L);
    coordinates[1] = static_cast<T>(coordinates[0] * std::sin(turn));
    coordinates[0] = static_cast<T>(coordinates[0] * std::cos(turn));
  }
  T along[3] = {0, 0, -static_cast<T>(dice.uniform(1, 2))};
  const int axis = dice.below(3);
  const auto turned = [axis](const T* p) {
    return Vec3<T>{p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]};
  };
  return {{scaled(turned(coordinates), shared.scale), scaled(turned(along), shared.direction)},
          {},
          std::ldexp(static_cast<T>(shared.radius), shared.scale)};
}

template <class T>
Shot<T> draw_shot(Dice& dice, const Shots& shots, const Shared& shared) {
  if (shots.centered && shots.around_surface && dice.once_in(4))
    return draw_grazing_shot<T>(dice, shots, shared);
  const long double radius = shared.radius;
  const int least = -1 - std::numeric_limits<T>::digits10;
  // From near by, through the outermost tenth of the sphere: there errors are largest.
  const bool at_limb = shots.around_surface && dice.once_in(4);
  const long double ratio = at_limb ? dice.uniform(0.9L, 3)
                            : shots.around_surface && dice.once_in(4)
                                ? 1 + dice.sign() * dice.power_of_ten(least, -1)
                                : dice.power_of_ten(shots.nearest, shots.farthest);
  const long double away = ratio * radius;
  const long double impact = radius * [&] {
    if (at_limb) return dice.uniform(0.9L, 0.99L);
    const int kind = dice.below(4);
    if (kind == 0) return 1 + dice.sign() * dice.power_of_ten(least, -0.5L);
    if (kind > 1) return dice.uniform(0, 1.2L);
    // As nearly grazing as one form or another can see at this distance.
    const long double seen =
        std::pow(std::max(1.0L, ratio), static_cast<long double>(dice.below(3)));
    return 1 + dice.uniform(-3, 3) * static_cast<long double>(unit_roundoff<T>()) * seen;
  }();
  const Vec3<long double> out = dice.direction();
  Vec3<long double> direction = dice.direction();
  if (impact < away) {
    const long double sine = impact / away;
    const long double side = dice.once_in(8) ? 1 : -1;  // some look away
    direction = out * (side * std::sqrt(1 - sine * sine)) + dice.across(out) * sine;
  }
  direction = direction * dice.uniform(1, 2);
  const auto center = number_cast<long double>(shared.center);
  return {{scaled(number_cast<T>(center + out * away), shared.scale),
           scaled(number_cast<T>(direction), shared.direction)},
          scaled(number_cast<T>(center), shared.scale),
          std::ldexp(static_cast<T>(radius), shared.scale)};
}

/// Whether the type holds the answer, and also the sphere's size over the length of the direction.
template <class T>
bool is_in_range(const Shot<T>& shot, const ExactMeeting& exact) {
  using Limits = std::numeric_limits<T>;
  const Digits50 size =
      (length(shot.from_center()) + Digits50(shot.radius)) / length(exactly(shot.ray.direction));
  return size < Digits50(Limits::max()) / 8 &&
         (!exact.meets || exact.distance > Digits50(Limits::min()));
}

/// One lane's ray and what a form answers; a claim leaves what it does not check at 0.
template <class T>
struct Answer {
  const Shot<T>& shot;
  ExactMeeting exact;
  T distance;
  Vec3<T> normal;

  /// The origin is so near to the surface that rounding can put it on the other side.
  [[nodiscard]] bool is_on_surface() const {
    return abs(length(shot.from_center()) / Digits50(shot.radius) - 1) < 4 * roundoff<T>();
  }
  [[nodiscard]] bool is_misjudged() const { return (distance < infinity<T>()) != exact.meets; }
  /// Both find the sphere, and the ray does not graze.
  [[nodiscard]] bool is_compared() const {
    return exact.meets && distance < infinity<T>() && exact.impact < 0.99;
  }
  /// (distance / radius)^power, 1 at least.
  [[nodiscard]] double ratio(int power) const {
    return std::pow(
        std::max(1.0, static_cast<double>(length(shot.from_center()) / Digits50(shot.radius))),
        power);
  }
};
template <class T>
using Off = double (*)(const Answer<T>&);

/// How far from grazing (impact 1) a wrongly missed or hit ray was, in unit roundoffs times
/// (distance / radius)^power.
template <class T, int power>
double grazing_off(const Answer<T>& a) {
  if (!a.is_misjudged()) return 0;
  return static_cast<double>(abs(a.exact.impact - 1) / roundoff<T>()) / a.ratio(power);
}
/// The same in unit roundoffs times 5 + 1.2 distance / radius.
template <class T>
double robust_grazing_off(const Answer<T>& a) {
  return grazing_off<T, 0>(a) / (5 + 1.2 * a.ratio(1));
}
/// Rays that graze closer than this, over the radius, may be hit or missed by the hybrid form.
template <class T>
const char* grazing_band() {
  return by_number<T>("3e-7", "1e-15", "1e-18");
}
/// 1 for a ray that was missed or met wrongly and does not graze.
template <class T>
double wrong(const Answer<T>& a) {
  static const Digits50 band(grazing_band<T>());
  return a.is_misjudged() && abs(a.exact.impact - 1) > band ? 1 : 0;
}
template <class T>
double distance_off(const Answer<T>& a) {
  return a.is_compared() ? ulps_off(a.distance, a.exact.distance) : 0;
}
/// In units in the last place of the distance or of the radius, whichever is larger.
template <class T>
double distance_off_coarsely(const Answer<T>& a) {
  if (!a.is_compared()) return 0;
  const Digits50 radius = Digits50(a.shot.radius) / length(exactly(a.shot.ray.direction));
  return units_off(a.distance, a.exact.distance,
                   ulp_at<T>(a.exact.distance > radius ? a.exact.distance : radius));
}
/// The angle of the normal in texels of a map 8192 wide, over (distance / radius)^power.
template <class T, int power>
double normal_off(const Answer<T>& a) {
  if (!a.is_compared()) return 0;
  if (!std::isfinite(a.normal.x + a.normal.y + a.normal.z)) return infinity<double>();
  const Vec3<Digits50> n = exactly(a.normal);
  const Vec3<Digits50> sine = cross(n, a.exact.normal);
  const auto angle = static_cast<double>(atan2(sqrt(dot(sine, sine)), dot(n, a.exact.normal)));
  return angle * (8192 / (2 * std::numbers::pi)) / a.ratio(power);
}
template <class T>
double normal_length_off(const Answer<T>& a) {
  if (!a.is_compared()) return 0;
  return static_cast<double>(abs(length(exactly(a.normal)) - 1) / roundoff<T>());
}

template <class Real>
Measurement worst_shot(SphereForm form, Shots shots, Off<Scalar<Real>> off_of) {
  using T = Scalar<Real>;
  return worst_over(1, [=](Dice& dice, Worst& worst) {
    const Shared shared = draw_shared(dice, shots);
    const auto each = drawn<Real>([&] { return draw_shot<T>(dice, shots, shared); });
    const Sphere<> sphere{number_cast<double>(each[0].center), static_cast<double>(each[0].radius),
                          form};
    const Ray<Real> ray = packed<Real>([&](std::size_t i) { return each[i].ray; }, each[0].ray);
    const Real distance = distance_to(sphere, ray);
    const Hit<Real> hit = hit_at(sphere, ray, distance);
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Shot<T>& shot = each[k];
      const Answer<T> answer{shot, shot.meeting(), lane(distance, k), lane_of(hit.normal, k)};
      if (!is_in_range(shot, answer.exact)) continue;
      if (form != SphereForm::hybrid && answer.is_on_surface()) continue;
      worst.see(off_of(answer), [&] {
        return "center " + described(shot.center) + ", radius " + described(shot.radius) +
               ", ray " + described(shot.ray);
      });
    }
  });
}

/// The smaller positive root from a, b, c and the discriminant's root, all as they are given.
template <class Real>
Measurement worst_root_ahead() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1,
      [](Dice& dice) {
        const auto any = [&] { return dice.number<T>(-20, 20); };
        const auto signed_one = [&] { return static_cast<T>(dice.sign()) * any(); };
        return std::array<T, 4>{any(), signed_one(), signed_one(), any()};
      },
      [](const std::array<Real, 4>& x) { return root_ahead(x[0], x[1], x[2], x[3]); },
      [](T got, const std::array<T, 4>& x) {
        const auto& [a, b, c, root] = x;
        if (b < 0 && c > 0) return got == infinity<T>() ? 0.0 : 1e30;
        if (b > 0 && c < 0) return relative_off(got, Digits50((Digits50(b) + root) / a));
        return relative_off(got, Digits50(c / (Digits50(b) + (b < 0 ? -root : root))));
      });
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
  [[nodiscard]] std::string text(
      const std::string& more = ", not within 4 u of the surface") const {
    return std::string("1e-6 to ") + far + " radii from the center" + more +
           "; sizes and directions of " + range;
  }
};

const std::string compared = "; impact below 0.99 radius";
template <class T>
std::string off_grazing() {
  return std::string("; impact off the radius by more than ") + grazing_band<T>() + " of it";
}

template <class Real>
void add_hybrid(Family& family) {
  using T = Scalar<Real>;
  const auto add = [&](const std::string& what, const std::string& where, const Bound& bound,
                       const Shots& shots, Off<T> off) {
    family.add<Real>("hybrid, " + what, where, bound,
                     worst_shot<Real>(SphereForm::hybrid, shots, off));
  };
  const auto domain =
      by_number<Real>(Domain{7, "1e7", 100, 122, "1e-30 to 1e30 and 1e-37 to 1e37"},
                      Domain{7, "1e7", 980, 995, "1e-295 to 1e295 and 1e-300 to 1e300"},
                      Domain{7, "1e7", 980, 16000, "1e-295 to 1e295 and 1e-4800 to 1e4800"});
  const Bound texels{by_number<Real>(0.002, 4e-12, 2e-15), "texel"};
  const Shots shots = domain.shots();
  const std::string text = domain.text(", also a roundoff off the surface");
  add("missed or met wrongly", text + off_grazing<T>(), {0, "rays"}, shots, wrong<T>);
  add("how nearly a misjudged ray grazes", text, {5, "u"}, shots, grazing_off<T, 0>);
  add("distance", text + compared, {16, "ulp"}, shots, distance_off<T>);
  add("normal", text + compared, texels, shots, normal_off<T, 0>);
  add("length of the normal", text + compared, {4, "u"}, shots, normal_length_off<T>);
  const Shots away{.nearest = -6, .farthest = 7, .scale = 20, .direction = 20, .centered = false};
  const std::string elsewhere =
      "center 1e-3 to 1e7 radii from the world's origin, rays from 1e-6 to 1e7 radii from it; "
      "sizes of 1e-6 to 1e6";
  add("missed or met wrongly, center elsewhere", elsewhere + off_grazing<T>(), {0, "rays"}, away,
      wrong<T>);
  add("normal, center elsewhere", elsewhere + compared, texels, away, normal_off<T, 0>);
}

template <class Real>
void add_robust(Family& family) {
  using T = Scalar<Real>;
  const auto domain = by_number<Real>(Domain{4, "1e4", 13, 13, "1e-4 to 1e4"},
                                      Domain{7, "1e7", 220, 220, "1e-66 to 1e66"},
                                      Domain{7, "1e7", 980, 980, "1e-295 to 1e295"});
  const auto add = [&](const std::string& what, const std::string& where, const Bound& bound,
                       Off<T> off) {
    family.add<Real>("robust, " + what, domain.text() + where, bound,
                     worst_shot<Real>(SphereForm::robust, domain.shots(), off));
  };
  add("how nearly a misjudged ray grazes", "", {1, "u (5 + 1.2 distance / radius)"},
      robust_grazing_off<T>);
  add("distance", compared, {24, "ulp of distance or radius"}, distance_off_coarsely<T>);
  add("normal", compared, {by_number<Real>(2e-3, 4e-12, 2e-15), "texel distance / radius"},
      normal_off<T, 1>);
  add("length of the normal", compared, {4, "u"}, normal_length_off<T>);
}

template <class T>
void add_plain(Family& family) {
  const SphereForm form = SphereForm::plain;
  const auto domain = by_number<T>(Domain{1.5L, "30", 13, 13, "1e-4 to 1e4"},
                                   Domain{5, "1e5", 220, 220, "1e-66 to 1e66"},
                                   Domain{5, "1e5", 980, 980, "1e-295 to 1e295"});
  family.add<T>("plain, how nearly a misjudged ray grazes", domain.text(),
                {4, "u (distance / radius)^2"},
                worst_shot<T>(form, domain.shots(), grazing_off<T, 2>));
  family.add<T>("plain, normal", domain.text() + compared,
                {by_number<T>(2.5e-3, 5e-12, 2.5e-15), "texel (distance / radius)^2"},
                worst_shot<T>(form, domain.shots(), normal_off<T, 2>));
}

}  // namespace

Family claims_of_spheres() {
  Family family{
      "Rays and spheres",
      "The sphere's center is the origin unless the row says otherwise. The ray is what the "
      "number holds after rounding, and the exact answer is that ray's. Exact: the quadratic "
      "equation in 50 digits. u is the unit roundoff, half the distance from 1 to the next "
      "number."};
  for_each_number([&]<class Real>() { add_hybrid<Real>(family); });
  for_each_number([&]<class Real>() { add_robust<Real>(family); });
  for_each_number([&]<class Real>() {
    family.add<Real>("root_ahead", "coefficients and the discriminant's root of 1e-6 to 1e6",
                     {2, "u"}, worst_root_ahead<Real>());
  });
  for_each<float, double, long double>([&]<class T>() { add_plain<T>(family); });
  // What the published form does where ours keeps its bound.
  for_each<float, double>([&]<class T>() {
    const long double ratio = by_number<T>(4, 7, 0);
    family.add_broken<T>(
        "plain, missed or met wrongly",
        by_number<T>("1e4", "1e7", "") + (" radii from the center" + off_grazing<T>()), {0, "rays"},
        worst_shot<T>(SphereForm::plain,
                      {.nearest = ratio, .farthest = ratio, .around_surface = false}, wrong<T>));
  });
  return family;
}

}  // namespace texmap::extremes
