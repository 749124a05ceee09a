// What the chapter tests do with pictures: draw a lesson, count differences, average a crop.
#pragma once
#include <algorithm>
#include <type_traits>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/run/draw_lesson.hpp"
#include "scene/nearest.hpp"
#include "support/made_pictures.hpp"

namespace texmap::test {

/// Whether a lesson's code can be run with a number: its `about` says so, and a build for learning
/// has double alone.
template <class Lesson, class Real>
constexpr bool draws_in = [] {
  if constexpr (std::is_same_v<Real, double>) {  // lessons of tests have no `about`
    return true;
  } else {
    constexpr Numbers numbers = Lesson::about.numbers;
    return all_numbers && (numbers == Numbers::all ||
                           (numbers != Numbers::only_double && std::is_floating_point_v<Real>));
  }
}();

/// A number, or double where a lesson cannot be run with that number.
template <class Lesson, class Real>
using number_in = std::conditional_t<draws_in<Lesson, Real>, Real, double>;

/// A lesson's picture in a number, or in double.
template <class Real = double, class Lesson>
[[nodiscard]] Image picture(const Lesson& lesson, int width = 800, int height = 600) {
  return render<number_in<Lesson, Real>>(lesson, view_of(lesson.stage.camera, width, height));
}

/// How many pixels differ by more than `levels`; all of them where the sizes differ.
[[nodiscard]] inline long count_different(const Image& a, const Image& b, int levels = 0) {
  if (a.width != b.width || a.height != b.height)
    return static_cast<long>(std::max(a.pixels.size(), b.pixels.size()));
  long count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    count += channel_difference(a.pixels[i], b.pixels[i]) > levels ? 1 : 0;
  return count;
}

/// Calls `look` with the ray of every pixel, in their order.
template <class Look>
void for_each_ray(const View<>& view, const Look& look) {
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column)
      look(ray_through<double>(view, column, row));
  }
}

/// The index of the object seen at each pixel's center, -1 for the sky.
template <class Lesson>
[[nodiscard]] std::vector<int> objects_seen(const Lesson& lesson, int width = 800,
                                            int height = 600) {
  std::vector<int> seen;
  for_each_ray(view_of(lesson.stage.camera, width, height), [&](const Ray<double>& ray) {
    seen.push_back(static_cast<int>(find_nearest(lesson.objects, ray).index));
  });
  return seen;
}

/// The step contract: how many pixels differ although the object they show may not change.
[[nodiscard]] inline long changed_elsewhere(const Image& before, const Image& after,
                                            const std::vector<int>& seen,
                                            const ObjectSet& allowed) {
  long count = 0;
  for (std::size_t i = 0; i < before.pixels.size(); ++i) {
    const bool may_change = seen[i] >= 0 && allowed.contains(seen[i]);
    count += before.pixels[i] != after.pixels[i] && !may_change ? 1 : 0;
  }
  return count;
}

struct Mean {
  double r = 0, g = 0, b = 0;
};

/// The mean of each channel, in levels, over a rectangle.
[[nodiscard]] inline Mean mean_of(const Image& image, int left, int top, int width, int height) {
  Mean sum;
  for (int row = top; row < top + height; ++row) {
    for (int column = left; column < left + width; ++column) {
      const Rgb8 p = image.at(column, row);
      sum = {sum.r + p.r, sum.g + p.g, sum.b + p.b};
    }
  }
  const double count = static_cast<double>(width) * height;
  return {sum.r / count, sum.g / count, sum.b / count};
}

/// The picture with columns and rows in the other order where that is said.
[[nodiscard]] inline Image turned(const Image& image, bool columns, bool rows) {
  return image_of(image.width, image.height, [&](int x, int y) {
    return image.at(columns ? image.width - 1 - x : x, rows ? image.height - 1 - y : y);
  });
}
[[nodiscard]] inline Image upside_down(const Image& image) { return turned(image, false, true); }
[[nodiscard]] inline Image mirrored(const Image& image) { return turned(image, true, false); }

}  // namespace texmap::test
