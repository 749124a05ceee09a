// The live page of chapter 10: shows the globe's map, marks a point on both, and draws the usual
// mistakes.
#pragma once
#include <cmath>
#include <utility>

#include "10_projections/lesson.hpp"
#include "figure.hpp"
#include "live.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::live {

/// What a program with a mistake reads in a layout's picture. To add one, add its row and the one
/// in `of_pages` of option_slips.hpp.
struct WrongReading {
  const char* name;
  Projection layout, read;  ///< of the picture; by which (u, v) is computed
  /// What becomes of (u, v); the picture is read there.
  Uv<double> (*moved)(const Uv<double>& uv) = [](const Uv<double>& uv) { return uv; };
};

/// An octahedron's (u, v), with its lower faces elsewhere: `move` is given a and b, -1 to 1.
[[nodiscard]] inline Uv<double> with_corners(const Uv<double>& uv,
                                             Uv<double> (*move)(double a, double b)) {
  const double a = 2 * uv.u - 1, b = 2 * uv.v - 1;
  if (std::abs(a) + std::abs(b) <= 1) return uv;
  const Uv<double> to = move(a, b);
  return uv_from_square(to.u, to.v);
}

inline constexpr WrongReading wrong_readings[] = {
    {"inside", Projection::cube, Projection::cube,
     [](const Uv<double>& uv) -> Uv<double> {
       return {(2 * std::floor(3 * uv.u) + 1) / 3 - uv.u, uv.v};
     }},
    {"columns", Projection::cube, Projection::cube,
     [](const Uv<double>& uv) -> Uv<double> {
       return {uv.u + (2 - 2 * std::floor(3 * uv.u)) / 3, uv.v};
     }},
    {"rows", Projection::cube, Projection::cube,
     [](const Uv<double>& uv) -> Uv<double> {
       return {uv.u, uv.v < 0.5 ? uv.v + 0.5 : uv.v - 0.5};
     }},
    {"angles", Projection::cube, Projection::equi_angular},
    {"height", Projection::equirect, Projection::cylinder},
    {"mirrored", Projection::cylinder, Projection::cylinder,
     [](const Uv<double>& uv) -> Uv<double> {
       return {1 - uv.u, uv.v};
     }},
    {"upside-down", Projection::cylinder, Projection::cylinder,
     [](const Uv<double>& uv) -> Uv<double> {
       return {uv.u, 1 - uv.v};
     }},
    {"unfolded", Projection::octahedral, Projection::octahedral,
     [](const Uv<double>& uv) {
       return with_corners(uv, [](double a, double b) -> Uv<double> {
         return {with_sign_of(a, 1 - std::abs(b)), with_sign_of(b, 1 - std::abs(a))};
       });
     }},
    {"exchanged", Projection::octahedral, Projection::octahedral,
     [](const Uv<double>& uv) {
       return with_corners(uv, [](double a, double b) -> Uv<double> {
         return {with_sign_of(a, std::abs(b)), with_sign_of(b, std::abs(a))};
       });
     }},
    {"signs", Projection::octahedral, Projection::octahedral,
     [](const Uv<double>& uv) {
       return with_corners(uv, [](double a, double b) -> Uv<double> {
         return {std::abs(a), std::abs(b)};
       });
     }},
};

struct MapAndGlobe {
  static constexpr int at_rest = 800;  ///< columns of a picture that no hand drags
  const WrongReading* mistake = nullptr;
  chapter_10::Paint misread{};  ///< the globe's, with the mistake

  [[nodiscard]] static const auto& globe_of(const chapter_10::Lesson& lesson) {
    return std::get<chapter_10::Textured>(lesson.objects[chapter_10::middle].paint);
  }
  void declare(CommandLine& line) { declare_mistakes(line, mistake, wrong_readings); }

