// A chapter's lesson as something to be timed: its picture, on one thread.
#pragma once
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "engine/draw/develop.hpp"
#include "engine/fast/box_search.hpp"
#include "engine/run/planned_highlight.hpp"
#include "pictures.hpp"
#include "variants.hpp"

namespace texmap::bench {

struct Drawing {
  virtual ~Drawing() = default;
  virtual void run(const Variant& variant) = 0;
  /// The picture that one run draws.
  [[nodiscard]] virtual Image picture(const Variant& variant) = 0;
};
using MakeDrawing = std::function<std::shared_ptr<Drawing>()>;

/// A lesson and all that drawing it needs.
///
/// @tparam As  what its work is run as: itself, or InDouble
template <class Lesson, template <class> class As = std::type_identity_t>
class LessonWork : public Drawing {
 public:
  /// @param samples, plan  of lessons that gather light
  LessonWork(Lesson lesson, int width, int height, int samples = 8, KernelPlan plan = {})
      : lesson_(std::move(lesson)),
        plan_(std::move(plan)),
        objects_(objects_of(plan_, lesson_)),
        view_(view_of(lesson_.stage.camera, width, height)),
        sampler_(SamplerKind::sobol, samples),
        settings_{.threads = 1} {}
  LessonWork(const LessonWork&) = delete;  // planned objects point into the lesson
  LessonWork& operator=(const LessonWork&) = delete;

  void run(const Variant& variant) override {
    settings_.instructions = variant.instructions;
    if constexpr (std::derived_from<Lesson, GathersLight>) {
      auto bounds = bounds_of_view(objects_, lesson_.stage.sky, lesson_.sampling.lens,
                                   plan_.smoothing, sampler_.samples());
      if constexpr (requires { requires Lesson::is_traced_everywhere; }) bounds = {};
      run_work({lesson_, objects_, view_, sampler_, bounds, settings_}, variant);
    } else {
      run_work({lesson_, view_, settings_}, variant);
    }
  }
  [[nodiscard]] Image picture(const Variant& variant) override {
    run(variant);
    if constexpr (std::derived_from<Lesson, GathersLight>) {
      return develop(*result_, Transfer::srgb);
    } else {
      return *result_;
    }
  }

 private:
  using Work = WorkOf<Lesson>;

  [[nodiscard]] static auto objects_of(const KernelPlan& plan, const Lesson& lesson) {
    if constexpr (std::derived_from<Lesson, GathersLight>) {
      return planned_objects(plan, lesson.objects);
    } else {
      return std::false_type();
    }
  }
  void run_work(const Work& work, const Variant& variant) {
    result_ = run_in_number(As<Work>{work}, variant.number, variant.instructions);
  }

  Lesson lesson_;
  KernelPlan plan_;
  decltype(objects_of({}, std::declval<const Lesson&>())) objects_;
  View<> view_;
  Sampler sampler_;
  RenderSettings settings_;
  std::optional<typename Work::Result> result_;
};

}  // namespace texmap::bench
