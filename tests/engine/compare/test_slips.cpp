// The slips of ./course diagnose: pictures drawn by lessons with a mistake in them are explained by
// it, and right ones with damage by none.
#include "diagnose/slips.hpp"

#include <doctest.h>

#include "03_image_texture/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "support/made_pictures.hpp"
#include "support/pictures.hpp"

using namespace texmap;
using chapter_03::Object;

const std::vector<slips::OnStage>& slips::stages() {
  static const std::vector<OnStage> all{on_stage<chapter_03::Lesson>("03_image_texture")};
  return all;
}
const std::vector<slips::OnStage>& slips::variants() {
  static const std::vector<OnStage> none;
  return none;
}

namespace {

/// What a student can do wrong in chapter 03, by functions of his own.
struct Mistake {
  Uv<double> (*uv)(Vec3d n) = [](Vec3d n) { return uv_rtiow(n); };
  bool shadows = true;
  double ambient = 0.2;
  bool bgr = false;
  double degrees = 60, across = 1;  ///< the angle of view; a factor on a ray's way to the right
  Point lamp{5, 5, 5};
  std::size_t casters = 4;  ///< that many objects cast a shadow
  bool acne = false;        ///< a shadow ray meets what it leaves
  bool unlimited = false;   ///< neither the cosine nor the channel is limited to 0
};

/// True if a sphere lies at a distance above 0, however small.
bool is_ahead(const Sphere<>& sphere, const Point& from, const Vec3d& to) {
  const Vec3d out = from - sphere.center;
  const double b = -dot(out, to), c = dot(out, out) - sphere.radius * sphere.radius;
  return b * b >= c && b + std::sqrt(b * b - c) > 0;
}

Image drawn_with(const Mistake& mistake) {
  chapter_03::Lesson lesson = prepared<chapter_03::Lesson>();
  lesson.stage.camera.fov_y_degrees = mistake.degrees;
  lesson.stage.light.position = mistake.lamp;
  std::vector<Object> casters = lesson.objects;
  casters.resize(mistake.shadows ? mistake.casters : 0);
  const auto color_of = [&](const Ray<double>& ray) {
    const auto shade = [&](const Object& object, const Hit<double>& hit) {
      LightSample<double> light = sample_light(lesson.stage.light, casters, hit);
      const Point from = ray.origin + ray.direction * distance_to(object.shape, ray);
      if (mistake.unlimited) light.cosine = std::min(light.cosine, dot(hit.normal, light.to_light));
      if (mistake.acne && is_ahead(object.shape, from, light.to_light)) light.cosine = 0;
      Rgb color = object.paint(hit);
      if (const auto* textured = std::get_if<chapter_03::Textured>(&object.paint))
        color = textured->texture(mistake.uv(hit.normal));
      if (mistake.bgr && hit.object == chapter_03::middle) std::swap(color.r, color.b);
      return color * (mistake.ambient + 0.8 * light.cosine);
    };
    return color_along(lesson.objects, ray, lesson.stage.sky, shade);
  };
  View<> view = view_of(lesson.stage.camera, 800, 600);
  view.right = view.right * mistake.across;
  return image_of(800, 600, [&](int column, int row) {
    const Rgb c = color_of(ray_through<double>(view, column, row));
    const auto byte = [&](double x) {
      return mistake.unlimited ? static_cast<std::uint8_t>(static_cast<int>(255 * std::min(x, 1.0)))
                               : byte_of(x);
    };
    return Rgb8{byte(c.r), byte(c.g), byte(c.b)};
  });
}

std::string words_of(const slips::Explanation& why) {
  std::string words;
  for (const slips::Slip& slip : why.slips)
    words += slip.words.substr(0, slip.words.find(':')) + ";";
  return words;
}

// A student's (u, v), by the word for its mistake.
Uv<double> mirrored(Vec3d n) { return uv_rtiow(Vec3d{n.x, n.y, -n.z}); }
Uv<double> quarter_turn_off(Vec3d n) { return uv_rtiow(Vec3d{n.z, n.y, -n.x}); }
Uv<double> striped(Vec3d n) { return {uv_rtiow(n).u - 0.5, uv_rtiow(n).v}; }
Uv<double> squeezed(Vec3d n) { return {uv_rtiow(n).u, (n.y + 1) / 2}; }

}  // namespace

