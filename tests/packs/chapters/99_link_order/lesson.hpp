// A lesson with a color from a function of plain numbers that every file of its program contains:
// main.cpp, for any machine, and one file for each set of wide instructions. The order of linking
// decides which of them the program keeps.
#pragma once
#include <array>
#include <type_traits>

#include "engine/draw/lesson.hpp"
#include "scene/stage.hpp"

namespace texmap::chapter_99 {

/// A sum that a compiler for wide instructions makes of wide instructions.
[[gnu::noinline]] inline double plain_sum(const std::array<double, 16>& terms, double factor) {
  std::array<double, 16> products{};
  for (std::size_t i = 0; i < terms.size(); ++i) products[i] = terms[i] * factor + terms[15 - i];
  double sum = 0;
  for (const double product : products) sum += product;
  return sum;
}

struct Lesson : LessonHooks {
  static constexpr About about{.idea = "which of equal functions the linker keeps"};

  Stage stage;
  std::array<double, 16> terms{0.01, 0.02, 0.03};

  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    if constexpr (std::is_class_v<Real> && lanes<Real> == 1)
      return gray(ray.direction.y);
    else
      return gray(from_lanes<Real>([&](std::size_t i) {
        return static_cast<Scalar<Real>>(
            plain_sum(terms, static_cast<double>(lane(ray.direction.y, i))));
      }));
  }
};

}  // namespace texmap::chapter_99
