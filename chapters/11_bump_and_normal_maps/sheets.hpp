// The chapter's sheets: bump or dent, the pole, the daily exercise's bricks.
#pragma once
#include <algorithm>
#include <functional>

#include "engine/draw/settings.hpp"
#include "engine/run/bump_options.hpp"
#include "engine/run/session.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "texture/image.hpp"

namespace texmap::chapter_11 {

/// Eight ways to read one normal map, by three programs, each with the word it deserves.
[[nodiscard]] Image sheet_of_readings(int width);

/// The daily exercise's picture of 23 February 2026, drawn by our own code; 800 x 600 is its size.
[[nodiscard]] Image published_bricks(int width, int height);

/// The same ball from nearby, as published and as it was meant.
[[nodiscard]] Image sheet_of_bricks(int width);

/// Two pictures under their captions.
[[nodiscard]] Image side_by_side(const Image& left, const char* left_caption, const Image& right,
                                 const char* right_caption);

/// The lesson seen from above its pole, with waves in (u, v) and with waves in space.
template <class Lesson>
[[nodiscard]] Image sheet_of_poles(const Lesson& lesson, Session& session) {
  const int half = std::max(1, session.settings.width / 2);
  const auto from_above = [&](HeightKind height) {
    Lesson globe = lesson;
    globe.bump.height = height;
    globe.objects[0].paint = Solid{white};
    globe.bump.relief = 0.02;
    globe.stage.light.position = {-12, 9, 2};
    globe.stage.camera.eye = {0, 5.5, 2.4};
    globe.stage.camera.target = {0, 0.7, 0.1};
    globe.stage.camera.fov_y_degrees = 17;
    globe.build(session.chosen);
    return session.draw(globe, half, half);
  };
  return side_by_side(from_above(HeightKind::uv), "waves in (u, v): they crowd at the pole",
                      from_above(HeightKind::space), "waves in space: no pole, no seam");
}

/// Draws and saves what the user asked for.
template <class Lesson>
void show_bumps(Lesson& lesson, Session& session) {
  const auto size = [&](int width, int height) { session.chosen.default_size(width, height); };
  const auto drawn = [&](const std::function<Image(int width)>& draw_sheet) {
    const double width = session.settings.width;
    session.save(session.timed(width * session.settings.height, [&](const RenderSettings&) {
      return draw_sheet(session.settings.width);
    }));
  };
  switch (lesson.bump.picture) {
    case BumpPicture::globe:
      return session.save_frames(lesson);
    case BumpPicture::sheet:
      size(1600, 868);
      return drawn(sheet_of_readings);
    case BumpPicture::poles:
      size(1000, 514);
      return session.save(sheet_of_poles(lesson, session));
    case BumpPicture::daily:
      size(1000, 514);
      return drawn(sheet_of_bricks);
  }
}

}  // namespace texmap::chapter_11
