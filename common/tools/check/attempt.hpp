// The student's function, in a file that CMake writes for each exercise.
#pragma once
#include <any>
#include <functional>
#include <string>

namespace texmap::check {

struct Attempt {
  std::string id;         ///< "02.1", or empty for a program that only answers questions
  std::any function;      ///< a std::function
  std::string signature;  ///< that it must have: "Uv uv_of(Vec3 p)"
};
extern const Attempt attempt;

}  // namespace texmap::check