TEST_CASE("a mistake, or two at once, are found by what they draw") {
  const slips::StageView stage = slips::view_stage<chapter_03::Lesson>("03_image_texture");
  const struct {
    Mistake mistake;
    const char* words;
  } rows[] = {
      {{.uv = mirrored}, "mirrored;"},
      {{.uv = quarter_turn_off}, "a quarter turn off;"},
      {{.uv = striped}, "striped;"},
      {{.uv = squeezed}, "squeezed at the poles;"},
      {{.uv = [](Vec3d n) { return uv_rtiow(rotation_y(37)(n)); }}, "turned by 37 degrees;"},
      {{.shadows = false}, "without shadows;"},
      {{.ambient = 0}, "black in the shadow;"},
      {{.unlimited = true}, "too dark on the far side;"},
      {{.bgr = true}, "red and blue are exchanged in the texture;"},
      {{.uv = mirrored, .shadows = false}, "mirrored;without shadows;"},
      {{.uv = squeezed, .bgr = true},
       "squeezed at the poles;red and blue are exchanged in the texture;"},
      {{.ambient = 0.43}, "the ambient light is 0.43 and not 0.2;"},
      {{.lamp = {2, 10, 5}}, "the lamp is at (2, 10, 5) and not at (5, 5, 5);"},
      {{.lamp = {5, -5, 5}}, "no light of the lamp arrives;"},
      {{.degrees = 47}, "the angle of view is 47 degrees and not 60;"},
      {{.bgr = true, .across = 0.75},
       "all is too narrow;red and blue are exchanged in the texture;"},
  };
  for (const auto& row : rows) {
    CAPTURE(row.words);
    const Image drawn = drawn_with(row.mistake);
    slips::Explanation why = explain(drawn, stage, 2);
    for (const int more : {0, 1})
      if (why.slips.empty()) why = explain_by_view(drawn, stage, more);
    CHECK(words_of(why) == row.words);
    CHECK(why.explained * 10 >= why.different * 9);
    CHECK(why.different > 500);
  }
}

TEST_CASE("a right picture with dots, and noise, have no slips") {
  const slips::StageView stage = slips::view_stage<chapter_03::Lesson>("03_image_texture");
  const Image right = drawn_with({});
  for (const std::size_t dots : {0U, 1U, 100U}) {
    Image damaged = right;
    for (std::size_t i = 0; i < dots; ++i) damaged.pixels[240000 + 37 * i] = {};
    CHECK(explain(damaged, stage, 2).slips.empty());
  }
  CHECK(explain(test::noise(800, 600, 3), stage, 2).slips.empty());
  CHECK(explain_by_view(test::noise(800, 600, 3), stage, 1).slips.empty());
}

TEST_CASE("shadows that are wrong at some places only") {
  const slips::StageView stage = slips::view_stage<chapter_03::Lesson>("03_image_texture");
  const auto words = [&](const Mistake& mistake) {
    const std::string said = wrong_shadows(drawn_with(mistake), stage).words;
    return said.substr(0, said.find(':'));
  };
  CHECK(words({.acne = true}) == "full of dark dots");
  CHECK(words({.casters = 1}) == "some shadows are missing");
  CHECK(words({}).empty());
  CHECK(words({.ambient = 0}).empty());
  CHECK(words({.lamp = {5, 10, 5}}).empty());
}

TEST_CASE("a blend of the globe with its light that is no row of a list") {
  const slips::StageView stage = slips::view_stage<chapter_06::Lesson>("06_phong_texture_blend");
  const auto lesson = prepared<chapter_06::Lesson>({"--blend", "0.8"});
  const Image drawn = render<double>(lesson, view_of(lesson.stage.camera, 800, 600));
  CHECK(words_of(explain(drawn, stage, 1)) ==
        "the globe's texture is blended with its light, 0.8 parts of texture, though nobody asked "
        "for a blend;");
}

TEST_CASE("another texture is told from a wrong place in the right one") {
  const std::vector<std::string> crate{"--texture", "crate.png"};
  const auto of_chapter = [](const std::vector<std::string>& options) {
    return slips::view_stage<chapter_03::Lesson>("03_image_texture", options);
  };
  const auto lesson = prepared<chapter_03::Lesson>(crate);
  const Image drawn = render<double>(lesson, view_of(lesson.stage.camera, 800, 600));
  CHECK(has_other_colors(drawn, of_chapter({})));
  CHECK(explain(drawn, of_chapter(crate), 0).different == 0);
  const Image wrong = drawn_with({.uv = mirrored});
  CHECK(!has_other_colors(wrong, of_chapter({})));
  CHECK(explain(wrong, of_chapter(crate), 0).different > 500);
}

TEST_CASE("the words for grading: of slips, of the whole picture, and none that is not sure") {
  slips::Words words;
  const WrongPicture right{"03_image_texture", "", drawn_with({})};
  const auto of = [&](const Image& drawn) { return short_words(words.of(drawn, right)); };
  CHECK(of(drawn_with({.shadows = false, .bgr = true})) ==
        "red and blue are exchanged in the texture and without shadows");
  CHECK(of(drawn_with({.acne = true})) == "full of dark dots");
  CHECK(of(test::mirrored(right.picture)) == "the whole picture is mirrored");
  CHECK(of(test::noise(800, 600, 3)).empty());
  CHECK(of(Image(800, 600)) == "black");
  // A chapter that is not known, and a lesson that draws another picture than the right one.
  CHECK(words.of(drawn_with({.shadows = false}), {"99_other", "", right.picture}).empty());
  CHECK(words.of(right.picture, {"03_image_texture", "", drawn_with({.ambient = 0})}).empty());
}
