// What changed between two steps, and whether only that changed which the chapters declare.
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/run/draw_lesson.hpp"
#include "texture/uv.hpp"
#include "tools/page/page.hpp"

namespace texmap::steps {

/// A lesson's picture of the stage with everything that a comparison asks about it; or a picture
/// alone, with nothing at its pixels.
struct DrawnStep {
  std::string name;  ///< the chapter's folder, such as 02_checkerboard_uv, and the options
  Image picture;
  std::vector<int> objects;    ///< index of the object at each pixel's center, -1 for the sky
  std::vector<Uv<double>> uv;  ///< texture coordinates there; u is NaN where there are none
};

struct Drawing {
  int width = 800;
  int height = 600;
};

/// Draws a lesson's stage as its program does.
///
/// @param options  as they are typed; chapter 04 needs none: its stage is not its sheet
template <class Lesson>
[[nodiscard]] DrawnStep draw_step(const std::string& chapter, const Drawing& drawing,
                                  const std::vector<std::string>& options = {}) {
  Ready<Lesson> ready(chapter, options);
  ready.build();
  const Lesson& lesson = ready.lesson;
  const View<> view = view_of(lesson.stage.camera, drawing.width, drawing.height);
  DrawnStep step{chapter, draw(lesson, view, ready.chosen.settings.number, {}), {}, {}};
  for (const std::string& word : options) step.name += " " + word;
  for (int row = 0; row < drawing.height; ++row) {
    for (int column = 0; column < drawing.width; ++column) {
      const Surface<double> seen = surface_along(lesson, ray_through<double>(view, column, row));
      step.objects.push_back(seen.object);
      step.uv.push_back(seen.uv);
    }
  }
  return step;
}

/// A chapter that draws the stage: its pixels can be compared with those of another.
struct OnStage {
  std::string_view name;
  DrawnStep (*draw)(const std::string& chapter, const Drawing&,
                    const std::vector<std::string>& options);
  ObjectSet changed_objects;
};
template <class Lesson>
constexpr OnStage on_stage(std::string_view name) {
  return {name, draw_step<Lesson>, Lesson::about.changed_objects};
}

/// The chapters that draw the stage: stages.cmake lists them.
[[nodiscard]] const std::vector<OnStage>& stages();

struct Comparison {
  DrawnStep before, after;
  ObjectSet may_change;  ///< what the steps in between declare
  Figures figures;
  std::size_t changed_inside = 0;  ///< pixels that show, before or after, what may change
  std::size_t changed_elsewhere = 0;
  int stray_column = -1, stray_row = -1;  ///< the first that changed elsewhere; -1: there is none
  std::size_t pixels_with_uv = 0;         ///< where both steps have texture coordinates
  double largest_du = 0;                  ///< turns, the short way round, 0 to 1/2
  double largest_dv = 0;                  ///< 0 to 1
  std::string mistake;  ///< in words, the one that drew one of two pictures; empty if none is known
};

/// Errors: DifferenceError if the sizes differ.
[[nodiscard]] Comparison compare(DrawnStep before, DrawnStep after, ObjectSet may_change = {});

/// All figures as JSON.
[[nodiscard]] std::string report_json(const Comparison& comparison);

/// Lines for the terminal.
[[nodiscard]] std::string summary(const Comparison& comparison, const std::string& page);

/// Where the pictures of a page go.
struct Pictures {
  std::filesystem::path folder;  ///< the page's; empty: they go into the page, which is one file
  std::filesystem::path drawn;   ///< has the chapters' own pictures, which pages then share

  /// @param file  its name in the folder of the page
  [[nodiscard]] page::Picture show(const Image& image, const std::string& file) const;
  /// A step's picture: that of its chapter, or of one before, where it has the same pixels.
  [[nodiscard]] page::Picture show(const DrawnStep& step, const std::string& file) const;
  /// The picture in a file of the drawn ones.
  [[nodiscard]] page::Picture show(const std::filesystem::path& file) const;
};

/// The C++ files of a checkout's chapters: their texts by their places.
using Files = std::map<std::string, std::string>;

/// A chapter on a page: its lesson and its picture; or a checkout with the files that differ.
struct Code {
  std::string chapter;            ///< its folder
  std::string text;               ///< of its lesson
  std::filesystem::path picture;  ///< that it drew; empty if there is none
};

/// The page of two steps on the same stage, with their code; or of two pictures, without.
[[nodiscard]] std::string report_page(const Comparison& comparison, const Code& before,
                                      const Code& after, const Pictures& pictures);

/// The page of two chapters, or checkouts, with no pixels to compare.
/// @param why  there are none, or what differs; the page says so
[[nodiscard]] std::string code_page(const Code& before, const Code& after, const std::string& why,
                                    const Pictures& pictures);

}  // namespace texmap::steps
