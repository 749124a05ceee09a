// Draws and saves a lesson as its user chose: the verb draw.
#pragma once
#include <concepts>

#include "engine/draw/draw.hpp"
#include "engine/draw/kinds.hpp"
#include "engine/draw/lesson_surfaces.hpp"
#include "engine/fast/box_search.hpp"
#include "engine/files/save_png.hpp"
#include "engine/run/gather_session.hpp"
#include "engine/run/planned_highlight.hpp"
#include "engine/run/ready.hpp"
#include "engine/run/session.hpp"
#include "engine/run/turntable.hpp"

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

/// Draws and saves what a lesson shows.
template <class Lesson>
void draw_and_save(Lesson& lesson, Session& session) {
  if constexpr (draws_itself<Lesson>) {
    lesson.draw_all(session);
  } else {
    session.save_frames(lesson);
  }
}

}  // namespace texmap
