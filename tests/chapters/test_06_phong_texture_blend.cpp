// Chapter 06: Phong's highlight, blending, and the lecture's scene.
#include <doctest.h>

#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "support/lesson_laws.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_06::Lesson;

namespace {

/// The lecture's scene without a texture, with a highlight of this exponent and formula.
Image lit_alone(const char* shininess, const char* formula) {
  return picture(prepared<Lesson>({"--scene", "lecture", "--blend", "0", "--shininess", shininess,
                                   "--highlight", formula}),
                 800, 400);
}

}  // namespace

TEST_CASE("only the globe changes from chapter 05") {
  const auto lesson = prepared<Lesson>();
  const auto before =
      prepared<chapter_05::Lesson>({"--degrees", std::to_string(lesson.turn.degrees)});
  CHECK(check_step(before, lesson, chapter_06::ground) > 500);
}

TEST_CASE("a budget in levels buys a cheaper highlight, which is off by no more") {
  const auto exact = prepared<Lesson>();
  CHECK(exact.phong.power_terms == 0);
  const View<> view = view_of(exact.stage.camera, 600, 450);
  int terms_before = 0;
  for (const std::string levels : {"1", "0.01"}) {
    const auto cheap = prepared<Lesson>({"--budget", "levels=" + levels, "--quiet"});
    CHECK(cheap.phong.power_terms > terms_before);
    terms_before = cheap.phong.power_terms;
    double worst = 0;
    for_each_ray(view, [&](const Ray<double>& ray) {
      worst = std::max(worst, std::abs(exact(ray).g - cheap(ray).g));
    });
    CHECK(255 * worst <= std::stod(levels));
    CHECK(worst > 0);
  }
  CHECK(prepared<Lesson>({"--budget", "texels=0.01", "--quiet"}).phong.power_terms == 0);
  CHECK_THROWS_AS((void)prepared<Lesson>({"--budget", "levels"}), UsageError);
}

TEST_CASE(
    "at exponent 100 the slides light 903 pixels in the dark, and 780 where a highlight "
    "belongs") {
  const Image without = lit_alone("1e30", "phong");
  const Image right = lit_alone("100", "phong");
  const Image slides = lit_alone("100", "lecture");
  long in_the_light = 0, in_the_dark = 0;
  for (std::size_t i = 0; i < without.pixels.size(); ++i) {
    const Rgb8 p = without.pixels[i];
    if (p.r != p.b || p.r == 0) continue;  // the ground is yellow, the sky black
    in_the_light += right.pixels[i] != p ? 1 : 0;
    in_the_dark += p.r == 51 && slides.pixels[i] != p ? 1 : 0;  // 51 is the ambient light
  }
  CHECK(in_the_light == 780);
  CHECK(in_the_dark == 903);
}

TEST_CASE(
    "the lecture's scene has its own size, exponent, convention and angle unless the user chose "
    "others") {
  Ready<Lesson> ready("test", {"--scene", "lecture"});
  ready.build();
  const Lesson& lesson = ready.lesson;
  CHECK(ready.chosen.settings.width == 800);
  CHECK(ready.chosen.settings.height == 400);
  CHECK(lesson.phong.shininess == 500);
  CHECK(lesson.objects.front().material.blends);
  CHECK(lesson.layout.convention == Convention::lecture);
  CHECK(lesson.turn.degrees == 0);
  const Lesson chosen = prepared<Lesson>(
      {"--scene", "lecture", "--convention", "daily", "--shininess", "5", "--degrees", "3"});
  CHECK(chosen.layout.convention == Convention::daily);
  CHECK(chosen.phong.shininess == 5);
  CHECK(chosen.turn.degrees == 3);
}

TEST_CASE("the lecture's scene in one file is the picture of --scene lecture") {
  const Image one = drawn_by(TEXMAP_ONE_FILE, "--texture \"" TEXMAP_ASSETS_DIR "/earth.png\"");
  const Image expected = picture(prepared<Lesson>({"--scene", "lecture"}), 800, 400);
  // At u = 1/8 and 7/8 two pixels' centers lie on the edge between two texels: rounding decides.
  expect_same_picture(one, expected, {.pixels = 2});
}
