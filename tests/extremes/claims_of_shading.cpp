// Claims of common/shading, common/math/color.hpp and common/geometry/camera.hpp: light, colors and the rays of a picture.
#include "camera.hpp"
#include "claims.hpp"
#include "color.hpp"
#include "describe.hpp"
#include "dice.hpp"
#include "digits.hpp"
#include "phong.hpp"
#include "seed_blend.hpp"
#include "sky.hpp"

namespace texmap::extremes {
namespace {

/// A surface point with a lamp and an eye.
template <class T>
struct Gloss {
  Vec3<T> normal, to_light, to_eye;
};

template <class T>
std::string gloss_described(const Gloss<T>& gloss, double shininess) {
  return "shininess " + described(shininess) + ", normal " + described(gloss.normal) + ", light " + described(gloss.to_light) +
         ", eye " + described(gloss.to_eye);
}

/// Unit vectors but for rounding; the eye often near the mirrored lamp, as near as visible highlights of any exponent are.
template <class T>
Gloss<T> draw_gloss(Dice& dice) {
  const Vec3<long double> normal = dice.direction();
  Vec3<long double> to_light = dice.direction();
  if (dot(normal, to_light) < 0) to_light = -to_light;
  const Vec3<long double> mirrored = normal * (2 * dot(normal, to_light)) - to_light;
  Vec3<long double> to_eye = dice.direction();
  switch (dice.below(8)) {
    case 0:
      to_eye = mirrored;
      break;
    case 1:
      to_eye = -mirrored;
      break;
    case 2:
      to_eye = dice.across(mirrored);
      break;
    case 3:
      break;
    default: {
      const long double angle = dice.power_of_ten(-12, 0.2L);
      to_eye = mirrored * std::cos(angle) + dice.across(mirrored) * std::sin(angle);
    }
  }
  return {rounded<T>(normal), rounded<T>(to_light), rounded<T>(to_eye)};
}

template <class Real>
Real shone(const Finish& finish, const std::array<Gloss<Scalar<Real>>, lanes<Real>>& each, const Real& cosine) {
  std::array<Vec3<Scalar<Real>>, lanes<Real>> normals;
  std::array<Vec3<Scalar<Real>>, lanes<Real>> lights;
  std::array<Vec3<Scalar<Real>>, lanes<Real>> eyes;
  for (std::size_t k = 0; k < lanes<Real>; ++k) {
    normals[k] = each[k].normal;
    lights[k] = each[k].to_light;
    eyes[k] = each[k].to_eye;
  }
  const Illumination<Real> lamp{gathered<Real>(lights), cosine};
  return highlight(finish, lamp, gathered<Real>(normals), gathered<Real>(eyes));
}

/// The highlight's difference from that of the exactly normalized vectors, in unit roundoffs times sqrt(1 + shininess).
template <class Real>
auto worst_highlight() {
  using T = Scalar<Real>;
  return worst_over([](Dice& dice, Worst& worst) {
    const double shininess =
        dice.once_in(4) ? static_cast<double>(dice.within(0, 1000)) : static_cast<double>(dice.number<float>(-10, 60));
    const Finish finish{{}, 1, shininess};
    const auto each = drawn<Real>([&] { return draw_gloss<T>(dice); });
    const Real got = shone<Real>(finish, each, Real(1));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const auto unit = [](const Vec3<T>& p) {
        const Vec3<Digits50> q = exactly<Digits50>(p);
        return q * Digits50(1 / sqrt(dot(q, q)));
      };
      const Vec3<Digits50> n = unit(each[k].normal);
      const Vec3<Digits50> l = unit(each[k].to_light);
      // The cosine itself: with 50 digits, nothing is lost beside 1.
      const Digits50 cosine = 2 * dot(n, l) * dot(n, unit(each[k].to_eye)) - dot(l, unit(each[k].to_eye));
      const Digits50 exact = cosine > 0 ? Digits50(pow(cosine, Digits50(shininess))) : Digits50(0);
      // At exponents below 1 the highlight ends with a step, or steeply, at 90 degrees.
      if (shininess < 1 && abs(cosine) < 0.1) continue;
      worst.see(units_off(lane(got, k), exact, roundoff<T>() * sqrt(Digits50(1 + shininess))),
                [&] { return gloss_described(each[k], shininess); });
    }
  });
}

enum class Which { ours, slides };

/// Highlights that are negative, above specular, or no number.
template <class Real>
auto count_wrong_highlights(Which which) {
  using T = Scalar<Real>;
  return worst_over(10, [which](Dice& dice, Worst& worst) {
    const double shininess = dice.once_in(16) ? 0 : static_cast<double>(dice.power_of_ten(-30, which == Which::ours ? 30 : 3));
    const double specular = dice.once_in(4) ? 1 : static_cast<double>(dice.uniform(0, 1));
    const Finish finish{{}, specular, shininess};
    const auto each = drawn<Real>([&] { return draw_gloss<T>(dice); });
    const Real got = which == Which::ours ? shone<Real>(finish, each, Real(1)) : from_lanes<Real>([&](std::size_t k) {
      const Illumination<T> lamp{each[k].to_light, T(1)};
      return highlight_of_the_slides(finish, lamp, each[k].normal, each[k].to_eye);
    });
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const T x = lane(got, k);
      worst.count(!(x >= 0 && x <= static_cast<T>(specular)), [&] { return gloss_described(each[k], shininess); });
    }
  });
}

