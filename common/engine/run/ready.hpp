// A lesson and what its user chose: the verbs read and build.
#pragma once
#include <algorithm>
#include <concepts>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/draw/draw.hpp"
#include "engine/draw/lesson_surfaces.hpp"
#include "engine/draw/number_names.hpp"
#include "engine/run/chosen.hpp"
#include "engine/run/command_line.hpp"
#include "engine/run/session.hpp"
#include "scene/camera.hpp"
#include "scene/sphere_choice.hpp"

namespace texmap {

/// Lessons with a list of spheres, for which the user may choose formulas.
template <class Lesson>
concept HasSpheres = requires(const Lesson& lesson) {
  lesson.objects.front().shape.form;
};

/// Those whose scene is spheres or a mesh, a lamp, a camera, and a floor with a picture on it.
template <class Lesson>
concept HasMovableScene = std::derived_from<Lesson, HasMesh> || HasSpheres<Lesson>;

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

/// What a program of a lesson offers its user: first the options of the lesson's groups.
template <class Lesson>
[[nodiscard]] Offer offer_of(Lesson& lesson, CommandLine& line) {
  Offer offer{.line = line,
              .camera = !std::derived_from<Lesson, SheetLesson>,
              .spheres = HasSpheres<Lesson>,
              .surfaces = HasSurfaces<Lesson>,
              .extremes = HasMovableScene<Lesson>,
              .one_number = !all_numbers};
  const Groups groups = lesson.options();
  for (const void* member : groups.members) {
    if (std::less<>()(member, &lesson) || !std::less<>()(member, &lesson + 1))
      throw std::logic_error("`options` names groups that are members of the lesson");
  }
  groups.declare(offer);
  if constexpr (std::derived_from<Lesson, GathersLight>) {
    if (std::count(groups.members.begin(), groups.members.end(), &lesson.sampling) == 0)
      throw std::logic_error("a PathLesson names `sampling` in `options`: its samples, its lens");
  }
  return offer;
}

/// Gives a lesson's spheres the formula that the user chose, or that they need.
template <class Lesson>
void choose_spheres(const Chosen& chosen, Lesson& lesson) {
  if constexpr (HasObjects<Lesson>) {
    if (chosen.was_given("--spheres")) {
      for (auto& object : lesson.objects)
        if_sphere(object.shape, [&](auto& sphere) { sphere.form = chosen.settings.spheres; });
    }
    const bool in_float = is_float(chosen.settings.number);
    keep_to_domains(
        lesson.objects, lesson.stage.camera.eye,
        in_float ? std::numeric_limits<float>::digits : std::numeric_limits<double>::digits);
  }
}

/// Errors: std::logic_error for a camera without a view, and for a sphere that no ray can meet.
template <class Lesson>
void check_scene(Lesson& lesson) {
  const auto refuse_if = [](bool refused, const std::string& why) {
    if (refused) throw std::logic_error(why);
  };
  if constexpr (requires { lesson.stage.camera; }) {
    const Camera& camera = lesson.stage.camera;
    const Vec3d ahead = camera.target - camera.eye;
    refuse_if(
        !(abs(ahead.x) + abs(ahead.z) > 0),
        "the camera's `target` must differ from its `eye` in x or z: straight up or down, the "
        "picture has no upper side. Move one of them by 0.001");
    refuse_if(!(camera.fov_y_degrees > 0 && camera.fov_y_degrees < 180),
              "the camera's `fov_y_degrees` is not between 0 and 180");
  }
  if constexpr (HasObjects<Lesson>) {
    int number = 0;
    for (auto& object : lesson.objects) {
      if_sphere(object.shape, [&](const auto& sphere) {
        refuse_if(!(sphere.radius > 0),
                  "object " + std::to_string(number) + ": its radius is not above 0");
      });
      ++number;
    }
  }
}

/// Makes a lesson what the user chose.
template <class Lesson>
void build(Lesson& lesson, Chosen& chosen) {
  lesson.build(chosen);
  check_scene(lesson);
  choose_spheres(chosen, lesson);
}

/// A lesson with what its user chose, as its program has it after some words.
template <class Lesson>
struct Ready {
  Lesson lesson;
  CommandLine line;
  Chosen chosen;

  /// Reads the words; build() comes next.
  Ready(const std::string& chapter, const std::vector<std::string>& words)
      : line(chapter, ""), chosen(chapter, offer_of(lesson, line), Lesson::about) {
    if (!line.parse(words)) throw std::runtime_error("no picture was asked for");
  }
  void build() { texmap::build(lesson, chosen); }
};

/// A lesson as its program has it after these words: for tests and for the exercises.
template <class Lesson>
[[nodiscard]] Lesson prepared(const std::vector<std::string>& words = {}) {
  Ready<Lesson> ready("test", words);
  ready.chosen.settings.quiet = true;  // what is said is about a program's picture
  ready.build();
  return std::move(ready.lesson);
}

}  // namespace texmap
