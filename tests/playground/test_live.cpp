// Live lessons without a browser: what no program draws. test_live.py compares the rest.
#include <doctest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "chapter_07.hpp"
#include "chapter_08.hpp"
#include "chapter_09.hpp"
#include "chapter_10.hpp"
#include "chapter_11.hpp"
#include "chapter_12.hpp"
#include "engine/compare/difference.hpp"
#include "engine/fast/srgb_kernel.hpp"
#include "engine/run/draw_lesson.hpp"
#include "knobs.hpp"
#include "sampling/hash.hpp"
#include "support/pictures.hpp"
#include "support/same_picture.hpp"
#include "texture/uv_inverse.hpp"
#include "tools/diagnose/option_slips.hpp"

using namespace texmap;
using live::Live;
using live::LiveLesson;
using Words = std::vector<std::string>;

namespace {

constexpr int widest = 120;

Image whole(LiveLesson& lesson) {
  return lesson.rows(0, lesson.size().height, lesson.passes() - 1);
}

nlohmann::json seen(const LiveLesson& lesson, int column, int row) {
  return nlohmann::json::parse(lesson.look(column, row));
}

/// The numbers of a row that a module tells of a pixel.
std::vector<double> numbers_of(const nlohmann::json& seen, const char* name) {
  std::vector<double> numbers;
  for (const auto& row : seen["rows"]) {
    if (row[0] != name) continue;
    for (const auto& part : row)
      if (part.is_number()) numbers.push_back(part);
  }
  return numbers;
}

template <class Lesson>
View<> view_of_lesson(const Lesson& lesson, const Size& size) {
  return view_of(lesson.stage.camera, size.width, size.height);
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

TEST_CASE("a picture that is wider than the page keeps its shape, and at least one row") {
  Live<chapter_02::Lesson> lesson;
  lesson.set({"--width", "1200", "--height", "500"}, widest);
  CHECK(lesson.size().height == 50);
  lesson.set({"--width", "1200", "--height", "2"}, widest);
  CHECK(lesson.size().height == 1);
}

TEST_CASE("a page says what was done to a reader's file, as long as it is in the picture") {
  const std::string turned = TEXMAP_TESTS_DIR "/corpus/jpg_exif_orient6.jpg";
  Live<chapter_03::Lesson> lesson;
  lesson.set({"--texture", turned}, widest);
  CHECK(lesson.notes() == turned + " is turned as its EXIF says\n");
  lesson.set({}, widest);
  CHECK(lesson.notes().empty());
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

namespace {

/// Compares the map of ten pixels with what rays through them and their corners meet.
template <class Lesson>
void expect_maps(const Words& words) {
  Live<Lesson> shown;
  shown.set(words, 800);
  const auto lesson = prepared<Lesson>(words);
  const View<> view = view_of(lesson.stage.camera, 800, 600);
  for (int i = 0; i < 10; ++i) {
    const int column = 372 + 5 * i, row = 268 + 6 * i;
    INFO("column ", column, ", row ", row);
    const nlohmann::json pixel = seen(shown, column, row);
    const nlohmann::json& map = pixel["map"];
    const double x = map["at"][0], y = map["at"][1];
    const auto expect_at = [&](const nlohmann::json& place, double right, double down) {
      const auto met = surface_along(lesson, ray_through(view, column + right, row + down));
      const double turns = place[0].get<double>() - met.uv.u;  // whole ones, across the seam
      CHECK(turns == doctest::Approx(std::round(turns)));
      CHECK(std::abs(place[0].get<double>() - x) < 0.5);
      CHECK(place[1] == (words[1] == "daily" ? met.uv.v : 1 - met.uv.v));
    };
    expect_at(map["at"], 0, 0);
    expect_at(map["corners"][0], -0.5, -0.5);
    expect_at(map["corners"][1], 0.5, -0.5);
    expect_at(map["corners"][2], 0.5, 0.5);
    expect_at(map["corners"][3], -0.5, 0.5);
    const auto met = surface_along(lesson, ray_through(view, 1.0 * column, 1.0 * row));
    CHECK(pixel["uv"] == nlohmann::json{met.uv.u, met.uv.v});
    if (pixel.contains("texel")) {
      CHECK(pixel["texel"]["column"] == static_cast<int>((x - std::floor(x)) * 2048));
      CHECK(pixel["texel"]["row"] == static_cast<int>(y * 1024));
    }
    // There the flat texture has the pixel's paint.
    const Rgb8 flat = shown.flat(map["object"], {x - 1e-9, y - 1e-9, 2e-9, 2e-9, 1, 1}).at(0, 0);
    const std::vector<double> paint = pixel["paint"];
    CHECK(std::abs(paint[0] - flat.r) + std::abs(paint[2] - flat.b) < 1.5);
  }
}

}  // namespace

TEST_CASE("the map has the pixel's point and corners, and the flat texture its paint") {
  expect_maps<chapter_02::Lesson>({"--number", "double"});
  expect_maps<chapter_04::Lesson>({"--convention", "daily", "--width", "800", "--height", "600"});
  expect_maps<chapter_05::Lesson>({"--degrees", "-135"});
  expect_maps<chapter_06::Lesson>({"--convention", "lecture", "--blend", "0.5"});
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

TEST_CASE("a mirrored Earth shows the texel at 1 - u; a mistake without a name is refused") {
  Live<chapter_03::Lesson> lesson;
  const auto pixel_with = [&](const Words& words) {
    lesson.set(words, 400);
    return whole(lesson).at(210, 140);
  };
  const Rgb8 right = pixel_with({});
  const auto pixel = seen(lesson, 210, 140);
  const double u = pixel["uv"][0], v = pixel["uv"][1];
  const auto texel_at = [&](double x) {  // as the flat texture has it, from the top
    return lesson.flat(pixel["object"], {x - 1e-9, 1 - v - 1e-9, 2e-9, 2e-9, 1, 1}).at(0, 0);
  };
  const Rgb8 here = texel_at(u), there = texel_at(1 - u);
  REQUIRE(channel_difference(here, there) > 20);
  const Rgb8 wrong = pixel_with({"--mistake", "mirrored"});
  CHECK(std::abs(right.b * there.b - wrong.b * here.b) <= here.b + there.b);  // the same light
  CHECK_THROWS_AS(lesson.set({"--mistake", "nothing of the kind"}, 400), UsageError);
  CHECK(pixel_with({"--mistake", "mirrored"}) == wrong);  // it stayed as it was
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

TEST_CASE("07: passes end with the program's picture, and its samples have the film's mean") {
  const Words words = {"--samples", "5", "--seed", "3", "--width", "60", "--height", "40"};
  Ready<chapter_07::Lesson> ready("test", words);
  ready.build();
  const chapter_07::Lesson& lesson = ready.lesson;
  const View<> view = view_of_lesson(lesson, {60, 40});
  const Sampler sampler(lesson.sampling.sampler, 5, 3);
  const Film film =
      gather<double>(lesson, lesson.objects, view, sampler, {}, RenderSettings{.threads = 1});
  live::Chapter07 page;
  page.set(words, 800);
  CHECK(page.passes() == 4);  // 1, 2, 4, 5 samples
  for (int pass = 0; pass < 3; ++pass) static_cast<void>(page.rows(7, 20, pass));
  test::expect_same_picture(whole(page), develop(film, lesson.sampling.transfer));
  for (int i = 0; i < 10; ++i) {
    const auto pixel = seen(page, 5 * i + 3, 3 * i + 5);
    const Rgb light = film.light(5 * i + 3, 3 * i + 5);
    const auto mean = numbers_of(pixel, "mean light");
    CHECK(mean[0] == doctest::Approx(light.r).epsilon(1e-12));
    CHECK(mean[2] == doctest::Approx(light.b).epsilon(1e-12));
    CHECK(pixel["figure"]["shapes"].size() == 5);
  }
  CHECK(ready.chosen.settings.samples == 5);
}

TEST_CASE("08: weights and (u, v) are those of the mesh, and areas give the weights") {
  const auto lesson = prepared<chapter_08::Lesson>();
  live::Chapter08 page;
  page.set({}, 800);
  const View<> view = view_of_lesson(lesson, page.size());
  for (int i = 0; i < 10; ++i) {
    const int column = 30 * i + 70, row = 15 * i + 180;
    const auto hit = first_hit(lesson.scene.mesh, ray_through(view, 1.0 * column, 1.0 * row));
    REQUIRE(hit.met);
    const auto pixel = seen(page, column, row);
    const Uv<double> uv = lesson.paint.mapping(hit);
    CHECK(numbers_of(pixel, "u").back() == doctest::Approx(uv.u).epsilon(1e-12));
    CHECK(numbers_of(pixel, "v").back() == doctest::Approx(uv.v).epsilon(1e-12));
    double sum = 0;
    for (const char* corner : {"a", "b", "c"}) {
      const auto numbers = numbers_of(pixel, corner);  // area, sum, weight, u, v
      CHECK(numbers[0] / numbers[1] == doctest::Approx(numbers[2]));
      sum += numbers[2];
    }
    CHECK(sum == doctest::Approx(1));
  }
}

TEST_CASE("09: texels times the weights of their reads are what the filter returns") {
  FilteredTexture texture;
  Image noise(64, 32);
  for (std::size_t i = 0; i < noise.pixels.size(); ++i) {
    const std::uint32_t bits = hash_bits(static_cast<std::uint32_t>(i));
    noise.pixels[i].r = static_cast<std::uint8_t>(bits);
  }
  static_cast<Pyramid&>(texture.pyramid) = pyramid_of(light_of(noise, TexelLight::linear));
  for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear,
                              Filter::anisotropic, Filter::ewa, Filter::stochastic}) {
    texture.filter = filter;
    for (int i = 0; i < 10; ++i) {
      const Uv<Dual<double>> uv{{0.31 + 0.09 * i, 0.02 * i, 0.07}, {0.2 + 0.05 * i, 0.04, -0.03}};
      double sum = 0;
      for (const live::TexelRead& read : live::reads_of(texture, filter, uv)) {
        const auto level = level_of(texture.pyramid, std::log2(read.wide));
        sum += read.weight *
               texel_light(texture.pyramid, level, read.x / read.wide, read.y / read.high).r;
      }
      CHECK(sum == doctest::Approx(texture.filtered(uv).r).epsilon(1e-9));
    }
  }
}

namespace {

/// Draws the mistakes of a page: each differs from the right picture and from all others, and its
/// line is on the page. Returns what the page alone draws, by the mistake's name.
template <class Page>
std::map<std::string, Image> expect_mistakes(const std::string& chapter, std::size_t at_least) {
  std::ifstream file(std::string(TEXMAP_TESTS_DIR) + "/../chapters/" + chapter + "/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Page page;
  Words words = {"--width", "240", "--height", "180"};
  page.set(words, 240);
  std::vector<Image> drawn{whole(page)};
  std::map<std::string, Image> named;
  for (const slips::OptionSlip* slip : slips::of_chapter(chapter, slips::of_pages)) {
    CAPTURE(std::string(slip->words));
    Words typed = words;
    for (const std::string& word : slip->typed()) typed.push_back(word);
    page.set(typed, 240);
    drawn.push_back(whole(page));
    if (slip->typed().front() == "--mistake") named[slip->value] = drawn.back();
    for (std::size_t i = 0; i + 1 < drawn.size(); ++i)
      CHECK(test::count_different(drawn[i], drawn.back()) > 100);
    CHECK(text.find(slip->right) != std::string::npos);
    CHECK(std::string(slip->right).empty() == std::string(slip->wrong).empty());
    CHECK((*slip->right != 0 || *slip->change != 0));
  }
  CHECK(drawn.size() > at_least);
  page.set(words, 240);
  test::expect_same_picture(whole(page), drawn.front());  // and the right one is there again
  return named;
}

}  // namespace

TEST_CASE("09: a mistake draws a picture of its own: what a program with its line draws") {
  const auto drawn_by_page = expect_mistakes<live::Chapter09>("09_texture_filtering", 6);
  const auto lesson = prepared<chapter_09::Lesson>({"--filter", "anisotropic"});
  const View<> view = view_of_lesson(lesson, {240, 180});
  struct Student {
    const char* mistake;
    double across, down;  ///< the slopes of the pixel's column and row
  };
  for (const Student& student :
       {Student{"twice", 2, 2}, Student{"half", 0.5, 0.5}, Student{"right-alone", 1, 0}}) {
    CAPTURE(std::string(student.mistake));
    const Image drawn = image_of(240, 180, [&](int column, int row) {
      const Color<Dual<double>> light =
          lesson(ray_through(view, Dual<double>{double(column), student.across, 0.0},
                             Dual<double>{double(row), 0.0, student.down}));
      const auto byte = [](const Dual<double>& channel) {
        return static_cast<std::uint8_t>(srgb_byte_exact(channel.value));
      };
      return Rgb8{byte(light.r), byte(light.g), byte(light.b)};
    });
    test::expect_same_picture(drawn_by_page.at(student.mistake), drawn);
  }
  live::Chapter09 page;
  page.set({"--width", "240", "--height", "180", "--filter", "bilinear"}, 240);
  test::expect_same_picture(drawn_by_page.at("no-texels"), whole(page));  // less than a texel
  // Half black and half white: the mean of light is the byte 188, that of bytes 127 or 128.
  int row = 0;
  while (drawn_by_page.at("bytes").at(200, row) == drawn_by_page.at("twice").at(200, row)) ++row;
  CHECK(drawn_by_page.at("twice").at(200, row).g == 188);
  CHECK(std::abs(drawn_by_page.at("bytes").at(200, row).g - 127.5) < 1);
}

TEST_CASE("what a lesson keeps from the one before makes no difference to its picture") {
  const auto expect_like_fresh = [](LiveLesson&& page, LiveLesson&& fresh, const auto& changes) {
    for (const Words& words : changes) page.set(words, widest);
    fresh.set(changes.back(), widest);
    for (int pass = page.passes() - (page.size_beside().width > 0 ? 0 : 1); pass >= 0; --pass)
      test::expect_same_picture(page.rows(0, 60, pass), fresh.rows(0, 60, pass));
  };
  const Words ewa = {"--filter", "ewa", "--beside", "nearest", "--taps", "3"};
  for (const Words& words : {Words{"--filter", "bilinear"}, Words{"--wrap", "clamp"}})
    expect_like_fresh(live::Chapter09(), live::Chapter09(), std::vector{words, ewa, words});
  for (const char* mistake : {"twice", "bytes"}) {
    const Words wrong = {"--mistake", mistake};
    expect_like_fresh(live::Chapter09(), live::Chapter09(), std::vector{wrong, ewa});
    expect_like_fresh(live::Chapter09(), live::Chapter09(), std::vector{ewa, wrong});
  }
  const Words two = {"--samples", "2"};
  for (const Words& words :
       {Words{"--seed", "4"}, Words{"--exposure", "1"}, Words{"--light", "cosine"}})
    expect_like_fresh(live::Chapter12(), live::Chapter12(), std::vector{words, two});
}

TEST_CASE("10: from the globe to the map and back is the same pixel") {
  live::Chapter10 page;
  for (const char* layout : {"equirect", "cube", "octahedral"}) {
    page.set({"--width", "800", "--height", "600", "--projection", layout}, 800);
    for (int i = 0; i < 10; ++i) {
      const int column = 360 + 9 * i, row = 265 + 5 * i;
      const auto pixel = seen(page, column, row);
      REQUIRE(pixel.contains("spot"));
      const auto back = nlohmann::json::parse(page.find(pixel["spot"][0], pixel["spot"][1]));
      CHECK(back[0].get<double>() == doctest::Approx(column).epsilon(1e-7));
      CHECK(back[1].get<double>() == doctest::Approx(row).epsilon(1e-7));
    }
    const Size map = page.size_beside();
    CHECK(page.rows(0, map.height, page.passes()).width == map.width);
  }
}

TEST_CASE("10: a mistake draws a picture of its own: what a program with its line draws") {
  using std::abs, std::atan2;
  constexpr double pi = std::numbers::pi;
  const auto on_cube = [](const Vec3d& n, const auto& at) {  // as the page says it
    const bool lower = std::max(abs(n.y), -n.z) > std::max(abs(n.x), n.z);
    const Vec3d p = lower ? Vec3d{n.y, n.x, -n.z} : n;
    if (p.z >= abs(p.x)) return at(1, lower ? 0 : 1, p.x / p.z, p.y / p.z);
    const double depth = abs(p.x);
    return p.x < 0 ? at(0, lower ? 0 : 1, p.z / depth, p.y / depth)
                   : at(2, lower ? 0 : 1, -p.z / depth, p.y / depth);
  };
  const auto on_square = [](const Vec3d& n, const auto& fold) -> Uv<double> {
    const double s = abs(n.x) + abs(n.y) + abs(n.z), a = n.x / s, b = -n.z / s;
    const Uv<double> at = n.y < 0 ? fold(a, b) : Uv<double>{a, b};
    return {(1 + at.u) / 2, (1 + at.v) / 2};
  };
  const auto sign = [](double x) { return x < 0 ? -1 : 1; };
  using Place = Uv<double>;
  struct Student {
    const char *mistake, *layout;
    std::function<Place(const Vec3d& n)> uv;
  };
  const auto cube = [&](auto at) { return [=](const Vec3d& n) { return on_cube(n, at); }; };
  const auto square = [&](auto fold) { return [=](const Vec3d& n) { return on_square(n, fold); }; };
  const Student students[] = {
      {"inside", "cube", cube([](int c, int k, double right, double up) -> Place {
         return {(c + (1 - right) / 2) / 3, (k + (1 + up) / 2) / 2};
       })},
      {"columns", "cube", cube([](int c, int k, double right, double up) -> Place {
         return {(2 - c + (1 + right) / 2) / 3, (k + (1 + up) / 2) / 2};
       })},
      {"rows", "cube", cube([](int c, int k, double right, double up) -> Place {
         return {(c + (1 + right) / 2) / 3, (1 - k + (1 + up) / 2) / 2};
       })},
      {"angles", "cube", cube([](int c, int k, double right, double up) -> Place {
         return {(c + (1 + std::atan(right) * 4 / pi) / 2) / 3,
                 (k + (1 + std::atan(up) * 4 / pi) / 2) / 2};
       })},
      {"height", "equirect",
       [](const Vec3d& n) -> Place {
         return {0.5 - atan2(n.z, n.x) / (2 * pi), (1 + n.y) / 2};
       }},
      {"mirrored", "cylinder",
       [](const Vec3d& n) -> Place {
         return {0.5 + atan2(n.z, n.x) / (2 * pi), (1 + n.y) / 2};
       }},
      {"upside-down", "cylinder",
       [](const Vec3d& n) -> Place {
         return {0.5 - atan2(n.z, n.x) / (2 * pi), (1 - n.y) / 2};
       }},
      {"unfolded", "octahedral", square([](double a, double b) -> Place {
         return {a, b};
       })},
      {"exchanged", "octahedral", square([=](double a, double b) -> Place {
         return {sign(a) * (1 - abs(a)), sign(b) * (1 - abs(b))};
       })},
      {"signs", "octahedral", square([](double a, double b) -> Place {
         return {1 - abs(b), 1 - abs(a)};
       })},
  };
  const auto drawn_by_page = expect_mistakes<live::Chapter10>("10_projections", 10);
  CHECK(drawn_by_page.size() == std::size(students));
  for (const Student& student : students) {
    CAPTURE(std::string(student.mistake));
    const auto lesson = prepared<chapter_10::Lesson>({"--projection", student.layout});
    const auto& globe = lesson.objects[chapter_10::middle];
    const auto texture = std::get<chapter_10::Textured>(globe.paint).texture;
    const auto look = [&](const Ray<double>& ray) {
      return color_along(
          lesson.objects, ray, lesson.stage.sky, [&](const auto& object, const Hit<double>& hit) {
            const Rgb color =
                &object == &globe ? texture(student.uv(hit.normal)) : object.paint(hit);
            return color *
                   lambert(lesson.surface, sample_light(lesson.stage.light, lesson.objects, hit));
          });
    };
    const Image drawn = render<double>(look, view_of_lesson(lesson, {240, 180}));
    CHECK(test::count_different(drawn_by_page.at(student.mistake), drawn) < 8);  // texels' edges
  }
}

TEST_CASE("11: the lamp is where it is put, as far away as before; normals are the lesson's") {
  live::Chapter11 page;
  const double there = std::sqrt(228.0 / 229);  // from the middle, (0, 0, 1), to 90 degrees
  const auto to_light = [&page](const char* around, const char* up) {
    page.set({"--lamp-around", around, "--lamp-up", up, "--width", "601"}, 800);
    return numbers_of(seen(page, 300, 300), "light l");  // half a pixel off the middle row
  };
  CHECK(to_light("0", "0")[2] == doctest::Approx(1).epsilon(1e-3));
  CHECK(to_light("90", "0")[0] == doctest::Approx(there).epsilon(1e-3));
  CHECK(to_light("0", "90")[1] == doctest::Approx(there).epsilon(1e-3));
  const auto lesson = prepared<chapter_11::Lesson>();
  page.set({}, 800);
  const View<> view = view_of_lesson(lesson, page.size());
  for (int i = 0; i < 10; ++i) {
    const auto pixel = seen(page, 250 + 10 * i, 130 + 5 * i);
    const auto surface = surface_along(lesson, ray_through(view, 250.0 + 10 * i, 130.0 + 5 * i));
    const auto normal = numbers_of(pixel, "bump's n");
    CHECK(normal[0] == doctest::Approx(surface.normal.x).epsilon(1e-12));
    CHECK(normal[1] == doctest::Approx(surface.normal.y).epsilon(1e-12));
  }
}

TEST_CASE("12: by the cosine, all samples leave the ball to its own side, with the weight 1") {
  live::Chapter12 page;
  page.set({"--light", "cosine", "--samples", "16"}, 800);
  const auto pixel = seen(page, 270, 220);
  const auto lesson = prepared<chapter_12::Lesson>();
  const Vec3d normal =
      surface_along(lesson, ray_through(view_of_lesson(lesson, page.size()), 270.0, 220.0)).normal;
  int dots = 0;
  for (const auto& shape : pixel["figure"]["shapes"]) {
    if (shape[0] != "dot") continue;
    ++dots;
    CHECK(shape[1] == "rgb(255,255,255)");
    const double x = shape[2], y = shape[3];
    CHECK(dot(normal, direction_rtiow(Uv<double>{x / 2, 1 - y})) > 0);
  }
  CHECK(dots == 16);
}
