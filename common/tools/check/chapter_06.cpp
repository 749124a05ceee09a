// The exercises of chapter 06. The lesson is the chapter's own. It uses PhongOptions, mix and other
// names; here those names, in the lesson's namespace, lead to the student's function.
#include <numeric>

#include "engine/app/layout_options.hpp"
#include "engine/app/phong_options.hpp"
#include "engine/app/planned_highlight.hpp"
#include "exercises.hpp"

namespace texmap::chapter_06 {

static std::function<Vec3d(Vec3d, Vec3d)> mirrored;
static std::function<double(Vec3d, Vec3d, Vec3d, double)> highlight;
static std::function<Rgb(Rgb, double, double)> blended;

/// The common one, and the whole way to the lamp.
template <class Real>
struct LightSample : texmap::LightSample<Real> {
  Vec3<Real> to_lamp;
};

inline constexpr struct {
  LightSample<double> operator()(const PointLight& light, const auto& objects,
                                 const Hit<double>& hit) const {
    return {texmap::sample_light(light, objects, hit), light.position - hit.point};
  }
} sample_light;

struct PhongOptions : texmap::PhongOptions {
  double highlight(const PhongMaterial& material, const LightSample<double>& light,
                   const Vec3d& normal, const Vec3d& to_eye) const {
    if (!mirrored && !chapter_06::highlight)
      return texmap::PhongOptions::highlight(material, light, normal, to_eye);
    const bool behind = dot(normal, light.to_light) <= 0;
    if (material.specular == 0 || (light.cosine == 0 && !behind)) return 0;  // in a shadow
    if (!mirrored) {
      return material.specular *
             chapter_06::highlight(normal, light.to_lamp, -to_eye, material.shininess);
    }
    const double cosine = dot(mirrored(-light.to_light, normal), to_eye);
    return behind || cosine <= 0 ? 0 : material.specular * std::pow(cosine, material.shininess);
  }
};

/// The student limits the light.
inline constexpr struct {
  double operator()(double light, double least, double most) const {
    return blended ? light : texmap::clamp(light, least, most);
  }
} clamp;

inline constexpr struct {
  Rgb operator()(const Rgb& light, const Rgb& texture, double t) const {
    return blended ? blended(texture, light.r, t) : texmap::mix(light, texture, t);
  }
} mix;

}  // namespace texmap::chapter_06

#include "06_phong_texture_blend/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_06;

/// The lecture's scene with large spots; the shininess is odd, so that a wrong sign shows.
std::function<Image()> lecture_scene() {
  return picture<Lesson>({"--scene", "lecture", "--shininess", "15", "--blend", "0.1"}, 36);
}

Vec3d right_mirror(const Vec3d& d, const Vec3d& n) { return mirror(-d, n); }

Slips<Vec3d> wrong_mirrors(Vec3d d, Vec3d n) {
  const double k = dot(n, d);
  const Vec3d along = n * k;
  Slips<Vec3d> wrong = {
      {"all signs are exchanged: this mirrors l, which leads away from the surface; d comes to it",
       along * 2. - d},
      {"the part along n counts once: the formula has 2 (n . d) n", {d - along, along - d}},
      {"n and d are exchanged: you mirror the normal at d", {n - d * (2 * k), d * (2 * k) - n}},
      {"2 (n . d) n is subtracted from d: r is no mirrored direction, and longer than 1",
       {d + along * 2., -d - along * 2.}},
      {"you return d: a mirror turns the part of d along n around", d},
      {"you return the opposite of d: that is the way back", -d},
      {"this is no more than the part along n: r is d - 2 (n . d) n",
       {along * 2., along, along * -2., -along}},
      {"the part of d along n is shorter than n: it is n * dot(n, d)",
       {d - n, d + n, d - n * 2., d + n * 2.}},
      {"2 (n . d) multiplies n alone: n * (2 * dot(n, d)), not a sum",
       {(d - n) * (2 * k), (n - d) * (2 * k), (d + n) * (2 * k)}},
      {"this is the middle between n and the way back: r is on the other side of n",
       normalize(n - d)},
      {"this is right for n = +y at most: the normal may have any direction",
       Vec3d{d.x, -d.y, d.z}},
      {"the cross product is at a right angle to both: r lies in the plane of n and d",
       {cross(n, d), cross(d, n)}},
      {"n . d is above 0 behind the mirror, and r needs its sign: no std::abs, std::max or "
       "std::min",
       {d + n * (2 * abs(k)), d - n * (2 * abs(k)), d - n * (2 * max(k, 0.)),
        d - n * (2 * min(k, 0.))}},
  };
  return wrong += changed(wrong, [](const Vec3d& v) { return normalize(v); });
}

