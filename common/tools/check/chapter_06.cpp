// The exercises of chapter 06. The lesson is the chapter's own. It uses PhongOptions, mix and other
// names; here those names, in the lesson's namespace, lead to the student's function.
#include <numeric>

#include "engine/run/phong_options.hpp"
#include "engine/run/planned_highlight.hpp"
#include "exercises.hpp"

namespace texmap::chapter_06 {

static std::function<Vec3d(Vec3d, Vec3d)> mirrored;
static std::function<double(Vec3d, Vec3d, Vec3d, double)> highlight;
static std::function<Rgb(Rgb, double, double)> printed;

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
    return printed ? light : texmap::clamp(light, least, most);
  }
} clamp;

inline constexpr struct {
  Rgb operator()(const Rgb& light, const Rgb& texture, double t) const {
    return printed ? printed(texture, light.r, t) : texmap::mix(light, texture, t);
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
      {"all signs are exchanged: this mirrors l, and d comes to the surface", along * 2. - d},
      {"you return d, or the way back: a mirror turns the part of d along n around", {d, -d}},
      {"r is d - 2 (n . d) n",
       {{"the part along n counts once", {d - along, along - d}},
        {"n and d are exchanged, you mirror the normal", {n - d * (2 * k), d * (2 * k) - n}},
        {"you add 2 (n . d) n, and yours is longer than 1", {d + along * 2., -d - along * 2.}},
        {"this is the part along n", {along * 2., along, along * -2., -along}},
        {"the part of d along n is n * dot(n, d), not n", {d - n, d + n, d - n * 2., d + n * 2.}},
        {"2 (n . d) is for n alone", {(d - n) * (2 * k), (n - d) * (2 * k), (d + n) * (2 * k)}},
        {"n . d is above 0 behind the mirror, so no std::abs, std::max or std::min",
         {d + n * (2 * abs(k)), d - n * (2 * abs(k)), d - n * (2 * max(k, 0.)),
          d - n * (2 * min(k, 0.))}}}},
      {"this is halfway between n and the way back: r is on the other side of n", normalize(n - d)},
      {"this is right for n = +y at most: n may have any direction", Vec3d{d.x, -d.y, d.z}},
      {"a cross product leaves the plane of n and d: r lies in it", {cross(n, d), cross(d, n)}},
  };
  return wrong += changed(wrong, [](const Vec3d& v) { return normalize(v); });
}

constexpr Vec3d up{0, 1, 0};
constexpr Place<Vec3d, Vec3d> mirrored_places[] = {
    {"a ray straight down is sent straight up", {{0, -1, 0}, up}},
    {"a ray along the surface goes on as it is", {{1, 0, 0}, up}},
    {"a ray that comes down at 45 degrees goes up at 45 degrees", {{half_root, -half_root, 0}, up}},
    {"with n = +y and d = (0.6, -0.8, 0)", {{0.6, -0.8, 0}, up}},
    {"with n = +z and d = (0.6, 0, -0.8)", {{0.6, 0, -0.8}, {0, 0, 1}}},
    {"n = (2, 3, 6) / 7, d = (-2, -1, -2) / 3",
     {{-2. / 3, -1. / 3, -2. / 3}, {2. / 7, 3. / 7, 6. / 7}}},
    {"from behind it is the same formula: with n = +y and d = (0.6, 0.8, 0)", {{0.6, 0.8, 0}, up}},
};

