// The pictures of docs/symptoms.md: each is drawn here by the fault that its row names.
// TEXMAP_COLLECT=1 writes them into docs/pictures/symptoms/.
#include <doctest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>

#include "03_image_texture/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "math/srgb.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"
#include "texture/conventions.hpp"
#include "texture/filters.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

constexpr int width = 240;
constexpr int height = 180;

const Camera close_by{.eye = {0, 0.8, 4.2}, .target = {0, -0.05, 0}, .fov_y_degrees = 42};

/// A picture of what each ray sees.
Image drawn(const Camera& camera, const std::function<Rgb(const Ray<double>&)>& color,
            int columns = width, int rows = height) {
  const View<> view = view_of(camera, columns, rows);
  Image image(columns, rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Rgb seen = color(ray_through<double>(view, column, row));
      image.at(column, row) = {byte_of(seen.r), byte_of(seen.g), byte_of(seen.b)};
    }
  }
  return image;
}

const chapter_03::Lesson& lesson() {
  static const auto prepared_once = prepared<chapter_03::Lesson>();
  return prepared_once;
}

const ImageTexture& earth() {
  return std::get<chapter_03::Textured>(lesson().objects[chapter_03::middle].paint).texture;
}

using PaintOfGlobe = std::function<Rgb(const Hit<double>&)>;
using LightOfGlobe = std::function<double(const Hit<double>&, const Ray<double>&)>;

double light_of(const Hit<double>& hit, const Ray<double>& /*ray*/) {
  return lambert(lesson().surface, sample_light(lesson().stage.light, lesson().objects, hit));
}

/// The stage of chapter 03, with another paint or another light on the globe.
Image stage(const PaintOfGlobe& paint, const LightOfGlobe& light = light_of,
            const Camera& camera = close_by) {
  const auto& objects = lesson().objects;
  return drawn(camera, [&](const Ray<double>& ray) {
    return color_along(objects, ray, lesson().stage.sky,
                       [&](const chapter_03::Object& object, const Hit<double>& hit) {
                         const bool is_globe = &object == &objects[chapter_03::middle];
                         return (is_globe ? paint(hit) : object.paint(hit)) *
                                (is_globe ? light : light_of)(hit, ray);
                       });
  });
}

Rgb right_paint(const Hit<double>& hit) { return earth()(uv_rtiow(hit.normal)); }

Image right() { return stage(right_paint); }

Image mirrored_map() {
  return stage([](const Hit<double>& hit) {
    const Uv<double> uv = uv_rtiow(hit.normal);
    return earth()(Uv<double>{1 - uv.u, uv.v});
  });
}

Image flipped_map() {
  return stage([](const Hit<double>& hit) {
    const Uv<double> uv = uv_rtiow(hit.normal);
    return earth()(Uv<double>{uv.u, 1 - uv.v});
  });
}

Image half_turn_of_map() {
  return stage([](const Hit<double>& hit) {
    const Uv<double> uv = uv_rtiow(hit.normal);
    return earth()(Uv<double>{1 - uv.u, 1 - uv.v});
  });
}

/// atan2(-z, x) / 2 pi without the 1/2: negative on the side that is seen.
Image without_half() {
  return stage([](const Hit<double>& hit) {
    const Uv<double> uv = uv_rtiow(hit.normal);
    return earth()(Uv<double>{uv.u - 0.5, uv.v});
  });
}

Image quarter_turn() {
  return stage(
      [](const Hit<double>& hit) { return earth()(uv_of(Convention::lecture, hit.normal)); });
}

/// A mip-mapped globe seen from the seam's side, its pixels drawn three wide. The footprint of a
/// pixel is the difference of (u, v) to the next pixel; at the seam that is nearly 1.
Image seen_at_the_seam(bool by_differences) {
  static const Filtered<Pyramid> texture{
      .pyramid =
          pyramid_of(light_of(load_image(TEXMAP_ASSETS_DIR "/uv_map.png"), TexelLight::encoded)),
      .filter = Filter::trilinear};
  const Camera camera{.eye = {-3.4, 0.6, 0}, .target = {0, 0, 0}, .fov_y_degrees = 42};
  const View<> view = view_of(camera, width / 3, height / 3);
  const Sphere<> globe{{0, 0, 0}, 1};
  Image image(width, height, {140, 170, 210});
  const auto uv_at = [&](auto column, auto row) {
    const auto ray = ray_through(view, column, row);
    return uv_rtiow(normal_at(globe, ray, distance_to(globe, ray)));
  };
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      if (!(distance_to(globe, ray_through<double>(view, column, row)) < infinity<double>()))
        continue;
      Uv<Dual<double>> uv = uv_at(Dual<double>(column, 1, 0), Dual<double>(row, 0, 1));
      if (by_differences) {
        const Uv<double> across = uv_at(column + 1.0, double(row));
        const Uv<double> down = uv_at(double(column), row + 1.0);
        const Uv<double> here{uv.u.value, uv.v.value};
        uv = {{here.u, across.u - here.u, down.u - here.u},
              {here.v, across.v - here.v, down.v - here.v}};
      }
      const Rgb color = texture.filtered(uv);
      for (int i = 0; i < 9; ++i)
        image.at(3 * column + i % 3, 3 * row + i / 3) = {byte_of(color.r), byte_of(color.g),
                                                         byte_of(color.b)};
    }
  }
  return image;
}

