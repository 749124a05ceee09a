// What the tests of chapters that sample do with films: draw one of a lesson, compare two.
#pragma once
#include <cstdint>

#include "engine/draw/draw.hpp"
#include "engine/run/budget_options.hpp"
#include "support/pictures.hpp"

namespace texmap::test {

/// How a film is drawn, apart from how many samples it has.
struct Drawn {
  Size size = {64, 36};
  int threads = 0;
  SamplerKind kind = SamplerKind::sobol;
  std::uint32_t seed = 0;
};

/// The film of a lesson, with the kernels of a plan; in double where it has no other number.
template <class Real = double, class Lesson>
[[nodiscard]] Film film_of(const Lesson& lesson, int samples, const Drawn& drawn = {},
                           const KernelPlan& plan = {}) {
  const View<> view = view_of(lesson.stage.camera, drawn.size.width, drawn.size.height);
  const auto objects = planned_objects(plan, lesson.objects);
  return gather<number_in<Lesson, Real>>(
      lesson, objects, view, {Sampler(drawn.kind, samples, drawn.seed)},
      bounds_of_view(objects, lesson.stage.sky, lesson.sampling.lens, plan.smoothing, samples),
      {.threads = drawn.threads});
}

/// Root mean square difference of two films, over pixels and channels.
[[nodiscard]] inline double apart(const Film& a, const Film& b) {
  return 2 * error_of_halves(a, b);
}

/// Calls `look` with the light of every pixel.
template <class Look>
void for_each_pixel(const Film& film, const Look& look) {
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) look(film.light(column, row));
  }
}

}  // namespace texmap::test
