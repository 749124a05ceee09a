// The formats for learning systems, held against the fields that each system's description lists.
#include <doctest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "formats.hpp"
#include "support/running.hpp"

using namespace texmap::grade;
using namespace texmap::test;
using nlohmann::json;

namespace {

enum class Kind { text, number, list, object };

/// A field of a format: what it may hold.
struct Field {
  const char* name;
  Kind kind;
  bool required = false;
  std::vector<std::string> words = {};  // if only these are allowed
};

bool is_of(const json& value, Kind kind) {
  switch (kind) {
    case Kind::text:
      return value.is_string();
    case Kind::number:
      return value.is_number();
    case Kind::list:
      return value.is_array();
    case Kind::object:
      return value.is_object();
  }
  return false;
}

/// What is wrong with an object, in one line; empty if it keeps to the fields.
std::string faults(const json& object, const std::vector<Field>& fields) {
  std::string found;
  for (const auto& [name, value] : object.items()) {
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&name = name](const Field& one) { return one.name == name; });
    if (field == fields.end()) {
      found += name + " is no field; ";
    } else if (!is_of(value, field->kind)) {
      found += name + " is of another kind; ";
    } else if (!field->words.empty() &&
               std::find(field->words.begin(), field->words.end(), value) == field->words.end()) {
      found += name + " is none of its words; ";
    }
  }
  for (const Field& field : fields) {
    if (field.required && !object.contains(field.name))
      found += std::string(field.name) + " is missing; ";
  }
  return found;
}

const std::vector<std::string> formats = {"text", "html", "simple_format", "md", "ansi"};
const std::vector<std::string> visibilities = {"visible", "hidden", "after_due_date",
                                               "after_published"};
const std::vector<Field> gradescope = {{"score", Kind::number},
                                       {"execution_time", Kind::number},
                                       {"output", Kind::text},
                                       {"output_format", Kind::text, false, formats},
                                       {"test_output_format", Kind::text, false, formats},
                                       {"test_name_format", Kind::text, false, formats},
                                       {"visibility", Kind::text, false, visibilities},
                                       {"stdout_visibility", Kind::text, false, visibilities},
                                       {"extra_data", Kind::object},
                                       {"tests", Kind::list, true}};
const std::vector<Field> gradescope_test = {{"score", Kind::number},
                                            {"max_score", Kind::number},
                                            {"status", Kind::text, false, {"passed", "failed"}},
                                            {"name", Kind::text},
                                            {"name_format", Kind::text, false, formats},
                                            {"number", Kind::text},
                                            {"output", Kind::text},
                                            {"output_format", Kind::text, false, formats},
                                            {"tags", Kind::list},
                                            {"visibility", Kind::text, false, visibilities},
                                            {"extra_data", Kind::object}};
const std::vector<std::string> statuses = {"pass", "fail", "error"};
const std::vector<Field> classroom = {{"version", Kind::number, true},
                                      {"status", Kind::text, true, statuses},
                                      {"max_score", Kind::number, true},
                                      {"tests", Kind::list, true}};
const std::vector<Field> classroom_test = {
    {"name", Kind::text, true},    {"status", Kind::text, true, statuses},
    {"score", Kind::number, true}, {"message", Kind::text},
    {"test_code", Kind::text},     {"filename", Kind::text},
    {"line_no", Kind::number},     {"duration", Kind::number}};
/// Every list item keeps to the fields.
std::string faults_of_all(const json& list, const std::vector<Field>& fields) {
  std::string found;
  for (const json& item : list) found += faults(item, fields);
  return found;
}

Row row(const std::string& item, bool picture, std::size_t passed, const std::string& note) {
  Row row;
  row.item = item;
  row.word = picture ? "ok" : "mirrored";
  row.note = note;
  row.build = "ok";
  row.run = "ok";
  row.cpu_seconds = "1.5";
  row.picture_ok = picture;
  row.figures = PictureFigures{picture ? 0U : 12U, 0, 0, 1};
  row.with_tests = true;
  row.tests_passed = passed;
  row.tests_run = 5;
  return row;
}

const std::string evil = "]]> & <b> \"quoted\" \\ back\nnext line\x01 王 \xFF";

/// Students of every kind: all right, some wrong, hostile, not built, without tests, an exercise.
std::vector<Student> students() {
  Row broken = row("04_uv_conventions", false, 0, "lesson.hpp:7: error: expected ';'");
  broken.build = broken.word = "does not build";
  broken.figures.reset();
  Row exercise;
  exercise.item = "02.1";
  exercise.exercise = "chapters/02_checkerboard_uv/exercises/1_where_on_the_map.hpp";
  exercise.build = exercise.run = exercise.word = "ok";
  exercise.tests_passed = exercise.tests_run = 1;
  return {{"s/ada", "ada", "ada", "", {row("03_image_texture", true, 5, ""), exercise}},
          {"s/" + evil, evil, "evil", evil, {row("03_image_texture", false, 4, evil)}},
          {"s/bob", "bob", "bob", "", {broken, row("05_y_rotation", true, 5, "")}}};
}

}  // namespace

