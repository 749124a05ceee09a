// Runs a chapter: reads its command line, draws its lesson, saves the picture.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "command_line.hpp"
#include "studio.hpp"

namespace texmap {

/// Makes running out of memory end with a message and status 1 even where none is left to throw an exception with.
/// Called before anything else.
void expect_little_memory();

/// Calls `body` and turns what it throws into a message on stderr and an exit status: 1 for failures, 2 for a wrong command
/// line.
[[nodiscard]] int run_guarded(const CommandLine& line, const std::function<void()>& body);

/// A chapter's whole main program.
///
/// @param chapter  its folder's name, such as 02_checkerboard_uv
/// A lesson has an `idea`, a `stage` with a camera, and operator()(Ray) that gives a Color. Beyond that it may have
///   options(CommandLine&)   its own options,
///   prepare(Studio&)        what to do once they are known, such as loading a texture,
///   show(Studio&)           what to draw and save, if it is not one picture of the lesson,
///   single_numbers          a constant, if its code cannot run on packs or intervals: the user is then not offered them.
template <class Lesson>
[[nodiscard]] int run_chapter(const char* chapter, int argc, const char* const* argv) {
  expect_little_memory();
  CommandLine line(chapter, Lesson::idea);
  return run_guarded(line, [&] {
    Lesson lesson;
    if constexpr (requires { lesson.options(line); }) lesson.options(line);
    constexpr bool single = requires { Lesson::single_numbers; };
    Studio studio(chapter, line, single ? Offered::single : Offered::all);
    if constexpr (requires { lesson.objects; }) studio.offer_forms();
    if (!line.parse(argc, argv)) return;
    if constexpr (requires { lesson.prepare(studio); }) lesson.prepare(studio);
    studio.check();
    if constexpr (requires { lesson.objects; }) {
      for (auto& object : lesson.objects) object.sphere.form = studio.spheres;
    }
    if constexpr (requires { lesson.show(studio); }) {
      lesson.show(studio);
    } else {
      studio.save(studio.draw(lesson));
    }
  });
}

}  // namespace texmap
