// The exercises of chapter 06. The lesson is the chapter's own. It uses PhongOptions, mix and other
// names; here those names, in the lesson's namespace, lead to the student's function.
#include <cmath>

#include "engine/app/layout_options.hpp"
#include "engine/app/phong_options.hpp"
#include "engine/app/planned_highlight.hpp"
#include "exercises.hpp"

namespace texmap::check {

static Hook<Vec3<double>(Vec3<double>, Vec3<double>)> mirrored;
static Hook<double(Vec3<double>, Vec3<double>, Vec3<double>, double)> highlight;
static Hook<Color<double>(Color<double>, double, double)> blended;

}  // namespace texmap::check

namespace texmap::chapter_06 {

/// The common one, and the whole way to the lamp.
template <class Real>
struct LightSample : texmap::LightSample<Real> {
  Vec3<Real> to_lamp;
};

inline constexpr struct {
  template <class Objects>
  LightSample<double> operator()(const PointLight& light, const Objects& objects,
                                 const Hit<double>& hit) const {
    return {texmap::sample_light(light, objects, hit), light.position - hit.point};
  }
} sample_light;

struct PhongOptions : texmap::PhongOptions {
  double highlight(const PhongMaterial& material, const LightSample<double>& light,
                   const Vec3<double>& normal, const Vec3<double>& to_eye) const {
    if (!check::mirrored && !check::highlight)
      return texmap::PhongOptions::highlight(material, light, normal, to_eye);
    const bool behind = dot(normal, light.to_light) <= 0;
    if (material.specular == 0 || (light.cosine == 0 && !behind)) return 0;  // in a shadow
    if (check::highlight) {
      return material.specular *
             check::highlight.yours(normal, light.to_lamp, -to_eye, material.shininess);
    }
    const double cosine = dot(check::mirrored.yours(light.to_light, normal), to_eye);
    return behind || cosine <= 0 ? 0 : material.specular * std::pow(cosine, material.shininess);
  }
};

/// The student limits the light.
inline constexpr struct {
  double operator()(double light, double least, double most) const {
    return check::blended ? light : texmap::clamp(light, least, most);
  }
} clamp;

inline constexpr struct {
  Color<double> operator()(const Color<double>& light, const Color<double>& texture,
                           double t) const {
    return check::blended ? check::blended.yours(texture, light.r, t)
                          : texmap::mix(light, texture, t);
  }
} mix;

}  // namespace texmap::chapter_06

#include "06_phong_texture_blend/lesson.hpp"