/// Highlights of one cause, of those who also normalize the way to the lamp and test n . l > 0, or
/// forget it.
Slips<double> careless_highlights(Vec3d n, Vec3d to_lamp, Vec3d d, double s, bool normalizes,
                                  bool tests_side) {
  const Vec3d l = normalizes ? normalize(to_lamp) : to_lamp;
  const Vec3d e = -d, h = normalize(l + e);
  const double c = dot(n, h), with_d = dot(n, normalize(l + d)), page = dot(mirror(l, n), e);
  const auto power = [=](double cosine) { return pow(max(cosine, 0.), s); };
  const auto half_angle = [](double cosine) { return cos(acos(clamp(cosine, -1., 1.)) / 2); };
  Slips<double> wrong;
  if (!normalizes || !tests_side) {
    wrong += {!normalizes ? "the way to the lamp does not have the length 1: normalize it"
                          : "the lamp can be behind the surface: test n . l first",
              {power(c), pow(c, s)}};
  }
  const Slips<double> cosines = {
      {"the sum does not have the length 1: normalize", {dot(n, l + e), dot(n, (l + e) * 0.5)}},
      {"a cross product is a sine, no cosine", {length(cross(n, h)), length(cross(n, l + e))}},
      {"take the cosine between n and the direction halfway from lamp to eye",
       {{"d goes to the surface, and the direction to the eye is -d",
         {with_d, -with_d, std::max(0., with_d), dot(n, l + d)}},  // 0, not NaN, where l is -d
        {"this is the page's r . e", {page, dot(mirror(h, n), e)}},
        {"this is that of two of n, l, -d",
         {dot(n, l), dot(n, e), dot(l, e), dot(h, l), dot(h, e)}},
        {"halfway is between lamp and eye, not between one of them and n",
         {dot(e, normalize(n + l)), dot(l, normalize(n + e)), dot(n, normalize(n + l)),
          dot(n, normalize(n + e))}},
        {"take no half of an angle", {half_angle(c), half_angle(page)}}}},
      {"no cosine is above 0: take the sum of l and -d, limited by std::max", {-c, min(c, 0.)}},
  };
  wrong += {
      changed(cosines, power),
      changed(cosines, [=](double cosine) { return pow(cosine, s); }),
      {"the cross product is at right angles to l and -d: their sum lies halfway",
       {pow(dot(n, cross(l, e)), s), pow(dot(n, cross(e, l)), s)}},
      {"raise the cosine to the power shininess, std::pow(cosine, shininess)",
       {{"you multiply them", c * s},
        {"base and exponent are exchanged", pow(s, c)},
        {"this is the cosine", c},
        {"the dot product already is the cosine, not the angle", pow(acos(c), s)},
        {"the shininess may have decimals", {pow(c, trunc(s)), pow(c, ceil(s))}}}},
      {"return the power alone",
       {{"the strength 0.3 is the lesson's", 0.3 * power(c)},
        {"n . l is a factor of the diffuse light", power(c) * dot(n, l)}}},
  };
  return tests_side && dot(n, l) <= 0 ? changed(wrong, [](double) { return 0.; }) : wrong;
}

double right_highlight(Vec3d n, Vec3d to_lamp, Vec3d d, double s) {
  const Vec3d halfway = normalize(normalize(to_lamp) - d);
  return dot(n, to_lamp) > 0 ? pow(max(dot(n, halfway), 0.), s) : 0;
}

Slips<double> wrong_highlights(Vec3d n, Vec3d to_lamp, Vec3d d, double s) {
  Slips<double> wrong;
  for (int care = 3; care >= 0; --care)
    wrong += careless_highlights(n, to_lamp, d, s, care > 1, care % 2 > 0);
  return wrong +=
         {"the test is the wrong way around: return 0 where n . l is 0 or less",
          dot(n, to_lamp) >= 0 ? 0 : pow(max(dot(n, normalize(normalize(to_lamp) - d)), 0.), s)};
}

constexpr double sine_of_60 = std::numbers::sqrt3 / 2;
constexpr Place<Vec3d, Vec3d, Vec3d, double> highlight_places[] = {
    {"with lamp and eye straight above it is 1", {up, {0, 1, 0}, {0, -1, 0}, 3}},
    {"also if the lamp is 5 away", {up, {0, 5, 0}, {0, -1, 0}, 3}},
    {"where n itself is halfway it is 1", {up, {-3, 4, 0}, {-0.6, -0.8, 0}, 3}},
    {"with the eye straight above and the lamp at 60 degrees from n, shininess 2: 3/4",
     {up, {2 * sine_of_60, 1, 0}, {0, -1, 0}, 2}},
    {"with shininess 4 it is 9/16", {up, {2 * sine_of_60, 1, 0}, {0, -1, 0}, 4}},
    {"with shininess 2.5 it is 0.7", {up, {2 * sine_of_60, 1, 0}, {0, -1, 0}, 2.5}},
    {"with lamp and eye on the same side of n, at 60 degrees both, shininess 1: 1/2",
     {up, {sine_of_60, 0.5, 0}, {-sine_of_60, -0.5, 0}, 1}},
    {"with the lamp behind the surface it is 0", {up, {3, -1, 0}, {-0.6, -0.8, 0}, 2}},
    {"also if the direction halfway is behind the surface", {up, {3, -4, 0}, {-0.8, -0.6, 0}, 2}},
    {"n = +y, lamp (3, 4, 0), d = (0.8, -0.6, 0), shininess 2", {up, {3, 4, 0}, {0.8, -0.6, 0}, 2}},
    {"with a slanted normal and shininess 7", {{2. / 7, 3. / 7, 6. / 7}, {2, 1, 2}, {0, 0, -1}, 7}},
};

/// Blends as many write them, with the light limited to 1 or not.
Slips<Rgb> wrong_shares(Rgb texture, double light, double share) {
  const double rest = 1 - share;
  const Rgb lit = gray(light);
  return {
      {"you multiply texture and light, as in the chapters before: a blend is a sum",
       {texture * light, texture * (light * share), texture * (light * rest),
        texture * (share + light * rest), texture * (light * share + rest),
        texture * (light * share) + lit * rest}},
      {"multiply the texture by its share, and the light by the rest, 1 - share",
       {{"the shares are exchanged", lit * share + texture * rest},
        {"one or both have no share", {lit + texture, lit + texture * share, lit * rest + texture}},
        {"equal shares", {(lit + texture) * share, (lit + texture) * rest, (lit + texture) * 0.5}},
        {"the light or the texture is missing", {texture * share, lit * rest}},
        {"the light has another factor",
         {gray(1 - light) + texture * share, gray(light * (1 - light)) + texture * share,
          gray(rest) + texture * share, texture * share + lit * -rest}}}},
      {"a gray has three equal parts: Color{x, x, x}", texture * share + Rgb{light, 0, 0} * rest},
  };
}