constexpr Place<Vec3d, Vec3d> mirrored_places[] = {
    {"a ray straight down is sent straight up", {{0, -1, 0}, {0, 1, 0}}},
    {"a ray along the surface goes on as it is", {{1, 0, 0}, {0, 1, 0}}},
    {"a ray that comes down at 45 degrees goes up at 45 degrees",
     {{half_root, -half_root, 0}, {0, 1, 0}}},
    {"with n = +y and d = (0.6, -0.8, 0)", {{0.6, -0.8, 0}, {0, 1, 0}}},
    {"with n = +z and d = (0.6, 0, -0.8)", {{0.6, 0, -0.8}, {0, 0, 1}}},
    {"with n = (2, 3, 6) / 7 and d = (-2, -1, -2) / 3",
     {{-2. / 3, -1. / 3, -2. / 3}, {2. / 7, 3. / 7, 6. / 7}}},
    {"from behind it is the same formula: with n = +y and d = (0.6, 0.8, 0)",
     {{0.6, 0.8, 0}, {0, 1, 0}}},
};

/// Highlights of one cause, of those who remember, too, to normalize the light, to test n . l > 0
/// and to limit the cosine, or do not.
Slips<double> careless_highlights(Vec3d n, Vec3d to_lamp, Vec3d d, double s, bool normalizes,
                                  bool tests_side, bool limits) {
  const Vec3d l = normalizes ? normalize(to_lamp) : to_lamp;
  const Vec3d e = -d;
  const double straight = dot(n, l), right = dot(mirror(l, n), e);
  const auto limited = [=](double cosine) { return limits && cosine < 0 ? 0 : cosine; };
  const double c = limited(right);
  constexpr auto no_cosine =
      "the direction to the lamp does not have the length 1: normalize it first, or the cosine is "
      "no cosine";
  constexpr auto negative =
      "the cosine is not limited: a negative number to an even power is positive. Raise "
      "std::max(cosine, 0.0)";
  constexpr auto behind =
      "there is a highlight where the lamp is behind the surface: test n . l first";
  Slips<double> wrong;
  if (!normalizes || !limits || !tests_side) {
    wrong += {!normalizes ? no_cosine
              : !limits   ? negative
                          : behind,
              {pow(c, s), max(pow(c, s), 0.)}};
  }
  const Slips<double> cosines = {
      {"the cosine has the wrong sign: d goes away from the eye, so take dot(r, -d), r = 2 (n . l) "
       "n - l",
       -right},
      {no_cosine, {dot(n * (2 * dot(n, to_lamp)) - l, e), dot(n * (2 * straight) - to_lamp, e)}},
      {"std::abs lights the side away from r, too: take std::max(cosine, 0.0)", abs(right)},
      {"what is above 0 stays and what is below 0 becomes 0: l leads to the lamp, and "
       "std::max(cosine, 0.0) limits it",
       min(right, 0.)},
      {"this is 1 everywhere: limit the cosine to 0 or more, not to 1", 1},
      {"n . l is the cosine of the diffuse light: take r and the direction to the eye", straight},
      {"the light is not mirrored: take r = 2 (n . l) n - l and the direction to the eye",
       dot(l, e)},
      {"this is the angle between n and the eye: take r and the direction to the eye", dot(n, e)},
      {"this takes the vector halfway to the eye, as Blinn does: take the mirrored direction r",
       dot(n, normalize(l + e))},
      {"the part along n counts once: r is 2 (n . l) n - l", dot(n * straight - l, e)},
      {"n and l are exchanged in r: it is 2 (n . l) n - l", dot(mirror(n, l), e)},
      {"l is added in r: subtract it, r is 2 (n . l) n - l", dot(n * (2 * straight) + l, e)},
      {"l is missing in r: it is 2 (n . l) n - l", dot(n * (2 * straight), e)},
      {"n . l is missing in r: it is 2 (n . l) n - l", dot(n * 2. - l, e)},
  };
  wrong += {
      changed(cosines, [&](double cosine) { return pow(limited(cosine), s); }),
      {"the cosine is multiplied by the shininess: raise it to this power, with std::pow", c * s},
      {"base and exponent are exchanged: std::pow(cosine, shininess)", pow(s, c)},
      {"this is the cosine: raise it to the power shininess", c},
      {"you raise the angle: the dot product already is its cosine", pow(acos(c), s)},
      {"the strength 0.3 is the lesson's: return the power alone", 0.3 * pow(c, s)},
      {"the shininess need not be a whole number: take std::pow",
       {pow(c, trunc(s)), pow(c, ceil(s))}},
  };
  return tests_side && straight <= 0 ? changed(wrong, [](double) { return 0.; }) : wrong;
}

