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
#include "engine/files/sheet.hpp"
#include "engine/run/run_chapter.hpp"

namespace texmap::test {
namespace {

void print_part(const SheetPart& part) {
  if (part.width > 0) {
    std::cout << "picture " << part.left << ' ' << part.top << ' ' << part.width << ' '
              << part.height << '\n';
  } else if (!part.words.empty()) {
    std::cout << "text " << part.words << '\n';
  }
}

/// @param words  what the book needs to know beside the sheet
template <class Lesson>
void print_head(const char* chapter, const std::string& words = "") {
  std::cout << "sheet " << chapter << ' ' << Lesson::about.size.width << ' '
            << Lesson::about.size.height << words << '\n';
}

template <class Lesson>
int print_sheet(const char* chapter, const std::string& words = "") {
  print_head<Lesson>(chapter, words);
  constexpr std::array options{"", "--quiet", "--out", "/dev/null"};
  return run_chapter<Lesson>(chapter, options.size(), options.data());
}

/// The names of the exhibits, in the order of the sheet.
std::string exhibits() {
  std::string names;
  for (const auto& exhibit : chapter_14::Lesson{}.exhibits()) names += ' ' + exhibit.name;
  return names;
}

}  // namespace
}  // namespace texmap::test

int main() {
  using namespace texmap;
  using namespace texmap::test;
  on_sheet_part = print_part;
  int failed = print_sheet<chapter_04::Lesson>("04_uv_conventions");
  const std::string table = chapter_04::table_of_relations();
  std::istringstream lines(table.substr(table.find("\n\n") + 2));
  for (std::string line; std::getline(lines, line) && !line.empty();) print_part({line, 0, 0});
  failed += print_sheet<chapter_09::Lesson>("09_texture_filtering");
  failed += print_sheet<chapter_10::Lesson>("10_projections");
  print_head<chapter_13::Lesson>("13_speed_for_accuracy");
  const auto [width, height] = chapter_13::Lesson::about.size;
  const chapter_13::Globe globe(chapter_13::Lesson{}.texture.load());
  static_cast<void>(draw_sheet(globe, width, height, 0, [](int, int) {}));
  return failed + print_sheet<chapter_14::Lesson>("14_numerical_extremes", exhibits());
}
