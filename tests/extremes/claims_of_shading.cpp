// Claims of common/scene and common/math/color.hpp: light, colors and the rays of a picture.
#include "claims.hpp"
#include "math/color.hpp"
#include "scene/camera.hpp"
#include "scene/phong.hpp"
#include "scene/sky.hpp"

namespace texmap::extremes {
namespace {

/// Normal, direction to the light and direction to the eye.
template <class Real>
using Gloss = std::array<Vec3<Real>, 3>;

/// Unit vectors, up to rounding. The eye is often near the mirrored light, as near as visible
/// highlights of any exponent are.
template <class T>
Gloss<T> draw_gloss(Dice& dice) {
  const Vec3<long double> normal = dice.direction();
  Vec3<long double> to_light = dice.direction();
  if (dot(normal, to_light) < 0) to_light = -to_light;
  const Vec3<long double> mirrored = normal * (2 * dot(normal, to_light)) - to_light;
  Vec3<long double> to_eye = dice.direction();
  const int which = dice.below(8);
  if (which < 2) to_eye = which == 0 ? mirrored : -mirrored;
  if (which == 2) to_eye = dice.across(mirrored);
  if (which > 3) {
    const long double angle = dice.power_of_ten(-12, 0.2L);
    to_eye = mirrored * std::cos(angle) + dice.across(mirrored) * std::sin(angle);
  }
  // As long as hit_at, normalize and ray_through may leave them.
  const auto nearly_unit = [&dice](const Vec3<long double>& v, long double most) {
    const auto off = most * static_cast<long double>(unit_roundoff<T>());
    return number_cast<T>(v * (1 + dice.uniform(-off, off)));
  };
  return {nearly_unit(normal, 3), nearly_unit(to_light, 3.5L), nearly_unit(to_eye, 5)};
}

template <class Real>
Real shone(HighlightFormula formula, const PhongMaterial& material, const Gloss<Real>& gloss) {
  return highlight(formula, material, LightSample<Real>{gloss[1], Real(1)}, gloss[0], gloss[2]);
}

/// Exponents of 1 and more have an end like a cosine's; below, the highlight ends steeply.
enum class End { smooth, steep };

/// The highlight's difference from that of exactly normalized vectors, in u sqrt(1 + shininess).
template <class Real>
Measurement worst_highlight(End end) {
  using T = Scalar<Real>;
  return worst_over(1, [end](Dice& dice, Worst& worst) {
    const double shininess = end == End::steep ? static_cast<double>(dice.number<float>(-10, 0))
                             : dice.once_in(4) ? static_cast<double>(dice.within(1, 1000))
                                               : static_cast<double>(dice.number<float>(0, 60));
    const PhongMaterial material{{}, 1, shininess};
    see_lanes<Real>(
        worst, [&] { return draw_gloss<T>(dice); },
        [&](const Gloss<Real>& gloss) { return shone(HighlightFormula::phong, material, gloss); },
        [&](T got, const Gloss<T>& gloss) {
          const Vec3<Digits50> n = normalize(exactly(gloss[0]));
          const Vec3<Digits50> l = normalize(exactly(gloss[1]));
          const Vec3<Digits50> e = normalize(exactly(gloss[2]));
          // The cosine itself: with 50 digits, nothing is lost near 1.
          const Digits50 cosine = 2 * dot(n, l) * dot(n, e) - dot(l, e);
          const Digits50 exact =
              cosine > 0 ? Digits50(pow(cosine, Digits50(shininess))) : Digits50(0);
          if (end == End::steep && abs(cosine) < 0.1) return 0.0;
          return units_off(got, exact, roundoff<T>() * sqrt(Digits50(1 + shininess)));
        },
        [&] { return "shininess " + described(shininess); });
  });
}

/// Highlights that are negative, above specular, or no number.
template <class Real>
Measurement count_wrong_highlights(HighlightFormula formula) {
  using T = Scalar<Real>;
  return worst_over(10, [formula](Dice& dice, Worst& worst) {
    const bool ours = formula == HighlightFormula::phong;
    const double shininess =
        dice.once_in(16) ? 0 : static_cast<double>(dice.power_of_ten(-30, ours ? 30 : 3));
    const double specular = dice.once_in(4) ? 1 : static_cast<double>(dice.uniform(0, 1));
    const PhongMaterial material{{}, specular, shininess};
    see_lanes<Real>(
        worst, [&] { return draw_gloss<T>(dice); },
        [&](const Gloss<Real>& gloss) { return shone(formula, material, gloss); },
        [&](T got, const Gloss<T>&) { return !(got >= 0 && got <= static_cast<T>(specular)); },
        [&] { return "shininess " + described(shininess); });
  });
}

template <class T>
Measurement worst_lambert() {
  return worst_over(1, [](Dice& dice, Worst& worst) {
    const Lambertian lambertian{static_cast<double>(dice.uniform(0, 1)),
                                static_cast<double>(dice.uniform(0, 1))};
    const T cosine = dice.once_in(8) ? T(0) : dice.number<T>(-60, 0);
    const T got = lambert(lambertian, LightSample<T>{{}, cosine});
    const Digits50 exact =
        Digits50(lambertian.ambient) + Digits50(lambertian.diffuse) * Digits50(cosine);
    worst.see(units_off(got, exact, exact * roundoff<T>()), [&] { return described(cosine); });
  });
}

/// Ends a and b, of up to 2^`most`, and t.
template <class T, int most>
std::array<T, 3> draw_mix(Dice& dice) {
  const T a = dice.number<T>(-most, most);
  const T b = dice.number<T>(-most, most);
  return {a, b, dice.once_in(2) ? static_cast<T>(dice.uniform(0, 1)) : dice.number<T>(-60, 0)};
}

template <class Real>
Real mixed(const Real& a, const Real& b, const Real& t) {
  return mix(gray(a), gray(b), t).g;
}

template <class Real>
Measurement worst_mix() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1, draw_mix<T, 100>, [](const std::array<Real, 3>& x) { return mixed(x[0], x[1], x[2]); },
      [](T got, const std::array<T, 3>& x) {
        const Digits50 a = x[0], b = x[1];
        return units_off(got, Digits50(a + x[2] * (b - a)), std::max(a, b) * roundoff<T>());
      });
}