template <class T>
auto worst_lambert() {
  return worst_over([](Dice& dice, Worst& worst) {
    const Matt matt{static_cast<double>(dice.uniform(0, 1)), static_cast<double>(dice.uniform(0, 1))};
    const T cosine = dice.once_in(8) ? T(0) : dice.number<T>(-60, 0);
    const T got = lambert(matt, Illumination<T>{{}, cosine});
    const Digits50 exact = Digits50(matt.ambient) + Digits50(matt.diffuse) * Digits50(cosine);
    worst.see(units_off(got, exact, exact * roundoff<T>()), [&] { return described(cosine); });
  });
}

template <class Real>
Real mixed(const Real& a, const Real& b, const Real& t) {
  return mix(gray(a), gray(b), t).g;
}

template <class Real>
auto worst_mix() {
  using T = Scalar<Real>;
  return worst_over([](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] {
      return std::array<T, 3>{dice.number<T>(-100, 100), dice.number<T>(-100, 100),
                              dice.once_in(2) ? static_cast<T>(dice.uniform(0, 1)) : dice.number<T>(-60, 0)};
    });
    const auto part = [&](std::size_t which) { return from_lanes<Real>([&](std::size_t k) { return each[k][which]; }); };
    const Real got = mixed(part(0), part(1), part(2));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Digits50 a = each[k][0];
      const Digits50 b = each[k][1];
      const Digits50 exact = a + Digits50(each[k][2]) * (b - a);
      worst.see(units_off(lane(got, k), exact, (a > b ? a : b) * roundoff<T>()),
                [&] { return described(each[k][0]) + " " + described(each[k][1]) + " " + described(each[k][2]); });
    }
  });
}

/// Mixes that miss an end, or change a color mixed with itself.
template <class Real>
auto count_wrong_mixes() {
  using T = Scalar<Real>;
  return worst_over(20, [](Dice& dice, Worst& worst) {
    const T a = dice.number<T>(-120, 120);
    const T b = dice.number<T>(-120, 120);
    const T t = dice.once_in(2) ? static_cast<T>(dice.uniform(0, 1)) : dice.number<T>(-60, 0);
    const bool right = lane(mixed(Real(a), Real(b), Real(0)), 0) == a && lane(mixed(Real(a), Real(b), Real(1)), 0) == b &&
                       lane(mixed(Real(a), Real(a), Real(t)), 0) == a;
    worst.count(!right, [&] { return described(a) + " " + described(b) + " " + described(t); });
  });
}

/// The lecture's bytes that do not survive being mixed with themselves.
auto count_changed_bytes() {
  return count_bytes([](int byte) { return seeds::blend_lecture(byte, byte, 0.3) != byte; });
}

