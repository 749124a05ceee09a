// Checks one exercise and says what it found, in words and with a picture: ./course check 02.1
// builds and runs it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "attempt.hpp"
#include "engine/app/command_line.hpp"
#include "engine/app/run_guarded.hpp"
#include "engine/compare/difference_map.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/system/system.hpp"
#include "exercises.hpp"
#include "tools/page/page.hpp"

namespace {

using namespace texmap;
using namespace texmap::check;

struct Request {
  std::string out = "out/exercises";
  std::string title;
  std::string values, exercise, judge, report;
  std::string question, answer;

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
    line.statuses("0 right; 1 not yet; 2 trouble, such as a file that cannot be written");
  }
};

/// A share of pixels in words.
std::string percent(std::size_t part, std::size_t all) {
  const double share = 100 * static_cast<double>(part) / static_cast<double>(all);
  return part > 0 && share < 0.1 ? "less than 0.1 %" : text("%.1f %%", share);
}

/// Values and picture are right; a rounding may move single pixels, as in the golden pictures.
bool is_right(const Verdict& verdict, std::size_t different, std::size_t pixels) {
  return verdict.right && different * 5000 <= pixels;
}

std::string wrong_values(const Verdict& verdict) {
  return text("%zu of %zu values %s wrong", verdict.wrong, verdict.places,
              verdict.wrong == 1 ? "is" : "are");
}

/// The verdict, line by line.
std::string in_words(const Exercise& exercise, const std::string& title, const Verdict& verdict,
                     std::size_t different, std::size_t pixels) {
  const bool right = is_right(verdict, different, pixels);
  std::string words = exercise.id + "  " + title + (title.ends_with('?') ? " " : ": ") +
                      (right ? "right\n" : "not yet\n");
  if (verdict.right) {
    words += text("  All %zu values that were tried are right.\n", verdict.places);
  } else {
    words += "  tried:     " + verdict.law + "\n  expected:  " + verdict.expected +
             "\n  yours:     " + verdict.got + "\n";
    words.append("  ").append(wrong_values(verdict)).append(".\n");
    if (!verdict.mistake.empty()) words += "  This is a known mistake: " + verdict.mistake + ".\n";
  }
  if (!is_right({}, different, pixels)) {
    words += "  In the exercise's picture " + percent(different, pixels) +
             " of the pixels differ; none should. The pictures show where.\n";
  } else if (!right) {
    words += "  The exercise's picture does not show this mistake.\n";
  } else {
    words +=
        "  In the exercise's picture " + percent(different, pixels) + " of the pixels differ.\n";
  }
  if (!right) words += "  For a hint: ./course check hint " + exercise.id + "\n";
  return words;
}

/// The verdict in two lines: "right" or "not yet", and what is wrong, known mistakes first.
std::string in_two_lines(const Verdict& verdict, std::size_t different, std::size_t pixels) {
  if (is_right(verdict, different, pixels)) return "right\n";
  if (verdict.right) {
    return text("not yet\nnot yet: all %zu values that were tried are right, but ",
                verdict.places) +
           percent(different, pixels) + " of the pixels of the exercise's picture differ\n";
  }
  std::string words = verdict.mistake;
  if (words.empty()) words = "not yet: " + wrong_values(verdict);
  return "not yet\n" + words + "; tried: " + verdict.law + "; expected: " + verdict.expected +
         "; yours: " + verdict.got + "\n";
}

/// Saves a picture into the folder, for a page there.
page::Picture saved(const Image& image, const std::filesystem::path& folder, const char* file) {
  save_png(image, folder / file);
  return {file, image.width, image.height};
}

void write_page(const std::filesystem::path& folder, const std::string& title, bool good,
                const std::string& words, const Image& yours, const Image& right) {
  const Image map = difference_map(yours, right);
  std::string body = page::verdict(good, good ? "Right." : "Not yet.");
  body += "<pre>" + page::escaped_foreign(words) + "</pre>\n";
  body += page::side_by_side(
      {page::figure(saved(yours, folder, "yours.png"), "drawn with your function"),
       page::figure(saved(right, folder, "right.png"), "drawn with the right function"),
       page::figure(saved(map, folder, "map.png"), "where they differ")});
  const page::Frame frame{.title = title, .style = "pre { white-space: pre-wrap; }", .script = {}};
  write_text_atomically(folder / "index.html", page::framed(frame, body));
}

