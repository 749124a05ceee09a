// The sheet of filters: the same scene by each of them.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparison.hpp"
#include "engine/files/sheet_image.hpp"
#include "engine/run/filter_options.hpp"
#include "engine/run/session.hpp"
#include "plan.hpp"
#include "texture/filters.hpp"

namespace texmap::chapter_09 {

/// The scene by a filter, in a size.
using DrawFiltered = std::function<Image(Filter filter, int width, int height)>;

/// The sheet, as large as the session's picture, with each filter's reads and error.
///
/// @param all  empty: with the filters' names alone
[[nodiscard]] SheetImage sheet_of_filters(const Session& session,
                                          const std::vector<FilterFigures>& all,
                                          const DrawFiltered& draw);

/// Draws and saves the sheet, prints the table of errors and reads, and saves their plot if asked.
///
/// @param floor  nothing where none is seen: then there are no errors
/// Errors: UsageError for a plot without a floor.
void show_sheet(Session& session, const std::optional<FloorView>& floor, const std::string& plot,
                const DrawFiltered& draw);

/// A lesson's floor as the figures need it.
template <class Lesson>
[[nodiscard]] FloorView floor_of(const Lesson& lesson) {
  return {lesson.stage.camera, lesson.floor, lesson.ground.mapping};
}

/// A lesson's scene by any filter. Must not outlive the session.
template <class Lesson>
[[nodiscard]] DrawFiltered drawn_by(const Lesson& lesson, Session& session) {
  return [other = lesson, &session](Filter filter, int width, int height) mutable {
    read_by(other, filter, other.filtering.taps);
    return session.draw(other, width, height);
  };
}

/// Draws and saves the sheet; one picture where the user chose a filter or a budget.
template <class Lesson>
void show_filters(Lesson& lesson, Session& session) {
  if (session.chosen.was_given("--filter") || !session.settings.budget.is_exact()) {
    session.chosen.default_size(800, 600);
    return session.save(session.draw(lesson));
  }
  std::optional<FloorView> floor;
  if (lesson.filtering.scene != FilterScene::globe) floor = floor_of(lesson);
  show_sheet(session, floor, lesson.filtering.plot, drawn_by(lesson, session));
}

}  // namespace texmap::chapter_09
