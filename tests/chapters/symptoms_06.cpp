// Chapter 06's symptoms: Phong's highlight and blending, with the word for a mistake.
#include <cmath>

#include "06_phong_texture_blend/lesson.hpp"
#include "engine/run/planned_highlight.hpp"
#include "support/symptoms.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

const Vec3d up{0, 1, 0};
const Vec3d from_left{-0.6, 0.8, 0};
const Vec3d to_right{0.6, 0.8, 0};
constexpr PhongMaterial shiny{.lambertian = {}, .specular = 0.5, .shininess = 2};

/// The highlight on a floor, with the light from the left at a cosine of 0.8.
double highlight_towards(const Vec3d& eye, double cosine = 0.8) {
  return highlight(shiny, LightSample<double>{from_left, cosine}, up, eye);
}

/// A point of the globe, with its light computed without the course's functions of light.
struct GlobePoint {
  Vec3d normal;  ///< of length 1; the globe has radius 1 about (0, 0, 0)
  Vec3d to_lamp = normalize(Vec3d{5, 5, 5} - normal);
  double cosine = dot(to_lamp, normal);
  Vec3d reflected = normal * (2 * cosine) - to_lamp;
};

const GlobePoint top{{0, 1, 0}};
const Rgb globe_color{0.9, 0.6, 0.3};
constexpr double strength = 0.3;  // of the highlight

/// The lesson, ready but for its texture: the globe has one color.
chapter_06::Lesson plain_globe() {
  chapter_06::Lesson lesson;
  lesson.objects[chapter_06::middle].paint = Solid{globe_color};
  lesson.objects[chapter_06::middle].material.specular = strength;
  lesson.objects[chapter_06::middle].material.shininess = lesson.phong.shininess;
  return lesson;
}

/// What an eye sees of a point, in a direction of length 1 from there.
Rgb seen_from(const chapter_06::Lesson& lesson, const GlobePoint& point, const Vec3d& to_eye) {
  return lesson(Ray<double>{point.normal + to_eye * 3.0, -to_eye});
}

/// A direction so many degrees from the reflected light of `top`, still above the surface.
Vec3d beside_the_highlight(double degrees) {
  const double angle = degrees * pi<double>() / 180;
  const Vec3d across = normalize(cross(top.reflected, top.normal));
  return top.reflected * std::cos(angle) + across * std::sin(angle);
}

}  // namespace

TEST_CASE("the reflected light leaves on the other side, at the same height") {
  const Vec3d mirrored = mirror(from_left, up);
  expect_number("x of the reflected light", mirrored.x, 0.6,
                {{-0.6, "the reflected direction has the wrong sign (highlight sign)"}});
}

TEST_CASE("the highlight is brightest toward the eye in the mirror's direction") {
  expect_number("the highlight seen along the reflected light", highlight_towards(to_right), 0.5,
                {{0, "it shines away from the eye: r . e has the wrong sign (highlight sign)"},
                 {1, "the strength of the highlight is missing"}});
}

TEST_CASE("the exponent narrows the highlight, and shadow has none") {
  const double cosine = std::cos(pi<double>() / 3);  // the eye 60 degrees from the reflected light
  const Vec3d aside = to_right * cosine + Vec3d{0, 0, 1} * std::sin(pi<double>() / 3);
  expect_number("the highlight at 60 degrees with exponent 2", highlight_towards(aside), 0.125,
                {{0.25, "the exponent is missing"}});
  expect_number("the highlight in shadow", highlight_towards(to_right, 0), 0,
                {{0.5, "a highlight shines in the shadow"}});
}

TEST_CASE("the lesson's light is ambient + diffuse, and its globe is not blended unless asked") {
  const Vec3d no_highlight{0, 0.6, 0.8};  // more than 90 degrees from the reflected light
  const double own_red = globe_color.r, bright = 0.2 + 0.8 * top.cosine;
  expect_number("red of a lit point of the globe", seen_from(plain_globe(), top, no_highlight).r,
                own_red * bright,
                {{own_red * (bright - 0.2), "the ambient light is missing where the lamp shines"},
                 {0.7 * bright + 0.3 * own_red,
                  "texture and light are always blended: only if the material blends"},
                 {own_red, "the light is missing"}},
                "not color times (ambient + diffuse)");
  const GlobePoint dark{{-0.6, 0, -0.8}};  // the lamp is below its horizon
  expect_number("red of a point on the dark side", seen_from(plain_globe(), dark, dark.normal).r,
                own_red * 0.2,
                {{0, "the ambient light is missing"},
                 {own_red * (0.2 + 0.8 * dark.cosine), "a cosine below 0 takes light away"}},
                "it has color times ambient, and nothing else");
}

