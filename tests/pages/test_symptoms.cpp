// The pictures of docs/symptoms.md, each drawn by the fault that its row names; and what the course
// says of a picture with such a fault.
// TEXMAP_COLLECT=1 writes them into docs/pictures/symptoms/; then pictures.sh --write packs them.
#include <doctest.h>

#include <cstdlib>
#include <set>

#include "03_image_texture/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "engine/compare/known_mistakes.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "math/srgb.hpp"
#include "support/made_pictures.hpp"
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

template <class Look>
Image drawn(const Camera& camera, const Look& look) {
  return render<double>(look, view_of(camera, width, height));
}

const chapter_03::Lesson& lesson() {
  static const auto prepared_once = prepared<chapter_03::Lesson>();
  return prepared_once;
}

const ImageTexture& earth() {
  return std::get<chapter_03::Textured>(lesson().objects[chapter_03::middle].paint).texture;
}

double light_of(const Hit<double>& hit, const Ray<double>& /*ray*/) {
  return lambert(lesson().surface, sample_light(lesson().stage.light, lesson().objects, hit));
}

/// The stage of chapter 03, with another paint or another light on the globe.
template <class Paint, class Light = decltype(&light_of)>
Image stage(const Paint& paint, const Light& light = &light_of, const Camera& camera = close_by) {
  const auto& objects = lesson().objects;
  return drawn(camera, [&](const Ray<double>& ray) {
    return color_along(objects, ray, lesson().stage.sky,
                       [&](const chapter_03::Object& object, const Hit<double>& hit) {
                         const bool is_globe = &object == &objects[chapter_03::middle];
                         if (is_globe) return paint(hit) * light(hit, ray);
                         return object.paint(hit) * light_of(hit, ray);
                       });
  });
}

Rgb right_paint(const Hit<double>& hit) { return earth()(uv_rtiow(hit.normal)); }

Image right() { return stage(right_paint); }

/// What a student's program computes: a color from (u, v).
using D = double;
using LookUp = Rgb (*)(D u, D v);

Image looked_up(LookUp look_up) {
  return stage([&](const Hit<double>& hit) {
    const Uv<double> uv = uv_rtiow(hit.normal);
    return look_up(uv.u, uv.v);
  });
}

/// The texel at a column and a row of the map, without limits.
Rgb texel(int column, int row) {
  const Image& map = earth().image;
  const int n = map.width;
  const Rgb8 t = map.at(((column % n) + n) % n, std::clamp(row, 0, map.height - 1));
  return {t.r / 255.0, t.g / 255.0, t.b / 255.0};
}
int column_of(double u) { return static_cast<int>(std::floor(u * earth().image.width)); }
int row_of(double v) {
  const int height_of_map = earth().image.height;
  return height_of_map - 1 - static_cast<int>(std::floor(v * height_of_map));
}
Rgb at(D u, D v) { return texel(column_of(u), row_of(v)); }

