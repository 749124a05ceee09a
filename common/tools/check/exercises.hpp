// The exercises of a chapter: what a program checks, draws and asks. A file chapter_NN.cpp
// defines them.
#pragma once
#include <any>
#include <functional>
#include <stdexcept>
#include <string>
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

/// An exercise: a function to write, its laws, and the chapter's lesson that calls it.
struct Exercise {
  std::string id;         ///< "02.1"
  std::string signature;  ///< "Uv uv_of(Vec3 p)"
  std::function<Verdict(const std::any& yours)> verdict;
  std::function<Image(const std::any& yours)> draw;  ///< an empty any: with the right function
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

/// An exercise from its law and the lesson that calls `hook` while it is drawn.
template <class Function>
[[nodiscard]] Exercise exercise(std::string id, std::string signature, Law<Function> law,
                                Hook<Function>& hook, std::function<Image()> draw) {
  const auto function_of = [signature,
                            right = law.right](const std::any& yours) -> std::function<Function> {
    if (!yours.has_value()) return right;
    if (const auto* function = std::any_cast<Function*>(&yours)) return *function;
    throw WrongSignature("the function must be: " + signature);
  };
  return {std::move(id), signature,
          [law = std::move(law), function_of](const std::any& yours) {
            return judge(law, function_of(yours));
          },
          [&hook, draw = std::move(draw), function_of](const std::any& yours) {
            hook.yours = function_of(yours);
            Image image = draw();
            hook.yours = nullptr;
            return image;
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
