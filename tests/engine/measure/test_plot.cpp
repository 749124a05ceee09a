// Plots: labels that do not cover each other, marks of axes, whole SVG.
#include "engine/measure/plot.hpp"

#include <doctest.h>

#include <cmath>
#include <regex>

using namespace texmap;

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
