// grades.csv and points.csv.
#include "tables.hpp"

#include <vector>

#include "engine/measure/text.hpp"
#include "safe_text.hpp"

namespace texmap::grade {
namespace {

constexpr const char* byte_order_mark = "\xEF\xBB\xBF";

std::string line(const std::vector<std::string>& cells) {
  std::string result;
  for (const std::string& cell : cells) {
    if (!result.empty()) result += ',';
    result += csv_cell(cell);
  }
  return result + "\r\n";
}

}  // namespace

std::string grades_csv_head() {
  return byte_order_mark +
         line({"student", "chapter", "build", "run", "seconds", "pixels_off", "share_off", "rmse",
               "ssim", "picture_ok", "tests", "note", "verdict", "points", "of",
               "second_picture_ok", "limit_seconds", "contained_by", "folder"});
}

std::string grades_csv_line(const Student& student, const Row& row) {
  std::vector<std::string> cells = {student.name, row.item, row.build, row.run, row.cpu_seconds};
  if (row.figures) {
    cells.push_back(std::to_string(row.figures->pixels_off));
    cells.push_back(text("%.8f", row.figures->share_off));
    cells.push_back(text("%.6f", row.figures->rmse));
    cells.push_back(text("%.6f", row.figures->ssim));
  } else {
    cells.resize(cells.size() + 4);
  }
  cells.emplace_back(!row.exercise.empty() ? "" : row.picture_ok ? "yes" : "no");
  cells.push_back(row.tests());
  cells.insert(cells.end(),
               {row.note, row.word, std::to_string(row.points()), std::to_string(row.of()),
                row.hidden, row.limit_cpu_seconds, row.containment, student.folder});
  return line(cells);
}

std::string grades_csv(const Class& all) {
  std::string table = grades_csv_head();
  // The byte order mark stays first, or a spreadsheet would not read the file as UTF-8.
  if (!all.contained()) table.insert(3, line({not_contained}));
  for (const Student& student : all.students) {
    for (const Row& row : student.rows) table += grades_csv_line(student, row);
  }
  return table;
}

std::string points_csv(const Class& all) {
  std::string table = byte_order_mark;
  if (!all.contained()) table += line({not_contained});
  table += line({"folder", "name", "points", "of", "chapters", "page", "note"});
  for (const Student& student : all.students) {
    table += line({student.folder, student.name, std::to_string(student.points()),
                   std::to_string(student.of()), std::to_string(student.rows.size()), student.page,
                   student.note.empty() ? all.unfinished(student) : student.note});
  }
  return table;
}

}  // namespace texmap::grade
