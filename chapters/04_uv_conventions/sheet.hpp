// The sheet of conventions. For each source document: a globe, a labelled map, u, v, and the two
// ways to round to a texel.
#pragma once
#include <functional>

#include "engine/app/session.hpp"
#include "texture/conventions.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_04 {

using GlobePaint = Mapped<ConventionMapping, ImageTexture>;
/// The stage from nearby, its globe in this paint, in this size.
using DrawGlobe = std::function<Image(const GlobePaint& paint, int width, int height)>;

/// The sheet, as large as the session's picture. The flat maps use the published formulas.
[[nodiscard]] Image sheet_of_conventions(const Session& session, const Image& earth,
                                         const DrawGlobe& draw_globe);

/// The same for a lesson: only its globe's mapping changes from panel to panel.
template <class Lesson>
[[nodiscard]] Image sheet_of_conventions(const Lesson& lesson, Session& session) {
  return sheet_of_conventions(session, lesson.texture.load(),
                              [&](const GlobePaint& paint, int width, int height) {
                                Lesson globe = lesson;
                                globe.stage.camera.fov_y_degrees = 20;
                                globe.objects[0].paint = paint;
                                return session.draw(globe, width, height);
                              });
}

/// Saves the sheet and prints the table of relations.
void save_sheet(Session& session, const Image& sheet);

/// Draws and saves the sheet; the stage alone where the user chose a convention.
template <class Lesson>
void show_conventions(const Lesson& lesson, Session& session) {
  if (!session.was_given("--convention") && !session.was_given("--rounding"))
    return save_sheet(session, sheet_of_conventions(lesson, session));
  session.default_size(800, 600);
  session.save(session.draw(lesson));
}

}  // namespace texmap::chapter_04