/// The direction of a picture's ray against that of the exact sum of the view's exact vectors.
template <class Real>
auto worst_camera() {
  using T = Scalar<Real>;
  return worst_over([](Dice& dice, Worst& worst) {
    const int width = dice.within(1, 8192);
    const auto height = static_cast<int>(1 + static_cast<long double>(width) * dice.uniform(0.5L, 2));
    const double angle = static_cast<double>(dice.uniform(1, 120));
    const Vec3<long double> eye = dice.direction() * dice.power_of_ten(-3, 3);
    const Camera camera{{static_cast<double>(eye.x), static_cast<double>(eye.y), static_cast<double>(eye.z)}, {0, 0, 0}, angle};
    const View view = view_of(camera, width, height);
    const auto columns = drawn<Real>([&] { return static_cast<T>(dice.within(0, width - 1)); });
    const auto row = static_cast<T>(dice.within(0, height - 1));
    const Ray<Real> ray = ray_through(view, gathered_numbers<Real>(columns), Real(row));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Digits50 x = (Digits50(columns[k]) - view.center_column) * view.pixel;
      const Digits50 y = (view.center_row - Digits50(row)) * view.pixel;
      Vec3<Digits50> exact =
          exactly<Digits50>(view.forward) + exactly<Digits50>(view.right) * x + exactly<Digits50>(view.up) * y;
      exact = exact * Digits50(1 / sqrt(dot(exact, exact)));
      const Vec3<Digits50> off = exactly<Digits50>(lane_of(ray.direction, k)) - exact;
      worst.see(static_cast<double>(sqrt(dot(off, off)) / roundoff<T>()),
                [&] { return described(columns[k]) + " " + described(row); });
    }
  });
}

/// The three vectors of a view against the exact ones: they are double in every picture.
auto worst_view() {
  return worst_over([](Dice& dice, Worst& worst) {
    const auto place = [&dice] {
      const Vec3<long double> p = dice.direction() * dice.power_of_ten(-3, 3);
      return Point{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    };
    const Camera camera{place(), place(), static_cast<double>(dice.uniform(1, 170))};
    const View view = view_of(camera, 640, 480);
    const auto unit = [](const Vec3<Digits50>& p) { return p * Digits50(1 / sqrt(dot(p, p))); };
    const Vec3<Digits50> forward = unit(exactly<Digits50>(camera.target) - exactly<Digits50>(camera.eye));
    // Nearly straight up or down there is no right; its error grows as the angle from there shrinks.
    const Digits50 level = sqrt(forward.x * forward.x + forward.z * forward.z);
    const Vec3<Digits50> right = unit(cross(forward, Vec3<Digits50>{0, 1, 0}));
    const Vec3<Digits50> up = cross(right, forward);
    const auto off = [](const Point& got, const Vec3<Digits50>& exact) {
      const Vec3<Digits50> apart = exactly<Digits50>(got) - exact;
      return Digits50(sqrt(dot(apart, apart)));
    };
    const Digits50 most =
        std::max({off(view.forward, forward), Digits50(off(view.right, right) * level), Digits50(off(view.up, up) * level)});
    worst.see(static_cast<double>(most / roundoff<double>()),
              [&] { return described(camera.eye) + " " + described(camera.target); });
  });
}

template <class Real>
auto worst_sky() {
  using T = Scalar<Real>;
  const GradientSky sky{.below = {1, 1, 1}, .above = {0.5, 0.7, 1}};
  return worst_over([=](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] { return rounded<T>(dice.direction()); });
    const Color<Real> got = sky(Ray<Real>{{}, gathered<Real>(each)});
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Digits50 height = (Digits50(each[k].y) + 1) / 2;
      const Digits50 exact = Digits50(sky.below.g) * (1 - height) + Digits50(sky.above.g) * height;
      worst.see(units_off(lane(got.g, k), exact, roundoff<T>()), [&] { return described(each[k]); });
    }
  });
}

template <class Real>
auto glosses() {
  return inputs_of_cost<Real>([](Dice& dice) { return drawn<Real>([&] { return draw_gloss<Scalar<Real>>(dice); }); });
}

struct Bounds {
  double highlight;  ///< u sqrt(1 + shininess)
  double mix;        ///< u of the larger end
  double direction;  ///< u
  double sky;        ///< u
};