/// The pole from above: v is the square of what it should be, as if its arc cosine were missing.
Image at_the_pole(bool without_arc_cosine) {
  static const ImageTexture map{load_image(TEXMAP_ASSETS_DIR "/uv_map.png")};
  const Camera camera{.eye = {0, 3.2, 1.6}, .target = {0, 0, 0}, .fov_y_degrees = 40};
  return stage(
      [&](const Hit<double>& hit) {
        Uv<double> uv = uv_rtiow(hit.normal);
        if (without_arc_cosine) uv.v = (hit.normal.y + 1) / 2;
        return map(uv);
      },
      light_of, camera);
}

Image without_texture() {
  return stage([](const Hit<double>& hit) { return ImageTexture{}(uv_rtiow(hit.normal)); });
}

/// Shadow rays that begin at the hit point itself, and spheres by the textbook's formula.
Image with_acne() {
  auto objects = lesson().objects;
  for (auto& object : objects) object.shape.form = SphereForm::plain;
  return drawn(close_by, [&](const Ray<double>& ray) {
    return color_along(
        objects, ray, lesson().stage.sky, [&](const chapter_03::Object& object, Hit<double> hit) {
          hit.outside = ray.origin + ray.direction * distance_to(object.shape, ray);
          hit.object = -1;
          return object.paint(hit) *
                 lambert(lesson().surface, sample_light(lesson().stage.light, objects, hit));
        });
  });
}

/// The globe of the stage, its pixels drawn three wide; each from so many rays.
Image coasts(int rays) {
  const Camera camera{.eye = {0, 1.6, 6.4}, .target = {0, 0.05, 0}, .fov_y_degrees = 24};
  const View<> view = view_of(camera, width / 3, height / 3);
  Image image(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      Rgb sum{};
      for (int i = 0; i < rays * rays; ++i) {
        const double x = column / 3 + (i % rays + 0.5) / rays - 0.5;
        const double y = row / 3 + (i / rays + 0.5) / rays - 0.5;
        sum = sum + lesson()(ray_through<double>(view, x, y));
      }
      const double share = 1.0 / (rays * rays);
      image.at(column, row) = {byte_of(sum.r * share), byte_of(sum.g * share),
                               byte_of(sum.b * share)};
    }
  }
  return image;
}

/// Each byte of the picture through a curve.
Image through(double (*curve)(double)) {
  Image image = right();
  for (Rgb8& pixel : image.pixels) {
    for (std::uint8_t* channel : {&pixel.r, &pixel.g, &pixel.b})
      *channel = byte_of(curve(*channel / 255.0));
  }
  return image;
}

Image egg(double degrees) {
  const Camera camera{.eye = {0, 0, 4}, .target = {0, 0, 0}, .fov_y_degrees = degrees};
  const double half_width = std::tan(degrees * std::numbers::pi / 360) * width / height;
  const Sphere<> globe{{0.62 * half_width * 4, 0, 0}, 0.22 * half_width * 4};
  return drawn(camera, [&](const Ray<double>& ray) -> Rgb {
    const double distance = distance_to(globe, ray);
    if (!(distance < infinity<double>())) return {0.6, 0.75, 1};
    const Vec3d normal = normal_at(globe, ray, distance);
    return earth()(uv_rtiow(normal)) * (0.4 + 0.6 * std::max(0.0, normal.z));
  });
}

Image close_up(bool filtered) {
  static const Filtered<Pyramid> texture{
      .pyramid = pyramid_of(light_of(earth().image, TexelLight::encoded)),
      .filter = Filter::bilinear};
  const Camera camera{.eye = {-0.1, 0.5, 1.2}, .target = {-0.15, 0.62, 0}, .fov_y_degrees = 16};
  return stage(
      [&](const Hit<double>& hit) {
        const Uv<double> uv = uv_rtiow(hit.normal);
        return filtered ? texture(uv) : earth()(uv);
      },
      [](const Hit<double>&, const Ray<double>&) { return 1.0; }, camera);
}