/// Mixes that miss an end, or change a color mixed with itself.
template <class Real>
Measurement count_wrong_mixes() {
  return count_lanes<Real>(20, draw_mix<Scalar<Real>, 120>, [](const std::array<Real, 3>& x) {
    const auto& [a, b, t] = x;
    return !(mixed(a, b, Real(0)) == a && mixed(a, b, Real(1)) == b && mixed(a, a, t) == a);
  });
}

/// A place up to 1e3 from the origin.
Point draw_place(Dice& dice) {
  return number_cast<double>(dice.direction() * dice.power_of_ten(-3, 3));
}

/// The direction of a picture's ray against that of the exact sum of the view's exact vectors.
template <class Real>
Measurement worst_camera() {
  using T = Scalar<Real>;
  return worst_over(1, [](Dice& dice, Worst& worst) {
    const int width = dice.within(1, 8192);
    const auto height =
        static_cast<int>(1 + static_cast<long double>(width) * dice.uniform(0.5L, 2));
    const double angle = static_cast<double>(dice.uniform(1, 120));
    const View<> view = view_of({draw_place(dice), {0, 0, 0}, angle}, width, height);
    const auto columns = drawn<Real>([&] { return static_cast<T>(dice.within(0, width - 1)); });
    const auto row = static_cast<T>(dice.within(0, height - 1));
    std::size_t lane = 0;
    see_lanes<Real>(
        worst, [&] { return columns[lane++]; },
        [&](const Real& column) { return ray_through(view, column, Real(row)).direction; },
        [&](const Vec3<T>& direction, T column) {
          const Digits50 x = (Digits50(column) - view.center_column) * view.pixel;
          const Digits50 y = (view.center_row - Digits50(row)) * view.pixel;
          return length_off(direction, normalize(exactly(view.forward) + exactly(view.right) * x +
                                                 exactly(view.up) * y));
        },
        [&] { return described(row); });
  });
}

