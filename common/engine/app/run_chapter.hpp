// Runs a chapter: reads its command line, draws its lesson, saves the picture.
#pragma once
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

#include "engine/app/command_line.hpp"
#include "engine/app/gather_session.hpp"
#include "engine/app/planned_highlight.hpp"
#include "engine/app/run_guarded.hpp"
#include "engine/app/session.hpp"
#include "engine/app/turntable.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/render/draw.hpp"
#include "engine/render/surfaces.hpp"
#include "math/rotation.hpp"
#include "scene/sphere_choice.hpp"

namespace texmap {

/// The surfaces of a lesson's scene, from one ray through the center of each pixel. Packs would
/// draw the same as single numbers.
template <HasSurfaces Lesson>
[[nodiscard]] Image draw_surfaces(const Lesson& lesson, const View<>& view, Shown shown,
                                  NumberKind number, RenderSettings settings) {
  settings.samples = 1;
  const SurfaceColors<Lesson> surfaces{lesson, shown};
  if constexpr (Lesson::about.numbers == Numbers::only_double) {
    return render<double>(surfaces, view, settings);
  } else {
    const bool in_float = number == NumberKind::float_pack;
    return draw_single(surfaces, view, in_float ? NumberKind::float_ : number, settings);
  }
}

template <class Lesson>
Image Session::draw(const Lesson& lesson, int width, int height) {
  if constexpr (HasSurfaces<Lesson>) {
    if (settings.show != Shown::color) {
      return timed(static_cast<double>(width) * height, [&](const RenderSettings& render_settings) {
        return draw_surfaces(lesson, view(lesson.stage.camera, width, height), settings.show,
                             settings.number, render_settings);
      });
    }
  }
  return timed(static_cast<double>(width) * height * settings.samples,
               [&](const RenderSettings& render_settings) -> Image {
                 const View<> seen = view(lesson.stage.camera, width, height);
                 if constexpr (GathersLight<Lesson>) {
                   throw std::logic_error("light is gathered, see show_gathered");
                 } else if constexpr (Lesson::about.numbers == Numbers::all) {
                   return texmap::draw(lesson, seen, settings.number, render_settings);
                 } else if constexpr (Lesson::about.numbers == Numbers::single) {
                   return texmap::draw_single(lesson, seen, settings.number, render_settings);
                 } else {
                   return render<double>(lesson, seen, render_settings);
                 }
               });
}

/// Sets the rotation of a paint if its mapping has one.
template <class Paint>
void turn_paint(Paint& paint, const RotationY& rotation) {
  if constexpr (requires { paint.mapping.rotation; }) paint.mapping.rotation = rotation;
}
template <class... Paints>
void turn_paint(AnyOf<Paints...>& paint, const RotationY& rotation) {
  std::visit([&rotation](auto& one) { turn_paint(one, rotation); },
             static_cast<std::variant<Paints...>&>(paint));
}

/// Draws and saves one picture of a lesson.
template <class Lesson>
void show_picture(Session& session, const Lesson& lesson, const std::string& suffix = "") {
  if constexpr (GathersLight<Lesson>) {
    if (session.settings.show == Shown::color) return show_gathered(session, lesson, suffix);
  }
  session.save(session.draw(lesson), suffix);
}

/// Draws and saves all frames of a lesson's turntable, one numbered picture after another.
template <class Lesson>
void show_turntable(Session& session, Lesson& lesson) {
  const int frames = lesson.turn.frames;
  for (int frame = 0; frame < frames; ++frame) {
    check_output(session.file_name(frame_suffix(frame)));
  }
  for (int frame = 0; frame < frames; ++frame) {
    for (auto& object : lesson.objects) turn_paint(object.paint, lesson.turn.rotation(frame));
    show_picture(session, lesson, frame_suffix(frame));
  }
}

/// True for a lesson that overrides `show`.
template <class Lesson>
inline constexpr bool shows_itself =
    !std::is_same_v<decltype(&Lesson::show), void (LessonHooks::*)(Session&)>;

/// The digits of a number in base 2; those of double for all that have more.
[[nodiscard]] constexpr int digits(NumberKind number) {
  const bool is_float = number == NumberKind::float_ || number == NumberKind::float_pack;
  return is_float ? std::numeric_limits<float>::digits : std::numeric_limits<double>::digits;
}

/// Lessons with a list of spheres, for which the user may choose formulas.
template <class Lesson>
concept HasSpheres = requires(const Lesson& lesson) {
  lesson.objects.front().shape.form;
};

/// What a session offers for a lesson.
template <class Lesson>
[[nodiscard]] Offers offers_for(const Lesson& lesson) {
  Offers offers;
  offers.spheres = HasSpheres<Lesson>;
  offers.surfaces = HasSurfaces<Lesson>;
  offers.camera = requires { lesson.stage.camera; };
  offers.one_number = !all_numbers;
  if constexpr (GathersLight<Lesson>) {
    if constexpr (requires { lesson.texture; }) {
      offers.budget =
          "the allowed error: exact, texels=0.01 (a place on the texture) or levels=1 (a byte of "
          "the picture); prints which fast formulas it chooses";
    }
    offers.no_intervals = "it bounds the error of one ray, not the noise of random samples";
    offers.samples = lesson.sampling.samples;
    offers.most_samples = most_samples;
  } else if constexpr (requires { lesson.phong; }) {
    offers.budget =
        "the allowed error of Phong's highlight: exact or levels=1; prints which fast formula it "
        "chooses";
  } else if constexpr (requires { lesson.filtering; }) {
    offers.budget =
        "the allowed error of textured pixels: exact or levels=4; prints which filter it chooses";
    offers.no_intervals =
        "where rounding leaves open which level a filter reads, the bound would be too wide to be "
        "of use";
  }
  return offers;
}

inline constexpr const char* unused_texture =
    "the lesson offers --texture and never loads it: is its hook spelt `prepare`? Write `override` "
    "after it, and the compiler checks the name";

/// Chooses the formulas of a lesson's spheres and of its highlight, after `prepare`.
template <class Lesson>
void choose_formulas(Session& session, Lesson& lesson) {
  if constexpr (HasSpheres<Lesson>) {
    if (session.was_given("--spheres"))
      for (auto& object : lesson.objects) object.shape.form = session.settings.spheres;
    keep_to_domains(lesson.objects, lesson.stage.camera.eye, digits(session.settings.number));
  }
  if constexpr (requires { lesson.phong; }) {
    lesson.phong.plan(session, read_budget(session.settings.budget));
  }
}

/// Draws and saves what a lesson shows with the options that were read.
template <class Lesson>
void draw_and_save(Session& session, Lesson& lesson) {
  lesson.prepare(session);
  session.check();
  if constexpr (requires { lesson.texture.loaded; } && !shows_itself<Lesson>) {
    if (!lesson.texture.loaded) throw std::logic_error(unused_texture);
  }
  if constexpr (requires { lesson.filtering; }) {
    if (session.settings.zoom != 1 && session.was_given("--budget"))
      throw UsageError("--budget chooses a filter for the whole picture: leave --zoom out");
  }
  choose_formulas(session, lesson);
  if constexpr (shows_itself<Lesson>) {
    lesson.show(session);
    return;
  } else {
    if constexpr (requires { lesson.turn.frames; }) {
      if (lesson.turn.frames > 0) return show_turntable(session, lesson);
    }
    show_picture(session, lesson);
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
