// The sheet of projections, the globe in one of them, and the conversion of a file.
#pragma once
#include <functional>

#include "engine/files/sheet_image.hpp"
#include "engine/run/projection_options.hpp"
#include "engine/run/session.hpp"
#include "texture/mapped.hpp"
#include "texture/projections.hpp"

namespace texmap::chapter_10 {

/// The stage from nearby in this size, its globe in this picture, which is equirectangular.
using DrawGlobe = std::function<Image(const Image& picture, int width, int height)>;

/// The sheet, as large as the session's picture, of a picture in the layout `from`; of its maps the
/// pixels that the session needs.
[[nodiscard]] SheetImage sheet_of_projections(const Session& session, const SharedImage& picture,
                                              Projection from, const DrawGlobe& draw_globe);

/// The same for a lesson: only its globe's paint changes.
template <class Lesson>
[[nodiscard]] SheetImage sheet_of_projections(Lesson& lesson, Session& session) {
  const auto draw_globe = [&](const Image& picture, int width, int height) {
    Lesson globe = lesson;
    globe.stage.camera.fov_y_degrees = 18;
    globe.objects[0].paint = Mapped<ProjectionMapping, ImageTexture>{{}, {picture}};
    return session.draw(globe, width, height);
  };
  return sheet_of_projections(session, lesson.texture.load(), lesson.layout.from, draw_globe);
}

/// Saves the sheet and prints the table of figures.
void save_sheet(Session& session, const Image& sheet);
/// Converts the texture's file, saves it, and says which layout the file probably has.
void save_converted(Session& session, TextureFile& file, const ProjectionOptions& layout);

/// Draws and saves what the user asked for.
template <class Lesson>
void show_projections(Lesson& lesson, Session& session) {
  if (lesson.layout.to) return save_converted(session, lesson.texture, lesson.layout);
  if (lesson.layout.projection) {
    session.chosen.default_size(800, 600);
    return session.save(session.draw(lesson));
  }
  save_sheet(session, sheet_of_projections(lesson, session));
}

}  // namespace texmap::chapter_10