  /// Takes the mistake's layout. A wrong place in its picture is the right one in another picture.
  void apply(chapter_10::Lesson& lesson) {
    if (mistake == nullptr) return;
    if (lesson.layout.on_globe() != mistake->layout) {  // else it is loaded
      lesson.layout.projection = mistake->layout;
      lesson.objects[chapter_10::middle].paint =
          chapter_10::Textured{{mistake->layout}, lesson.layout.load(lesson.texture)};
    }
    const SharedImage& map = globe_of(lesson).texture.image;
    misread = chapter_10::Textured{
        {mistake->read}, {image_of(map.width, map.height, [&](int column, int row) {
          const Uv<double> at =
              mistake->moved({(column + 0.5) / map.width, 1 - (row + 0.5) / map.height});
          return map.at(static_cast<int>(at.u * map.width),
                        map.height - 1 - static_cast<int>(at.v * map.height));
        })}};
  }
  [[nodiscard]] std::optional<Image> draw(chapter_10::Lesson& lesson, const View<>& view,
                                          const RenderSettings& how) const {
    if (mistake == nullptr) return std::nullopt;
    chapter_10::Paint& paint = lesson.objects[chapter_10::middle].paint;
    const chapter_10::Paint right = std::exchange(paint, misread);
    Image drawn = render<double>(lesson, view, how);
    paint = right;
    return drawn;
  }

  [[nodiscard]] Size size_beside(const chapter_10::Lesson& lesson, const Size& size) const {
    const Image& map = globe_of(lesson).texture.image;
    const int width = size.width < at_rest ? std::min(map.width, size.width) : map.width;
    return {width, std::max(1, map.height * width / map.width)};
  }
  /// The map: all of its texels, so that the page can save it, or those at the pixels' centers of a
  /// smaller one. A layout's empty parts are black as the program's.
  [[nodiscard]] Image draw_beside(const chapter_10::Lesson& lesson, const View<>& strip, int first,
                                  const RenderSettings& /*how*/) const {
    const Image& map = globe_of(lesson).texture.image;
    const Size size = size_beside(lesson, {strip.width, 0});
    Image image(size.width, strip.height);
    for (int row = 0; row < strip.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        image.at(column, row) = map.at((2 * column + 1) * map.width / (2 * size.width),
                                       (2 * (row + first) + 1) * map.height / (2 * size.height));
      }
    }
    return image;
  }

  template <class State>
  [[nodiscard]] Members look(const State& state, int column, int row) const {
    const chapter_10::Lesson& lesson = state.lesson;
    const Ray<double> ray = ray_through(state.whole, double(column), double(row));
    const Surface<double> seen = surface_along(lesson, ray);
    if (seen.object != chapter_10::middle) return what_a_ray_meets(lesson, ray);
    const auto& [mapping, texture] = globe_of(lesson);
    const TexelPlace<double> texel = texel_place(seen.uv, texture.image.width, texture.image.height,
                                                 texture.v_axis, texture.rounding);
    const Distortion<double> here = distortion(mapping.projection, seen.normal);
    return {{"rows",
             Json::list({fact("normal n", seen.normal), fact({"u, v", seen.uv.u, ", ", seen.uv.v}),
                         fact({"texel", "column ", texel.column, ", row ", texel.row, " of ",
                               texture.image.width, " × ", texture.image.height}),
                         fact({"here", "a texel is ", here.area, " times the mean, and ",
                               here.stretch, " times as long as wide"})})},
            {"spot", Json::list({seen.uv.u, 1 - seen.uv.v})}};
  }

  /// The pixel of the globe that shows a place on the map, 0 to 1 from the left and from the top;
  /// nothing where it is on the far side.
  template <class State>
  [[nodiscard]] std::optional<PixelPlace<double>> find(const State& state, double x,
                                                       double y) const {
    const auto& [mapping, texture] = globe_of(state.lesson);
    if (!shows(mapping.projection, Uv<double>{x, 1 - y})) return {};
    const auto& ball = state.lesson.objects[chapter_10::middle].shape;
    const Vec3d normal = unproject(mapping.projection, Uv<double>{x, 1 - y});
    const View<>& view = state.whole;
    const Vec3d way = ball.center + normal * ball.radius - view.eye;
    if (dot(way, normal) >= 0) return {};
    const double depth = dot(way, view.forward) * view.pixel;
    return PixelPlace<double>{view.center_column + dot(way, view.right) / depth,
                              view.center_row - dot(way, view.up) / depth};
  }
};

using Chapter10 = Live<chapter_10::Lesson, MapAndGlobe>;

}  // namespace texmap::live
