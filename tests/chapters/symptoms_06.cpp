// Chapter 06's symptoms: Phong's highlight and blending, with the word for a mistake.
#include "06_phong_texture_blend/lesson.hpp"
#include "engine/app/planned_highlight.hpp"
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

}  // namespace

TEST_SUITE_BEGIN("symptoms of chapter 06");

TEST_CASE("the reflected light leaves on the other side, at the same height") {
  const Vec3d mirrored = mirror(from_left, up);
  expect_number("x of the reflected light", mirrored.x, 0.6,
                {{-0.6, "the reflected direction has the wrong sign (highlight sign)"}});
  expect_number("y of the reflected light", mirrored.y, 0.8,
                {{-0.8, "the reflected direction has the wrong sign (highlight sign)"}});
}

TEST_CASE("the highlight is brightest toward the eye in the mirror's direction") {
  expect_number("the highlight seen along the reflected light", highlight_towards(to_right), 0.5,
                {{0, "it shines away from the eye: r . e has the wrong sign (highlight sign)"},
                 {1, "the strength of the highlight is missing"}});
  expect_number("the highlight seen from the opposite side", highlight_towards(-to_right), 0,
                {{0.5, "it shines away from the eye: r . e has the wrong sign (highlight sign)"}});
}

TEST_CASE("the exponent narrows the highlight, and shadow has none") {
  const double cosine = std::cos(pi<double>() / 3);  // the eye 60 degrees from the reflected light
  const Vec3d aside = to_right * cosine + Vec3d{0, 0, 1} * std::sin(pi<double>() / 3);
  expect_number("the highlight at 60 degrees with exponent 2", highlight_towards(aside), 0.125,
                {{0.25, "the exponent is missing"}});
  expect_number("the highlight in shadow", highlight_towards(to_right, 0), 0,
                {{0.5, "a highlight shines in the shadow"}});
}

TEST_CASE("the blend weighs the texture, and the rest is light") {
  chapter_06::Lesson lesson;
  lesson.phong.blends = true;
  lesson.objects[chapter_06::middle].paint = Solid{{0.9, 0.2, 0.2}};
  const Ray<double> ray{{0, 0, 8}, {0, 0, -1}};
  for (const double weight : {0.3, 1.0, 0.0}) {
    lesson.phong.blend = weight;
    const Rgb seen = lesson(ray);
    // Light is gray: red less green comes from the texture alone.
    expect_number("red less green of a texture of 0.7 with the blend " + digits_of(weight),
                  seen.r - seen.g, weight * 0.7,
                  {{(1 - weight) * 0.7, "the weights of texture and light are exchanged (blend)"},
                   {0.7, "the texture is not blended"}});
  }
}

TEST_SUITE_END();