/// Checks the student's function, draws the pictures, and writes the page. Returns the status.
int check_exercise(const Exercise& exercise, const Request& request) {
  const Verdict verdict = exercise.verdict(attempt.function);
  const Image yours = exercise.draw(attempt.function);
  const Image right = exercise.draw({});
  const std::size_t different = measure(yours, right).pixels_different;
  const std::string words =
      in_words(exercise, request.title, verdict, different, right.pixels.size());
  print(words);

  const std::filesystem::path folder = path_of(request.out) / exercise.id;
  std::filesystem::create_directories(folder);
  const bool good = is_right(verdict, different, right.pixels.size());
  write_page(folder, exercise.id + "  " + request.title, good, words, yours, right);
  print("  pictures:  " + name_of(folder / "index.html") + "\n");
  return good ? 0 : 1;
}

/// Writes the picture of the student's function, pixel by pixel, and its values.
void write_values(const Exercise& exercise, const std::string& file) {
  const std::string values = exercise.verdict(attempt.function).values;
  const Image yours = exercise.draw(attempt.function);
  std::string bytes(yours.pixels.size() * sizeof(Rgb8), '\0');
  std::memcpy(bytes.data(), yours.pixels.data(), bytes.size());
  write_text_atomically(path_of(file), bytes + values);
}

/// Judges what write_values() wrote, in a program without the student's function.
void judge_values(const Exercise& exercise, const Request& request) {
  const Image right = exercise.draw({});
  Image yours = right;
  const std::size_t size = yours.pixels.size() * sizeof(Rgb8);
  const std::vector<std::uint8_t> bytes = read_file(path_of(request.judge), size + (1U << 20U));
  if (bytes.size() < size) throw std::runtime_error("there is no whole picture");
  std::memcpy(yours.pixels.data(), bytes.data(), size);
  const Verdict verdict =
      exercise.verdict(Replayed{{bytes.begin() + static_cast<std::ptrdiff_t>(size), bytes.end()}});
  write_text_atomically(
      path_of(request.report),
      in_two_lines(verdict, measure(yours, right).pixels_different, right.pixels.size()));
}

/// Which unit a prediction is in, if it is right in another one than the question's.
std::string wrong_unit(const Question& question, double answer, double predicted) {
  const auto means = [&](double number) {
    return apart(answer, number) <= std::max(question.tolerance, 0.01) * std::abs(answer);
  };
  if (question.unit == "degrees" && means(predicted * 180 / pi<double>()))
    return " Yours is in radians.";
  if (question.unit == "percent" && means(predicted * 100))
    return " Yours is a fraction: multiply by 100 for percent.";
  return "";
}

/// Says how far a prediction is off. Returns the status.
int check_answer(const Question& question, double predicted) {
  const double answer = question.answer();
  const double off = apart(answer, predicted);
  const bool right = off <= question.tolerance * std::abs(answer);
  const std::string unit = question.unit.empty() ? "" : " " + question.unit;
  std::string words = question.id + "  " + question.text + "\n  You say " +
                      check::in_words(predicted) + unit + ", the program finds " +
                      check::in_words(answer) + unit + ": ";
  if (right) {
    words += "right.\n";
  } else {
    words += check::in_words(off) + (predicted > answer ? " too large" : " too small");
    if (answer != std::round(answer) && off < std::abs(answer))
      words += text(" (%.3g %%)", 100 * off / std::abs(answer));
    words.append(".").append(wrong_unit(question, answer, predicted)).append("\n");
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

}  // namespace

int main(int argc, char** argv) {
  texmap::CommandLine line("check", "checks an exercise, or the answer to a question");
  Request request;
  request.declare(line);
  int found = 0;
  const int status = texmap::run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    const ExercisesOfChapter& chapter = exercises_of_chapter();
    if (!request.question.empty() && request.answer.empty()) {
      print(with_id(chapter.questions, request.question).text + "\n");
    } else if (!request.question.empty()) {
      found = check_answer(with_id(chapter.questions, request.question),
                           predicted_number(request.answer));
    } else if (!request.judge.empty()) {
      judge_values(with_id(chapter.exercises, request.exercise), request);
    } else if (!request.values.empty()) {
      write_values(with_id(chapter.exercises, attempt.id), request.values);
    } else {
      found = check_exercise(with_id(chapter.exercises, attempt.id), request);
    }
  });
  return status != 0 ? 2 : found;
}
