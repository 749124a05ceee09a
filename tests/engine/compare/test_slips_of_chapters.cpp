// Students' wrong lessons of several chapters, written as students write them: each gets its words,
// and its neighbors none. What is drawn again is drawn as the program draws it.
#include <doctest.h>

#include <cmath>
#include <numbers>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "10_projections/lesson.hpp"
#include "12_environment_map/lesson.hpp"
#include "diagnose/page_slips.hpp"
#include "diagnose/slips.hpp"
#include "diagnose/variants.hpp"
#include "diagnose/wrong_program.hpp"
#include "engine/run/measure.hpp"
#include "support/pictures.hpp"

using namespace texmap;
using namespace texmap::test;

const std::vector<slips::OnStage>& slips::stages() {
  static const std::vector<OnStage> none;
  return none;
}
const std::vector<slips::OnStage>& slips::variants() { return stages(); }

namespace {

/// The words of what explains a picture.
std::string words_of(const Image& drawn, const slips::StageView& stage) {
  const auto whys = slips::explain_by_any(drawn, {&stage, 1});
  return whys.empty() ? "" : slips::all_of(whys.front().second.slips);
}

/// A chapter of the stage, and its right picture.
template <class Lesson>
struct Key {
  Lesson lesson = prepared<Lesson>();
  slips::StageView stage;

  explicit Key(const std::string& chapter) : stage(slips::view_stage<Lesson>(chapter)) {}
  /// The picture with a student's color at each hit gets these words, or how they begin.
  template <class Shade>
  void expect(const std::string& words, const Shade& shade) const {
    const auto look = [&](const Ray<double>& ray) {
      return color_along(
          lesson.objects, ray, lesson.stage.sky,
          [&](const auto& object, const Hit<double>& hit) { return shade(object, hit, ray); });
    };
    const Image drawn = render<double>(look, view_of(lesson.stage.camera, 800, 600));
    const std::string named = words_of(drawn, stage);
    CHECK_MESSAGE((named.starts_with(words) && named.empty() == words.empty()), words, ": ", named);
  }
};

}  // namespace

TEST_CASE("chapter 02: four mistakes draw the other squares, and have one word") {
  const Key<chapter_02::Lesson> key("02_checkerboard_uv");
  const chapter_02::Lesson& lesson = key.lesson;
  const char* const word = "every square has the other color";
  // (u, v) is `from` and so many of the angles; in turns, 0 at +x and at the equator.
  const struct {
    const char* words;
    Uv<double> from, angles;
    Rgb even, odd;
  } rows[] = {
      {"", {0.5, 0.5}, {1, 1}, blue, white},  // right
      {word, {0.5, 0.5}, {-1, 1}, blue, white},
      {word, {0.5, 0.5}, {1, -1}, blue, white},
      {word, {0, 0.5}, {1, 1}, blue, white},
      {word, {0.5, 0}, {1, 1}, blue, white},
      {word, {0.5, 0.5}, {1, 1}, white, blue},
      // The neighbors: other colors, and half a square off, as by a quarter turn.
      {"", {0.5, 0.5}, {1, 1}, red, white},
      {"a quarter turn off", {0.55, 0.5}, {1, 1}, blue, white},
  };
  for (const auto& row : rows) {
    key.expect(row.words, [&](const auto& object, const Hit<double>& hit, const auto&) {
      const Vec3d& n = hit.normal;
      const double u = std::atan2(-n.z, n.x) / (2 * std::numbers::pi);
      const double v = std::asin(n.y) / std::numbers::pi;
      const auto square = static_cast<int>(std::floor(10 * (row.from.u + row.angles.u * u)) +
                                           std::floor(10 * (row.from.v + row.angles.v * v)));
      const bool checkered = &object != &lesson.objects[chapter_02::left];
      const Rgb color = !checkered ? red : square % 2 == 0 ? row.even : row.odd;
      return color * lambert(lesson.surface, sample_light(lesson.stage.light, lesson.objects, hit));
    });
  }
}