TEST_CASE("the lesson's highlight is white, toward the eye, and added to the color") {
  const double bright = 0.2 + 0.8 * top.cosine;
  const Rgb seen = seen_from(plain_globe(), top, top.reflected);
  const double own_blue = globe_color.b;
  expect_number(
      "blue in the middle of the highlight", seen.b, own_blue * bright + strength,
      {{own_blue * bright, "no highlight, or the direction to the eye has the wrong sign"},
       {own_blue * (bright + strength),
        "the highlight has the texture's color: add it after "
        "the multiplication"},
       {own_blue * bright + 1, "the strength of the highlight is missing"},
       {own_blue * (bright - 0.2) + strength, "the ambient light is missing"}},
      "not color times light, and the highlight added");
}

TEST_CASE("the lesson's highlight has the exponent 50, about the reflected light") {
  const Vec3d eye = beside_the_highlight(12);
  const Vec3d half = normalize(top.to_lamp + eye);
  const double base = globe_color.b * (0.2 + 0.8 * top.cosine);
  const double cosine = std::cos(12 * pi<double>() / 180);
  const auto with = [&](double exponent) { return strength * std::pow(cosine, exponent); };
  expect_number("the highlight at 12 degrees", seen_from(plain_globe(), top, eye).b - base,
                with(50),
                {{with(1), "its exponent is missing"},
                 {with(10), "it is too wide: its exponent is 10, and not 50"},
                 {strength * std::pow(dot(half, top.normal), 50),
                  "it is too wide: this is Blinn's half vector, and not the reflected light"},
                 {0, "no highlight, or the direction to the eye has the wrong sign"}},
                "another exponent, or another formula");
}

TEST_CASE("half a blend is the mean of the texture and of its light, which ends at 1") {
  chapter_06::Lesson lesson = plain_globe();
  lesson.objects[chapter_06::middle].material.blends = true;
  lesson.phong.blend = 0.5;
  const double own_red = globe_color.r, bright = 0.2 + 0.8 * top.cosine;
  expect_number(
      "red of a lit point at half a blend", seen_from(lesson, top, {0, 0.6, 0.8}).r,
      (bright + own_red) / 2,
      {{own_red * bright, "the texture is not blended"},
       {(own_red * bright + own_red) / 2, "the light to be blended is gray, without the color"},
       {(bright - 0.2 + own_red) / 2, "the ambient light is missing"}});
  // Near the lamp's foot the light is almost 1; with the highlight it is more.
  const double third = 1 / std::sqrt(3.0);
  const GlobePoint foot{{third, third, third}};
  expect_number("red in the highlight under the lamp, at half a blend",
                seen_from(lesson, foot, foot.normal).r, (1 + own_red) / 2,
                {{(1 + strength + own_red) / 2, "light above 1 was not limited to 1"},
                 {own_red + strength, "the texture is not blended"}});
}

TEST_CASE("the blend weighs the texture, and the rest is light") {
  chapter_06::Lesson lesson;
  lesson.objects[chapter_06::middle].paint = Solid{{0.9, 0.2, 0.2}};
  lesson.objects[chapter_06::middle].material.blends = true;
  lesson.phong.blend = 0.3;
  const Rgb seen = lesson(Ray<double>{{0, 0, 8}, {0, 0, -1}});
  // Light is gray: red less green comes from the texture alone.
  expect_number("red less green of a texture of 0.7 with the blend 0.3", seen.r - seen.g, 0.3 * 0.7,
                {{0.7 * 0.7, "the weights of texture and light are exchanged (blend)"},
                 {0.7, "the texture is not blended"}});
}
