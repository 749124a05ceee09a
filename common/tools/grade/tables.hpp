// grades.csv and points.csv.
#pragma once
#include <string>

#include "grades.hpp"

namespace texmap::grade {

/// The names of the columns, after the byte order mark that tells spreadsheets: this is UTF-8.
[[nodiscard]] std::string grades_csv_head();
/// A line of grades.csv.
[[nodiscard]] std::string grades_csv_line(const Student& student, const Row& row);
/// grades.csv as a whole; its first line says so if programs were not contained.
[[nodiscard]] std::string grades_csv(const Class& all);
/// points.csv: a line for each student.
[[nodiscard]] std::string points_csv(const Class& all);

}  // namespace texmap::grade