Slips<double> wrong_highlights(Vec3d n, Vec3d to_lamp, Vec3d d, double s) {
  Slips<double> wrong;
  for (int care = 7; care >= 0; --care)
    wrong += careless_highlights(n, to_lamp, d, s, care > 3, care % 4 > 1, care % 2 > 0);
  const Vec3d l = normalize(to_lamp);
  const auto power = [&](const Vec3d& r) { return pow(max(dot(r, -d), 0.), s); };
  const double anywhere = power(mirror(l, n));
  const double front = max(dot(n, l), 0.);
  return {
      wrong,
      {"it is not enough to limit n . l in r: return 0 where it is 0 or less",
       power(n * (2 * front) - l)},
      {"n . d says where the eye is: test n . l, on which side the lamp is",
       {dot(n, d) <= 0 ? 0 : anywhere, dot(n, d) >= 0 ? 0 : anywhere}},
      {"the test is the wrong way around: return 0 where n . l is 0 or less",
       dot(n, to_lamp) >= 0 ? 0 : anywhere},
      {"n . l is a factor of the diffuse light: return the power alone", anywhere * front},
  };
}

constexpr Vec3d up{0, 1, 0};
constexpr double sine_of_60 = std::numbers::sqrt3 / 2;
constexpr Place<Vec3d, Vec3d, Vec3d, double> highlight_places[] = {
    {"with lamp and eye straight above, all of the light comes back: 1",
     {up, {0, 1, 0}, {0, -1, 0}, 3}},
    {"also if the lamp is 5 away", {up, {0, 5, 0}, {0, -1, 0}, 3}},
    {"at 60 degrees from the mirrored direction, with shininess 1, it is 1/2",
     {up, {0, 2, 0}, {sine_of_60, -0.5, 0}, 1}},
    {"with shininess 5 it is 1/32", {up, {0, 2, 0}, {sine_of_60, -0.5, 0}, 5}},
    {"at 45 degrees, with shininess 2, it is 1/2", {up, {0, 2, 0}, {0, -half_root, -half_root}, 2}},
    {"with shininess 2.5 it is 0.42", {up, {0, 2, 0}, {0, -half_root, -half_root}, 2.5}},
    {"where r and the direction to the eye are more than 90 degrees apart, it is 0",
     {up, {3, 1, 0}, {-0.8, -0.6, 0}, 3}},
    {"also with an even shininess", {up, {3, 1, 0}, {-0.8, -0.6, 0}, 4}},
    {"with the lamp behind the surface it is 0", {up, {3, -4, 0}, {0.6, 0.8, 0}, 2}},
    {"also if the eye is in front of it", {up, {4, -3, 0}, {0.8, -0.6, 0}, 2}},
    {"with n = +y, the lamp at (3, 4, 0), d = (0.8, -0.6, 0) and shininess 2",
     {up, {3, 4, 0}, {0.8, -0.6, 0}, 2}},
    {"with a slanted normal and shininess 7", {{2. / 7, 3. / 7, 6. / 7}, {2, 1, 2}, {0, 0, -1}, 7}},
};

/// Blends as many write them, with the light limited to 1 or not.
Slips<Rgb> wrong_shares(Rgb texture, double light, double t) {
  const double rest = 1 - t;
  const Rgb lit = gray(light);
  return {
      {"the shares are exchanged: the texture has the share t, the light 1 - t",
       lit * t + texture * rest},
      {"both are added whole: multiply each by its share", lit + texture},
      {"you multiply texture and light, as in the chapters before: a blend is a sum",
       {texture * light, texture * (light * t), texture * (light * rest),
        texture * (t + light * rest), texture * (light * t + rest),
        texture * (light * t) + lit * rest}},
      {"the light has no share: multiply it by 1 - t", lit + texture * t},
      {"the texture has no share: multiply it by t", lit * rest + texture},
      {"both have the same share: the texture has the share t, the light 1 - t",
       {(lit + texture) * t, (lit + texture) * rest}},
      {"both have the share 1/2: the texture has the share t, the light 1 - t",
       (lit + texture) * 0.5},
      {"the light is missing: add it with the share 1 - t", texture * t},
      {"the texture is missing: add it with the share t", lit * rest},
      {"the light has the share 1 - t, not 1 minus the light", gray(1 - light) + texture * t},
      {"the light has the share 1 - t: multiply it by this, not by 1 minus the light",
       gray(light * (1 - light)) + texture * t},
      {"the share 1 is not yet the light's: multiply the light by 1 - t", gray(rest) + texture * t},
      {"the light has a negative share: it is 1 - t, not t - 1", texture * t + lit * (t - 1)},
      {"a gray has three equal parts: Color{x, x, x}", texture * t + Rgb{light, 0, 0} * rest},
  };
}