/// A mistake in the look-up, as students write it: nothing here comes from mistaken_maps.
struct LookUpMistake {
  const char* picture;  ///< of the page; nullptr if it shows none
  const char* words;    ///< with which name_mistake begins
  LookUp look_up;
};
constexpr LookUpMistake look_up_mistakes[] = {
    {"mirrored", "mirrored: u runs the other way", [](D u, D v) { return at(1 - u, v); }},
    {"upside_down", "upside down: v runs the other way", [](D u, D v) { return at(u, 1 - v); }},
    {"half_turn", "turned by half", [](D u, D v) { return at(1 - u, 1 - v); }},
    {"quarter_turn", "a quarter turn off", [](D u, D v) { return at(u - 0.25, v); }},
    {nullptr, "a quarter turn off", [](D u, D v) { return at(u + 0.25, v); }},
    {nullptr, "half a turn off", [](D u, D v) { return at(u + 0.5, v); }},
    {"stripes", "striped",  // u without its 1/2 is negative on the side that is seen
     [](D u, D v) { return texel(std::max(column_of(u - 0.5), 0), row_of(v)); }},
    {"black", "black texture", [](D, D) { return gray(0.0); }},
    {nullptr, "half a texel to the left",
     [](D u, D v) {
       return texel(static_cast<int>(std::lround(u * earth().image.width)), row_of(v));
     }},
    {nullptr, "one texel to the left", [](D u, D v) { return texel(column_of(u) + 1, row_of(v)); }},
    {nullptr, "one texel up: rows were counted from 1",
     [](D u, D v) { return texel(column_of(u), row_of(v) + 1); }},
    {nullptr, "u and v are exchanged", [](D u, D v) { return at(v, u); }},
    {nullptr, "squeezed at the poles",
     [](D u, D v) { return at(u, (1 - std::cos(std::numbers::pi * v)) / 2); }},
    {nullptr, "red and blue are exchanged in the texture",
     [](D u, D v) {
       const Rgb c = at(u, v);
       return Rgb{c.b, c.g, c.r};
     }},
    {nullptr, "gray: the texture's colors are lost",
     [](D u, D v) {
       const Rgb c = at(u, v);
       return gray(0.299 * c.r + 0.587 * c.g + 0.114 * c.b);
     }},
    // Nothing of these: another place, two mistakes at once, and a mean of two.
    {nullptr, "", [](D u, D v) { return at(u + 0.15, v); }},
    {nullptr, "", [](D u, D v) { return texel(column_of(1 - u), row_of(v) + 80); }},
    {nullptr, "", [](D u, D v) { return (at(1 - u, v) + at(u, 1 - v)) * 0.5; }},
};

/// A picture with its pixels three wide and three high.
Image tripled(const Image& small) {
  return image_of(3 * small.width, 3 * small.height,
                  [&](int column, int row) { return small.at(column / 3, row / 3); });
}
Rgb8 pixel_of(const Rgb& color) { return {byte_of(color.r), byte_of(color.g), byte_of(color.b)}; }

/// A mip-mapped globe seen from the seam's side, its pixels drawn three wide. The footprint of a
/// pixel is the difference of (u, v) to the next pixel; at the seam that is nearly 1, or, the short
/// way round, as small as elsewhere.
Image seam_line(bool short_way) {
  const Filtered<Pyramid> texture{
      .pyramid =
          pyramid_of(light_of(load_image(TEXMAP_ASSETS_DIR "/uv_map.png"), TexelLight::encoded)),
      .filter = Filter::trilinear};
  const Camera camera{.eye = {-3.4, 0.6, 0}, .target = {0, 0, 0}, .fov_y_degrees = 42};
  const View<> view = view_of(camera, width / 3, height / 3);
  const Sphere<> globe{{0, 0, 0}, 1};
  const auto ray_at = [&](int x, int y) { return ray_through<double>(view, x, y); };
  const auto uv_at = [&](int column, int row) {
    const auto ray = ray_at(column, row);
    return uv_rtiow(normal_at(globe, ray, distance_to(globe, ray)));
  };
  return tripled(image_of(view.width, view.height, [&](int column, int row) {
    if (!(distance_to(globe, ray_at(column, row)) < infinity<double>())) return Rgb8{140, 170, 210};
    const Uv<double> here = uv_at(column, row);
    const Uv<double> across = uv_at(column + 1, row), down = uv_at(column, row + 1);
    const auto step = [&](double to) {
      return to - here.u - (short_way ? std::round(to - here.u) : 0);
    };
    return pixel_of(texture.filtered(Uv<Dual<double>>{
        {here.u, step(across.u), step(down.u)}, {here.v, across.v - here.v, down.v - here.v}}));
  }));
}

