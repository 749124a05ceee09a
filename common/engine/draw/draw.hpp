// Draws a lesson with the number that the user chose.
#pragma once
#include <concepts>
#include <optional>
#include <vector>

#include "engine/draw/certainty_map.hpp"
#include "engine/draw/gather.hpp"
#include "engine/draw/lesson.hpp"
#include "engine/draw/number_names.hpp"
#include "engine/draw/render.hpp"
#include "number/kinds/pack2.hpp"

namespace texmap {

/// Which numbers the code of what is drawn compiles for: a lesson says it in `about`, and all else
/// compiles for all. In the order of `Numbers`, each has less than the one before.
template <class Drawn>
[[nodiscard]] constexpr Numbers numbers_of() {
  if constexpr (std::derived_from<Drawn, LessonHooks>) {
    return Drawn::about.numbers;
  } else {
    return Numbers::all;
  }
}
template <class Drawn>
inline constexpr bool compiles_for_packs = numbers_of<Drawn>() <= Numbers::no_intervals;
template <class Lesson>
inline constexpr bool has_only_double = numbers_of<Lesson>() == Numbers::only_double;

/// Draws a lesson's picture with any number that its code compiles for.
template <class Lesson, bool packs = compiles_for_packs<Lesson>>
struct DrawWork {
  using Result = Image;
  static constexpr bool for_packs = packs;

  const Lesson& lesson;
  const View<>& view;
  const RenderSettings& settings;

  template <class Real>
  [[nodiscard]] Image run() const {
    return render<Real>(lesson, view, settings);
  }
};

/// Gathers a lesson's light with any number.
template <class Lesson, class Paint>
struct GatherWork {
  using Result = Film;
  static constexpr bool for_packs = compiles_for_packs<Lesson>;

  const Lesson& lesson;
  const std::vector<Painted<Paint>>& objects;  ///< the lesson's or a plan's
  const View<>& view;
  const Sampler& sampler;
  std::optional<ViewBounds> bounds;
  const RenderSettings& settings;

  template <class Real>
  [[nodiscard]] Film run() const {
    return gather<Real>(lesson, objects, view, sampler, bounds, settings);
  }
};

template <class Lesson>
struct WorkOfLesson {
  using Type = DrawWork<Lesson>;
};
template <std::derived_from<GathersLight> Lesson>
struct WorkOfLesson<Lesson> {
  template <class Paint>
  static GatherWork<Lesson, Paint> work(const std::vector<Painted<Paint>>& objects);
  using Type = decltype(work(planned_objects(KernelPlan{}, std::declval<const Lesson&>().objects)));
};
/// The work that draws a lesson. wide_packs.cpp.in uses this name.
template <class Lesson>
using WorkOf = typename WorkOfLesson<Lesson>::Type;

/// Runs a work with packs of one instruction set, two packs at a time (0.7 to 0.8 of the time).
///
/// @param number  float_pack or double_pack
template <class Arch, class Work>
[[nodiscard]] typename Work::Result run_in_packs(const Work& work, NumberKind number) {
  if (number == NumberKind::float_pack) return work.template run<Pack2<Pack<float, Arch>>>();
  return work.template run<Pack2<Pack<double, Arch>>>();
}

/// The same with wider instructions: defined in files that CMake adds for each set, called only on
/// machines that have them.
template <Instructions instructions, class Work>
[[nodiscard]] typename Work::Result run_in_wide_packs(const Work& work, NumberKind number);

/// Runs a work with a number; with double if it cannot be run with that one.
template <class Work>
[[nodiscard]] typename Work::Result run_in_number(const Work& work, NumberKind number,
                                                  [[maybe_unused]] Instructions instructions) {
  if constexpr (all_numbers) {
    if (number == NumberKind::float_) return work.template run<float>();
  }
  if constexpr (all_numbers && wide_numbers) {
    if (number == NumberKind::extended) return work.template run<long double>();
  }
  if constexpr (all_numbers && pack_numbers) {
    if constexpr (Work::for_packs) {
      if (is_pack(number)) {
#ifdef TEXMAP_WIDE_PACKS
        if (instructions == Instructions::avx512)
          return run_in_wide_packs<Instructions::avx512>(work, number);
        if (instructions == Instructions::avx2)
          return run_in_wide_packs<Instructions::avx2>(work, number);
#endif
        return run_in_packs<simd::default_arch>(work, number);
      }
    }
  }
  return work.template run<double>();
}

/// The picture of a lesson, drawn with `number`.
template <class Lesson>
[[nodiscard]] Image draw(const Lesson& lesson, const View<>& view, NumberKind number,
                         const RenderSettings& settings) {
  if constexpr (has_only_double<Lesson>) {
    return render<double>(lesson, view, settings);
  } else {
    if constexpr (all_numbers && numbers_of<Lesson>() == Numbers::all) {
      if (number == NumberKind::interval) return draw_certainty_map(lesson, view, settings);
    }
    return run_in_number(DrawWork<Lesson>{lesson, view, settings}, number, settings.instructions);
  }
}

/// The light of a lesson, gathered with `number`.
///
/// @param objects  the lesson's or a plan's
/// @param bounds   as bounds_of_view gives them
template <class Lesson, class Paint>
[[nodiscard]] Film gather(const Lesson& lesson, const std::vector<Painted<Paint>>& objects,
                          const View<>& view, const Sampler& sampler,
                          const std::optional<ViewBounds>& bounds, NumberKind number,
                          const RenderSettings& settings) {
  const GatherWork<Lesson, Paint> work{lesson, objects, view, sampler, bounds, settings};
  if constexpr (has_only_double<Lesson>) {
    return work.template run<double>();
  } else {
    return run_in_number(work, number, settings.instructions);
  }
}

}  // namespace texmap
