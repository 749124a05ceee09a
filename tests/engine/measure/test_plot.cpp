// Plots: labels that do not cover each other, marks of axes, whole SVG.
#include "engine/measure/plot.hpp"

#include <doctest.h>

#include <cstdint>

using namespace texmap;
using plotting::Taken;

TEST_CASE("no label of a plot covers another or a point, while there is room") {
  std::vector<Taken> taken;
  const Taken frame{0, 0, 700, 500};
  for (std::uint32_t i = 0; i < 40; ++i) {
    const double x =
        20 + 660 * std::fmod(i * 0.618033988749895, 1);  // anywhere, the same each time
    const double y = 20 + 460 * std::fmod(i * i * 0.414213562373095, 1);
    taken.push_back({x - 5, y - 5, x + 5, y + 5});
  }
  const std::vector<Taken> points = taken;
  for (const Taken& point : points) {
    const Taken box =
        plotting::place_label((point.left + point.right) / 2, (point.top + point.bottom) / 2,
                              "multi-jitter 64", taken, frame);
    for (const Taken& other : taken) CHECK_FALSE(box.meets(other));
    CHECK((box.left >= 0 && box.right <= 700 && box.top >= 0 && box.bottom <= 500));
    taken.push_back(box);
  }
}

TEST_CASE("marks are written short, and lie on whole decades where there are many") {
  CHECK(plotting::tick_text(0.001) == "0.001");
  CHECK(plotting::tick_text(1e-5) == "1e-5");
  CHECK(plotting::axis_for(1, 1000, 0, 1).ticks() == std::vector<double>{1, 10, 100, 1000});
  CHECK(plotting::axis_for(1, 10, 0, 1).ticks() == std::vector<double>{1, 2, 5, 10});
}

TEST_CASE("a plot has its titles, its series and its labels, escaped") {
  Plot plot{.title = "a < b", .x_title = "time", .y_title = "error"};
  plot.series.push_back({"dots & more", 0, {{1, 2, "first"}, {10, 0.1, ""}}});
  plot.series.push_back({"dashed", 4, {{1, 1, ""}, {10, 2, ""}}, true, true});
  plot.front = {{1, 2, ""}, {10, 0.1, "last"}};
  const std::string svg = svg_of(plot);
  CHECK(svg.starts_with("<svg "));
  CHECK(svg.ends_with("</svg>\n"));
  for (const char* part : {">a &lt; b<", ">time<", ">error<", ">dots &amp; more<", ">dashed<",
                           ">first<", ">last<", ">the front<", "stroke-dasharray"})
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