/// The three vectors of a view against the exact ones: they are double in every picture.
Measurement worst_view() {
  return worst_over(1, [](Dice& dice, Worst& worst) {
    const Camera camera{draw_place(dice), draw_place(dice),
                        static_cast<double>(dice.uniform(1, 170))};
    const View<> view = view_of(camera, 640, 480);
    const Vec3<Digits50> forward = normalize(exactly(camera.target) - exactly(camera.eye));
    // Straight up or down has no right; near them the error of right grows as the angle shrinks.
    const auto level = static_cast<double>(sqrt(forward.x * forward.x + forward.z * forward.z));
    const Vec3<Digits50> right = normalize(cross(forward, Vec3<Digits50>{0, 1, 0}));
    worst.see(std::max({length_off(view.forward, forward), length_off(view.right, right) * level,
                        length_off(view.up, cross(right, forward)) * level}),
              [&] { return described(camera.eye) + " " + described(camera.target); });
  });
}

template <class Real>
Measurement worst_sky() {
  using T = Scalar<Real>;
  const GradientSky sky{.below = {1, 1, 1}, .above = {0.5, 0.7, 1}};
  return worst_lanes<Real>(
      1, [](Dice& dice) { return number_cast<T>(dice.direction()); },
      [sky](const Vec3<Real>& direction) {
        return sky(Ray<Real>{{}, direction}).g;
      },
      [sky](T got, const Vec3<T>& direction) {
        const Digits50 height = (Digits50(direction.y) + 1) / 2;
        return units_off(
            got, Digits50(Digits50(sky.below.g) * (1 - height) + Digits50(sky.above.g) * height),
            roundoff<T>());
      });
}

}  // namespace

Family claims_of_shading() {
  Family family{"Light, colors and the camera",
                "Exact: the same geometry with exactly normalized vectors in 50 digits, the "
                "highlight as the power of its cosine. The last rows are the lecture's forms."};
  const std::string unit_vectors =
      "vectors 1 long within 4 u (normal), 4.5 u (light) and 6 u (eye); shininess ";
  const Bound in_range{0, "outside [0, specular]"};
  for_each_number([&]<class Real>() {
    family.add<Real>("highlight", unit_vectors + "1 to 1e18", {28, "u sqrt(1 + shininess)"},
                     worst_highlight<Real>(End::smooth));
    family.add<Real>("highlight, below 1", unit_vectors + "0.001 to 1, to a cosine of 0.1",
                     {56, "u sqrt(1 + shininess)"}, worst_highlight<Real>(End::steep));
    family.add<Real>("highlight, range", unit_vectors + "0 to 1e30", in_range,
                     count_wrong_highlights<Real>(HighlightFormula::phong));
    family.add<Real>("mix", "ends 1e-30 to 1e30, t in [0, 1]", {2, "u of the larger end"},
                     worst_mix<Real>());
    family.add<Real>("mix, both ends and a color with itself", "ends 1e-36 to 1e36, t in [0, 1]",
                     {0, "not exact"}, count_wrong_mixes<Real>());
    family.add<Real>("ray_through, direction",
                     "any pixel of pictures 1 to 8192 wide and half to twice as high, angles of "
                     "view of 1 to 120 degrees, the view as view_of gives it",
                     {6, "u"}, worst_camera<Real>());
    family.add<Real>("GradientSky", "unit directions, colors of 0 to 1", {2, "u"},
                     worst_sky<Real>());
  });
  for_each<float, double, long double>([&]<class T>() {
    family.add<T>("lambert", "ambient, diffuse and cosine in [0, 1]", {3, "u of itself"},
                  worst_lambert<T>());
  });
  family.add<double>("view_of, vectors", "eye and target 1e-3 to 1e3 from the origin",
                     {8, "u over the cosine of the camera's tilt"}, worst_view());
  family.add_broken<double>("the lecture's highlight, range", unit_vectors + "to 1000", in_range,
                            count_wrong_highlights<double>(HighlightFormula::lecture));
  // (int)(a t + b (1 - t)).
  const auto blended = [t = 0.3](int byte) { return static_cast<int>(byte * t + byte * (1 - t)); };
  family
      .add_broken<double>("the lecture's blend of a byte with itself", "every byte, t = 0.3",
                          {0, "bytes changed"},
                          worst_byte([=](int byte) { return blended(byte) != byte; }))
      .number = "byte";
  return family;
}

}  // namespace texmap::extremes