/// The pole from above: v is the square of what it should be, as if its arc cosine were missing,
/// or what it should be.
Image squeezed_pole(bool with_angle) {
  const ImageTexture map{load_image(TEXMAP_ASSETS_DIR "/uv_map.png")};
  const Camera camera{.eye = {0, 3.2, 1.6}, .target = {0, 0, 0}, .fov_y_degrees = 40};
  const auto paint = [&](const Hit<double>& hit) {
    const Uv<double> uv = uv_rtiow(hit.normal);
    return map(Uv<double>{uv.u, with_angle ? uv.v : (hit.normal.y + 1) / 2});
  };
  return stage(paint, light_of, camera);
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

/// The globe of the stage, its pixels drawn three wide; each from so many rays across and down.
Image frayed_coasts(int rays) {
  const Camera camera{.eye = {0, 1.6, 6.4}, .target = {0, 0.05, 0}, .fov_y_degrees = 24};
  const Image fine = render<double>(lesson(), view_of(camera, width / 3 * rays, height / 3 * rays));
  return tripled(shrunk(fine, width / 3, height / 3));
}

Image through(double (*curve)(double)) {
  Image image = right();
  for (Rgb8& pixel : image.pixels) {
    for (std::uint8_t* channel : {&pixel.r, &pixel.g, &pixel.b})
      *channel = byte_of(curve(*channel / 255.0));
  }
  return image;
}

/// A globe at the edge, seen with an angle of view of 100 degrees, or from so many times as far.
Image egg(double times_as_far) {
  const double half_height = std::tan(50 * std::numbers::pi / 180);
  const Camera camera{
      .eye = {0, 0, 4 * times_as_far},
      .target = {0, 0, 0},
      .fov_y_degrees = std::atan(half_height / times_as_far) * 360 / std::numbers::pi};
  const double half_width = half_height * width / height;
  const Sphere<> globe{{0.62 * half_width * 4, 0, 0}, 0.22 * half_width * 4};
  return drawn(camera, [&](const Ray<double>& ray) -> Rgb {
    const double distance = distance_to(globe, ray);
    if (!(distance < infinity<double>())) return {0.6, 0.75, 1};
    const Vec3d normal = normal_at(globe, ray, distance);
    return earth()(uv_rtiow(normal)) * (0.4 + 0.6 * std::max(0.0, normal.z));
  });
}

Rgb bilinear_paint(const Hit<double>& hit) {
  const Uv<double> uv = uv_rtiow(hit.normal);
  const double x = uv.u * earth().image.width - 0.5, y = (1 - uv.v) * earth().image.height - 0.5;
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const auto along = [&](int r) { return mix(texel(column, r), texel(column + 1, r), x - column); };
  return mix(along(row), along(row + 1), y - row);
}

template <class Paint>
Image blocks(const Paint& paint) {
  const Camera camera{.eye = {-0.1, 0.5, 1.2}, .target = {-0.15, 0.62, 0}, .fov_y_degrees = 16};
  return stage(
      paint, [](const Hit<double>&, const Ray<double>&) { return 1.0; }, camera);
}

/// A checkerboard as an image of ten by ten texels, with a tenth of red at each square's lower edge
/// drawn by formula: the squares of the image should begin there, and not so much of a square away.
Image half_a_texel(double off) {
  return stage([off](const Hit<double>& hit) -> Rgb {
    const Uv<double> uv = uv_rtiow(hit.normal);
    const double u = uv.u * 10, v = uv.v * 10;
    if (u - std::floor(u) < 0.08 || v - std::floor(v) < 0.08) return red;
    return std::lround(std::floor(u + off) + std::floor(v + off)) % 2 == 0 ? blue : white;
  });
}

Image dents(const char* relief) {
  auto bumpy = prepared<chapter_11::Lesson>({"--relief", relief});
  bumpy.stage.camera.fov_y_degrees = 18;
  return picture(bumpy, width, height);
}

/// A crate and a floor of triangles, with these weights of the corners.
Image bent(const char* weights) {
  return picture(prepared<chapter_08::Lesson>({"--weights", weights}), width, height);
}

/// The light is the cosine between the ray and the normal, as in the triangle article.
Image dark_rim() {
  return stage(right_paint, [](const Hit<double>& hit, const Ray<double>& ray) {
    return std::abs(dot(hit.normal, ray.direction));
  });
}

Image night_highlight(const char* formula) {
  return picture(prepared<chapter_06::Lesson>({"--scene", "lecture", "--shininess", "20", "--blend",
                                               "0.1", "--highlight", formula}),
                 width, width / 2);
}

Image filtered(const char* filter) {
  return picture(prepared<chapter_09::Lesson>({"--filter", filter}), width, height);
}

}  // namespace

