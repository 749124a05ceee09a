// A chapter drawn for a comparison: its picture, and what is seen at each pixel.
#pragma once
#include <chrono>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "command_line.hpp"
#include "nearest.hpp"
#include "painted.hpp"
#include "studio.hpp"
#include "uv.hpp"

namespace texmap::steps {

/// A lesson's picture of the stage with everything that a comparison asks about it.
struct DrawnStep {
  std::string chapter;  ///< its folder, such as 02_checkerboard_uv
  Image picture;
  std::vector<int> objects;     ///< index of the object at each pixel's center, -1 for the sky
  std::vector<Uv<double>> uv;   ///< texture coordinates there, NaN where the paint has none
  std::vector<int> may_change;  ///< the objects that this step may change from the one before
  double milliseconds = 0;      ///< time of drawing, the least of three
};

/// The (u, v) with which a paint is looked up at a hit; NaN for a paint that has none.
template <class Paint>
[[nodiscard]] Uv<double> uv_of_paint(const Paint& paint, const Hit<double>& hit) {
  if constexpr (requires { paint.mapping(hit.normal); }) {
    return paint.mapping(hit.normal);
  } else {
    return {std::nan(""), std::nan("")};
  }
}
template <class... Paints>
[[nodiscard]] Uv<double> uv_of_paint(const AnyOf<Paints...>& paint, const Hit<double>& hit) {
  return std::visit([&hit](const auto& one) { return uv_of_paint(one, hit); },
                    static_cast<const std::variant<Paints...>&>(paint));
}

/// Draws a lesson as its program does without options. Chapter 04's sheet is not a picture of the stage: its stage is drawn.
template <class Lesson>
[[nodiscard]] DrawnStep draw_step(const std::string& chapter, int width, int height, int threads) {
  Lesson lesson;
  CommandLine line(chapter, "");
  Studio studio(chapter, line);
  studio.quiet = true;
  studio.width = width;
  studio.height = height;
  studio.threads = threads;
  if constexpr (requires { lesson.prepare(studio); }) lesson.prepare(studio);

  DrawnStep step;
  step.chapter = chapter;
  if constexpr (requires { Lesson::changed_objects; }) {
    for (const int object : Lesson::changed_objects) step.may_change.push_back(object);
  }
  step.milliseconds = infinity<double>();
  for (int repeat = 0; repeat < 3; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    step.picture = studio.draw(lesson);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    step.milliseconds = smaller(elapsed.count(), step.milliseconds);
  }

  const View view = view_of(lesson.stage.camera, width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Ray<double> ray = ray_through<double>(view, column, row);
      const Nearest<double> nearest = find_nearest(lesson.objects, ray);
      step.objects.push_back(static_cast<int>(nearest.index));
      if (nearest.index < 0) {
        step.uv.push_back({std::nan(""), std::nan("")});
        continue;
      }
      const auto& object = lesson.objects[static_cast<std::size_t>(nearest.index)];
      step.uv.push_back(uv_of_paint(object.paint, hit_at(object.sphere, ray, nearest.distance)));
    }
  }
  return step;
}

}  // namespace texmap::steps