template <class Real>
void add_number(std::vector<Claim>& claims, const Bounds& bounds) {
  const Finish finish{{}, 1, 50};
  const Cost cost{"the power of the cosine, double",
                  working_through(glosses<Real>(), [finish](const auto& each) { return shone<Real>(finish, each, Real(1)); }),
                  working_through(glosses<double>(), [](const auto& each) {
                    const auto& [normal, to_light, to_eye] = each[0];
                    const Vec3<double> mirrored = normal * (2 * dot(normal, to_light)) - to_light;
                    return std::pow(larger(dot(mirrored, to_eye), 0.0), 50.0);
                  })};
  claims.push_back({.function = "highlight",
                    .number = name_of<Real>,
                    .domain = "vectors of unit length but for rounding; shininess 0.001 to 1e18, below 1 to a cosine of 0.1",
                    .bound = bounds.highlight,
                    .unit = "u sqrt(1 + shininess)",
                    .worst = worst_highlight<Real>(),
                    .cost = cost});
  claims.push_back({.function = "highlight, range",
                    .number = name_of<Real>,
                    .domain = "vectors of unit length but for rounding; shininess 0 to 1e30",
                    .unit = "outside [0, specular]",
                    .worst = count_wrong_highlights<Real>(Which::ours)});
  claims.push_back({.function = "mix",
                    .number = name_of<Real>,
                    .domain = "ends 1e-30 to 1e30, t in [0, 1]",
                    .bound = bounds.mix,
                    .unit = "u of the larger end",
                    .worst = worst_mix<Real>()});
  claims.push_back({.function = "mix, both ends and a color with itself",
                    .number = name_of<Real>,
                    .domain = "ends 1e-36 to 1e36, t in [0, 1]",
                    .unit = "not exact",
                    .worst = count_wrong_mixes<Real>()});
  claims.push_back(
      {.function = "ray_through, direction",
       .number = name_of<Real>,
       .domain =
           "any pixel of pictures 1 to 8192 wide and half to twice as high, angles of view of 1 to 120 degrees, the view as "
           "view_of gives it",
       .bound = bounds.direction,
       .unit = "u",
       .worst = worst_camera<Real>()});
  claims.push_back({.function = "GradientSky",
                    .number = name_of<Real>,
                    .domain = "unit directions, colors of 0 to 1",
                    .bound = bounds.sky,
                    .unit = "u",
                    .worst = worst_sky<Real>()});
}

template <class T>
void add_lambert(std::vector<Claim>& claims) {
  claims.push_back({.function = "lambert",
                    .number = name_of<T>,
                    .domain = "ambient, diffuse and cosine in [0, 1]",
                    .bound = 2.5,
                    .unit = "u of itself",
                    .worst = worst_lambert<T>()});
}

}  // namespace

Family claims_of_shading() {
  Family family{
      "Light, colors and the camera",
      "Exact: the same geometry with exactly normalized vectors in 50 digits, the highlight as the power of its cosine. "
      "The last rows are the slides' forms.",
      {}};
  std::vector<Claim>& claims = family.claims;
  add_number<float>(claims, {6, 2, 6, 2});
  add_number<double>(claims, {6, 2, 6, 2});
  add_number<long double>(claims, {6, 2, 6, 2});
#ifdef TEXMAP_HAVE_PACKS
  add_number<Pack<float>>(claims, {6, 2, 6, 2});
  add_number<Pack<double>>(claims, {6, 2, 6, 2});
#endif
  add_lambert<float>(claims);
  add_lambert<double>(claims);
  add_lambert<long double>(claims);
  claims.push_back({.function = "view_of, vectors",
                    .number = name_of<double>,
                    .domain = "eye and target 1e-3 to 1e3 from the origin",
                    .bound = 8,
                    .unit = "u over the cosine of the camera's tilt",
                    .worst = worst_view()});
  claims.push_back({.function = "seed 4's highlight, range",
                    .number = name_of<double>,
                    .domain = "vectors of unit length but for rounding; shininess to 1000",
                    .unit = "outside [0, specular]",
                    .worst = count_wrong_highlights<double>(Which::slides),
                    .expect = Expect::beyond});
  claims.push_back({.function = "seed 4's blend of a byte with itself",
                    .number = "byte",
                    .domain = "every byte, t = 0.3",
                    .unit = "bytes changed",
                    .worst = count_changed_bytes(),
                    .expect = Expect::beyond});
  return family;
}

}  // namespace texmap::extremes