TEST_CASE("the check of fields notices a wrong name, kind, word and a missing field") {
  const json good = json::parse(classroom_json(students()[0]));
  for (const auto& [field, value] :
       {std::pair<const char*, json>{"max_score", "3"}, {"status", "up"}, {"rank", 1}}) {
    json bad = good;
    bad[field] = value;
    CHECK(!faults(bad, classroom).empty());
  }
  CHECK(!faults({{"version", 1}}, classroom).empty());
}

TEST_CASE("Gradescope's results have its fields, and the points add up") {
  for (const Student& student : students()) {
    const json results = json::parse(gradescope_json(student));
    CHECK(faults(results, gradescope) == "");
    CHECK(faults_of_all(results["tests"], gradescope_test) == "");
    int score = 0, of = 0;
    for (const json& test : results["tests"]) {
      score += test["score"].get<int>();
      of += test["max_score"].get<int>();
      CHECK((test["status"] == "passed") == (test["score"] == test["max_score"]));
    }
    CHECK(score == results["score"]);
    CHECK(score == student.points());
    CHECK(of == student.of());
  }
  const json ada = json::parse(gradescope_json(students()[0]));
  CHECK(ada["tests"][0]["number"] == "3.1");
  CHECK(ada["tests"][2]["name"] == "02.1: the exercise");
  CHECK(ada["tests"][2]["number"] == "2.E1");  // 2.1 is the picture of chapter 02
}

TEST_CASE("Classroom's report has its fields, and the notices its numbers") {
  for (const Student& student : students()) {
    const json results = json::parse(classroom_json(student));
    CHECK(faults(results, classroom) == "");
    CHECK(faults_of_all(results["tests"], classroom_test) == "");
    CHECK(results["version"] == 1);
    CHECK(results["max_score"] == student.of());
  }
  const json ada = json::parse(classroom_json(students()[0]));
  CHECK(ada["status"] == "pass");
  CHECK(ada["tests"][0]["filename"] == "chapters/03_image_texture/lesson.hpp");
  CHECK(ada["tests"][2]["filename"] == students()[0].rows[1].exercise);
  CHECK(json::parse(classroom_json(students()[1]))["status"] == "fail");
  CHECK(json::parse(classroom_json(students()[2]))["status"] == "fail");  // one chapter was built
  const std::string notices = classroom_notices(students()[1]);
  CHECK(notices.starts_with("::notice title=Autograding complete::Points 0/2\n"));
  const std::string report = notices.substr(notices.find("report::") + 8);
  CHECK(json::parse(report) == json{{"totalPoints", 0}, {"maxPoints", 2}});
}

TEST_CASE("one chapter that does not build is an error of its own, not of the whole") {
  Student student = students()[2];
  json results = json::parse(classroom_json(student));
  CHECK(results["status"] == "fail");
  CHECK(results["tests"][0]["status"] == "error");
  student.rows.pop_back();
  results = json::parse(classroom_json(student));
  CHECK(results["status"] == "error");
  CHECK(results["tests"][0]["message"] == "does not build: lesson.hpp:7: error: expected ';'");
}

TEST_CASE("a message says the reason once") {
  Row mirrored = row("03_image_texture", false, 0, "mirrored: columns run the other way");
  mirrored.note += "; tests: the texture's left half: is blue";
  const Row untested = row("04_uv_conventions", true, 0, "tests: the pole: is red");
  Row failed = untested;
  failed.word = "tests 0 of 5";
  const json tests =
      json::parse(gradescope_json({"s/ada", "ada", "ada", "", {mirrored, failed}}))["tests"];
  CHECK(tests[0]["output"] == mirrored.note);
  CHECK(tests[1]["output"] == "0 of 5 tests passed: the texture's left half: is blue");
  CHECK(tests[3]["output"] == "0 of 5 tests passed: the pole: is red");
}

TEST_CASE("a long message is cut before a learning system refuses it") {
  Student student = students()[1];
  student.rows.resize(1);
  student.rows[0].note.assign(100000, 'x');
  student.rows[0].build = "does not build";
  CHECK(json::parse(classroom_json(student))["tests"][0]["message"].get<std::string>().size() <=
        65535);
}

TEST_CASE(
    "a JUnit file is XML, and has a case for each test and a failure or an error for each that "
    "failed") {
  for (const Student& student : students()) {
    const std::string xml = junit_xml(student);
    const auto count = [&xml](const std::string& part) {
      std::size_t found = 0;
      for (std::size_t at = 0; (at = xml.find(part, at)) != std::string::npos; ++at) ++found;
      return found;
    };
    CHECK(count("<testcase ") == static_cast<std::size_t>(student.of()));
    CHECK(count("<failure ") + count("<error ") ==
          static_cast<std::size_t>(student.of() - student.points()));
    CHECK(count("<error ") == (student.name == "bob" ? 2U : 0U));  // a chapter that is not built
    CHECK(count(" errors=\"2\"") == (student.name == "bob" ? 1U : 0U));
    CHECK(count("\x01") == 0);
#ifndef _WIN32
    const TemporaryFolder folder;
    std::ofstream(folder / "junit.xml") << xml;
    const Outcome parsed =
        run("python3 -c \"import sys, xml.dom.minidom as d; d.parse(sys.argv[1])\" \"" +
            (folder / "junit.xml") + "\"");
    CAPTURE(parsed.err);
    CHECK((parsed.status == 0 || parsed.status == 127));  // 127: there is no python3
#endif
  }
}
