// The pages of a class: the table of all students, and a page for a student where there is more to
// see than the table shows.
#pragma once
#include <string>

#include "grades.hpp"

namespace texmap::grade {

/// index.html: the worst first, sortable, with a row of sums such as "37 of 200 mirrored".
[[nodiscard]] std::string class_page(const Class& all);

/// The student's page, complete in itself: what is not right, with small pictures.
[[nodiscard]] std::string student_page(const Student& student);

}  // namespace texmap::grade
