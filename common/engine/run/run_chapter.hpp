// Runs a chapter: reads its command line, draws its lesson, saves the picture.
#pragma once
#include <cmath>
#include <concepts>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/draw/draw.hpp"
#include "engine/draw/kinds.hpp"
#include "engine/draw/lesson_surfaces.hpp"
#include "engine/draw/number_names.hpp"
#include "engine/fast/box_search.hpp"
#include "engine/files/save_png.hpp"
#include "engine/run/check_objects.hpp"
#include "engine/run/command_line.hpp"
#include "engine/run/gather_session.hpp"
#include "engine/run/planned_highlight.hpp"
#include "engine/run/session.hpp"
#include "engine/run/trade.hpp"
#include "engine/run/turntable.hpp"
#include "scene/sphere_choice.hpp"

namespace texmap {

template <class Lesson>
Image Session::draw(const Lesson& lesson, int width, int height) {
  if constexpr (HasSurfaces<Lesson>) {
    if (settings.show != Shown::color) {
      return timed(static_cast<double>(width) * height, [&](RenderSettings render_settings) {
        render_settings.samples = 1;  // through the center of each pixel
        const View<> seen = view(lesson.stage.camera, width, height);
        return render<double>(SurfaceColors<Lesson>{lesson, settings.show}, seen, render_settings);
      });
    }
  }
  if constexpr (std::derived_from<Lesson, GathersLight>) {
    return draw_gathered(*this, lesson, width, height);
  } else {
    return timed(static_cast<double>(width) * height * settings.samples,
                 [&](const RenderSettings& render_settings) {
                   const View<> seen = view(lesson.stage.camera, width, height);
                   return texmap::draw(lesson, seen, settings.number, render_settings);
                 });
  }
}

/// Lessons with a list of spheres, for which the user may choose formulas.
template <class Lesson>
concept HasSpheres = requires(const Lesson& lesson) {
  lesson.objects.front().shape.form;
};

/// Those whose scene is spheres or a mesh, a lamp, a camera, and a floor with a picture on it.
template <class Lesson>
concept HasMovableScene = std::derived_from<Lesson, HasMesh> || HasSpheres<Lesson>;

/// Lessons with a list of objects of which not all are known to be spheres.
template <class Lesson>
concept HasOtherShapes = requires(const Lesson& lesson) {
  requires !SphereLike<decltype(lesson.objects.front().shape)>;
};

/// What a program of a lesson offers its user: first the options of the lesson's groups.
template <class Lesson>
[[nodiscard]] Offer offer_of(Lesson& lesson, CommandLine& line) {
  Offer offer{.line = line,
              .camera = !std::derived_from<Lesson, SheetLesson>,
              .spheres = HasSpheres<Lesson>,
              .surfaces = HasSurfaces<Lesson>,
              .extremes = HasMovableScene<Lesson>,
              .one_number = !all_numbers};
  lesson.options().declare(offer);
  return offer;
}

/// Gives a lesson's spheres the formula that the user chose, or that they need.
template <class Lesson>
void choose_spheres(const Chosen& chosen, Lesson& lesson) {
  if constexpr (HasSpheres<Lesson>) {
    if (chosen.was_given("--spheres"))
      for (auto& object : lesson.objects) object.shape.form = chosen.settings.spheres;
    const bool in_float = is_float(chosen.settings.number);
    keep_to_domains(
        lesson.objects, lesson.stage.camera.eye,
        in_float ? std::numeric_limits<float>::digits : std::numeric_limits<double>::digits);
  }
}

/// Makes a lesson what the user chose.
template <class Lesson>
void build(Lesson& lesson, Chosen& chosen) {
  lesson.build(chosen);
  choose_spheres(chosen, lesson);
}

template <class Lesson>
void Session::save_frames(Lesson& lesson) {
  Turntable* turn = chosen.turntable;
  if (turn == nullptr || turn->frames == 0) return save(draw(lesson));
  for (int frame = 0; frame < turn->frames; ++frame) check_output(file_name(frame_suffix(frame)));
  for (turn->frame = 0; turn->frame < turn->frames; ++turn->frame) {
    if (turn->frame > 0) build(lesson, chosen);
    save(draw(lesson), frame_suffix(turn->frame));
  }
}

/// Which hooks a lesson overrides: `&Lesson::hook` is else a member of the base.
template <class Lesson>
inline constexpr bool has_options =
    !std::is_same_v<decltype(&Lesson::options), Groups (LessonHooks::*)()>;
template <class Lesson>
inline constexpr bool has_build =
    !std::is_same_v<decltype(&Lesson::build), void (LessonHooks::*)(Chosen&)>;
template <class Lesson>
inline constexpr bool draws_itself =
    !std::is_same_v<decltype(&Lesson::draw_all), void (LessonHooks::*)(Session&)>;

/// Draws and saves what a lesson shows.
template <class Lesson>
void draw_and_save(Lesson& lesson, Session& session) {
  if constexpr (draws_itself<Lesson>) {
    lesson.draw_all(session);
  } else {
    session.save_frames(lesson);
  }
}

/// A lesson with what its user chose, as its program has it after some words.
template <class Lesson>
struct Ready {
  Lesson lesson;
  CommandLine line;
  Chosen chosen;

