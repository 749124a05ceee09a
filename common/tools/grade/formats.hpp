// A student's grades in the formats that learning systems read.
#pragma once
#include <string>

#include "grades.hpp"

namespace texmap::grade {

enum class Format { none, gradescope, classroom, junit };

/// results.json of a Gradescope autograder.
[[nodiscard]] std::string gradescope_json(const Student& student);
/// What a step of GitHub Classroom's autograding reports, before base64.
[[nodiscard]] std::string classroom_json(const Student& student);
/// The same as two notices that any program of a workflow may print.
[[nodiscard]] std::string classroom_notices(const Student& student);
/// A JUnit file with the fields that ctest --output-junit writes.
[[nodiscard]] std::string junit_xml(const Student& student);

}  // namespace texmap::grade
