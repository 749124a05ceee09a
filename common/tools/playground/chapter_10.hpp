// Chapter 10: the map beside the globe, and a point on one shown on the other.
#pragma once
#include <cmath>

#include "10_projections/lesson.hpp"
#include "figure.hpp"
#include "live.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::live {

struct MapAndGlobe {
  static constexpr int at_rest = 800;  ///< columns of a picture that no hand drags

  [[nodiscard]] static const auto& globe_of(const chapter_10::Lesson& lesson) {
    return std::get<chapter_10::Textured>(lesson.objects[chapter_10::middle].paint);
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
