// The suite of a chapter's exercises, included by its test_exercises_NN.cpp, which has the answers
// of strangers: as students write them, not as the judge's own tables do.
#pragma once
#include <doctest.h>

#include <any>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/compare/difference.hpp"
#include "exercise.hpp"
#include "exercises.hpp"

using D = double;
using V = Vec3;
using std::abs, std::acos, std::asin, std::atan2, std::clamp, std::cos, std::exp2, std::floor;
using std::fmod, std::log2, std::max, std::min, std::pow, std::sin, std::sqrt;

namespace texmap::test {

/// What students get for an exercise, and the solution. CMake writes these, in starts/NN.hpp.
struct Written {
  std::string id;
  std::any start;
  std::any solution;
};
extern const std::vector<Written> written;

/// What the chapter's page leads to: the program must know it, as near as the question asks for.
struct Answer {
  std::string id;
  double value;
};
extern const std::vector<Answer> answers;

/// Judges what strangers write for one exercise.
template <class Out, class... In>
struct Strangers {
  std::string id;

  /// The answer is wrong, and its word has this text; without a text, it gets no word.
  template <class Lambda>
  void operator()(const std::string& text, Lambda answer) const {
    const check::Verdict verdict = judged(std::move(answer));
    INFO(id, " gets '", verdict.mistake, "' and should get '", text, "'");
    CHECK_FALSE(verdict.right);
    CHECK(verdict.mistake.empty() == text.empty());
    CHECK(verdict.mistake.find(text) != std::string::npos);
  }

  /// The answer is right, however unusual.
  template <class Lambda>
  void right(Lambda answer) const {
    const check::Verdict verdict = judged(std::move(answer));
    CHECK_MESSAGE(verdict.right, id << ": " << verdict.law << ": " << verdict.got);
  }

 private:
  template <class Lambda>
  check::Verdict judged(Lambda answer) const {
    static std::optional<Lambda> kept;  // an attempt is a plain function, so it captures nothing
    kept.emplace(std::move(answer));
    Out (*const function)(In...) = [](In... in) -> Out { return (*kept)(in...); };
    for (const check::Exercise& one : check::exercises_of_chapter().exercises)
      if (one.id == id) return one.verdict(function);
    throw std::runtime_error("there is no exercise " + id);
  }
};

/// Strangers to this exercise; they write a function like the solution. starts/NN.hpp has one for
/// each exercise, under the function's name.
template <class Out, class... In>
[[nodiscard]] Strangers<Out, In...> strangers_to(std::string id, Out (* /*solution*/)(In...)) {
  return {std::move(id)};
}

TEST_CASE("an exercise fails as shipped and its solution passes, by values and by picture") {
  const auto& exercises = check::exercises_of_chapter().exercises;
  REQUIRE(exercises.size() == written.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    const check::Exercise& exercise = exercises[i];
    REQUIRE(exercise.id == written[i].id);
    INFO(exercise.id);
    const Image right = exercise.draw({});
    CHECK_FALSE(exercise.verdict(written[i].start).right);
    CHECK(measure(exercise.draw(written[i].start), right).share_different > 0.0002);
    const check::Verdict solved = exercise.verdict(written[i].solution);
    CHECK_MESSAGE(solved.right, solved.law << ": " << solved.got);
    CHECK(solved.places >= 3);
    CHECK(measure(exercise.draw(written[i].solution), right).share_different <= 0.0002);
    CHECK(exercise.verdict(check::Replayed{solved.values}).right);
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
  for (const check::Question& question : check::exercises_of_chapter().questions) {
    int asked = 0;
    for (const Answer& answer : answers) {
      if (answer.id != question.id) continue;
      ++asked;
      const double off = check::apart(question.answer(), answer.value);
      CHECK_MESSAGE(off <= question.tolerance * answer.value, question.id << " is off by " << off);
    }
    CHECK_MESSAGE(asked > 0, "no answer here to " << question.id);
  }
}

}  // namespace texmap::test

using texmap::test::Answer;
using texmap::test::strangers_to;
