// Prints what stands on the sheets of the chapters, for the book, which shows their golden pictures
// piece by piece with the words as text: docs/sheets.txt. A line for each sheet, picture and line
// of text, in the order in which they are laid:
//   sheet CHAPTER WIDTH HEIGHT WORDS
//   picture LEFT TOP WIDTH HEIGHT
//   text WORDS
#include <iostream>
#include <sstream>

#include "04_uv_conventions/conventions_compared.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "10_projections/lesson.hpp"
#include "13_speed_for_accuracy/lesson.hpp"
#include "13_speed_for_accuracy/show.hpp"
#include "14_numerical_extremes/lesson.hpp"
#include "engine/run/draw_lesson.hpp"

namespace texmap::test {
namespace {

/// A picture of a sheet, or a line of text on it.
void print_part(const SheetPart& part) {
  if (part.width > 0) {
    std::cout << "picture " << part.left << ' ' << part.top << ' ' << part.width << ' '
              << part.height << '\n';
  } else if (!part.words.empty()) {
    std::cout << "text " << part.words << '\n';
  }
}

/// @param words  what the book needs to know beside the sheet
void print_sheet(const char* chapter, const SheetImage& sheet, const std::string& words = "") {
  std::cout << "sheet " << chapter << ' ' << sheet.width << ' ' << sheet.height << words << '\n';
  for (const SheetPart& part : sheet.parts) print_part(part);
}

/// A lesson without an option, with a session that draws its sheet.
template <class Lesson>
struct Drawing {
  Ready<Lesson> ready{"page_sheets", {}};
  Session session{ready.chosen};

  Drawing() { ready.build(); }
};

}  // namespace
}  // namespace texmap::test

int main() {
  using namespace texmap;
  using namespace texmap::test;
  Drawing<chapter_04::Lesson> conventions;
  print_sheet("04_uv_conventions",
              sheet_of_conventions(conventions.ready.lesson, conventions.session));
  const std::string table = chapter_04::table_of_relations();
  std::istringstream lines(table.substr(table.find("\n\n") + 2));
  for (std::string line; std::getline(lines, line) && !line.empty();) print_part({line, 0, 0});

  Drawing<chapter_09::Lesson> filters;
  const auto figures = chapter_09::compare_filters(floor_of(filters.ready.lesson), 0, false);
  print_sheet(
      "09_texture_filtering",
      sheet_of_filters(filters.session, figures, drawn_by(filters.ready.lesson, filters.session)));

  Drawing<chapter_10::Lesson> projections;
  print_sheet("10_projections",
              sheet_of_projections(projections.ready.lesson, projections.session));

  const auto [width, height] = chapter_13::Lesson::about.size;
  const chapter_13::Globe globe(chapter_13::Lesson{}.texture.load());
  print_sheet("13_speed_for_accuracy", draw_sheet(globe, width, height, 0, [](int, int) {}));

  Drawing<chapter_14::Lesson> extremes;
  const auto exhibits = extremes.ready.lesson.exhibits();
  std::string names;  // in the order of the sheet
  for (const auto& exhibit : exhibits) names += ' ' + exhibit.name;
  print_sheet("14_numerical_extremes", draw_sheet(exhibits, extremes.session).picture, names);
}
