// Chapter 06: Phong's highlight, blending, and the lecture's scene.
#include <doctest.h>

#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"
#include "support/lecture_highlight.hpp"
#include "support/lecture_program.hpp"
#include "support/lesson_laws.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"
#include "support/same_picture.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::test;
using chapter_06::Lesson;

namespace {

Lesson blended(const char* weight, const Image& map) {
  Lesson lesson = prepared<Lesson>({"--blend", weight});
  std::get<chapter_06::Textured>(lesson.objects[chapter_06::middle].paint).texture.image = map;
  return lesson;
}

/// The picture of `--scene lecture` with these options.
Image of_the_lecture(const lecture::Choices& choices) {
  const Lesson lesson = prepared<Lesson>(
      {"--scene", "lecture", "--degrees", std::to_string(choices.degrees), "--blend",
       std::to_string(choices.blend), "--shininess", std::to_string(choices.shininess),
       "--rounding", choices.texel_of_the_slides ? "lecture" : "floor", "--highlight",
       choices.sign_of_the_slides ? "lecture" : "phong"});
  return picture(lesson, choices.width, choices.width / 2);
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
  const View<> view = view_of(exact.stage.camera, 800, 600);
  int terms_before = 0;
  for (const std::string levels : {"1", "0.01"}) {
    const auto cheap = prepared<Lesson>({"--budget", "levels=" + levels, "--quiet"});
    CHECK(cheap.phong.power_terms > terms_before);
    terms_before = cheap.phong.power_terms;
    double worst = 0;
    for (int row = 0; row < 600; row += 2) {
      for (int column = 0; column < 800; ++column) {
        const Ray<double> ray = ray_through<double>(view, column, row);
        worst = std::max(worst, std::abs(exact(ray).g - cheap(ray).g));
      }
    }
    CHECK(255 * worst <= std::stod(levels));
    CHECK(worst > 0);
  }
  CHECK(prepared<Lesson>({"--budget", "texels=0.01", "--quiet"}).phong.power_terms == 0);
  CHECK_THROWS_AS((void)prepared<Lesson>({"--budget", "levels"}), UsageError);
}

TEST_CASE("with weight 1 the texture is alone, without any light") {
  const Lesson lesson = blended("1", Image(1, 1, {200, 100, 50}));
  const Image drawn = picture(lesson);
  const std::vector<int> seen = objects_seen(lesson);
  long other = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
    other += seen[i] == chapter_06::middle && drawn.pixels[i] != Rgb8{200, 100, 50} ? 1 : 0;
  CHECK(other == 0);
  const Image without = picture(blended("0", Image(1, 1, {200, 100, 50})));
  CHECK(without == picture(blended("0", Image(2, 1, {3, 2, 1}))));
}

TEST_CASE(
    "the lecture's scene is the picture of an independent program, for several angles and blends") {
  const Image map = load_image(find_texture("earth.png"));
  const auto check = [&](const lecture::Choices& choices) {
    CAPTURE(choices.degrees);
    CAPTURE(choices.blend);
    const Image drawn = of_the_lecture(choices);
    expect_same_picture(drawn, lecture::draw(map, choices), {.pixels = 320, .levels = 1});
    return drawn;
  };
  for (const bool slides : {true, false}) {
    for (const double degrees : {0.0, 300.5}) {
      for (const double blend : {0.3, 1.0, 0.75})
        check({.degrees = degrees, .blend = blend, .texel_of_the_slides = slides});
    }
  }
  // The slides' highlight, with its wrong sign, is another picture.
  const Image right = check({.shininess = 500});
  CHECK(count_different(check({.shininess = 500, .sign_of_the_slides = true}), right, 1) > 1000);
}

TEST_CASE(
    "at exponent 100 the slides light 903 pixels in the dark, and 780 where a highlight "
    "belongs") {
  const BrightenedPixels count = brightened_pixels();
  CHECK(count.in_the_light == 780);
  CHECK(count.in_the_dark == 903);
}

TEST_CASE(
    "the lecture's scene has its own size, exponent, convention and angle unless the user chose "
    "others") {
  Lesson lesson;
  const Settings settings = make_ready(lesson, {"--scene", "lecture"});
  CHECK(settings.width == 800);
  CHECK(settings.height == 400);
  CHECK(lesson.phong.shininess == 500);
  CHECK(lesson.phong.blends);
  CHECK(lesson.layout.convention == Convention::lecture);
  CHECK(lesson.turn.degrees == 0);
  const Lesson chosen = prepared<Lesson>(
      {"--scene", "lecture", "--convention", "daily", "--shininess", "5", "--degrees", "3"});
  CHECK(chosen.layout.convention == Convention::daily);
  CHECK(chosen.phong.shininess == 5);
  CHECK(chosen.turn.degrees == 3);
}

TEST_CASE("the lecture's scene in one file is the picture of --scene lecture") {
  const TemporaryFolder folder;
  const std::string file = folder / "one.png";
  const Outcome outcome =
      run("\"" TEXMAP_ONE_FILE "\" --texture \"" TEXMAP_ASSETS_DIR "/earth.png\" --out \"" + file +
          "\"");
  REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
  const Image expected = picture(prepared<Lesson>({"--scene", "lecture"}), 800, 400);
  // At u = 1/8 and 7/8 two pixels' centers lie on the edge between two texels: rounding decides.
  expect_same_picture(load_image(file), expected, {.pixels = 2});
}
