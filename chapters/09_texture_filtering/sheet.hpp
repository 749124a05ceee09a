// The sheet of filters: the same scene by each of them.
#pragma once
#include <functional>

#include "engine/app/session.hpp"
#include "texture/filters.hpp"

namespace texmap::chapter_09 {

/// The scene by a filter, in a size.
using DrawFiltered = std::function<Image(Filter filter, int width, int height)>;

/// Draws and saves the sheet, prints the table of errors and reads, and saves their plot if asked.
void show_sheet(Session& session, const std::string& plot, const DrawFiltered& draw);

/// Draws and saves the sheet; one picture where the user chose a filter.
template <class Lesson>
void show_filters(const Lesson& lesson, Session& session) {
  if (session.was_given("--filter")) {
    session.default_size(800, 600);
    return session.save(session.draw(lesson));
  }
  show_sheet(session, lesson.filtering.plot, [&](Filter filter, int width, int height) {
    Lesson one = lesson;
    one.use(filter);
    return session.draw(one, width, height);
  });
}

}  // namespace texmap::chapter_09