TEST_CASE("chapter 05: a turned light and another axis have their words") {
  const Key<chapter_05::Lesson> key("05_y_rotation");
  const chapter_05::Lesson& lesson = key.lesson;
  struct Turn {
    Vec3d x, y, z;  // the rows of its matrix
    Vec3d operator()(const Vec3d& p) const { return {dot(x, p), dot(y, p), dot(z, p)}; }
  };
  constexpr Turn alone{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr Turn right{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};  // by 90 degrees
  constexpr Turn back{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  const char* const axis = "turned about a horizontal axis";
  const struct {
    const char* words;
    Turn of_texture, of_light;
  } rows[] = {
      {"", right, alone},
      {"light and shade turned with the globe", right, right},
      {"", right, back},
      {"turned the other way", back, alone},
      {axis, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, alone},
      {axis, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, alone},
      {axis, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, alone},
      // x and y exchanged: a turn about z, upside down.
      {axis, {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, alone},
  };
  const auto& globe = lesson.objects[chapter_05::middle];
  for (const auto& row : rows) {
    key.expect(row.words, [&](const auto& object, Hit<double> hit, const auto&) {
      Rgb color = object.paint(hit);
      if (&object == &globe) {
        const auto& paint = std::get<chapter_05::Textured>(globe.paint);
        color = paint.texture(uv_rtiow(row.of_texture(hit.normal)));
        hit.normal = row.of_light(hit.normal);
      }
      return color * lambert(lesson.surface, sample_light(lesson.stage.light, lesson.objects, hit));
    });
  }
}

TEST_CASE("chapter 06: mistakes of the light and of the highlight have their words") {
  const Key<chapter_06::Lesson> key("06_phong_texture_blend");
  const chapter_06::Lesson& lesson = key.lesson;
  struct Student {
    const char* words;
    double exponent = 50, ambient = 0.2, toward_eye = 1;
    bool half_vector = false, colored = false, blended = false;
  };
  const Student rows[] = {
      {.words = ""},  // right
      {.words = "black in the shadow: the ambient light is missing", .ambient = 0},
      {.words = "without a highlight: its factor is 0", .toward_eye = -1},
      {.words = "the highlight has the color of the surface", .colored = true},
      {.words = "the globe's texture is blended", .blended = true},
      {.words = "the highlight is too wide: it takes Blinn's half vector", .half_vector = true},
      // With four times the exponent the half vector draws almost the right picture.
      {.words = "the highlight is too wide: it takes Blinn's half vector and not the reflected "
                "light; and the highlight's exponent is 200",
       .exponent = 200,
       .half_vector = true},
      {.words = "the highlight's exponent is 10 and not 50", .exponent = 10},
      {.words = "the highlight's exponent is 40 and not 50", .exponent = 40},
      {.words = "the highlight's exponent is 80 and not 50", .exponent = 80},
  };
  for (const Student& row : rows) {
    key.expect(row.words, [&](const auto& object, const auto& hit, const auto& ray) {
      const auto light = sample_light(lesson.stage.light, lesson.objects, hit);
      const bool on_globe = &object == &lesson.objects[chapter_06::middle];
      const Vec3d &n = hit.normal, &l = light.to_light, eye = ray.direction * -row.toward_eye;
      const double cosine =
          row.half_vector ? dot(n, normalize(l + eye)) : dot(n * (2 * dot(n, l)) - l, eye);
      const bool shines = on_globe && light.cosine > 0 && cosine > 0;
      const double shine = shines ? 0.3 * std::pow(cosine, row.exponent) : 0;
      const double diffuse = row.ambient + 0.8 * light.cosine;
      const Rgb color = object.paint(hit);
      if (row.blended && on_globe) return mix(gray(std::min(diffuse + shine, 1.0)), color, 0.3);
      return row.colored ? color * (diffuse + shine) : color * diffuse + gray(shine);
    });
  }
}

TEST_CASE("what is drawn again at few pixels is what the program draws there") {
  const auto check = [](auto ready) {
    ready->chosen.settings.quiet = true;
    ready->build();
    const Image whole = Session(ready->chosen).draw(ready->lesson);
    for (const int every : {3, 30})
      CHECK(slips::drawn_at(*ready, every) == slips::pixels_of(whole, every));
  };
  const std::vector<std::string> small{"--width", "97", "--height", "64", "--samples", "3"};
  check(std::make_unique<Ready<chapter_07::Lesson>>("07_earth_by_sampling", small));
  check(std::make_unique<Ready<chapter_12::Lesson>>("12_environment_map", small));
  check(std::make_unique<Ready<chapter_08::Lesson>>("08_triangle_uv", small));

  Ready<chapter_10::Lesson> sheet("10_projections", {"--width", "300", "--height", "200"});
  sheet.chosen.settings.quiet = true;
  sheet.build();
  Session session(sheet.chosen);
  Image whole;
  session.taken = &whole;
  draw_and_save(sheet.lesson, session);
  CHECK(slips::drawn_at(sheet, 3) == slips::pixels_of(whole, 3));
}

TEST_CASE("a mesh and gathered light: mistakes are drawn again, also with other random numbers") {
  const auto draw_07 = [](const std::vector<std::string>& words) {
    return drawing_by<chapter_07::Lesson>("07_earth_by_sampling", words)();
  };
  const slips::StageView globe = slips::view_colors<chapter_07::Lesson>("07_earth_by_sampling", "");
  CHECK(words_of(draw_07({"--quiet", "--decode", "raw"}), globe).starts_with("the texture is too"));
  CHECK(words_of(draw_07({"--quiet", "--decode", "raw", "--seed", "7"}), globe)
            .starts_with("the texture is too pale"));
  CHECK(words_of(draw_07({"--quiet", "--seed", "7"}), globe).empty());
  const slips::StageView crate = slips::view_colors<chapter_08::Lesson>("08_triangle_uv", "");
  const Image clamped =
      drawing_by<chapter_08::Lesson>("08_triangle_uv", {"--quiet", "--wrap", "clamp"})();
  CHECK(words_of(clamped, crate).starts_with("the texture's edge is repeated"));
  CHECK(words_of(mirrored(clamped), crate) ==
        "the texture's edge is repeated: coordinates were limited to 0 and 1; and the whole "
        "picture is mirrored: columns run the other way");
}

TEST_CASE("a mistake that a page draws is named, and no other of the page is") {
  const slips::StageView all[] = {slips::view_stage<chapter_01::Lesson>("01_plain_spheres"),
                                  slips::view_stage<chapter_02::Lesson>("02_checkerboard_uv"),
                                  slips::view_stage<chapter_03::Lesson>("03_image_texture"),
                                  slips::view_stage<chapter_05::Lesson>("05_y_rotation"),
                                  slips::view_stage<chapter_06::Lesson>("06_phong_texture_blend")};
  int drawn_ones = 0;
  for (const slips::StageView& stage : all) {
    const auto of_page = slips::of_chapter(stage.chapter, slips::on_pages);
    for (const slips::PageSlip* one : of_page) {
      CAPTURE(stage.chapter + ": " + one->begins);
      const auto [place, row] = slips::row_named(one->begins).value();
      CHECK(std::string(one->right) != one->wrong);
      slips::Way way;
      way.row.at(static_cast<std::size_t>(place)) = row;
      Image drawn(stage.width, stage.height);
      for (const slips::Seen& seen : stage.pixels) {
        const Rgb c = slips::WrongProgram(stage).light_of(way, seen);
        drawn.at(seen.column, seen.row) = {byte_of(c.r), byte_of(c.g), byte_of(c.b)};
      }
      const slips::Explanation why = slips::explain(drawn, stage, 1);
      CHECK(slips::all_of(why.slips) == slips::slip_of(place, row).words);
      for (const std::string& other : why.instead) {
        for (const slips::PageSlip* listed : of_page)
          CHECK_FALSE(other.starts_with(listed->begins));
      }
      ++drawn_ones;
    }
  }
  CHECK(drawn_ones > 45);
}
