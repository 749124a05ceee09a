// The suite of a chapter's exercises, included by its test_exercises_NN.cpp, which has the answers
// of strangers: as students write them, not as the judge's own tables do.
#pragma once
#include <doctest.h>

#include <any>
#include <functional>
#include <string>
#include <vector>

#include "engine/compare/difference.hpp"
#include "exercise.hpp"
#include "exercises.hpp"

using D = double;
using V = Vec3;
using std::abs, std::acos, std::asin, std::atan2, std::clamp, std::cos, std::exp2, std::floor;
using std::fmod, std::log2, std::max, std::min, std::pow, std::sin, std::sqrt;

namespace texmap::test {

/// The solutions of the exercises. CMake writes these, in solutions/NN.hpp.
extern const std::vector<std::any> solutions;

/// What the chapter's page leads to, question by question: the program must know it, as near as the
/// question asks for.
extern const std::vector<double> answers;

/// Judges what strangers write for one exercise.
template <class Out, class... In>
struct Strangers {
  std::size_t k;  ///< of the exercise, from 1

  /// The answer is wrong, and its word has this text; without a text, it gets no word.
  void operator()(const std::string& text, const std::function<Out(In...)>& answer) const {
    const check::Exercise& exercise = check::exercises_of_chapter().exercises.at(k - 1);
    const check::Verdict verdict = exercise.verdict(answer);
    INFO(exercise.id, " gets '", verdict.mistake, "' and should get '", text, "'");
    CHECK_FALSE(verdict.right);
    CHECK(verdict.mistake.empty() == text.empty());
    CHECK(verdict.mistake.find(text) != std::string::npos);
  }

  /// The answer is right, however unusual, by values and by picture.
  void right(const std::function<Out(In...)>& answer) const {
    const check::Exercise& exercise = check::exercises_of_chapter().exercises.at(k - 1);
    const check::Verdict verdict = exercise.verdict(answer);
    CHECK_MESSAGE(verdict.right, verdict.law << ": " << verdict.got);
    CHECK(check::same_picture(exercise.draw(answer), exercise.draw({})));
  }
};

/// Strangers to this exercise; they write a function like the solution. solutions/NN.hpp has one of
/// them for each exercise, under the function's name.
template <class Out, class... In>
[[nodiscard]] Strangers<Out, In...> strangers_to(std::size_t k, Out (* /*solution*/)(In...)) {
  return {k};
}

TEST_CASE("an exercise fails as shipped and its solution passes, by values and by picture") {
  const auto& exercises = check::exercises_of_chapter().exercises;
  REQUIRE(exercises.size() == solutions.size());
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    const check::Exercise& exercise = exercises[i];
    INFO(exercise.id);
    const Image right = exercise.draw({});
    const check::Verdict started = exercise.verdict(check::starts.at(i));
    CHECK_FALSE(started.right);
    CHECK_FALSE(started.mistake.empty());
    CHECK_FALSE(check::same_picture(exercise.draw(check::starts.at(i)), right));
    const check::Verdict solved = exercise.verdict(solutions[i]);
    CHECK_MESSAGE(solved.right, solved.law << ": " << solved.got);
    CHECK(solved.places >= 3);
    CHECK(check::same_picture(exercise.draw(solutions[i]), right));
    CHECK(exercise.verdict(check::Replayed{solved.values}).right);
  }
}

TEST_CASE("rounding as in float is no mistake, neither by values nor by picture") {
  for (const check::Exercise& exercise : check::exercises_of_chapter().exercises) {
    const Image right = exercise.draw({});
    for (const double by : {5e-7, -5e-7}) {
      INFO(exercise.id, " off by ", by);
      CHECK(exercise.verdict(exercise.nudged(by)).right);
      CHECK(check::same_picture(exercise.draw(exercise.nudged(by)), right));
    }
  }
}

TEST_CASE("each known mistake gets its own word, and again from its values alone") {
  for (const check::Exercise& exercise : check::exercises_of_chapter().exercises) {
    for (const check::KnownMistake& known : exercise.mistakes()) {
      INFO(exercise.id, ": ", known.word);
      CHECK_FALSE(known.word.empty());
      CHECK_FALSE(known.verdict.right);
      CHECK(known.verdict.mistake == known.word);
      const check::Verdict again = exercise.verdict(check::Replayed{known.verdict.values});
      CHECK(again.mistake == known.verdict.mistake);
    }
  }
}

TEST_CASE("the program knows the answers of the chapter's page") {
  const auto& questions = check::exercises_of_chapter().questions;
  REQUIRE(questions.size() == answers.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const check::Question& asked = questions[i];
    const double answer = asked.answer(), off = check::apart(answer, answers[i]);
    const double most = asked.unit.tolerance * answer;
    CHECK_MESSAGE(off <= most, asked.id << " is off by " << off);
    for (const check::WrongNumber& wrong : asked.usual)
      CHECK_MESSAGE(check::apart(answer, wrong.number) > most, asked.id << wrong.word);
  }
}

}  // namespace texmap::test

using texmap::test::strangers_to;