namespace texmap::check {
namespace {

using Vector = Vec3<double>;
using chapter_06::Lesson;

/// The lecture's scene with large spots; the shininess is odd, so that a wrong sign shows.
Image lecture_scene() {
  auto lesson = prepared<Lesson>({"--scene", "lecture", "--shininess", "15", "--blend", "0.1"});
  lesson.stage.camera.fov_y_degrees = 36;
  return render<double>(lesson, view_of(lesson.stage.camera, 400, 300));
}

/// The globe from near by, with a spot in which the light is more than 1. No blend of a byte and a
/// limited light is a whole byte here: rounding would decide.
Image blended_globe() {
  auto lesson = prepared<Lesson>({"--blend", "0.3337", "--shininess", "5"});
  lesson.stage.camera.fov_y_degrees = 20;
  return render<double>(lesson, view_of(lesson.stage.camera, 400, 300));
}

/// Mirrored directions as many write them.
std::vector<Mistake<Vector(Vector, Vector)>> wrong_mirrors() {
  std::vector<Mistake<Vector(Vector, Vector)>> mistakes;
  const auto wrong = [&](const char* word, const std::function<Vector(Vector, Vector)>& function) {
    mistakes.push_back({word, function});
    mistakes.push_back(
        {word, [function](Vector l, Vector n) { return normalize(function(l, n)); }});
  };
  wrong("all signs are exchanged: r points into the surface, as if l came from the lamp",
        [](Vector l, Vector n) { return -mirror(l, n); });
  wrong("the part along n counts once: the formula has 2 (n . l) n",
        [](Vector l, Vector n) { return n * dot(n, l) - l; });
  wrong("n and l are exchanged: you mirror the normal at l",
        [](Vector l, Vector n) { return mirror(n, l); });
  wrong("l is added where it is subtracted: r is no mirrored direction, and longer than 1",
        [](Vector l, Vector n) { return n * (2 * dot(n, l)) + l; });
  wrong("2 (n . l) n has the wrong sign: add it, and subtract l",
        [](Vector l, Vector n) { return n * (-2 * dot(n, l)) - l; });
  wrong("you return the opposite of l: that sends all light away from the lamp",
        [](Vector l, Vector) { return -l; });
  wrong("you return l: a mirror changes the part of l along the surface",
        [](Vector l, Vector) { return l; });
  const char* along = "this is no more than the part along n: r is 2 (n . l) n - l";
  wrong(along, [](Vector l, Vector n) { return n * (2 * dot(n, l)); });
  wrong(along, [](Vector l, Vector n) { return n * dot(n, l); });
  wrong("this is the part of l along the surface: r has the opposite of it, and the part along n",
        [](Vector l, Vector n) { return l - n * dot(n, l); });
  const char* length = "the part of l along n is shorter than n: it is n * dot(n, l)";
  for (const double times : {1., 2.}) {
    wrong(length, [=](Vector l, Vector n) { return n * times - l; });
    wrong(length, [=](Vector l, Vector n) { return l - n * times; });
  }
  wrong("2 (n . l) multiplies n alone: subtract l after that",
        [](Vector l, Vector n) { return (n - l) * (2 * dot(n, l)); });
  wrong("2 (n . l) multiplies n alone: n * (2 * dot(n, l)), not a sum",
        [](Vector l, Vector n) { return (n + l) * (2 * dot(n, l)); });
  wrong("this is the middle between n and l: r is on the other side of n",
        [](Vector l, Vector n) { return normalize(n + l); });
  const char* only_up = "this is right for n = +y at most: the normal may have any direction";
  wrong(only_up, [](Vector l, Vector) { return Vector{-l.x, l.y, l.z}; });
  wrong(only_up, [](Vector l, Vector) { return Vector{-l.x, l.y, -l.z}; });
  return mistakes;
}

Exercise the_mirrored_direction() {
  const double r = std::sqrt(0.5);
  Law<Vector(Vector, Vector)> law{
      .right = [](Vector l, Vector n) { return mirror(l, n); },
      .places = {{"a lamp straight above is mirrored to itself",
                  {Vector{0, 1, 0}, Vector{0, 1, 0}}},
                 {"a lamp at the horizon is mirrored to the opposite horizon",
                  {Vector{1, 0, 0}, Vector{0, 1, 0}}},
                 {"a lamp at 45 degrees on the right is mirrored to 45 degrees on the left",
                  {Vector{r, r, 0}, Vector{0, 1, 0}}},
                 {"with n = +y and l = (0.6, 0.8, 0)", {Vector{0.6, 0.8, 0}, Vector{0, 1, 0}}},
                 {"with n = +z and l = (0.6, 0, 0.8)", {Vector{0.6, 0, 0.8}, Vector{0, 0, 1}}},
                 {"with n = (2, 3, 6) / 7 and l = (2, 1, 2) / 3",
                  {Vector{2. / 3, 1. / 3, 2. / 3}, Vector{2. / 7, 3. / 7, 6. / 7}}}},
      .mistakes = wrong_mirrors(),
      .tolerance = 1e-6};
  return exercise("06.1", "Vec3 mirrored(Vec3 l, Vec3 n)", std::move(law), mirrored, lecture_scene);
}

/// The directions of a highlight, and what many take for its cosine.
struct Directions {
  Vector n, l, to_lamp, e;
};
using Cosine = double (*)(const Directions&);
double right_cosine(const Directions& at) { return dot(mirror(at.l, at.n), at.e); }

constexpr const char* no_cosine =
    "the direction to the lamp does not have the length 1: normalize it first, or the cosine is "
    "no cosine";

/// Phong's power with what many do to its parts.
struct Highlight {
  Cosine cosine = right_cosine;
  double (*power)(double cosine, double s) = [](double c, double s) { return std::pow(c, s); };
  bool normalized = true;  ///< the light
  bool tests_side = true;  ///< n . l > 0
  bool limits = true;      ///< the cosine

