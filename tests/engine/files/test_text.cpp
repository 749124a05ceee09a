// Tests of engine/files/text.hpp, numbers in sentences, of any length; of json.hpp, every kind of
// value, nested, in one line and in several; and of plot.hpp: labels that do not cover each other,
// marks of axes, whole SVG.
#include <doctest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <regex>

#include "engine/compare/plot.hpp"
#include "engine/files/json.hpp"
#include "engine/files/text.hpp"

namespace texmap::test {

TEST_CASE("a text is what printf prints, however long") {
  CHECK(text("%d of %s, %.2f %%", 3, "four", 1.005) == "3 of four, 1.00 %");
  CHECK(text("%s", "").empty());
  const std::string long_one(5000, 'x');
  CHECK(text("<%s>", long_one.c_str()) == "<" + long_one + ">");
}

TEST_CASE("markup is escaped, each sign once") {
  CHECK(escaped_markup("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
}

TEST_CASE("a number is as short as it can be, with a point in any locale, and reads back") {
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  if (set == nullptr)
    MESSAGE("the locale de_DE.UTF-8 is not installed: only the C locale was tried");
  CHECK(round_trip(0) == "0");
  CHECK(round_trip(0.1) == "0.1");
  CHECK(round_trip(-0.25) == "-0.25");
  CHECK(round_trip(1.0 / 3) == "0.3333333333333333");
  std::setlocale(LC_ALL, "C");
  double value = 1;
  for (int i = 0; i < 2000; ++i) {
    value *= -1.37;
    REQUIRE(std::strtod(round_trip(value).c_str(), nullptr) == value);
  }
}

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

TEST_CASE("no label of a plot covers another, while there is room") {
  Plot plot{.title = "", .x_title = "", .y_title = ""};
  plot.series.push_back({"", 0, {}});
  for (int i = 0; i < 30; ++i) {  // anywhere, the same each time
    plot.series[0].points.push_back({std::pow(10, std::fmod(i * 0.618033988749895, 1)),
                                     std::pow(10, std::fmod(i * i * 0.414213562373095, 1)),
                                     "multi-jitter 64"});
  }
  const std::string svg = svg_of(plot);
  const std::regex label("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\">multi-jitter 64<");
  std::vector<std::pair<double, double>> places;
  for (std::sregex_iterator at(svg.begin(), svg.end(), label), end; at != end; ++at)
    places.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
  REQUIRE(places.size() == 30);
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK((places[i].first >= 80 && places[i].first <= 740 - 90));
    for (std::size_t k = 0; k < i; ++k) {
      CHECK((std::abs(places[i].first - places[k].first) > 90 ||
             std::abs(places[i].second - places[k].second) > 12));
    }
  }
}

TEST_CASE("no label of a plot lies on a line") {
  Plot plot{.title = "", .x_title = "", .y_title = ""};
  plot.series.push_back({"", 4, {{1, 10, ""}, {100, 10, ""}}, true});
  plot.series.push_back({"", 0, {{1, 1, ""}, {10, 10, "on the line"}, {100, 100, ""}}});
  const std::string svg = svg_of(plot);
  std::smatch line, label;
  REQUIRE(std::regex_search(svg, line, std::regex("fill=\"none\" d=\"M[0-9.]+ ([0-9.]+)L")));
  REQUIRE(std::regex_search(svg, label, std::regex("y=\"([0-9.]+)\">on the line<")));
  const double middle = std::stod(label[1]) - 3.5;  // letters are 13 high, 3 of them below
  CHECK(std::abs(middle - std::stod(line[1])) >= 7.4);
}

TEST_CASE("marks are written short, and lie on whole decades where there are many") {
  const auto marks = [](double least, double most) {
    Plot plot{.title = "", .x_title = "", .y_title = ""};
    plot.series.push_back({"", 0, {{least, 1, ""}, {most, 1, ""}}});
    const std::string svg = svg_of(plot);
    const std::regex mark("text-anchor=\"middle\">([^<]+)<");
    std::string all;
    for (std::sregex_iterator at(svg.begin(), svg.end(), mark), end; at != end; ++at)
      all += (*at)[1].str() + " ";
    return all;
  };
  CHECK(marks(1, 10) == "1 2 5 10 ");
  CHECK(marks(0.00001, 0.2) == "1e-5 1e-4 0.001 0.01 0.1 ");
}

TEST_CASE("a plot has its titles, its series and its labels, escaped") {
  Plot plot{.title = "a < b", .x_title = "time", .y_title = "error"};
  plot.series.push_back({"dots & more", 0, {{1, 2, "first"}, {10, 0.1, ""}}});
  plot.series.push_back({"joined", 4, {{1, 1, ""}, {10, 2, ""}}, true});
  plot.front = {{1, 2, ""}, {10, 0.1, "last"}};
  const std::string svg = svg_of(plot);
  CHECK(svg.starts_with("<svg "));
  CHECK(svg.ends_with("</svg>\n"));
  for (const char* part : {">a &lt; b<", ">time<", ">error<", ">dots &amp; more<", ">joined<",
                           ">first<", ">last<", ">the front<", "stroke-width=\"1.5\""})
    CHECK(svg.find(part) != std::string::npos);
  CHECK(svg.find("font-size=\"17\">a &lt; b<") != std::string::npos);
  plot.title = std::string(150, 'm');  // as wide as 10 pixels each would be: too wide
  CHECK(svg_of(plot).find("font-size=\"9.93\">mmm") != std::string::npos);
}

TEST_CASE("series have dots, squares or triangles, and a label far from its point has a line") {
  Plot plot{.title = "", .x_title = "", .y_title = ""};
  plot.series.push_back({"squares", 1, {{1, 2, ""}, {10, 1, ""}}});
  plot.series.push_back({"triangles", 2, {{1, 1, ""}, {10, 2, ""}}});
  const std::string line = "stroke=\"#999\"";
  std::string svg = svg_of(plot);
  CHECK(svg.find("<rect x=") != std::string::npos);
  CHECK(svg.find("l5 9h-10z") != std::string::npos);
  CHECK(svg.find(line) == std::string::npos);
  CHECK(svg.find("<circle") == std::string::npos);
  plot.series.push_back({"dots", 0, {}});
  for (int i = 0; i < 12; ++i) plot.series.back().points.push_back({3, 1.5, "in the way"});
  svg = svg_of(plot);
  CHECK(svg.find("<circle") != std::string::npos);
  CHECK(svg.find(line) != std::string::npos);
}

}  // namespace texmap::test
