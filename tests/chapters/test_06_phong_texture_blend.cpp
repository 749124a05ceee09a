// Chapter 06: Phong's highlight, blending, and the lecture's scene.
#include <doctest.h>

#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"
#include "support/lecture_highlight.hpp"
#include "support/lecture_program.hpp"
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

/// The light over each pixel of the middle sphere: 0 where it does not shine.
std::vector<double> cosines(const Lesson& lesson) {
  const View<> view = view_of(lesson.stage.camera, 800, 600);
  std::vector<double> lit;
  for (int row = 0; row < 600; ++row) {
    for (int column = 0; column < 800; ++column) {
      const Ray<double> ray = ray_through<double>(view, column, row);
      const Nearest<double> nearest = find_nearest(lesson.objects, ray);
      if (nearest.index < 0) {
        lit.push_back(0);
        continue;
      }
      const auto& object = lesson.objects[static_cast<std::size_t>(nearest.index)];
      lit.push_back(sample_light(lesson.stage.light, lesson.objects,
                                 hit_at(object.shape, ray, nearest.distance))
                        .cosine);
    }
  }
  return lit;
}

}  // namespace

TEST_CASE("only lit pixels of the globe change from chapter 05") {
  const Lesson lesson = prepared<Lesson>();
  const chapter_05::Lesson before =
      prepared<chapter_05::Lesson>({"--degrees", std::to_string(lesson.turn.degrees)});
  const Image first = picture(before);
  const Image second = picture(lesson);
  CHECK(changed_elsewhere(first, second, objects_seen(before), Lesson::about.changed_objects) == 0);
  const std::vector<double> lit = cosines(lesson);
  long in_the_dark = 0;
  long in_the_light = 0;
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (first.pixels[i] == second.pixels[i]) continue;
    (lit[i] > 0 ? in_the_light : in_the_dark) += 1;
  }
  CHECK(in_the_dark == 0);
  CHECK(in_the_light > 500);
  // The check can fail: the slides' highlight shines in the dark.
  const Lesson wrong = prepared<Lesson>({"--highlight", "lecture"});
  const Image false_lights = picture(wrong);
  long found = 0;
  for (std::size_t i = 0; i < lit.size(); ++i)
    found += lit[i] <= 0 && first.pixels[i] != false_lights.pixels[i] ? 1 : 0;
  CHECK(found > 0);
}

TEST_CASE(
    "a budget in levels buys a cheaper highlight, which is off by no more, and only where there is "
    "one") {
  const Lesson exact = prepared<Lesson>();
  CHECK(exact.phong.power_terms == 0);
  const Image should = picture(exact);
  const std::vector<double> lit = cosines(exact);
  int terms_before = 0;
  for (const std::string levels : {"1", "0.1", "0.01"}) {
    const Lesson cheap = prepared<Lesson>({"--budget", "levels=" + levels, "--quiet"});
    CHECK(cheap.phong.power_terms > terms_before);
    terms_before = cheap.phong.power_terms;
    const View<> view = view_of(cheap.stage.camera, 800, 600);
    double worst = 0;
    for (int row = 0; row < 600; row += 2) {
      for (int column = 0; column < 800; ++column) {
        const Ray<double> ray = ray_through<double>(view, column, row);
        const Rgb a = exact(ray);
        const Rgb b = cheap(ray);
        worst = std::max({worst, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
      }
    }
    CHECK(255 * worst <= std::stod(levels));
    CHECK(worst > 0);
    const Image is = picture(cheap);
    long in_the_dark = 0;
    for (std::size_t i = 0; i < lit.size(); ++i)
      in_the_dark += lit[i] <= 0 && is.pixels[i] != should.pixels[i] ? 1 : 0;
    CHECK(in_the_dark == 0);
  }
  CHECK(prepared<Lesson>({"--budget", "texels=0.01", "--quiet"}).phong.power_terms == 0);
  CHECK_THROWS_AS((void)prepared<Lesson>({"--budget", "levels"}), UsageError);
}

TEST_CASE("with weight 1 the texture is alone, without any light") {
  const Lesson lesson = blended("1", Image(1, 1, {200, 100, 50}));
  const Image drawn = picture(lesson);
  const std::vector<int> seen = objects_seen(lesson);
  long globe = 0;
  long other = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] != chapter_06::middle) continue;
    globe += 1;
    other += drawn.pixels[i] == Rgb8{200, 100, 50} ? 0 : 1;
  }
  CHECK(globe == 12644);
  CHECK(other == 0);
}

TEST_CASE("with weight 0 the light is alone, whatever the texture") {
  const Image one = picture(blended("0", Image(1, 1, {200, 100, 50})));
  const Image two = picture(blended("0", Image(2, 1, {3, 2, 1})));
  CHECK(one == two);
  CHECK(picture(blended("0.5", Image(1, 1, {200, 100, 50}))) != one);
}

TEST_CASE(
    "a white texture in full light stays white, and a gray light blended with itself stays "
    "itself") {
  // Ambient 1 and diffuse 0: the light is 1 everywhere, and so is any mixture with white.
  Lesson lesson = blended("0.3", Image(1, 1, {255, 255, 255}));
  lesson.objects[chapter_06::middle].material = {.lambertian = {.ambient = 1, .diffuse = 0}};
  const Image drawn = picture(lesson);
  CHECK(drawn.at(400, 300) == Rgb8{255, 255, 255});
}

TEST_CASE(
    "the lecture's scene is the picture of an independent program, for several angles and blends") {
  const Image map = load_image(find_texture("earth.png"));
  for (const bool slides : {true, false}) {
    for (const double degrees : {0.0, 37.0, 180.0, 300.5}) {
      for (const double blend : {0.3, 0.0, 1.0, 0.75}) {
        lecture::Choices choices{.degrees = degrees, .blend = blend};
        choices.texel_of_the_slides = slides;
        CAPTURE(slides);
        CAPTURE(degrees);
        CAPTURE(blend);
        const Image expected = lecture::draw(map, choices);
        const Image drawn = of_the_lecture(choices);
        expect_same_picture(drawn, expected, {.pixels = 320, .levels = 1});
      }
    }
  }
}

TEST_CASE(
    "the slides' highlight, with its wrong sign, is drawn when asked for and is another picture") {
  const Image map = load_image(find_texture("earth.png"));
  lecture::Choices choices;
  choices.shininess = 500;
  choices.sign_of_the_slides = true;
  const Image expected = lecture::draw(map, choices);
  expect_same_picture(of_the_lecture(choices), expected, {.pixels = 320, .levels = 1});
  choices.sign_of_the_slides = false;
  CHECK(count_different(of_the_lecture(choices), expected, 1) > 1000);
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
  expect_same_picture(load_image(file), expected, {.levels = 1});
}
