// The WebAssembly module of chapter 14's live picture: the chapter's exhibits, each with a number
// that a slider sets.
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "14_numerical_extremes/exhibits.hpp"
#include "engine/draw/render.hpp"
#include "engine/files/decode_image.hpp"
#include "engine/files/json.hpp"
#include "exported.hpp"

namespace {

using namespace texmap;
using namespace texmap::chapter_14;

/// An exhibit with a slider.
struct Dial {
  const char* exhibit;  ///< of the program, which has it at `value`
  const char* label;
  double value, least, most;
  const char* published;
  const char* course;
  std::function<Image(double value, Formulas formulas, bool in_float, int width, int height)> draw;
};
std::vector<Dial> dials;

/// Draws the scene that `scene_at` makes of a value.
template <class SceneAt>
auto drawing(const SceneAt& scene_at) {
  return [scene_at](double value, Formulas formulas, bool in_float, int width, int height) {
    const auto scene = scene_at(value);
    const SceneWith<std::decay_t<decltype(scene)>> lesson{scene, formulas};
    const View<> view = view_of(scene.camera, width, height);
    if (in_float) return render<float>(lesson, view, {.threads = 1});
    return render<double>(lesson, view, {.threads = 1});
  };
}

std::vector<Dial> all_dials(const Image& earth) {
  const ImageTexture texture{earth};
  const Sphere<> globe{{0, 0, 0}, 1};
  const Camera stage{.eye = {0, 2, 8}, .target = {0, 0, 0}};
  const char* far_off = "b² − a c: two large numbers, nearly equal";
  return {
      {"from-1e5", "distance of the eye, radii", 1e5, 2, 1e8, far_off,
       "a r² − |f × d|², with exact products", drawing([=](double radii) {
         return Globe<ImageTexture>{{"", "", towards_origin({0, 0, radii}, 1.15)}, globe, texture};
       })},
      {"far-home", "distance of eye and globe from (0, 0, 0)", 1e5, 1, 1e7,
       "(hit point − center) / radius: a difference of large numbers",
       "the normal computed from the center, not from (0, 0, 0)", drawing([=](double away) {
         return Globe<ImageTexture>{
             {"", "", {.eye = {away, 0, 5}, .target = {away, 0, 0}, .fov_y_degrees = 26}},
             {{away, 0, 0}, 1},
             texture};
       })},
      {"units", "radius of the globe", 1e-25, 1e-30, 1, "r² and b² become 0",
       "lengths scaled by powers of two", drawing([=](double radius) {
         return Globe<ImageTexture>{{"", "", towards_origin({0, 0, 10 * radius}, 1.15 * radius)},
                                    {{0, 0, 0}, radius},
                                    texture};
       })},
      {"pole", "degrees that the picture shows", 1.5, 0.1, 45, "v = acos(−y) / π",
       "v = atan2(√(x² + z²), −y) / π", drawing([=](double degrees) {
         Camera camera = above_the_pole;
         camera.fov_y_degrees = degrees;
         return Globe<Graticule>{{"", "", camera}, globe, {}};
       })},
      {"seam", "width of the picture, radii", 3e-7, 1e-8, 1,
       "u = (atan2(−z, x) + π) / 2π, which rounds to 1", "u limited to the last number below 1",
       drawing([=](double width) {
         return Globe<Graticule>{
             {"", "", towards_origin({-3, 0, 0}, width)}, globe, {.sectors = 2, .rings = 1}};
       })},
      {"acne", "radius of the ground", 1e5, 10, 1e7, "the shadow ray starts at the hit; t > 0.001",
       "it starts off the surface, by a bound on the rounding", drawing([=](double radius) {
         return Shadows{{"", "", stage}, 1, radius};
       })},
      {"small", "size of the stage", 1e-4, 1e-5, 1, "hits nearer than t = 0.001 are ignored",
       "a bound on the rounding, which is as small as the scene", drawing([=](double unit) {
         return Shadows{
             {"", "", {.eye = {0, 2 * unit, 8 * unit}, .target = {0, 0, 0}}}, unit, 1000};
       })},
      {"needle", "height of the triangle over its width", 1e4, 1, 1e6,
       "areas from the sides, by Heron: √(s (s − a) (s − b) (s − c))",
       "edge functions, from exact products where they cancel", drawing([=](double ratio) {
         return Needle{{"", "", towards_origin({0, 0, 1}, 0.55)}, texture, 0.5 / ratio};
       })},
      {"far-floor", "cells from (0, 0, 0)", 1e7, 10, 1e9, "cells counted from (0, 0, 0)",
       "cells counted from a corner near the eye", drawing([=](double cells) {
         const double at = std::round(cells) + 0.25;
         return FarFloor{
             {"", "", {.eye = {at, 2, at + 3}, .target = {at, 0, at - 4}, .fov_y_degrees = 50}}};
       })},
      {"highlight", "Phong's exponent", 101, 1, 200,
       "(r · d)ⁿ: the sign is wrong, an even n hides it", "max(r · e, 0)ⁿ",
       drawing([=](double exponent) {
         OddExponent scene{{"", "", {.eye = {0, 0, 4}, .target = {0, 0, 0}, .fov_y_degrees = 36}}};
         scene.material.shininess = std::round(exponent);
         return scene;
       })},
  };
}

}  // namespace

/// Reads the globe's PNG or JPEG; returns the exhibits and their sliders.
EXPORTED(begin) const char* begin(const std::uint8_t* bytes, int size) {
  return answer([&] {
    dials = all_dials(decode_image({bytes, static_cast<std::size_t>(size)}));
    return Json::list_of(dials,
                         [](const Dial& dial) {
                           return Json::object({{"exhibit", dial.exhibit},
                                                {"label", dial.label},
                                                {"value", dial.value},
                                                {"least", dial.least},
                                                {"most", dial.most},
                                                {"published", dial.published},
                                                {"course", dial.course}});
                         })
        .text;
  });
}

/// A picture of an exhibit at a value, 4 bytes a pixel.
EXPORTED(draw)
const std::uint8_t* draw(int dial, double value, int published, int in_float, int width,
                         int height) {
  return rgba_of(dials[static_cast<std::size_t>(dial)].draw(
      value, published != 0 ? Formulas::published : Formulas::robust, in_float != 0, width,
      height));
}
