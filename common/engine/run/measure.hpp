// Measures a lesson in place of drawing it: --trade and --extremes.
#pragma once
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/run/draw_lesson.hpp"
#include "engine/run/trade.hpp"

namespace texmap {

/// What draws a lesson's picture as its program does after these words.
template <class Lesson>
std::function<Image()> drawing_by(const std::string& chapter,
                                  const std::vector<std::string>& words) {
  const auto ready = std::make_shared<Ready<Lesson>>(chapter, words);
  ready->chosen.check();
  // Its scene, in place of its sheet, which is wider.
  if (draws_itself<Lesson> && Lesson::about.size.width > 800) ready->chosen.default_size(800, 600);
  ready->build();
  return [ready] { return Session(ready->chosen).draw(ready->lesson); };
}

/// The nearest move by whole copies of a floor's picture, which is mapped by a rotated point: the
/// floor then shows the same. By an even number of copies: every other one may be mirrored.
template <class Mapping>
Vec3d by_whole_copies(const Mapping& rotated, const Vec3d& by) {
  const auto [c, s] = rotated.rotation;
  const double two = 2 * rotated.mapping.size;
  const Vec3d turned = rotated.rotation(by);
  const double x = two * std::round(turned.x / two), z = two * std::round(turned.z / two);
  return {x * c - z * s, by.y, z * c + x * s};  // turned back
}

/// A lesson with all of its scene larger and moved, drawn in one number. The picture should not
/// change.
template <HasMovableScene Lesson>
Image draw_elsewhere(Chosen& chosen, Lesson lesson, bool in_float, double scale, double moved) {
  Vec3d by{moved, moved, moved};
  if constexpr (requires { lesson.floor, lesson.ground.mapping.mapping.size; }) {
    using Mode = decltype(lesson.filtering.wrap);
    usage_error_if(
        lesson.filtering.wrap != Mode::repeat && lesson.filtering.wrap != Mode::mirror,
        "--extremes moves the floor by whole copies of its picture: with --wrap clamp or border "
        "there is only one");
    lesson.ground.mapping.mapping.size *= scale;
    by = by_whole_copies(lesson.ground.mapping, by);
    lesson.floor.height = lesson.floor.height * scale + by.y;
  }
  const auto move = [&](Point& point) { point = point * scale + by; };
  move(lesson.stage.camera.eye);
  move(lesson.stage.camera.target);
  if constexpr (std::derived_from<Lesson, HasMesh>) {
    lesson.choice.place(lesson.scene, lesson.stage.camera, scale, by);
  } else {
    for (auto& object : lesson.objects) {
      move(object.shape.center);
      object.shape.radius *= scale;
    }
  }
  if constexpr (requires { lesson.stage.light; }) move(lesson.stage.light.position);
  if constexpr (std::derived_from<Lesson, GathersLight>) {
    lesson.sampling.lens.focus_distance *= scale;
    lesson.sampling.lens.shift *= scale;
  }
  if constexpr (requires { lesson.bumps; }) {
    lesson.bumps.relief *= scale;
    lesson.bumps.step *= scale;
  }
  Settings& settings = chosen.settings;
  settings.quiet = true;  // of one picture of many
  settings.number = in_float ? NumberKind::float_ : NumberKind::double_;
  if (!chosen.was_given("--samples")) settings.samples = std::min(settings.samples, 4);
  choose_spheres(chosen, lesson);
  return Session(chosen).draw(lesson);
}

/// Measures in place of drawing, if the user asked for that.
template <class Lesson>
[[nodiscard]] bool measures(const Lesson& lesson, Chosen& chosen, const CommandLine& line,
                            const std::vector<std::string>& words) {
  if (chosen.trade) {
    std::vector<Instructions> packs;
    for (const Instructions each : all_instructions) {
      const bool is_wanted =
          each == chosen.settings.instructions || !chosen.was_given("--instructions");
      if (is_wanted && has_packs_of(each)) packs.push_back(each);
    }
    show_trade(chosen, line, words, packs, [&](const std::vector<std::string>& changed) {
      return drawing_by<Lesson>(chosen.chapter, changed);
    });
  }
  if constexpr (HasMovableScene<Lesson>) {
    if (chosen.extremes) {
      chosen.default_size(320, 240);
      show_extremes(chosen, !has_only_double<Lesson>,
                    [&](bool in_float, double scale, double moved) {
                      return draw_elsewhere(chosen, lesson, in_float, scale, moved);
                    });
    }
  }
  return chosen.trade || chosen.extremes;
}

}  // namespace texmap