/// A checkerboard as an image of ten by ten texels, with a tenth of red at each square's lower edge
/// drawn by formula: the squares of the image should begin there.
Image half_a_texel(bool rounds) {
  return stage([&](const Hit<double>& hit) -> Rgb {
    const Uv<double> uv = uv_rtiow(hit.normal);
    const double u = uv.u * 10, v = uv.v * 10;
    if (u - std::floor(u) < 0.08 || v - std::floor(v) < 0.08) return red;
    const double shift = rounds ? 0.5 : 0;
    const long square = std::lround(std::floor(u + shift) + std::floor(v + shift));
    return square % 2 == 0 ? blue : white;
  });
}

Image bumps(const char* relief) {
  auto bumpy = prepared<chapter_11::Lesson>({"--relief", relief});
  bumpy.stage.camera.fov_y_degrees = 18;
  return picture(bumpy, width, height);
}

Image plane(const char* filter) {
  const auto with = prepared<chapter_09::Lesson>({"--filter", filter});
  return picture(with, width, height);
}

/// The light is the cosine between the ray and the normal, as in the triangle article.
Image dark_rim() {
  return stage(right_paint, [](const Hit<double>& hit, const Ray<double>& ray) {
    return std::abs(dot(hit.normal, ray.direction));
  });
}

Image night_side(const char* formula) {
  return picture(prepared<chapter_06::Lesson>({"--scene", "lecture", "--shininess", "20", "--blend",
                                               "0.1", "--highlight", formula}),
                 width, width / 2);
}

struct Symptom {
  const char* name;
  Image wrong;
  Image right;
};

std::vector<Symptom> symptoms() {
  return {
      {"mirrored", mirrored_map(), right()},
      {"upside_down", flipped_map(), right()},
      {"half_turn", half_turn_of_map(), right()},
      {"quarter_turn", quarter_turn(), right()},
      {"stripes", without_half(), right()},
      {"seam_line", seen_at_the_seam(true), seen_at_the_seam(false)},
      {"squeezed_pole", at_the_pole(true), at_the_pole(false)},
      {"black", without_texture(), right()},
      {"black_dots", with_acne(), right()},
      {"frayed_coasts", coasts(1), coasts(4)},
      {"too_dark", through(srgb_decode<double>), right()},
      {"too_pale", through(srgb_encode<double>), right()},
      {"egg", egg(100), egg(20)},
      {"blocks", close_up(false), close_up(true)},
      {"half_a_texel", half_a_texel(true), half_a_texel(false)},
      {"dents", bumps("-0.06"), bumps("0.06")},
      {"blurred", plane("trilinear"), plane("anisotropic")},
      {"dark_rim", dark_rim(), right()},
      {"night_highlight", night_side("lecture"), night_side("phong")},
  };
}

}  // namespace

TEST_CASE(
    "each symptom's picture is drawn by its fault, differs from the right one, and has a row") {
  const std::filesystem::path folder = TEXMAP_TESTS_DIR "/../docs/pictures/symptoms";
  const std::vector<std::uint8_t> bytes =
      test::bytes_of(std::string(TEXMAP_TESTS_DIR "/../docs/symptoms.md"));
  const std::string page(bytes.begin(), bytes.end());
  const bool collects = std::getenv("TEXMAP_COLLECT") != nullptr;
  std::set<std::string> names{"right"};
  const auto check = [&](const std::string& name, const Image& image) {
    CAPTURE(name);
    const std::filesystem::path file = folder / (name + ".png");
    if (collects) save_png(image, file);
    const Image there = load_image(file);
#ifdef TEXMAP_REFERENCE_PLATFORM
    CHECK(count_different(image, there) == 0);
#else
    CHECK(count_different(image, there, 1) < 50);
#endif
    CHECK(page.find("pictures/symptoms/" + name + ".png") != std::string::npos);
    names.insert(name);
  };
  check("right", right());
  for (const Symptom& symptom : symptoms()) {
    check(symptom.name, symptom.wrong);
    CHECK(count_different(symptom.wrong, symptom.right, 8) > 150);
  }
  CHECK(names.size() >= 15);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    CHECK_MESSAGE(names.count(entry.path().stem().string()) == 1, entry.path().string());
}

TEST_CASE("the stage drawn here is chapter 03's") {
  auto same = lesson();
  same.stage.camera = close_by;
  CHECK(right() == picture(same, width, height));
}
