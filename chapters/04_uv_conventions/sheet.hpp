// The sheet of conventions. For each source document: a globe, a labelled map, u, v, and the two
// ways to round to a texel.
#pragma once
#include <algorithm>
#include <array>
#include <functional>

#include "engine/files/sheet_image.hpp"
#include "engine/run/session.hpp"
#include "texture/conventions.hpp"

namespace texmap::chapter_04 {

/// The stage from nearby, its globe in this convention, in this size.
using DrawGlobe = std::function<Image(Convention convention, int width, int height)>;

/// The sheet, as large as the session's picture. The flat maps use the published formulas.
[[nodiscard]] SheetImage sheet_of_conventions(const Session& session, const DrawGlobe& draw_globe);

/// The same for a lesson: only its convention changes from panel to panel.
template <class Lesson>
[[nodiscard]] SheetImage sheet_of_conventions(Lesson globe, Session& session) {
  globe.stage.camera.fov_y_degrees = 20;
  return sheet_of_conventions(session, [&](Convention convention, int width, int height) {
    globe.layout.convention = convention;
    globe.build(session.chosen);
    return session.draw(globe, width, height);
  });
}

/// Saves the sheet and prints the table of relations.
void save_sheet(Session& session, const Image& sheet);

/// Draws and saves the sheet; the stage alone where the user chose how its globe looks.
template <class Lesson>
void show_conventions(const Lesson& lesson, Session& session) {
  constexpr std::array of_the_globe{"--convention", "--rounding",  "--uv-scale",
                                    "--uv-turn",    "--uv-offset", "--wrap"};
  if (std::none_of(of_the_globe.begin(), of_the_globe.end(),
                   [&](const char* option) { return session.chosen.was_given(option); }))
    return save_sheet(session, sheet_of_conventions(lesson, session));
  session.chosen.default_size(800, 600);
  session.save(session.draw(lesson));
}

}  // namespace texmap::chapter_04
