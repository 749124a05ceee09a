// Students' wrong lessons of the chapters 02, 05 and 06, written as students write them: the
// program draw_mistakes draws the same pictures, so each gets its word, and its neighbors none.
#include <doctest.h>

#include <cmath>
#include <numbers>

#include "02_checkerboard_uv/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "engine/compare/known_mistakes.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

constexpr int width = 240;
constexpr int height = 180;

/// A lesson that gives a hit its color by a student's function.
template <class Lesson, class Shade>
Image drawn(const Lesson& lesson, const Shade& shade) {
  struct Student {
    const Lesson& lesson;
    const Shade& shade;
    Rgb operator()(const Ray<double>& ray) const {
      return color_along(
          lesson.objects, ray, lesson.stage.sky,
          [&](const auto& object, const Hit<double>& hit) { return shade(object, hit, ray); });
    }
  };
  return render<double>(Student{lesson, shade}, view_of(lesson.stage.camera, width, height));
}

/// What an instructor has of a chapter.
struct Key {
  TemporaryFolder folder;
  Image right;
  std::vector<WrongPicture> wrong;

  Key(const std::string& chapter, Image right_picture) : right(std::move(right_picture)) {
    const std::string size =
        " --width " + std::to_string(width) + " --height " + std::to_string(height);
    const Outcome outcome = run("\"" TEXMAP_DRAW_MISTAKES "\" " + chapter + " --out \"" +
                                (folder / "made") + "\"" + size);
    REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
    wrong = load_wrong_pictures(folder / "made");
  }
  [[nodiscard]] std::string name_of(const Image& image) const {
    return name_mistake(image, right, wrong);
  }
};

}  // namespace

TEST_CASE("chapter 02: four mistakes draw the other squares, and have one word") {
  const chapter_02::Lesson lesson;
  const Key key("02", picture(lesson, width, height));
  const auto with = [&](const auto& uv_of_normal, const Rgb& even, const Rgb& odd) {
    return key.name_of(drawn(lesson, [&](const auto& object, const Hit<double>& hit, const auto&) {
      const auto& n = hit.normal;
      const Uv<double> uv = uv_of_normal(std::atan2(-n.z, n.x) / (2 * std::numbers::pi),
                                         std::asin(n.y) / std::numbers::pi);
      const int column = static_cast<int>(std::floor(10 * uv.u));
      const int row = static_cast<int>(std::floor(10 * uv.v));
      const bool checkered = &object != &lesson.objects[chapter_02::left];
      const Rgb color = !checkered ? red : (column + row) % 2 == 0 ? even : odd;
      return color * lambert(lesson.surface, sample_light(lesson.stage.light, lesson.objects, hit));
    }));
  };
  const char* word = "every square has the other color";
  const auto in = [&](double (*u)(double), double (*v)(double)) {
    return with([=](double a, double b) { return Uv<double>{u(a), v(b)}; }, blue, white);
  };
  const auto plus_half = [](double x) { return x + 0.5; };
  const auto half_minus = [](double x) { return 0.5 - x; };
  const auto alone = [](double x) { return x; };
  CHECK(in(plus_half, plus_half).empty());  // right
  CHECK(in(half_minus, plus_half).starts_with(word));
  CHECK(in(plus_half, half_minus).starts_with(word));
  CHECK(in(alone, plus_half).starts_with(word));
  CHECK(in(plus_half, alone).starts_with(word));
  CHECK(with(
            [](double u, double v) {
              return Uv<double>{u + 0.5, v + 0.5};
            },
            white, blue)
            .starts_with(word));
  // The neighbors: other colors, and half a square off.
  CHECK(with([](double u, double v) { return Uv<double>{u + 0.5, v + 0.5}; }, red, white).empty());
  CHECK(in([](double x) { return x + 0.55; }, plus_half).empty());
}