  double operator()(const Vector& n, const Vector& to_lamp, const Vector& d, double s) const {
    const Vector l = normalized ? normalize(to_lamp) : to_lamp;
    if (tests_side && dot(n, l) <= 0) return 0;
    const double c = cosine({n, l, to_lamp, -d});
    return power(limits && c < 0 ? 0 : c, s);
  }
};

using HighlightOf = double(Vector, Vector, Vector, double);

/// Highlights of one cause, each also with what else is often forgotten.
void add_wrong_parts(std::vector<Mistake<HighlightOf>>& mistakes) {
  const auto wrong = [&](const char* word, Highlight function) {
    for (const bool normalized : {true, false}) {
      for (const bool tests_side : {true, false}) {
        for (const bool limits : {true, false}) {
          function.normalized = normalized;
          function.tests_side = tests_side;
          function.limits = limits;
          mistakes.push_back({word, function});
        }
      }
    }
  };
  wrong(
      "the cosine has the wrong sign: d goes away from the eye, so take dot(r, -d), r = 2 (n . l) "
      "n - l",
      {.cosine = [](const Directions& at) { return -right_cosine(at); }});
  wrong(no_cosine, {.cosine = [](const Directions& at) {
          return dot(at.n * (2 * dot(at.n, at.to_lamp)) - at.l, at.e);
        }});
  wrong(no_cosine, {.cosine = [](const Directions& at) {
          return dot(at.n * (2 * dot(at.n, at.l)) - at.to_lamp, at.e);
        }});
  wrong("std::abs lights the side away from r, too: take std::max(cosine, 0.0)",
        {.cosine = [](const Directions& at) { return std::abs(right_cosine(at)); }});
  wrong("std::min keeps what is below 0: take std::max(cosine, 0.0)",
        {.cosine = [](const Directions& at) { return std::min(right_cosine(at), 0.); }});
  wrong("this is 1 everywhere: limit the cosine to 0 or more, not to 1",
        {.cosine = [](const Directions&) { return 1.; }});
  wrong("n . l is the cosine of the diffuse light: take r and the direction to the eye",
        {.cosine = [](const Directions& at) { return dot(at.n, at.l); }});
  wrong("the light is not mirrored: take r = 2 (n . l) n - l and the direction to the eye",
        {.cosine = [](const Directions& at) { return dot(at.l, at.e); }});
  wrong("this is the angle between n and the eye: take r and the direction to the eye",
        {.cosine = [](const Directions& at) { return dot(at.n, at.e); }});
  wrong("this takes the vector halfway to the eye, as Blinn does: take the mirrored direction r",
        {.cosine = [](const Directions& at) { return dot(at.n, normalize(at.l + at.e)); }});
  wrong("the part along n counts once: r is 2 (n . l) n - l",
        {.cosine = [](const Directions& at) { return dot(at.n * dot(at.n, at.l) - at.l, at.e); }});
  wrong("n and l are exchanged in r: it is 2 (n . l) n - l",
        {.cosine = [](const Directions& at) { return dot(mirror(at.n, at.l), at.e); }});
  wrong("l is added in r: subtract it, r is 2 (n . l) n - l", {.cosine = [](const Directions& at) {
          return dot(at.n * (2 * dot(at.n, at.l)) + at.l, at.e);
        }});
  wrong("l is missing in r: it is 2 (n . l) n - l",
        {.cosine = [](const Directions& at) { return dot(at.n * (2 * dot(at.n, at.l)), at.e); }});
  wrong("n . l is missing in r: it is 2 (n . l) n - l",
        {.cosine = [](const Directions& at) { return dot(at.n * 2. - at.l, at.e); }});
  wrong("the cosine is multiplied by the shininess: raise it to this power, with std::pow",
        {.power = [](double c, double s) { return c * s; }});
  wrong("base and exponent are exchanged: std::pow(cosine, shininess)",
        {.power = [](double c, double s) { return std::pow(s, c); }});
  wrong("this is the cosine: raise it to the power shininess",
        {.power = [](double c, double) { return c; }});
  wrong("you raise the angle: the dot product already is its cosine",
        {.power = [](double c, double s) { return std::pow(std::acos(c), s); }});
  wrong("the strength 0.3 is the lesson's: return the power alone",
        {.power = [](double c, double s) { return 0.3 * std::pow(c, s); }});
}

/// Highlights as many write them.
std::vector<Mistake<HighlightOf>> wrong_highlights() {
  std::vector<Mistake<HighlightOf>> mistakes;
  const auto wrong = [&](const char* word, std::function<HighlightOf> function) {
    mistakes.push_back({word, std::move(function)});
  };
  wrong(no_cosine, Highlight{.normalized = false});
  wrong(no_cosine, Highlight{.normalized = false, .tests_side = false});
  wrong(no_cosine, Highlight{.normalized = false, .limits = false});
  wrong(no_cosine, Highlight{.normalized = false, .tests_side = false, .limits = false});
  const char* clamp =
      "the cosine is not limited: a negative number to an even power is positive. Raise "
      "std::max(cosine, 0.0)";
  const auto late = [](double c, double s) { return std::max(std::pow(c, s), 0.); };
  for (const bool tests_side : {true, false}) {
    wrong(clamp, Highlight{.tests_side = tests_side, .limits = false});
    wrong(clamp, Highlight{.power = late, .tests_side = tests_side, .limits = false});
  }
  wrong("there is a highlight where the lamp is behind the surface: test n . l first",
        Highlight{.tests_side = false});
  add_wrong_parts(mistakes);
  const Highlight anywhere{.tests_side = false};
  wrong("it is not enough to limit n . l in r: return 0 where it is 0 or less",
        Highlight{.cosine =
                      [](const Directions& at) {
                        return dot(at.n * (2 * std::max(dot(at.n, at.l), 0.)) - at.l, at.e);
                      },
                  .tests_side = false});
  const char* side = "n . d says where the eye is: test n . l, on which side the lamp is";
  wrong(side, [=](Vector n, Vector to_lamp, Vector d, double s) {
    return dot(n, d) <= 0 ? 0 : anywhere(n, to_lamp, d, s);
  });
  wrong(side, [=](Vector n, Vector to_lamp, Vector d, double s) {
    return dot(n, d) >= 0 ? 0 : anywhere(n, to_lamp, d, s);
  });
  wrong("the test is the wrong way around: return 0 where n . l is 0 or less",
        [=](Vector n, Vector to_lamp, Vector d, double s) {
          return dot(n, to_lamp) >= 0 ? 0 : anywhere(n, to_lamp, d, s);
        });
  wrong("n . l is a factor of the diffuse light: return the power alone",
        [](Vector n, Vector to_lamp, Vector d, double s) {
          return Highlight{}(n, to_lamp, d, s) * std::max(dot(n, normalize(to_lamp)), 0.);
        });
  return mistakes;
}

Exercise the_highlight() {
  const double r = std::sqrt(0.5);
  const Vector up{0, 1, 0};
  Law<HighlightOf> law{
      .right =
          [](Vector n, Vector to_lamp, Vector d, double shininess) {
            const Vector l = normalize(to_lamp);
            return texmap::highlight({.lambertian = {}, .specular = 1, .shininess = shininess},
                                     LightSample<double>{l, std::max(dot(n, l), 0.)}, n, -d);
          },
      .places = {{"with lamp and eye straight above, all of the light comes back: 1",
                  {up, Vector{0, 1, 0}, Vector{0, -1, 0}, 3}},
                 {"also if the lamp is 5 away", {up, Vector{0, 5, 0}, Vector{0, -1, 0}, 3}},
                 {"at 60 degrees from the mirrored direction, with shininess 1, it is 1/2",
                  {up, Vector{0, 2, 0}, Vector{std::sqrt(0.75), -0.5, 0}, 1}},
                 {"with shininess 5 it is 1/32",
                  {up, Vector{0, 2, 0}, Vector{std::sqrt(0.75), -0.5, 0}, 5}},
                 {"at 45 degrees, with shininess 2, it is 1/2",
                  {up, Vector{0, 2, 0}, Vector{0, -r, -r}, 2}},
                 {"where r and the direction to the eye are more than 90 degrees apart, it is 0",
                  {up, Vector{3, 1, 0}, Vector{-0.8, -0.6, 0}, 3}},
                 {"also with an even shininess", {up, Vector{3, 1, 0}, Vector{-0.8, -0.6, 0}, 4}},
                 {"with the lamp behind the surface it is 0",
                  {up, Vector{3, -4, 0}, Vector{0.6, 0.8, 0}, 2}},
                 {"also if the eye is in front of it",
                  {up, Vector{4, -3, 0}, Vector{0.8, -0.6, 0}, 2}},
                 {"with n = +y, the lamp at (3, 4, 0), d = (0.8, -0.6, 0) and shininess 2",
                  {up, Vector{3, 4, 0}, Vector{0.8, -0.6, 0}, 2}},
                 {"with a slanted normal and shininess 7",
                  {Vector{2. / 7, 3. / 7, 6. / 7}, Vector{2, 1, 2}, Vector{0, 0, -1}, 7}}},
      .mistakes = wrong_highlights(),
      .tolerance = 1e-6};
  return exercise("06.2", "double highlight(Vec3 n, Vec3 to_lamp, Vec3 d, double shininess)",
                  std::move(law), highlight, lecture_scene);
}

using Blend = Rgb(Rgb, double, double);

/// Blends as many write them, with the light limited to 1 or not.
void add_wrong_blends(std::vector<Mistake<Blend>>& mistakes, bool limits) {
  const auto wrong = [&](const char* word, const std::function<Blend>& function) {
    mistakes.push_back({word, [=](Rgb texture, double light, double t) {
                          return function(texture, limits ? std::min(light, 1.) : light, t);
                        }});
  };
  wrong("the shares are exchanged: the texture has the share t, the light 1 - t",
        [](Rgb texture, double light, double t) { return gray(light) * t + texture * (1 - t); });
  wrong("both are added whole: multiply each by its share",
        [](Rgb texture, double light, double) { return gray(light) + texture; });
  const char* product =
      "you multiply texture and light, as in the chapters before: a blend is a sum";
  wrong(product, [](Rgb texture, double light, double) { return texture * light; });
  wrong(product, [](Rgb texture, double light, double t) { return texture * (light * t); });
  wrong(product, [](Rgb texture, double light, double t) { return texture * (light * (1 - t)); });
  wrong(product,
        [](Rgb texture, double light, double t) { return texture * (t + light * (1 - t)); });
  wrong(product, [](Rgb texture, double light, double t) {
    return texture * (light * t) + gray(light) * (1 - t);
  });
  wrong("the light has no share: multiply it by 1 - t",
        [](Rgb texture, double light, double t) { return gray(light) + texture * t; });
  wrong("the texture has no share: multiply it by t",
        [](Rgb texture, double light, double t) { return gray(light) * (1 - t) + texture; });
  const char* twice = "both have the same share: the texture has the share t, the light 1 - t";
  wrong(twice, [](Rgb texture, double light, double t) { return (gray(light) + texture) * t; });
  wrong(twice,
        [](Rgb texture, double light, double t) { return (gray(light) + texture) * (1 - t); });
  wrong("both have the share 1/2: the texture has the share t, the light 1 - t",
        [](Rgb texture, double light, double) { return (gray(light) + texture) * 0.5; });
  wrong("the light is missing: add it with the share 1 - t",
        [](Rgb texture, double, double t) { return texture * t; });
  wrong("the texture is missing: add it with the share t",
        [](Rgb, double light, double t) { return gray(light) * (1 - t); });
  wrong("the light has the share 1 - t, not 1 minus the light",
        [](Rgb texture, double light, double t) { return gray(1 - light) + texture * t; });
  wrong(
      "the light has the share 1 - t: multiply it by this, not by 1 minus the light",
      [](Rgb texture, double light, double t) { return gray(light * (1 - light)) + texture * t; });
  wrong("the share 1 is not yet the light's: multiply the light by 1 - t",
        [](Rgb texture, double, double t) { return gray(1 - t) + texture * t; });
  wrong("the light has a negative share: it is 1 - t, not t - 1",
        [](Rgb texture, double light, double t) { return texture * t + gray(light) * (t - 1); });
  wrong("a gray has three equal parts: Color{x, x, x}", [](Rgb texture, double light, double t) {
    return texture * t + Rgb{light, 0, 0} * (1 - t);
  });
}

/// Blends as many write them.
std::vector<Mistake<Blend>> wrong_blends() {
  std::vector<Mistake<Blend>> mistakes;
  const auto wrong_light = [&](const char* word, double (*limit)(double)) {
    mistakes.push_back({word, [=](Rgb texture, double light, double t) {
                          return gray(limit(light)) * (1 - t) + texture * t;
                        }});
  };
  wrong_light("the light is not limited to 1: take std::min(light, 1.0)",
              [](double light) { return light; });
  wrong_light("std::max makes all light 1 or more: take std::min(light, 1.0)",
              [](double light) { return std::max(light, 1.); });
  wrong_light("light above 1 counts as 1: it does not begin again at 0",
              [](double light) { return light - std::floor(light); });
  wrong_light("light above 1 counts as 1, not as 0",
              [](double light) { return light > 1 ? 0 : light; });
  const char* early = "the light alone is limited to 1, before you multiply it and add";
  mistakes.push_back({early, [](Rgb texture, double light, double t) {
                        return gray(std::min(light * (1 - t), 1.)) + texture * t;
                      }});
  mistakes.push_back({early, [](Rgb texture, double light, double t) {
                        const Rgb sum = gray(light) * (1 - t) + texture * t;
                        return Rgb{std::min(sum.r, 1.), std::min(sum.g, 1.), std::min(sum.b, 1.)};
                      }});
  add_wrong_blends(mistakes, true);
  add_wrong_blends(mistakes, false);
  return mistakes;
}

Exercise the_blend() {
  const Rgb sea{0.2, 0.4, 0.6};
  Law<Blend> law{
      .right = [](Rgb texture, double light,
                  double t) { return mix(gray(std::min(light, 1.)), texture, t); },
      .places = {{"with t = 1 the texture alone is left", {sea, 0.5, 1}},
                 {"with t = 0 the light alone is left", {sea, 0.5, 0}},
                 {"with t = 1/2 it is the middle of both", {sea, 0.8, 0.5}},
                 {"texture (0.2, 0.4, 0.6), light 0.5 and t = 0.3 give (0.41, 0.47, 0.53)",
                  {sea, 0.5, 0.3}},
                 {"in the dark the share of the texture is left", {sea, 0, 0.3}},
                 {"a light of 1.3 counts as 1", {sea, 1.3, 0}},
                 {"also where it is blended", {sea, 1.25, 0.3}}},
      .mistakes = wrong_blends(),
      .tolerance = 1e-6};
  return exercise("06.3", "Color blended(Color texture, double light, double t)", std::move(law),
                  blended, blended_globe);
}

Image stage_after(const std::vector<std::string>& words) {
  const auto lesson = prepared<Lesson>(words);
  return render<double>(lesson, view_of(lesson.stage.camera, 800, 600));
}

/// How many pixels the highlight changes.
double size_of_spot(const std::string& shininess) {
  const Image spot = stage_after({"--shininess", shininess});
  const Image none = stage_after({"--shininess", "1e30"});
  double count = 0;
  for (std::size_t i = 0; i < spot.pixels.size(); ++i) {
    if (spot.pixels[i] != none.pixels[i]) count += 1;
  }
  return count;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {the_mirrored_direction(), the_highlight(), the_blend()},
      .questions = {{"06.a",
                     "The highlight changes some pixels of the picture. By what factor are there "
                     "more of them "
                     "with --shininess 50 than with --shininess 500?",
                     [] { return size_of_spot("50") / size_of_spot("500"); }, "", 0.1},
                    {"06.b",
                     "Pixel (346, 320) is on the dark side. Its texture is (22, 69, 128), and the "
                     "light is the ambient 0.2. Which byte of green does --blend 0.5 draw?",
                     [] {
                       return double(stage_after({"--blend", "0.5"}).at(346, 320).g);
                     },
                     "", 0}},
  };
  return chapter;
}

}  // namespace texmap::check
