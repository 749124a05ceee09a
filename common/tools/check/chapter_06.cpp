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
      .mistakes =
          {{"all signs are exchanged: r points into the surface, as if l came from the lamp",
            [](Vector l, Vector n) { return -mirror(l, n); }},
           {"the part along n counts once: the formula has 2 (n . l) n",
            [](Vector l, Vector n) { return n * dot(n, l) - l; }},
           {"n and l are exchanged: you mirror the normal at l",
            [](Vector l, Vector n) { return mirror(n, l); }},
           {"l is added where it is subtracted: r is no mirrored direction, and longer than 1",
            [](Vector l, Vector n) { return n * (2 * dot(n, l)) + l; }},
           {"you return the opposite of l: that sends all light away from the lamp",
            [](Vector l, Vector) { return -l; }}},
      .tolerance = 1e-6};
  return exercise("06.1", "Vec3 mirrored(Vec3 l, Vec3 n)", std::move(law), mirrored, lecture_scene);
}

/// Phong's power with what many do to its parts.
struct Highlight {
  bool normalized = true;  ///< the light
  bool tests_side = true;  ///< n . l > 0
  bool limits = true;      ///< the cosine
  double sign = 1;         ///< of the direction to the eye
  bool power = true;       ///< or a product

  double operator()(const Vector& n, const Vector& to_lamp, const Vector& d, double s) const {
    const Vector l = normalized ? normalize(to_lamp) : to_lamp;
    if (tests_side && dot(n, l) <= 0) return 0;
    const double cosine = dot(mirror(l, n), d) * -sign;
    const double base = limits && cosine < 0 ? 0 : cosine;
    return power ? std::pow(base, s) : base * s;
  }
};

Exercise the_highlight() {
  const double r = std::sqrt(0.5);
  const Vector up{0, 1, 0};
  Law<double(Vector, Vector, Vector, double)> law{
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
                 {"with a slanted normal and shininess 7",
                  {Vector{2. / 7, 3. / 7, 6. / 7}, Vector{2, 1, 2}, Vector{0, 0, -1}, 7}}},
      .mistakes = {},
      .tolerance = 1e-6};
  const auto wrong = [&](const char* word, const Highlight& function) {
    law.mistakes.push_back({word, function});
  };
  const char* sign =
      "the highlight has the wrong sign: d goes away from the eye, and r . d is large on the dark "
      "side. Take -d";
  wrong(sign, {.sign = -1});
  wrong(sign, {.tests_side = false, .sign = -1});
  wrong(sign, {.limits = false, .sign = -1});
  wrong(sign, {.tests_side = false, .limits = false, .sign = -1});
  const char* length =
      "the direction to the lamp does not have the length 1: normalize it first, or the cosine is "
      "no cosine";
  wrong(length, {.normalized = false});
  wrong(length, {.normalized = false, .tests_side = false});
  wrong(length, {.normalized = false, .limits = false});
  wrong(length, {.normalized = false, .tests_side = false, .limits = false});
  const char* clamp =
      "the cosine is not limited: a negative number to an even power is positive. Raise "
      "std::max(cosine, 0.0)";
  wrong(clamp, {.limits = false});
  wrong(clamp, {.tests_side = false, .limits = false});
  wrong("there is a highlight where the lamp is behind the surface: test n . l first",
        {.tests_side = false});
  wrong("the cosine is multiplied by the shininess: raise it to this power, with std::pow",
        {.power = false});
  return exercise("06.2", "double highlight(Vec3 n, Vec3 to_lamp, Vec3 d, double shininess)",
                  std::move(law), highlight, lecture_scene);
}

Exercise the_blend() {
  const auto limited = [](double light) { return std::min(light, 1.); };
  const Rgb sea{0.2, 0.4, 0.6};
  Law<Rgb(Rgb, double, double)> law{
      .right = [=](Rgb texture, double light,
                   double t) { return mix(gray(limited(light)), texture, t); },
      .places = {{"with t = 1 the texture alone is left", {sea, 0.5, 1}},
                 {"with t = 0 the light alone is left", {sea, 0.5, 0}},
                 {"with t = 1/2 it is the middle of both", {sea, 0.8, 0.5}},
                 {"texture (0.2, 0.4, 0.6), light 0.5 and t = 0.3 give (0.41, 0.47, 0.53)",
                  {sea, 0.5, 0.3}},
                 {"in the dark the share of the texture is left", {sea, 0, 0.3}},
                 {"a light of 1.3 counts as 1", {sea, 1.3, 0}},
                 {"also where it is blended", {sea, 1.25, 0.3}}},
      .mistakes = {},
      .tolerance = 1e-6};
  const auto wrong = [&](const char* word, std::function<Rgb(Rgb, double, double)> function) {
    law.mistakes.push_back({word, std::move(function)});
  };
  wrong("the light is not limited to 1: take std::min(light, 1.0)",
        [](Rgb texture, double light, double t) { return gray(light) * (1 - t) + texture * t; });
  for (const bool limits : {true, false}) {
    const auto lit = [=](double light) { return limits ? limited(light) : light; };
    wrong("the shares are exchanged: the texture has the share t, the light 1 - t",
          [=](Rgb texture, double light, double t) {
            return gray(lit(light)) * t + texture * (1 - t);
          });
    wrong("both are added whole: multiply each by its share",
          [=](Rgb texture, double light, double) { return gray(lit(light)) + texture; });
    wrong("you multiply texture and light, as in the chapters before: a blend is a sum",
          [=](Rgb texture, double light, double) { return texture * lit(light); });
    wrong("the light has no share: multiply it by 1 - t",
          [=](Rgb texture, double light, double t) { return gray(lit(light)) + texture * t; });
  }
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