TEST_CASE("chapter 05: a turned light and another axis have their words") {
  const auto lesson = prepared<chapter_05::Lesson>();
  const Key key("05", picture(lesson, width, height));
  const auto& globe = lesson.objects[chapter_05::middle];
  const auto with = [&](const auto& of_texture, const auto& of_light) {
    return key.name_of(drawn(lesson, [&](const auto& object, Hit<double> hit, const auto&) {
      Rgb color = object.paint(hit);
      if (&object == &globe) {
        const auto& paint = std::get<chapter_05::Textured>(globe.paint);
        color = paint.texture(uv_rtiow(of_texture(hit.normal)));
        hit.normal = of_light(hit.normal);
      }
      return color * lambert(lesson.surface, sample_light(lesson.stage.light, lesson.objects, hit));
    }));
  };
  const auto alone = [](const Vec3d& p) { return p; };
  const auto right = [](const Vec3d& p) { return Vec3d{p.z, p.y, -p.x}; };  // by 90 degrees
  const auto back = [](const Vec3d& p) { return Vec3d{-p.z, p.y, p.x}; };
  CHECK(with(right, alone).empty());
  CHECK(with(right, right).starts_with("light and shade turned with the globe"));
  CHECK(with(right, back).empty());
  CHECK(with(back, alone).starts_with("turned the other way"));
  const char* axis = "turned about a horizontal axis";
  CHECK(with([](const Vec3d& p) { return Vec3d{p.x, -p.z, p.y}; }, alone).starts_with(axis));
  CHECK(with([](const Vec3d& p) { return Vec3d{p.x, p.z, -p.y}; }, alone).starts_with(axis));
  CHECK(with([](const Vec3d& p) { return Vec3d{-p.y, p.x, p.z}; }, alone).starts_with(axis));
  // x and y exchanged are a mirror, and no turn.
  CHECK(with([](const Vec3d& p) { return Vec3d{p.y, p.x, p.z}; }, alone).empty());
}

TEST_CASE("chapter 06: mistakes of the light and of the highlight have their words") {
  const auto lesson = prepared<chapter_06::Lesson>();
  const Key key("06", picture(lesson, width, height));
  const auto& globe = lesson.objects[chapter_06::middle];
  struct Parts {
    Rgb color;
    double cosine;
    Vec3d to_lamp, normal, to_eye;
    bool on_globe;
    [[nodiscard]] double shine(double exponent, const Vec3d& eye) const {
      const Vec3d reflected = normal * (2 * dot(normal, to_lamp)) - to_lamp;
      const double along = dot(reflected, eye);
      const bool shines = on_globe && cosine > 0 && along > 0;
      return shines ? 0.3 * std::pow(along, exponent) : 0;
    }
    [[nodiscard]] double shine_by_half(double exponent) const {
      const bool shines = on_globe && cosine > 0;
      return shines ? 0.3 * std::pow(dot(normal, normalize(to_lamp + to_eye)), exponent) : 0;
    }
    [[nodiscard]] double diffuse() const { return 0.2 + 0.8 * cosine; }
  };
  const auto with = [&](const auto& color_of) {
    return key.name_of(drawn(lesson, [&](const auto& object, const auto& hit, const auto& ray) {
      const auto light = sample_light(lesson.stage.light, lesson.objects, hit);
      return Rgb(color_of(Parts{object.paint(hit), light.cosine, light.to_light, hit.normal,
                                -ray.direction, &object == &globe}));
    }));
  };
  CHECK(with([](const Parts& p) {
          return p.color * p.diffuse() + gray(p.shine(50, p.to_eye));
        }).empty());  // right
  CHECK(with([](const Parts& p) {
          return p.color * (0.8 * p.cosine) + gray(p.shine(50, p.to_eye));
        }).starts_with("black in the shadow: the ambient light is missing"));
  CHECK(with([](const Parts& p) {
          return p.color * p.diffuse() + gray(p.shine(50, -p.to_eye));
        }).ends_with("or the direction to the eye has the wrong sign"));
  CHECK(with([](const Parts& p) {
          return p.color * (p.diffuse() + p.shine(50, p.to_eye));
        }).starts_with("the highlight has the color of the surface"));
  CHECK(with([](const Parts& p) {
          const double light = p.diffuse() + p.shine(50, p.to_eye);
          if (!p.on_globe) return p.color * light;
          return mix(gray(std::min(light, 1.0)), p.color, 0.3);
        }).starts_with("the globe's texture is blended"));
  const auto half = [&](double exponent) {
    return with(
        [=](const Parts& p) { return p.color * p.diffuse() + gray(p.shine_by_half(exponent)); });
  };
  CHECK(half(50).ends_with("Blinn's half vector and not the reflected light"));
  // With four times the exponent the half vector draws almost the right picture.
  CHECK(half(200).empty());
  const auto exponent = [&](double n) {
    return with([=](const Parts& p) { return p.color * p.diffuse() + gray(p.shine(n, p.to_eye)); });
  };
  CHECK(exponent(10) == "the highlight is too wide: its exponent is too small");
  CHECK(exponent(40).empty());
  CHECK(exponent(80).empty());
}