Slips<Rgb> wrong_blends(Rgb texture, double light, double t) {
  const auto with = [&](double other) { return gray(other) * (1 - t) + texture * t; };
  const Rgb sum = with(light);
  return {
      {"the light is not limited to 1: take std::min(light, 1.0)", sum},
      {"std::max makes all light 1 or more: take std::min(light, 1.0)", with(max(light, 1.))},
      {"light above 1 counts as 1: it does not begin again at 0", with(light - floor(light))},
      {"light above 1 counts as 1, not as 0", with(light > 1 ? 0 : light)},
      {"the light alone is limited to 1, before you multiply it and add",
       {gray(min(light * (1 - t), 1.)) + texture * t,
        {min(sum.r, 1.), min(sum.g, 1.), min(sum.b, 1.)}}},
      wrong_shares(texture, min(light, 1.), t),
      wrong_shares(texture, light, t),
  };
}

Rgb right_blend(Rgb c, double light, double t) { return texmap::mix(gray(min(light, 1.)), c, t); }
constexpr Rgb sea{0.2, 0.4, 0.6};
constexpr Place<Rgb, double, double> blended_places[] = {
    {"with t = 1 the texture alone is left", {sea, 0.5, 1}},
    {"with t = 0 the light alone is left", {sea, 0.5, 0}},
    {"with t = 1/2 it is the middle of both", {sea, 0.8, 0.5}},
    {"texture (0.2, 0.4, 0.6), light 0.5 and t = 0.3 give (0.41, 0.47, 0.53)", {sea, 0.5, 0.3}},
    {"in the dark the share of the texture is left", {sea, 0, 0.3}},
    {"a light of 1.3 counts as 1", {sea, 1.3, 0}},
    {"also where it is blended", {sea, 1.25, 0.3}},
};

Image stage_after(const std::vector<std::string>& words) {
  const auto lesson = prepared<Lesson>(words);
  return render<double>(lesson, view_of(lesson.stage.camera, 800, 600));
}
/// How many pixels the highlight changes.
double size_of_spot(const std::string& shininess) {
  const auto spot = stage_after({"--shininess", shininess}).pixels;
  const auto none = stage_after({"--shininess", "1e30"}).pixels;
  return std::transform_reduce(spot.begin(), spot.end(), none.begin(), 0., std::plus<>(),
                               std::not_equal_to<>());
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "06",
      {exercise(chapter_06::mirrored, lecture_scene(),
                {right_mirror, wrong_mirrors, mirrored_places}),
       exercise(chapter_06::highlight, lecture_scene(),
                {[](Vec3d n, Vec3d to_lamp, Vec3d d, double shininess) {
                   const Vec3d l = normalize(to_lamp);
                   return texmap::highlight(
                       {.lambertian = {}, .specular = 1, .shininess = shininess},
                       texmap::LightSample<double>{l, max(dot(n, l), 0.)}, n, -d);
                 },
                 wrong_highlights, highlight_places}),
       // From near by, with a spot in which the light is more than 1. No blend of a byte and a
       // limited light is a whole byte here: rounding would decide.
       exercise(chapter_06::blended, picture<Lesson>({"--blend", "0.3337", "--shininess", "5"}, 20),
                {right_blend, wrong_blends, blended_places})},
      {{"The highlight changes some pixels of the picture. By what factor are there more of them "
        "with --shininess 50 than with --shininess 500?",
        [] { return size_of_spot("50") / size_of_spot("500"); },
        {"", 0.1},
        "By what factor is the spot wider with 50? The pixels fill its area.",
        {{3.16, "this is how much wider the spot is: its area has the square of that"}}},
       {"Pixel (346, 320) is on the dark side. Its texture is (22, 69, 128), and the light is the "
        "ambient 0.2. Which byte of green does --blend 0.5 draw?",
        [] {
          return double(stage_after({"--blend", "0.5"}).at(346, 320).g);
        },
        {"", 0},
        "Which byte has the light, and which share of it and of the texture is in the blend?",
        {{13, "this multiplies texture and light: a blend adds a share of each"},
         {34, "this is the texture's half: the light's half is added"},
         {41, "the light's share is a gray, 0.2 of 255: it is not multiplied by the texture"},
         {120, "each has the share 1/2: you add both whole"}}}},
  };
  return chapter;
}

}  // namespace texmap::check
