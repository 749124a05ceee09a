// A chapter drawn for a comparison: its picture, and what is seen at each pixel.
#pragma once
#include <string>
#include <vector>

#include "engine/app/run_chapter.hpp"
#include "texture/uv.hpp"

namespace texmap::steps {

/// A lesson's picture of the stage with everything that a comparison asks about it.
struct DrawnStep {
  std::string chapter;  ///< its folder, such as 02_checkerboard_uv, and the options drawn with
  Image picture;
  std::vector<int> objects;     ///< index of the object at each pixel's center, -1 for the sky
  std::vector<Uv<double>> uv;   ///< texture coordinates there; u is NaN where there are none
  std::vector<int> may_change;  ///< the objects that this step may change from the one before
};

/// Draws a lesson's stage as its program does.
///
/// @param options  as they are typed; chapter 04 needs none: its stage is not its sheet
template <class Lesson>
[[nodiscard]] DrawnStep draw_step(const std::string& chapter, int width, int height, int threads,
                                  const std::vector<std::string>& options = {}) {
  Lesson lesson;
  CommandLine line(chapter, "");
  lesson.options(line);
  Session session(chapter, line, Lesson::about, offers_for(lesson));
  static_cast<void>(line.parse(options));
  session.settings.quiet = true;
  session.settings.width = width;
  session.settings.height = height;
  session.settings.threads = threads;
  lesson.prepare(session);

  DrawnStep step;
  step.chapter = chapter;
  for (const std::string& word : options) step.chapter += " " + word;
  for (int object = 0; object < static_cast<int>(lesson.objects.size()); ++object) {
    if (Lesson::about.changed_objects.contains(object)) step.may_change.push_back(object);
  }
  step.picture = session.draw(lesson);

  const View<> view = view_of(lesson.stage.camera, width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Surface<double> seen = surface_along(lesson, ray_through<double>(view, column, row));
      step.objects.push_back(seen.object);
      step.uv.push_back(seen.uv);
    }
  }
  return step;
}

}  // namespace texmap::steps
