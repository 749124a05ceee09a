// Runs a chapter: reads its command line, draws its lesson, saves the picture.
#pragma once
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "engine/app/command_line.hpp"
#include "engine/app/gather_session.hpp"
#include "engine/app/planned_highlight.hpp"
#include "engine/app/session.hpp"
#include "engine/app/turntable.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/render/draw.hpp"
#include "engine/render/number_names.hpp"
#include "engine/render/surfaces.hpp"
#include "scene/sphere_choice.hpp"

namespace texmap {

template <class Lesson>
Image Session::draw(const Lesson& lesson, int width, int height) {
  if constexpr (HasSurfaces<Lesson>) {
    if (settings.show != Shown::color) {
      return timed(static_cast<double>(width) * height, [&](RenderSettings render_settings) {
        render_settings.samples = 1;  // through the center of each pixel
        const View<> seen = view(lesson.stage.camera, width, height);
        const SurfaceColors<Lesson> surfaces{lesson, settings.show};
        if constexpr (has_only_double<Lesson>) {
          return render<double>(surfaces, seen, render_settings);
        } else {  // packs would draw the same, so single numbers do
          const NumberKind number = settings.number;
          return draw_single(surfaces, seen, is_float(number) ? NumberKind::float_ : number,
                             render_settings);
        }
      });
    }
  }
  return timed(static_cast<double>(width) * height * settings.samples,
               [&](const RenderSettings& render_settings) -> Image {
                 const View<> seen = view(lesson.stage.camera, width, height);
                 if constexpr (GathersLight<Lesson>) {
                   throw std::logic_error("light is gathered, see show_gathered");
                 } else {
                   return texmap::draw(lesson, seen, settings.number, render_settings);
                 }
               });
}

/// Draws and saves one picture of a lesson.
template <class Lesson>
void show_picture(Session& session, const Lesson& lesson, const std::string& suffix = "") {
  if constexpr (GathersLight<Lesson>) {
    if (session.settings.show == Shown::color) return show_gathered(session, lesson, suffix);
  }
  session.save(session.draw(lesson), suffix);
}

/// Lessons with a list of spheres, for which the user may choose formulas.
template <class Lesson>
concept HasSpheres = requires(const Lesson& lesson) {
  lesson.objects.front().shape.form;
};

/// Gives a lesson's spheres the formula that the user chose, or that they need.
template <class Lesson>
void choose_spheres(const Session& session, Lesson& lesson) {
  if constexpr (HasSpheres<Lesson>) {
    if (session.was_given("--spheres"))
      for (auto& object : lesson.objects) object.shape.form = session.settings.spheres;
    const bool in_float = is_float(session.settings.number);
    keep_to_domains(
        lesson.objects, lesson.stage.camera.eye,
        in_float ? std::numeric_limits<float>::digits : std::numeric_limits<double>::digits);
  }
}

/// Calls a lesson's hook, and chooses the formulas of the spheres that it made.
template <class Lesson>
void prepare(Session& session, Lesson& lesson) {
  lesson.prepare(session);
  choose_spheres(session, lesson);
}

template <class Lesson>
void Session::draw_all(Lesson& lesson) {
  Turntable* turn = line_.wishes.turntable;
  if (turn == nullptr || turn->frames == 0) return show_picture(*this, lesson);
  for (int frame = 0; frame < turn->frames; ++frame) check_output(file_name(frame_suffix(frame)));
  for (const auto& keep : line_.wishes.before_frames) keep();
  for (turn->frame = 0; turn->frame < turn->frames; ++turn->frame) {
    prepare(*this, lesson);
    show_picture(*this, lesson, frame_suffix(turn->frame));
  }
}

/// What a session offers for a lesson.
template <class Lesson>
[[nodiscard]] constexpr Offers offers_for(const Lesson& /*lesson*/) {
  return {
      .spheres = HasSpheres<Lesson>, .surfaces = HasSurfaces<Lesson>, .one_number = !all_numbers};
}

/// True for a lesson that overrides `draw_all`: `&Lesson::draw_all` is else a member of the base.
template <class Lesson>
inline constexpr bool draws_itself =
    !std::is_same_v<decltype(&Lesson::draw_all), void (LessonHooks::*)(Session&)>;

/// Draws and saves what a lesson shows with the options that were read.
template <class Lesson>
void draw_and_save(Session& session, Lesson& lesson) {
  prepare(session, lesson);
  session.check();
  session.plan();
  if constexpr (draws_itself<Lesson>) {
    lesson.draw_all(session);
  } else {
    session.check_uses();
    session.draw_all(lesson);
  }
}

/// A chapter's main program.
///
/// @param chapter  its folder's name, such as 02_checkerboard_uv
/// @tparam Lesson  derived from LessonHooks, with a static `about`, a `stage` with a camera, and an
///                 operator()(Ray) that returns a Color; to gather light, `sampling` and an
///                 operator() for one sample (see gather.hpp)
template <class Lesson>
[[nodiscard]] int run_chapter(const char* chapter, int argc, const char* const* argv) {
  static_assert(std::is_base_of_v<LessonHooks, Lesson>,
                "a lesson begins with `struct Lesson : LessonHooks`");
  static_assert(
      requires { Lesson::about.idea; },
      "a lesson says what it is about: static constexpr About about{.idea = ...}");
  static_assert(!GathersLight<Lesson> || HasSpheres<Lesson>,
                "light is gathered from spheres alone: a lesson with `sampling` has a list of "
                "Painted<Paint> in `objects`. Other shapes are for lessons like those of 01 to 06");
  expect_little_memory();
  CommandLine line(chapter, Lesson::about.idea);
  return run_guarded(line, [&] {
    Lesson lesson;
    lesson.options(line);
    Session session(chapter, line, Lesson::about, offers_for(lesson));
    if (!line.parse(argc, argv)) return;
    draw_and_save(session, lesson);
  });
}

}  // namespace texmap
