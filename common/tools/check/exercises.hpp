// The exercises of a chapter: what a program checks, draws and asks. A file chapter_NN.cpp
// defines them.
#pragma once
#include <any>
#include <cstddef>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/app/prepared.hpp"
#include "engine/render/render.hpp"
#include "judge.hpp"
#include "texture/image.hpp"

namespace texmap::check {

/// The function that the lesson calls while an exercise is drawn; if none, it calls the course's.
template <class Function>
struct Hook {
  std::function<Function> yours;
  explicit operator bool() const { return yours != nullptr; }
};

/// A row of an exercise's mistakes: its word, and the verdict on it as an attempt.
struct KnownMistake {
  std::string word;
  Verdict verdict;
};

/// An exercise: a function to write, its laws, and the chapter's lesson that calls it.
struct Exercise {
  std::string id;         ///< "02.1"
  std::string signature;  ///< "Uv uv_of(Vec3 p)"
  std::function<Verdict(const std::any& yours)> verdict;
  std::function<Image(const std::any& yours)> draw;  ///< an empty any: with the right function
  std::function<std::vector<KnownMistake>()> mistakes;
};

/// A question to predict: the student types a number, the program knows it.
struct Question {
  std::string id;    ///< "02.a"
  std::string text;  ///< ends with a question mark
  std::function<double()> answer;
  std::string unit;         ///< "pixels", or nothing
  double tolerance = 1e-3;  ///< of the answer: what counts as right, 0 for an exact number
};

struct ExercisesOfChapter {
  std::vector<Exercise> exercises;
  std::vector<Question> questions;
};
[[nodiscard]] const ExercisesOfChapter& exercises_of_chapter();

/// The student's file has a function of another type than the exercise wants; what() says which.
class WrongSignature : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a function returned in another process at the places of its law: Verdict::values.
struct Replayed {
  std::string values;
};

/// The function that returns these values, call by call.
/// Errors: std::runtime_error if it is called more often.
template <class Out, class... Args>
[[nodiscard]] std::function<Out(Args...)> function_of(const Replayed& replayed,
                                                      const std::function<Out(Args...)>& /*type*/) {
  static_assert(std::is_trivially_copyable_v<Out>);
  return [values = replayed.values, at = std::size_t{0}](const Args&... /*where*/) mutable -> Out {
    if (values.size() - at < sizeof(Out)) throw std::runtime_error("there are too few values");
    Out value{};
    if constexpr (std::is_same_v<Out, bool>) {
      value = values[at] != 0;  // no other byte is a bool
    } else {
      std::memcpy(&value, values.data() + at, sizeof value);
    }
    at += sizeof value;
    return value;
  };
}

/// An exercise from its law and the lesson that calls `hook` while it is drawn.
template <class Function>
[[nodiscard]] Exercise exercise(std::string id, std::string signature, Law<Function> law,
                                Hook<Function>& hook, std::function<Image()> draw) {
  const auto function_in = [signature,
                            right = law.right](const std::any& yours) -> std::function<Function> {
    if (!yours.has_value()) return right;
    if (const auto* replayed = std::any_cast<Replayed>(&yours))
      return function_of(*replayed, right);
    if (const auto* function = std::any_cast<Function*>(&yours)) return *function;
    throw WrongSignature("the function must be: " + signature);
  };
  return {std::move(id), signature,
          [law, function_in](const std::any& yours) { return judge(law, function_in(yours)); },
          [&hook, draw = std::move(draw), function_in](const std::any& yours) {
            hook.yours = function_in(yours);
            Image image = draw();
            hook.yours = nullptr;
            return image;
          },
          [law = std::move(law)] {
            std::vector<KnownMistake> known;
            for (const auto& mistake : functions_of(law.slips, law.places[0].at))
              known.push_back({mistake.word, judge(law, mistake.function)});
            return known;
          }};
}

/// A lesson's picture for an exercise, 400 x 300.
template <class Lesson>
[[nodiscard]] Image picture_of(const Lesson& lesson) {
  return render<double>(lesson, view_of(lesson.stage.camera, 400, 300));
}

/// The chapter's picture after these words of its command line.
template <class Lesson>
[[nodiscard]] Image drawn(const std::vector<std::string>& words = {}) {
  return picture_of(prepared<Lesson>(words));
}

}  // namespace texmap::check
