// A student's grades in the formats that learning systems read.
//
// Each format is a list of tests. A row of the grades makes one test for the picture, worth one
// point, and one for the chapter's suite, if it ran. An exercise is one test.
#include "formats.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "engine/measure/json.hpp"
#include "engine/measure/text.hpp"
#include "safe_text.hpp"

namespace texmap::grade {
namespace {

struct Test {
  std::string name;
  std::string number;  ///< 3.1; of an exercise 3.E1
  std::string item;
  std::string file;  ///< in the student's checkout
  bool passed = false;
  bool broken = false;  ///< the program could not be built
  std::string message;  ///< why it failed; empty if it passed
  double seconds = 0;
  int chapter = 0;
};

/// "4 of 5 tests passed: " and the first that failed, which the note has behind "tests: ".
std::string why_of_tests(const Row& row) {
  std::string message = text("%zu of %zu tests passed", row.tests_passed, row.tests_run);
  const std::size_t later = row.note.find("; tests: ");
  const std::string why = row.note.starts_with("tests: ") ? row.note.substr(7)
                          : later != std::string::npos    ? row.note.substr(later + 9)
                                                          : with_word(row.word, row.note);
  if (!why.empty()) message.append(": ").append(why);
  return clean_lines(message, 4000);
}

std::vector<Test> tests_of(const Student& student) {
  std::vector<Test> tests;
  tests.reserve(2 * student.rows.size());
  for (const Row& row : student.rows) {
    Test test;
    test.item = row.item;
    test.file = row.exercise.empty() ? "chapters/" + row.item + "/lesson.hpp" : row.exercise;
    test.broken = row.build == "does not build";
    test.seconds = std::atof(row.cpu_seconds.c_str());
    test.chapter = std::atoi(row.item.c_str());
    const auto add = [&](const char* what, const std::string& suffix, bool passed) {
      test.name = row.item + ": " + what;
      test.number = std::to_string(test.chapter).append(suffix);
      test.passed = passed;
      test.message = passed ? "" : clean_lines(with_word(row.word, row.note), 4000);
      tests.push_back(test);
      test.seconds = 0;  // counted once
    };
    if (!row.exercise.empty()) {
      // 2.E1, because 2.1 is the picture of chapter 02.
      add("the exercise", ".E" + row.item.substr(row.item.find('.') + 1), row.tests_ok());
      continue;
    }
    add("the picture", ".1", row.picture_point());
    if (row.with_tests) {
      add("the tests", ".2", row.tests_ok());
      if (!tests.back().passed && row.tests_run > 0) tests.back().message = why_of_tests(row);
    }
  }
  return tests;
}

std::string summary(const Student& student) {
  std::string words = text("%d of %d points", student.points(), student.of());
  if (!student.contained()) words = std::string(not_contained) + "\n" + words;
  return words;
}

/// An error if nothing could be built: then no test says more.
const char* status_of(const std::vector<Test>& tests) {
  const bool broken =
      std::all_of(tests.begin(), tests.end(), [](const Test& test) { return test.broken; });
  if (broken && !tests.empty()) return "error";
  const bool passed =
      std::all_of(tests.begin(), tests.end(), [](const Test& test) { return test.passed; });
  return passed ? "pass" : "fail";
}

double seconds_of(const std::vector<Test>& tests) {
  double seconds = 0;
  for (const Test& test : tests) seconds += test.seconds;
  return seconds;
}

/// XML 1.0 has no control characters, which clean() takes out.
std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped_markup(clean(value)) + "\"";
}

}  // namespace

std::string gradescope_json(const Student& student) {
  const std::vector<Test> tests = tests_of(student);
  const Json list = Json::list_of(tests, [](const Test& test) {
    return Json::object({{"name", test.name},
                         {"number", test.number},
                         {"score", int{test.passed}},
                         {"max_score", 1},
                         {"status", test.passed ? "passed" : "failed"},
                         {"output", test.message},
                         {"output_format", "text"},
                         {"tags", Json::list({test.item})},
                         {"visibility", "visible"}});
  });
  return Json::object({{"score", student.points()},
                       {"execution_time", seconds_of(tests)},
                       {"output", summary(student)},
                       {"output_format", "text"},
                       {"test_output_format", "text"},
                       {"visibility", "visible"},
                       {"stdout_visibility", "hidden"},
                       {"tests", list},
                       {"extra_data", Json::object({{"folder", clean(student.folder)}})}},
                      true)
             .text +
         "\n";
}

std::string classroom_json(const Student& student) {
  const std::vector<Test> tests = tests_of(student);
  const Json list = Json::list_of(tests, [](const Test& test) {
    return Json::object({{"name", test.name},
                         {"status", test.passed   ? "pass"
                                    : test.broken ? "error"
                                                  : "fail"},
                         {"score", int{test.passed}},
                         {"message", test.message},
                         {"test_code", "./course grade --chapters " + test.item},
                         {"filename", test.file},
                         {"line_no", 1},
                         {"duration", 1000 * test.seconds}});
  });
  return Json::object({{"version", 1},
                       {"status", status_of(tests)},
                       {"max_score", student.of()},
                       {"tests", list}},
                      true)
             .text +
         "\n";
}

std::string classroom_notices(const Student& student) {
  const Json report =
      Json::object({{"totalPoints", student.points()}, {"maxPoints", student.of()}});
  return text("::notice title=Autograding complete::Points %d/%d\n", student.points(),
              student.of()) +
         "::notice title=Autograding report::" + report.text + "\n";
}

std::string junit_xml(const Student& student) {
  const std::vector<Test> tests = tests_of(student);
  std::size_t failures = 0, errors = 0;
  std::string cases;
  for (const Test& test : tests) {
    cases += "  <testcase" + attribute("name", test.name) + attribute("classname", test.item) +
             attribute("time", text("%.3f", test.seconds)) +
             attribute("status", test.passed ? "run" : "fail");
    if (test.passed) {
      cases += "/>\n";
      continue;
    }
    ++(test.broken ? errors : failures);
    cases.append(">\n    <").append(test.broken ? "error" : "failure");
    cases += attribute("message", test.message) + "/>\n  </testcase>\n";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite" +
         attribute("name", student.name) + attribute("tests", std::to_string(tests.size())) +
         attribute("failures", std::to_string(failures)) +
         attribute("errors", std::to_string(errors)) + attribute("disabled", "0") +
         attribute("skipped", "0") + attribute("time", text("%.3f", seconds_of(tests))) + ">\n" +
         cases + "</testsuite>\n";
}

}  // namespace texmap::grade