double brightness(const Rgb& c) { return (c.r + c.g + c.b) / 3; }
Rgb right_print(Rgb c, double light, double t) {
  return texmap::mix(gray(min(light, 1.)), c, t * (1 - brightness(c)));
}

Slips<Rgb> wrong_prints(Rgb texture, double light, double t) {
  const auto [r, g, b] = texture;
  const double bright = brightness(texture), share = t * (1 - bright), lit = min(light, 1.);
  const double norm = length(Vec3d{r, g, b}), most = max({r, g, b}), least = min({r, g, b});
  const auto with = [&](double other) { return gray(other) * (1 - share) + texture * share; };
  const auto by = [&, r = r, g = g, b = b](double t_r, double t_g, double t_b) {
    return Rgb{r * t_r + lit * (1 - t_r), g * t_g + lit * (1 - t_g), b * t_b + lit * (1 - t_b)};
  };
  const Slips<double> means = {
      {"the brightness is the mean of all three parts",
       {{"divide the sum by 3, with parentheses", {3 * bright, min(3 * bright, 1.), r + g + b / 3}},
        {"yours is of one or two of them, or weighs them",
         {r, g, b, most, least, (most + least) / 2, 0.2126 * r + 0.7152 * g + 0.0722 * b}},
        {"the length of the color is no mean", {norm, min(norm, 1.), norm / sqrt(3.)}}}},
      {"brightness is the texture's, not the light's", {lit, light}},
  };
  const Slips<double> shares = {
      {"the share falls evenly from t to 0 (in C++ 1 / 3 is 0)", {t, bright < 0.5 ? t : 0}},
      {"the holes are where the texture is black: they belong where it is white", t * bright},
      {"the texture's share is t * (1 - brightness)",
       {{"t is missing", {1 - bright, bright}},
        {"no parentheses", {t - bright, max(t - bright, 0.), 1 - t * bright, t + 1 - bright}}}},
      changed(means, [=](double mean) { return t * (1 - mean); }),
  };
  return {
      changed(shares, [&](double one) { return by(one, one, one); }),
      {"all three parts have one share, of the mean", by(t * (1 - r), t * (1 - g), t * (1 - b))},
      {"the light has the rest, 1 - share, not 1 - t", texture * share + gray(lit) * (1 - t)},
      {"take std::min(light, 1.0)",
       {{"the light is not limited to 1", with(light)},
        {"std::max makes all light 1 or more", with(max(light, 1.))},
        {"light above 1 counts as 1, not as 0 or as its decimals",
         {with(light > 1 ? 0 : light), with(light - floor(light))}}}},
      wrong_shares(texture, lit, share),
      wrong_shares(texture, light, share),
      wrong_shares(texture, lit, t),
  };
}

constexpr Rgb sea{0.2, 0.3, 0.7};
constexpr Place<Rgb, double, double> printed_places[] = {
    {"black and t = 1: the texture alone is left", {{0, 0, 0}, 0.5, 1}},
    {"white and t = 1: a hole, the light alone is left", {{1, 1, 1}, 0.5, 1}},
    {"with t = 0 the light alone is left", {sea, 0.5, 0}},
    {"texture (0.2, 0.3, 0.7) has the brightness 0.4, and with t = 1 the share 0.6", {sea, 0.5, 1}},
    {"with t = 1/2 it has the share 0.3", {sea, 0.8, 0.5}},
    {"in the dark the share of the texture is left", {sea, 0, 0.5}},
    {"texture (0.6, 0.2, 0.1) has the brightness 0.3", {{0.6, 0.2, 0.1}, 0.5, 0.9}},
    {"a light of 1.3 counts as 1", {sea, 1.3, 0}},
    {"also where it is blended", {sea, 1.25, 0.8}},
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

ExercisesOfChapter all_exercises_of_chapter() {
  return {
      "06",
      {exercise(chapter_06::mirrored, lecture_scene(),
                {right_mirror, wrong_mirrors, mirrored_places}),
       exercise(chapter_06::highlight, lecture_scene(),
                {right_highlight, wrong_highlights, highlight_places}),
       // From near by, with a spot in which the light is more than 1. No blend of a byte and a
       // limited light is a whole byte here: rounding would decide.
       exercise(printed, picture<Lesson>({"--blend", "0.9337", "--shininess", "5"}, 20),
                {right_print, wrong_prints, printed_places})},
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
}

}  // namespace texmap::check
