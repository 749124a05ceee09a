// What grading finds out: a row for each student and item, the rows of a student, a class.
#pragma once
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "texture/image.hpp"

namespace texmap::grade {

/// Something that is graded: a chapter, or an exercise such as 02.1.
struct Item {
  std::string name;    ///< 03_image_texture
  std::string number;  ///< 03: what stands in the head of a table
  std::filesystem::path golden;
  bool has_tests = false;     ///< a checkout's tests are worth a point
  std::string exercise = {};  ///< the file of an exercise, in a checkout; empty for a chapter
};

/// How far a picture is from the golden one.
struct PictureFigures {
  std::size_t pixels_off = 0;  ///< by more than one level
  double share_off = 0;        ///< of all pixels, 0 to 1
  double rmse = 0;             ///< levels, 0 to 255
  double ssim = 1;
};

/// The part of a wrong picture that a page shows.
struct ShownPicture {
  Image is, should, map;
  std::string where;  ///< columns and rows of the whole picture
};

/// One student's result for one item. Words are the student's or the compiler's: not yet escaped.
struct Row {
  std::string item;
  std::string exercise;     ///< the file of an exercise, in a checkout; empty for a chapter
  std::string word;         ///< ok, mirrored, differs 2.5 %, missing, does not build, ...
  std::string note;         ///< the reason in words; empty if there is nothing to say
  std::string build;        ///< ok, missing, does not build; empty for a folder of pictures
  std::string run;          ///< ok, crashed SIGSEGV, hang, ...; empty likewise
  std::string containment;  ///< bwrap, unshare, none; empty likewise
  std::string cpu_seconds;
  std::string limit_cpu_seconds;
  std::optional<PictureFigures> figures;
  bool picture_ok = false;
  std::string hidden;  ///< yes, no: the second picture; empty if there was none
  bool with_tests = false;
  std::size_t tests_passed = 0, tests_run = 0;
  bool cached = false;
  std::optional<ShownPicture> shown;

  /// "4 of 5"; empty if no tests ran.
  [[nodiscard]] std::string tests() const {
    if (tests_run == 0) return "";
    return std::to_string(tests_passed) + " of " + std::to_string(tests_run);
  }
  [[nodiscard]] bool tests_ok() const { return tests_run > 0 && tests_passed == tests_run; }
  [[nodiscard]] bool picture_point() const { return picture_ok && hidden != "no"; }
  /// An exercise is right or not; of a chapter, picture and tests are.
  [[nodiscard]] int points() const {
    if (!exercise.empty()) return int{tests_ok()};
    return int{picture_point()} + int{with_tests && tests_ok()};
  }
  [[nodiscard]] int of() const { return exercise.empty() && with_tests ? 2 : 1; }
  [[nodiscard]] bool right() const { return points() == of(); }
};

/// One student.
struct Student {
  std::string folder;  ///< as the instructor named it
  std::string name;
  std::string page;  ///< name of the page's file without .html; unique in a class
  std::string note;
  std::vector<Row> rows;  ///< in the order of the items

  [[nodiscard]] int points() const {
    int sum = 0;
    for (const Row& row : rows) sum += row.points();
    return sum;
  }
  [[nodiscard]] int of() const {
    int sum = 0;
    for (const Row& row : rows) sum += row.of();
    return sum;
  }
  /// False if a program ran without a box around it.
  [[nodiscard]] bool contained() const {
    return std::none_of(rows.begin(), rows.end(),
                        [](const Row& row) { return row.containment == "none"; });
  }
  /// A page shows something that the table does not.
  [[nodiscard]] bool has_page() const {
    return !note.empty() || std::any_of(rows.begin(), rows.end(), [](const Row& row) {
      return !row.right() || !row.note.empty();
    });
  }
};

/// All that is graded in one run.
struct Class {
  std::vector<Item> items;
  std::vector<Student> students;
  std::size_t asked = 0;  ///< folders to grade; more than students if the run was ended

  /// Empty; or that the run was ended before all of a student's was graded.
  [[nodiscard]] std::string unfinished(const Student& student) const {
    if (student.rows.size() >= items.size()) return "";
    return "ended with " + std::to_string(student.rows.size()) + " of " +
           std::to_string(items.size()) + " graded";
  }
  [[nodiscard]] bool contained() const {
    return std::all_of(students.begin(), students.end(),
                       [](const Student& student) { return student.contained(); });
  }
};

inline constexpr const char* not_contained =
    "NOT CONTAINED: students' programs ran with your rights and could change any file, this one "
    "too.";

}  // namespace texmap::grade
