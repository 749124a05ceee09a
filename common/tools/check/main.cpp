// Checks one exercise and says what it found, in words and with a picture: ./course check 02.1
// builds and runs it.
#include <algorithm>
#include <any>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "attempt.hpp"
#include "engine/compare/difference.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"
#include "exercises.hpp"
#include "tools/page/page.hpp"

namespace {

using namespace texmap;
using namespace texmap::check;

struct Request {
  std::string out = "out/exercises";
  std::string title, values, exercise, judge, report, question, answer;
  bool again = false;

  void declare(CommandLine& line) {
    line.text("--out", "FOLDER", out, "where the pictures go, in a folder for each exercise");
    line.text("--title", "TEXT", title, "what the exercise is called");
    line.text("--values", "FILE", values,
              "write what your function returns, for another program to judge");
    line.text("--exercise", "ID", exercise, "judge such a file of this exercise, such as 02.1");
    line.text("--judge", "FILE", judge, "the file");
    line.text("--report", "FILE", report,
              "the verdict on it in two lines, as the grading reads it");
    line.text("--question", "ID", question, "check the answer to a question, such as 02.a");
    line.text("--answer", "NUMBER", answer, "the number that you predict");
    line.flag("--again", again, "you have answered before: if it is wrong, show the right number");
    line.statuses("0 right; 1 not yet; 2 trouble, such as a file that cannot be written");
  }
};

/// What a check finds: by values, and by the exercise's picture.
struct Findings {
  Verdict verdict;
  std::size_t different, pixels;
  bool picture_right;

  Findings(Verdict of_values, const Image& yours, const Image& right)
      : verdict(std::move(of_values)),
        different(measure(yours, right, {}, Detail::pixels).pixels_different),
        pixels(right.pixels.size()),
        picture_right(same_picture(yours, right)) {}

  [[nodiscard]] bool right() const { return verdict.right && picture_right; }

  [[nodiscard]] std::string wrong_values() const {
    return text("%zu of %zu values %s wrong", verdict.wrong, verdict.places,
                verdict.wrong == 1 ? "is" : "are");
  }
  [[nodiscard]] std::string different_pixels() const {
    const double share = 100 * static_cast<double>(different) / static_cast<double>(pixels);
    return (different > 0 && share < 0.1 ? "less than 0.1 %" : text("%.1f %%", share)) +
           " of the pixels";
  }

  /// The verdict, line by line.
  [[nodiscard]] std::string in_words(const std::string& id, const std::string& title) const {
    std::string words = id + "  " + title + (title.ends_with('?') ? " " : ": ") +
                        (right() ? "right\n" : "not yet\n");
    if (verdict.right) {
      words += text("  All %zu values that were tried are right.\n", verdict.places);
    } else {
      words += "  tried:     " + verdict.law + "\n  expected:  " + verdict.expected +
               "\n  yours:     " + verdict.got + "\n  " + wrong_values() + ".\n";
      if (verdict.mistake.starts_with("unchanged")) {
        words += "  Your function still returns what it returned when you got it.\n";
      } else if (!verdict.mistake.empty()) {
        words += "  This is a known mistake: " + verdict.mistake + ".\n";
      }
      if (!verdict.fact.empty()) words += "  Yours: " + verdict.fact + ".\n";
    }
    if (picture_right && !right()) {
      words += "  The exercise's picture does not show this mistake.\n";
    } else {
      words += "  In the exercise's picture " + different_pixels() + " differ" +
               (right() ? ".\n" : "; none should. The pictures show where.\n");
    }
    return right() ? words : words + "  For a hint: ./course check hint " + id + "\n";
  }