  /// Reads the words; what is built comes next.
  Ready(const std::string& chapter, const std::vector<std::string>& words)
      : line(chapter, ""), chosen(chapter, offer_of(lesson, line), Lesson::about) {
    if (!line.parse(words)) throw std::runtime_error("no picture was asked for");
  }
};

/// What draws a lesson's picture as its program does after these words.
template <class Lesson>
std::function<Image()> drawing_by(const std::string& chapter,
                                  const std::vector<std::string>& words) {
  const auto ready = std::make_shared<Ready<Lesson>>(chapter, words);
  ready->chosen.check();
  // Its scene, in place of its sheet, which is wider.
  if (draws_itself<Lesson> && Lesson::about.size.width > 800) ready->chosen.default_size(800, 600);
  build(ready->lesson, ready->chosen);
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
    if (lesson.filtering.wrap != Mode::repeat && lesson.filtering.wrap != Mode::mirror) {
      throw UsageError(
          "--extremes moves the floor by whole copies of its picture: with --wrap clamp or border "
          "there is only one");
    }
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
      if (has_packs_of(each)) packs.push_back(each);
    }
    show_trade(chosen, line, words, packs, [&](const std::vector<std::string>& changed) {
      return drawing_by<Lesson>(chosen.chapter, changed);
    });
  }
  if constexpr (HasMovableScene<Lesson>) {
    if (chosen.extremes) {
      chosen.default_size(320, 240);
      chosen.settings.quiet = true;
      show_extremes(chosen, !has_only_double<Lesson>,
                    [&](bool in_float, double scale, double moved) {
                      return draw_elsewhere(chosen, lesson, in_float, scale, moved);
                    });
    }
  }
  return chosen.trade || chosen.extremes;
}

/// A chapter's main program: reads what the user chose, builds the lesson, draws and saves.
///
/// @param chapter  its folder's name, such as 02_checkerboard_uv
/// @tparam Lesson  derived from LessonHooks, with a static `about`, a `stage` with a camera, and an
///                 operator()(Ray) that returns a Color; a PathLesson has one for a sample's path
template <class Lesson>
[[nodiscard]] int run_chapter(const char* chapter, int argc, const char* const* argv) {
  static_assert(std::is_base_of_v<LessonHooks, Lesson>,
                "a lesson begins with `struct Lesson : LessonHooks`");
  static_assert(
      requires { Lesson::about.idea; },
      "a lesson says what it is about: static constexpr About about{.idea = ...}");
  static_assert(
      std::derived_from<Lesson, SheetLesson> || requires(Lesson lesson) { lesson.stage.camera; },
      "a lesson has a member `stage`, with a camera");
  static_assert(!has_options<Lesson> || has_build<Lesson> || draws_itself<Lesson>,
                "a lesson with `options` uses them in `void build(Chosen& chosen) override`: is "
                "that what it says?");
  static_assert(!std::derived_from<Lesson, GathersLight> || HasSpheres<Lesson>,
                "light is gathered from spheres alone: a PathLesson has a list of Painted<Paint> "
                "in `objects`. Other shapes are for lessons like those of 01 to 06");
  expect_little_memory();
  CommandLine line(chapter, Lesson::about.idea);
  return run_guarded(line, [&] {
    Lesson lesson;
    Chosen chosen(chapter, offer_of(lesson, line), Lesson::about);
    if (!line.parse(argc, argv)) return;
    chosen.check();
    build(lesson, chosen);
    if constexpr (HasOtherShapes<Lesson>) check_objects(lesson.objects, lesson.stage.camera);
    if constexpr (all_numbers && !std::derived_from<Lesson, SheetLesson>) {
      if (measures(lesson, chosen, line, typed_words(argc, argv))) return;
    }
    Session session(chosen);
    draw_and_save(lesson, session);
  });
}

}  // namespace texmap