TEST_CASE("each symptom's picture is drawn by its fault, and has a row") {
  const std::filesystem::path folder = TEXMAP_TESTS_DIR "/../docs/pictures/symptoms";
  const std::string page = text_in(TEXMAP_TESTS_DIR "/../docs/symptoms.md");
  const bool collects = std::getenv("TEXMAP_COLLECT") != nullptr;
  std::set<std::string> names;
  const auto check = [&](const std::string& name, const Image& image) {
    CAPTURE(name);
    const std::filesystem::path file = folder / (name + ".png");
    if (collects) save_png(image, file);
    const Image there = load_image(file);
    CHECK(count_different(image, there, 24) < 50);  // the file has 256 colors
    CHECK(has(page, "pictures/symptoms/" + name + ".png"));
    names.insert(name);
  };
  check("right", right());
  for (const LookUpMistake& mistake : look_up_mistakes) {
    if (mistake.picture != nullptr) check(mistake.picture, looked_up(mistake.look_up));
  }
  const auto check_both = [&](const std::string& name, const Image& wrong, const Image& mended) {
    check(name, wrong);
    check(name + "_right", mended);
  };
  check_both("seam_line", seam_line(false), seam_line(true));
  check_both("squeezed_pole", squeezed_pole(false), squeezed_pole(true));
  check("black_dots", with_acne());
  check_both("frayed_coasts", frayed_coasts(1), frayed_coasts(4));
  check("too_dark", through(srgb_decode<double>));
  check("too_pale", through(srgb_encode<double>));
  check_both("egg", egg(1), egg(8));
  check_both("blocks", blocks(right_paint), blocks(bilinear_paint));
  check_both("half_a_texel", half_a_texel(0.5), half_a_texel(0));
  check_both("dents", dents("-0.06"), dents("0.06"));
  check_both("bent", bent("picture"), bent("signed"));
  check_both("blurred", filtered("trilinear"), filtered("anisotropic"));
  check("dark_rim", dark_rim());
  check_both("night_highlight", night_highlight("lecture"), night_highlight("phong"));
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    CHECK_MESSAGE(names.count(entry.path().stem().string()) == 1, entry.path().string());
}

TEST_CASE("each known mistake of a student is named, by a machine that rounds another way too") {
  auto same = lesson();
  same.stage.camera = close_by;
  const Image should = picture(same, width, height);
  CHECK(right() == should);  // the stage drawn here is chapter 03's
  std::vector<WrongPicture> known = mistakes_of_the_whole(should);
  for (const WrongPicture& map : mistaken_maps(earth().image)) {
    const ImageTexture texture{map.picture};
    known.push_back({map.name, map.words,
                     stage([&](const Hit<double>& hit) { return texture(uv_rtiow(hit.normal)); })});
  }
  const auto name_of = [&](const Image& image) { return name_mistake(image, should, known); };
  for (const LookUpMistake& mistake : look_up_mistakes) {
    const std::string words = mistake.words;
    CAPTURE(words);
    const Image wrong = looked_up(mistake.look_up);
    for (const Image& image : {wrong, with_noise(wrong, 1, 7)}) {
      CHECK(name_of(image).starts_with(words));
      CHECK(name_of(image).empty() == words.empty());
    }
  }
}
