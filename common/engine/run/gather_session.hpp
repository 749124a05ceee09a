// Draws lessons that gather light, up to a number of samples, a time or an error.
#pragma once
#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/draw/develop.hpp"
#include "engine/draw/draw.hpp"
#include "engine/draw/number_names.hpp"
#include "engine/files/stopwatch.hpp"
#include "engine/run/command_line.hpp"
#include "engine/run/sampling_options.hpp"
#include "engine/run/session.hpp"
#include "scene/sphere_choice.hpp"

namespace texmap {

/// Gathers `samples` samples per pixel with the pattern of that number.
using GatherPattern = std::function<Film(int samples, std::uint32_t pattern)>;

/// All samples that the options ask for: one pattern or, with a limit, pairs of independent
/// patterns that double in size up to `most`. The difference of a pair estimates the error.
///
/// @param most          samples per pixel
/// @param error_so_far  set after each pair
/// Errors: UsageError if `most` is too small for a limit.
[[nodiscard]] Film gather_within_limits(const SamplingOptions& options, int most,
                                        std::atomic<double>& error_so_far,
                                        const GatherPattern& gather);

/// The error in the progress line; empty for +infinity.
[[nodiscard]] std::string remark_on_error(double error);

/// The sentence about a film's samples and its error.
[[nodiscard]] std::string describe_error(const Film& film, const SamplingOptions& options);

/// A lesson's objects with the paints of a plan; in programs for learning, as they are.
template <class Lesson>
[[nodiscard]] decltype(auto) objects_to_draw(const KernelPlan& plan, const Lesson& lesson) {
  if constexpr (all_numbers) {
    return planned_objects(plan, lesson.objects);
  } else {
    return (lesson.objects);
  }
}

/// The kernels that a budget allows for a globe; for all other paints the reference formulas.
///
/// @param reads  how many texels the picture reads
/// Errors: UsageError for a budget with another paint, which has no faster formulas.
template <class Paint>
[[nodiscard]] KernelPlan plan_for([[maybe_unused]] const Paint& paint, const Budget& budget,
                                  [[maybe_unused]] double reads) {
  if constexpr (std::is_same_v<Paint, GlobePaint>) {
    return plan_surface(budget, paint.texture.image, reads);
  } else {
    usage_error_if(!budget.is_exact(),
                   "--budget is for a globe with a picture in one of the conventions: this "
                   "lesson's paint has no faster formulas");
    return {};
  }
}

/// The picture of the light that a lesson gathers; prints the kernels, and leaves the sentence
/// about its error to the session.
template <class Lesson>
[[nodiscard]] Image draw_gathered(Session& session, const Lesson& lesson, int width, int height) {
  const Settings& settings = session.settings;
  const SamplingOptions& options = lesson.sampling;
  const bool limited = options.has_limit();
  const int most = limited && !session.chosen.was_given("--samples") ? 1 << 20 : settings.samples;
  const double reads = double{1} * width * height * most;
  if (!settings.budget.is_exact() && lesson.objects.size() > 1)
    throw UsageError("--budget is for a lone object, which lights no other: add --scene book");
  const KernelPlan plan = lesson.objects.empty()
                              ? KernelPlan{}
                              : plan_for(lesson.objects.front().paint, settings.budget, reads);
  usage_error_if(
      !settings.budget.is_exact() && is_float(settings.number) && !plan.floats_are_enough,
      "--budget: the rounding of float is larger than that: leave out --number, or allow more");
  if (session.chosen.was_given("--budget")) session.chosen.say(plan.text);
  const bool float_packs = plan.floats_are_enough && !session.chosen.was_given("--number");
  const NumberKind number = float_packs ? NumberKind::float_pack : settings.number;
  auto&& objects = objects_to_draw(plan, lesson);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(objects)>>) {
    if (float_packs)  // the spheres' forms were chosen for double
      keep_to_domains(objects, lesson.stage.camera.eye, std::numeric_limits<float>::digits);
  }
  const View<> view = session.view(lesson.stage.camera, width, height);

  std::atomic<double> error_so_far = infinity<double>();
  session.remark = [&error_so_far] { return remark_on_error(error_so_far); };
  Image image = session.timed(0, [&](RenderSettings render_settings) {
    Image picture;
    if (!limited) {  // each row is developed when it is complete
      picture = Image(width, height);
      render_settings.error_so_far = [&error_so_far](double error) { error_so_far = error; };
      render_settings.take_row = [&](int row, const Rgb* light) {
        develop_row(light, options.transfer, picture, row);
      };
    }
    const Stopwatch watch;
    const auto report = render_settings.progress;
    int before = 0;  // samples of the patterns that are complete
    const Film film =
        gather_within_limits(options, most, error_so_far, [&](int samples, std::uint32_t pattern) {
          render_settings.progress = [&, samples](int rows, int all_rows) {
            const double gathered = (before + double{1} * samples * rows / all_rows) / most;
            const double passed =
                options.time_limit > 0 ? watch.milliseconds() / (1000 * options.time_limit) : 0;
            report(static_cast<int>(1000 * std::min(1.0, std::max(passed, gathered))), 1000);
          };
          const auto bounds =
              bounds_of_view(objects, lesson.stage.sky, options.lens, plan.smoothing, samples);
          Film made = gather(lesson, objects, view, {Sampler(options.sampler, samples, pattern)},
                             bounds, number, render_settings);
          before += samples;
          return made;
        });
    session.count_rays(static_cast<double>(width) * height * static_cast<double>(film.samples()));
    session.sentence = describe_error(film, options);
    return limited ? develop(film, options.transfer, settings.threads) : std::move(picture);
  });
  session.remark = {};
  return image;
}

}  // namespace texmap