  /// The verdict in two lines: "right" or "not yet", and what is wrong, known mistakes first.
  [[nodiscard]] std::string in_two_lines() const {
    if (right()) return "right\n";
    if (verdict.right) {
      return text("not yet\nnot yet: all %zu values that were tried are right, but ",
                  verdict.places) +
             different_pixels() + " of the exercise's picture differ\n";
    }
    return "not yet\n" +
           (verdict.mistake.empty() ? "not yet: " + wrong_values() : verdict.mistake) +
           (verdict.fact.empty() ? "" : "; " + verdict.fact) + "; tried: " + verdict.law +
           "; expected: " + verdict.expected + "; yours: " + verdict.got + "\n";
  }
};

/// What the student's function throws.
struct Thrown : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the student's function returns, and its picture.
struct Tried {
  Verdict verdict;
  Image picture;
};
/// Errors: Thrown; std::runtime_error for a function with other arguments.
Tried tried(const Exercise& exercise) {
  try {
    return {exercise.verdict(attempt.function), exercise.draw(attempt.function)};
  } catch (const std::bad_any_cast&) {
    throw std::runtime_error("the function must be: " + attempt.signature);
  } catch (const std::exception& error) {
    throw Thrown(std::string("your function throws: ") + error.what());
  }
}

/// Checks the student's function, draws the pictures, and writes the page. Returns the status.
int check_exercise(const Exercise& exercise, const Request& request) {
  const auto [verdict, yours] = tried(exercise);
  const Image right = exercise.draw({});
  const Findings found(verdict, yours, right);
  const std::string words = found.in_words(exercise.id, request.title);
  print(words);

  const std::filesystem::path folder = path_of(request.out) / exercise.id;
  std::filesystem::create_directories(folder);
  const auto figure = [&](const Image& image, const char* file, const char* caption) {
    save_png(image, folder / file);
    return page::figure({file, image.width, image.height}, caption);
  };
  const std::string body =
      page::verdict(found.right(), found.right() ? "Right." : "Not yet.") + "<pre>" +
      page::escaped_foreign(words) + "</pre>\n" +
      page::side_by_side({figure(yours, "yours.png", "drawn with your function"),
                          figure(right, "right.png", "drawn with the right function"),
                          figure(difference_map(yours, right), "map.png", "where they differ")});
  const page::Frame frame{.title = exercise.id + "  " + request.title,
                          .style = "pre { white-space: pre-wrap; }",
                          .script = {}};
  write_text_atomically(folder / "index.html", page::framed(frame, body));
  print("  pictures:  " + name_of(folder / "index.html") + "\n");
  return found.right() ? 0 : 1;
}

/// Writes the picture of the student's function, pixel by pixel, and its values.
void write_values(const Exercise& exercise, const std::string& file) {
  const auto [verdict, yours] = tried(exercise);
  std::string bytes(yours.pixels.size() * sizeof(Rgb8), '\0');
  std::memcpy(bytes.data(), yours.pixels.data(), bytes.size());
  write_text_atomically(path_of(file), bytes + verdict.values);
}

/// Checks the student's function, or writes down its values. Returns the exit status.
/// Errors: std::runtime_error.
int check_attempt(const Exercise& exercise, const Request& request) {
  try {
    if (request.values.empty()) return check_exercise(exercise, request);
    write_values(exercise, request.values);
    return 0;
  } catch (const Thrown& error) {
    if (!request.values.empty()) throw;
    print(exercise.id + "  not yet: " + error.what() + "\n");
    return 1;
  }
}

/// Judges what write_values() wrote, in a program without the student's function.
void judge_values(const Exercise& exercise, const Request& request) {
  const Image right = exercise.draw({});
  Image yours = right;
  const std::size_t size = yours.pixels.size() * sizeof(Rgb8);
  const std::vector<std::uint8_t> bytes = read_file(path_of(request.judge), size + (1U << 20U));
  if (bytes.size() < size) throw std::runtime_error("there is no whole picture");
  std::memcpy(yours.pixels.data(), bytes.data(), size);
  const Replayed values{{bytes.begin() + static_cast<std::ptrdiff_t>(size), bytes.end()}};
  write_text_atomically(path_of(request.report),
                        Findings(exercise.verdict(values), yours, right).in_two_lines());
}

/// The word of a wrong number that is usual, or empty.
std::string known_mistake(const Question& question, double answer, double predicted) {
  const auto is_near = [&](double number, double right, double share) {
    return apart(number, right) <= share * std::abs(right);
  };
  const double tolerance = question.unit.tolerance;
  for (const auto& [number, word] : question.usual) {
    const bool is_whole = number == std::round(number);  // others are typed with more decimals
    if (is_near(predicted, number, tolerance > 0 ? std::max(tolerance, 2e-3) : is_whole ? 0 : 5e-4))
      return word;
  }
  const double in_unit = std::max(tolerance, 0.01);
  if (question.unit.name == "degrees" && is_near(predicted / radian, answer, in_unit))
    return "yours is in radians";
  if (question.unit.name == "percent" && is_near(predicted * 100, answer, in_unit))
    return "yours is a fraction: multiply by 100 for percent";
  return "";
}

/// Says whether a prediction is right; if not, what is wrong with it, and the second time how far
/// off it is. Returns the status.
int check_answer(const Question& question, double predicted, bool again) {
  const double answer = question.answer();
  const double off = apart(answer, predicted);
  const bool right = off <= question.unit.tolerance * std::abs(answer);
  const std::string unit = question.unit.name.empty() ? "" : " " + question.unit.name;
  const auto* side = predicted > answer ? " too large" : " too small";
  std::string words =
      question.id + "  " + question.text + "\n  You say " + in_words(predicted) + unit;
  if (right || again) words += ", the program finds " + in_words(answer) + unit;
  words += right ? ": right" : ": " + (again ? in_words(off) : "not yet,") + side;
  if (again && !right && answer != std::round(answer) && off < std::abs(answer))
    words += text(" (%.3g %%)", 100 * off / std::abs(answer));
  words += ".\n";
  if (!right) {
    const std::string known = known_mistake(question, answer, predicted);
    if (!known.empty()) words += "  This is a known mistake: " + known + ".\n";
    if (!again) {
      words += (known.empty() ? "  Look again: " + question.look + "\n" : "") +
               "  After your next number you see the right one.\n";
    }
  }
  print(words);
  return right ? 0 : 1;
}

/// The number that somebody predicts. Errors: std::runtime_error.
double predicted_number(const std::string& typed) {
  if (const auto number = read_decimal(typed)) return *number;
  throw std::runtime_error("an answer is a number such as 0.25 or 1398101, without commas, not '" +
                           typed + "'");
}

/// The item with this id. Errors: std::runtime_error.
template <class Item>
const Item& with_id(const std::vector<Item>& items, const std::string& id) {
  for (const Item& item : items)
    if (item.id == id) return item;
  throw std::runtime_error("there is no '" + id + "' in this chapter");
}

bool is_done = false;

/// What is left to say where a student's function ended the program, with any status.
void end_of_program() {
  if (is_done) return;
  print(std::string(attempt.id) + "  not yet: your function ends the program; let it return\n");
  std::_Exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  std::atexit(end_of_program);
  texmap::CommandLine line("check", "checks an exercise, or the answer to a question");
  Request request;
  request.declare(line);
  int found = 0;
  const int status = texmap::run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    const ExercisesOfChapter& chapter = exercises_of_chapter();
    if (!request.question.empty() && request.answer.empty()) {
      print(request.question + "  " + with_id(chapter.questions, request.question).text + "\n");
    } else if (!request.question.empty()) {
      found = check_answer(with_id(chapter.questions, request.question),
                           predicted_number(request.answer), request.again);
    } else if (!request.judge.empty()) {
      judge_values(with_id(chapter.exercises, request.exercise), request);
    } else {
      found = check_attempt(with_id(chapter.exercises, attempt.id), request);
    }
  });
  is_done = true;
  return status != 0 ? 2 : found;
}
