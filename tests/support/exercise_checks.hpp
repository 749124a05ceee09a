// What the tests of exercises ask: does a start fail, does a solution pass, does a mistake get
// its word?
#pragma once
#include <doctest.h>

#include <string>

#include "engine/compare/difference.hpp"
#include "exercises.hpp"

namespace texmap::test {

[[nodiscard]] inline const check::Exercise& exercise(const std::string& id) {
  for (const check::Exercise& one : check::exercises_of_chapter().exercises)
    if (one.id == id) return one;
  throw std::runtime_error("there is no exercise " + id);
}

/// The share of the chapter's pixels that differ when this function takes the place of the common
/// one.
template <class Function>
[[nodiscard]] double share_different(const std::string& id, Function* function) {
  const check::Exercise& one = exercise(id);
  return measure(one.draw(function), one.draw({})).share_different;
}

/// As shipped, an exercise fails by its values, and its picture shows it.
template <class Function>
void check_start(const std::string& id, Function* start) {
  const check::Verdict verdict = exercise(id).verdict(start);
  CHECK_MESSAGE(!verdict.right, id);
  CHECK_MESSAGE(share_different(id, start) > 0.0002, id);
}

/// The verdict on the same values in another process.
[[nodiscard]] inline check::Verdict replayed(const std::string& id, const check::Verdict& verdict) {
  return exercise(id).verdict(check::Replayed{verdict.values});
}

/// A solution passes by its values and by its picture.
template <class Function>
void check_solution(const std::string& id, Function* solution) {
  const check::Verdict verdict = exercise(id).verdict(solution);
  CHECK_MESSAGE(verdict.right, id << ": " << verdict.law << ": " << verdict.got);
  CHECK(verdict.places >= 3);
  CHECK_MESSAGE(share_different(id, solution) <= 0.0002, id);
  CHECK_MESSAGE(replayed(id, verdict).right, id);
}

/// A mistake fails with a word that contains this text; no other exercise's word will do.
template <class Function>
void check_mistake(const std::string& id, Function* mistaken, const std::string& text) {
  const check::Verdict verdict = exercise(id).verdict(mistaken);
  CHECK_MESSAGE(!verdict.right, id << ": " << text);
  CHECK_MESSAGE(verdict.mistake.find(text) != std::string::npos,
                id << ": '" << verdict.mistake << "' should say '" << text << "'");
  CHECK_MESSAGE(replayed(id, verdict).mistake == verdict.mistake, id);
}

/// A wrong function that is no known mistake fails without a word.
template <class Function>
void check_unknown(const std::string& id, Function* wrong) {
  const check::Verdict verdict = exercise(id).verdict(wrong);
  CHECK_MESSAGE(!verdict.right, id);
  CHECK_MESSAGE(verdict.mistake.empty(), id << ": " << verdict.mistake);
}

/// The program's answer to a question is this one, as near as the question asks for.
inline void check_answer(const std::string& id, double answer) {
  for (const check::Question& question : check::exercises_of_chapter().questions) {
    if (question.id != id) continue;
    const double off = check::apart(question.answer(), answer);
    CHECK_MESSAGE(off <= question.tolerance * answer, id << " is off by " << off);
    return;
  }
  FAIL("there is no question " << id);
}

}  // namespace texmap::test
