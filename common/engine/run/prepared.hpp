// A lesson made ready without its program: for tests and for the exercises.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/run/run_chapter.hpp"

namespace texmap {

/// Makes a lesson ready as its program does when the user types these words.
///
/// @return  the settings that the user chose
template <class Lesson>
Settings make_ready(Lesson& lesson, const std::vector<std::string>& words = {}) {
  CommandLine line("test", "");
  Chosen chosen("test", offer_of(lesson, line), Lesson::about);
  if (!line.parse(words)) throw std::runtime_error("no picture was asked for");
  build(lesson, chosen);
  return chosen.settings;
}

/// A lesson as its program has it after these words.
template <class Lesson>
[[nodiscard]] Lesson prepared(const std::vector<std::string>& words = {}) {
  Lesson lesson;
  static_cast<void>(make_ready(lesson, words));
  return lesson;
}

}  // namespace texmap
