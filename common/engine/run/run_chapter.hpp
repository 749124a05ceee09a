// Runs a chapter: reads its command line, draws its lesson, saves the picture.
#pragma once
#include <concepts>
#include <type_traits>

#include "engine/files/system.hpp"
#include "engine/run/check_objects.hpp"
#include "engine/run/draw_lesson.hpp"
#include "engine/run/measure.hpp"

namespace texmap {

/// Lessons with a list of objects of which not all are known to be spheres.
template <class Lesson>
concept HasOtherShapes = requires(const Lesson& lesson) {
  requires !SphereLike<decltype(lesson.objects.front().shape)>;
};

/// A chapter's main program: reads what the user chose, builds the lesson, draws and saves.
///
/// @param chapter  its folder's name, such as 02_checkerboard_uv
/// @tparam Lesson  derived from LessonHooks, with a static `about`, a `stage` with a camera, and an
///                 operator()(Ray) that returns a Color; a PathLesson has one for a sample's path
template <class Lesson>
[[nodiscard]] int run_chapter(const char* chapter, int argc, const char* const* argv) {
  static_assert(std::derived_from<Lesson, LessonHooks>,
                "a lesson begins with `struct Lesson : LessonHooks`");
  static_assert(
      requires { requires std::bool_constant<(*Lesson::about.idea != 0)>::value; },
      "a lesson is a struct that says what it is about: static constexpr About about{.idea = ...}");
  static_assert(
      std::derived_from<Lesson, SheetLesson> || requires(Lesson lesson) { lesson.stage.camera; },
      "a lesson has a member `stage`, with a camera");
  static_assert(!has_options<Lesson> || has_build<Lesson> || draws_itself<Lesson>,
                "a lesson with `options` uses them in `void build(Chosen& chosen) override`: is "
                "that what it says?");
  static_assert(!std::derived_from<Lesson, GathersLight> || HasSpheres<Lesson>,
                "light is gathered from spheres alone: a PathLesson has a list of Painted<Paint> "
                "in `objects`. Other shapes are for lessons like those of 01 to 06");
  static_assert(
      !HasOtherShapes<Lesson> ||
          requires(const Lesson& lesson) {
            { lesson.objects.front().shape } -> Shape;
          },
      "a shape has distance_to, hit_at and a const convex(), as scene/shapes.hpp says: one of them "
      "is missing. What is derived from Sphere has its own");
  expect_little_memory();
  if constexpr (!all_numbers) expect_wrong_index();
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
