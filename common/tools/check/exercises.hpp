// The exercises of a chapter: what a program checks, draws and asks. A file chapter_NN.cpp
// defines them.
#pragma once
#include <algorithm>
#include <any>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/draw/render.hpp"
#include "engine/run/draw_lesson.hpp"
#include "judge.hpp"
#include "texture/image.hpp"

namespace texmap::check {

// What the tables of mistakes compute with.
using std::abs, std::acos, std::asin, std::atan, std::atan2, std::ceil, std::clamp, std::copysign,
    std::cos, std::exp, std::exp2, std::floor, std::fmod, std::log, std::log2, std::max, std::min,
    std::pow, std::remainder, std::round, std::sin, std::sqrt, std::trunc;
using Place2 = Uv<double>;
inline constexpr double pi = std::numbers::pi;
inline constexpr double radian = pi / 180;                    // of a degree
inline constexpr double half_root = std::numbers::sqrt2 / 2;  // the sine of 45 degrees
inline double fraction(double x) { return x - floor(x); }
inline int cut_off(double x) { return static_cast<int>(x); }
inline int rounded(double x) { return cut_off(round(x)); }

/// A row of an exercise's mistakes: its word, and the verdict on it as an attempt.
struct KnownMistake {
  std::string word;
  Verdict verdict;
};

/// An exercise: a function to write, its law, and the chapter's lesson that calls it. `yours` is a
/// std::function, or empty for the right one. Errors: std::bad_any_cast if it has other arguments
/// or another result.
struct Exercise {
  std::function<Trial()> trial;
  std::function<std::vector<Value>(const std::any& yours)> values;  ///< at the places of the law
  std::function<Image(const std::any& yours)> draw;
  std::function<std::any(double by)> nudged;  ///< the right function, all numbers off by this part
  const std::any* start = nullptr;            ///< what students find
  std::string id{};                           ///< "02.1"

  /// @param yours  may also be Replayed values. Errors: std::runtime_error if there are too few
  [[nodiscard]] Verdict verdict(const std::any& yours) const;
  [[nodiscard]] std::vector<KnownMistake> mistakes() const;
};

/// Whether the picture shows no mistake: rounding may move a byte by one level and a few pixels to
/// the other side of an edge, as in the golden pictures.
[[nodiscard]] inline bool same_picture(const Image& yours, const Image& right) {
  const Figures found = measure(yours, right, {}, Detail::pixels);
  return (found.pixels_different - found.pixels_by_levels[1]) * 400 <= found.pixels_compared;
}

/// A number that many give, and the word of what is wrong with it.
struct WrongNumber {
  double number;
  std::string word;
};

/// What an answer is measured in: "pixels", or nothing; and which part of it counts as right, 0 for
/// an exact number.
struct Unit {
  std::string name;
  double tolerance;
};

/// A question to predict: the student types a number, the program knows it.
struct Question {
  std::string text;  ///< ends with a question mark
  std::function<double()> answer;
  Unit unit;
  std::string look;  ///< where to look again, after a first wrong number
  std::vector<WrongNumber> usual;
  std::string id{};  ///< "02.a"
};

/// The functions that students find in the chapter's files. CMake writes them, in starts_NN.cpp.
extern const std::vector<std::any> starts;

struct ExercisesOfChapter {
  std::vector<Exercise> exercises;
  std::vector<Question> questions;

  ExercisesOfChapter(const std::string& chapter, std::vector<Exercise> all_exercises,
                     std::vector<Question> all_questions)
      : exercises(std::move(all_exercises)), questions(std::move(all_questions)) {
    give_ids(chapter, starts);
  }

 private:
  void give_ids(const std::string& chapter, const std::vector<std::any>& all_starts);
};
[[nodiscard]] ExercisesOfChapter all_exercises_of_chapter();
/// The same, made once.
[[nodiscard]] inline const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter = all_exercises_of_chapter();
  return chapter;
}

/// What a function returned in another process at the places of its law: Verdict::values.
struct Replayed {
  std::string values;
};

/// The value with each of its numbers off by this part; what counts things is not.
template <class Out>
[[nodiscard]] Out nudged(const Out& out, double by) {
  if constexpr (std::is_integral_v<Out>) return out;
  Value value = value_of(out);
  for (double& number : value.numbers)
    if (std::isfinite(number)) number += by * max(1.0, abs(number));
  return typed<Out>(value);
}

/// An exercise from its law and from the lesson that calls `hook` while it is drawn: the student's
/// function, or the right one. Otherwise the hook is empty.
template <class Out, class... Args>
[[nodiscard]] Exercise exercise(std::function<Out(Args...)>& hook, std::function<Image()> draw,
                                Law<Out, Args...> law) {
  using Function = std::function<Out(Args...)>;
  const auto function_in = [right = law.right](const std::any& yours) {
    return yours.has_value() ? std::any_cast<Function>(yours) : right;
  };
  Exercise made;
  made.values = [places = law.places, function_in](const std::any& yours) {
    const Function function = function_in(yours);
    std::vector<Value> values;
    for (const auto& place : places)
      values.push_back(value_of<Out>(std::apply(function, place.at)));
    return values;
  };
  made.draw = [&hook, draw = std::move(draw), function_in](const std::any& yours) {
    hook = function_in(yours);
    Image image = draw();
    hook = nullptr;
    return image;
  };
  made.nudged = [right = law.right](double by) {
    return std::any(Function([=](Args... at) { return nudged<Out>(right(at...), by); }));
  };
  made.trial = [law = std::move(law)] { return trial_of(law); };
  return made;
}

/// A lesson's picture for an exercise, 400 x 300; from another field of view if there is one.
template <class Lesson>
[[nodiscard]] Image picture_of(Lesson lesson, double fov_y_degrees = 0) {
  if (fov_y_degrees > 0) lesson.stage.camera.fov_y_degrees = fov_y_degrees;
  return render<double>(lesson, view_of(lesson.stage.camera, 400, 300));
}

/// Draws the chapter's picture after these words of its command line.
template <class Lesson>
[[nodiscard]] std::function<Image()> picture(std::vector<std::string> words = {},
                                             double fov_y_degrees = 0) {
  return [=] { return picture_of(prepared<Lesson>(words), fov_y_degrees); };
}

/// Twelve gray panels of 100 x 100 pixels: light(panel, x, y) of each, x to the right, y upward.
template <class Light>
[[nodiscard]] Image panels(const Light& light) {
  return image_of(400, 300, [&](int column, int row) {
    const int panel = row / 100 * 4 + column / 100;
    const double x = (column % 100 + 0.5) / 100, y = 1 - (row % 100 + 0.5) / 100;
    const bool is_edge = min(x, y) < 0.02;
    const std::uint8_t byte = byte_of(is_edge ? 0 : light(panel, x, y));
    return Rgb8{byte, byte, byte};
  });
}

}  // namespace texmap::check
