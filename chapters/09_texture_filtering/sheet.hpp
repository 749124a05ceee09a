// The sheet of filters: the same scene by each of them.
#pragma once
#include <functional>

#include "comparison.hpp"
#include "engine/app/session.hpp"
#include "plan.hpp"
#include "texture/filters.hpp"

namespace texmap::chapter_09 {

/// The scene by a filter, in a size.
using DrawFiltered = std::function<Image(Filter filter, int width, int height)>;

/// Draws and saves the sheet, prints the table of errors and reads, and saves their plot if asked.
void show_sheet(Session& session, const FloorView& floor, const std::string& plot,
                const DrawFiltered& draw);

/// Draws and saves the sheet; one picture where the user chose a filter or a budget.
template <class Lesson>
void show_filters(Lesson lesson, Session& session) {
  if (const auto plan = plan_by_budget(planned_scene(lesson), session)) {
    lesson.use(plan->filter, plan->taps);
    return session.save(session.draw(lesson));
  }
  if (session.was_given("--filter")) {
    session.default_size(800, 600);
    return session.save(session.draw(lesson));
  }
  const FloorView floor{lesson.stage.camera, lesson.floor, lesson.ground.mapping};
  show_sheet(session, floor, lesson.filtering.plot, [&](Filter filter, int width, int height) {
    lesson.use(filter, lesson.filtering.taps);
    return session.draw(lesson, width, height);
  });
}

}  // namespace texmap::chapter_09
