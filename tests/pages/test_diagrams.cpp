// All diagrams; what a single one shows is tested in diagrams/chapter_NN.cpp.
#include <doctest.h>

#include <string>

#include "diagrams/diagrams.hpp"

using namespace texmap::diagrams;

TEST_CASE("every diagram has a title, a description for those who do not see it, and all its ink") {
  for (const Drawing& drawing : all_diagrams()) {
    CAPTURE(drawing.name());
    const std::string svg = drawing.svg();
    CHECK(svg.find("<title></title>") == std::string::npos);
    const std::size_t from = svg.find("<desc>");
    CHECK(svg.find("</desc>") - from > 80);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
  }
}
