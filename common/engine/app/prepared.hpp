// A lesson made ready without its program: for tests and for the exercises.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/app/run_chapter.hpp"

namespace texmap {

/// Makes a lesson ready as its program does when the user types these words.
///
/// @return  what the session's settings then are
template <class Lesson>
Settings make_ready(Lesson& lesson, const std::vector<std::string>& words = {}) {
  CommandLine line("test", "");
  lesson.options(line);
  Session session("test", line, Lesson::about, offers_for(lesson));
  if (!line.parse(words)) throw std::runtime_error("no picture was asked for");
  prepare(session, lesson);
  session.plan();
  static_cast<void>(read_budget(session.settings.budget));  // a program refuses it when it draws
  return session.settings;
}

/// A lesson as its program has it after these words.
template <class Lesson>
[[nodiscard]] Lesson prepared(const std::vector<std::string>& words = {}) {
  Lesson lesson;
  static_cast<void>(make_ready(lesson, words));
  return lesson;
}

}  // namespace texmap
