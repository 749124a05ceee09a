// JSON: every kind of value, nested, in one line and in several.
#include "engine/measure/json.hpp"

#include <doctest.h>

#include <limits>

using namespace texmap;

TEST_CASE("values are written as JSON has them, and numbers that it lacks are null") {
  CHECK(Json(true).text == "true");
  CHECK(Json(false).text == "false");
  CHECK(Json(nullptr).text == "null");
  CHECK(Json(-7).text == "-7");
  CHECK(Json(std::size_t{7}).text == "7");
  CHECK(Json(0.1).text == "0.1");
  CHECK(Json(std::numeric_limits<double>::quiet_NaN()).text == "null");
  CHECK(Json(std::numeric_limits<double>::infinity()).text == "null");
}

TEST_CASE("what must be escaped in strings is escaped, in names too") {
  CHECK(Json("a\"b\\c\n\x1f").text == "\"a\\\"b\\\\c\\u000a\\u001f\"");
  CHECK(Json::object({{"a\"b", 1}}).text == "{\"a\\\"b\": 1}");
}

TEST_CASE("objects and lists keep their order, and lines are indented by their depth") {
  CHECK(Json::object({}).text == "{}");
  CHECK(Json::list({}, true).text == "[]");
  CHECK(Json::object({{"b", 1}, {"a", "x"}}).text == "{\"b\": 1, \"a\": \"x\"}");
  const Json list = Json::list_of(std::vector{1, 2}, [](int i) { return Json::list({i, i}); });
  CHECK(Json::object({{"list", list}, {"none", nullptr}}, true).text ==
        "{\n  \"list\": [\n    [1, 1],\n    [2, 2]\n  ],\n  \"none\": null\n}");
}
