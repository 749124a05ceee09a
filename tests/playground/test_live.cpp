// Live lessons without a browser: what no program draws. test_live.py compares the rest.
#include "live.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "published/uv.hpp"
#include "support/pictures.hpp"
#include "support/same_picture.hpp"

using namespace texmap;
using live::Live;
using live::LiveLesson;
using Words = std::vector<std::string>;

namespace {

constexpr int widest = 120;

Image whole(const LiveLesson& lesson) { return lesson.rows(0, lesson.size().height); }

nlohmann::json seen(const LiveLesson& lesson, int column, int row) {
  return nlohmann::json::parse(lesson.look(column, row));
}

}  // namespace

TEST_CASE("wrong words are refused, and the picture before stays") {
  Live<chapter_02::Lesson> lesson;
  lesson.set({"--squares", "4"}, widest);
  const Image before = whole(lesson);
  CHECK_THROWS_AS(lesson.set({"--squares", "0"}, widest), UsageError);
  CHECK_THROWS_AS(lesson.set({"--help"}, widest), UsageError);
  test::expect_same_picture(whole(lesson), before);
}

TEST_CASE("--squares changes every checkerboard") {
  const chapter_02::Lesson ten;
  chapter_02::Lesson four;
  for (auto& object : four.objects) {
    if (auto* checkered = std::get_if<chapter_02::Checkered>(&object.paint))
      checkered->texture.squares = 4;
  }
  Live<chapter_02::Lesson> lesson;
  lesson.set({"--squares", "4"}, widest);
  const Image drawn = whole(lesson);
  test::expect_same_picture(drawn, test::picture(four, 120, 90));
  CHECK(test::count_different(drawn, test::picture(ten, 120, 90)) > 1000);
}

TEST_CASE("--eye leaves the ray through the target where it was") {
  Live<chapter_06::Lesson> lesson;
  lesson.set({}, 801);  // an odd width has a middle column; 801 is not wider than the picture
  for (const char* factor : {"1", "10", "1e5"}) {
    lesson.set({"--width", "801", "--height", "601", "--eye", factor}, 801);
    const auto middle = seen(lesson, 400, 300);
    // The eye is at (0, 2, 8) times the factor and looks at the center of the unit sphere.
    CHECK(middle["normal"][0].get<double>() == doctest::Approx(0).epsilon(1e-9));
    CHECK(middle["normal"][1].get<double>() == doctest::Approx(2 / std::sqrt(68)).epsilon(1e-9));
    CHECK(middle["normal"][2].get<double>() == doctest::Approx(8 / std::sqrt(68)).epsilon(1e-9));
  }
}

TEST_CASE("look tells what the published formulas give") {
  Live<chapter_04::Lesson> lesson;
  struct Case {
    const char* word;
    Uv<double> (*formula)(const Vec3d&);
    bool down;
  };
  for (const Case& one : {Case{"daily", published::uv_daily<double>, true},
                          Case{"rtiow", published::uv_next_week_v4<double>, false},
                          Case{"lecture", published::uv_lecture<double>, false}}) {
    lesson.set({"--convention", one.word}, 800);
    const Size size = lesson.size();
    const auto pixel = seen(lesson, size.width / 2 + 20, size.height / 2 - 15);
    REQUIRE(pixel["object"] == chapter_04::middle);
    const auto& n = pixel["normal"];
    const Uv<double> uv = one.formula({n[0], n[1], n[2]});
    CHECK(pixel["uv"][0].get<double>() == doctest::Approx(uv.u).epsilon(1e-12));
    CHECK(pixel["uv"][1].get<double>() == doctest::Approx(uv.v).epsilon(1e-12));
    CHECK(pixel["texel"]["column"] == static_cast<int>(uv.u * 2048));
    const int from_zero = static_cast<int>(uv.v * 1024);
    CHECK(pixel["texel"]["row"] == (one.down ? from_zero : 1023 - from_zero));
  }
}

TEST_CASE("in float, look tells what float meets and how far its place is off") {
  Live<chapter_03::Lesson> lesson;
  lesson.set({}, 400);
  CHECK(!seen(lesson, 210, 140).contains("float"));
  lesson.set({"--number", "float"}, 400);
  const auto pixel = seen(lesson, 210, 140);
  REQUIRE(pixel.contains("float"));
  CHECK(pixel["float"]["object"] == pixel["object"]);
  const double across = (double(pixel["float"]["uv"][0]) - double(pixel["uv"][0])) * 2048;
  const double up = (double(pixel["float"]["uv"][1]) - double(pixel["uv"][1])) * 1024;
  CHECK(pixel["float"]["apart"].get<double>() == doctest::Approx(std::hypot(across, up)));
  CHECK(std::hypot(across, up) > 0);
  CHECK(std::hypot(across, up) < 0.05);
}

TEST_CASE("the seam is no distance, and errors have the colors of the legend") {
  using live::texels_apart;
  CHECK(texels_apart({0.999, 0.5}, {0.001, 0.5}, {1000, 500}) == doctest::Approx(2));
  CHECK(texels_apart({0.25, 0.5}, {0.253, 0.508}, {1000, 500}) == doctest::Approx(5));
  CHECK(live::color_of_error(1e-5).b > live::color_of_error(1e-5).r);
  CHECK(live::color_of_error(1).g > 0.9);
}

TEST_CASE("far away, float's texels are off by the textbook's sphere more than by its own rays") {
  // The middle of the globe, which shows a color between blue and yellow: red and green tell which.
  const auto yellow_pixels = [](const char* form) {
    Live<chapter_06::Lesson> lesson;
    lesson.set({"--errors", "--eye", "1000", "--spheres", form}, widest);
    const Image errors = whole(lesson);
    long count = 0;
    for (int row = 35; row < 55; ++row) {
      for (int column = 50; column < 70; ++column) count += errors.at(column, row).g > 150 ? 1 : 0;
    }
    return count;
  };
  CHECK(yellow_pixels("plain") > 200);
  CHECK(yellow_pixels("hybrid") < 60);  // 8000 radii away, a float's ray is 5e-4 radii off
}
