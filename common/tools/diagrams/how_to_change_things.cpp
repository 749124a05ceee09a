// The diagrams of docs/how_to_change_things.md.
#include <initializer_list>
#include <sstream>
#include <string>

#include "diagrams.hpp"
#include "scene/stage.hpp"
#include "texture/checkerboard.hpp"
#include "texture/uv.hpp"

namespace texmap::diagrams {
namespace {

/// Numbers in brackets, with some digits after the point.
std::string in_brackets(std::initializer_list<double> numbers, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << std::fixed << '(';
  const char* comma = "";
  for (const double number : numbers) {
    text << comma << number;
    comma = ", ";
  }
  text << ')';
  return text.str();
}

/// How docs/how_to_change_things.md calls the parts of a paint, with one hit as an example.
Drawing parts_of_a_paint() {
  const Vec3d normal{0.48, 0.6, 0.64};
  const Uv<double> uv = uv_rtiow(normal);
  const Rgb color = Checkerboard{.even = blue, .odd = white, .squares = 10}(uv);
  const std::string place = in_brackets({uv.u, uv.v}, 2);
  const std::string shown = in_brackets({color.r, color.g, color.b}, 1);

  Drawing d("parts_of_a_paint", 640, 190, "The parts of a paint",
            "Three boxes from left to right: a hit with its point and normal, its texture "
            "coordinates (u, v), and a color. The arrow from the hit to (u, v) is called mapping, "
            "that from (u, v) to the color is called texture. A bracket over both arrows is called "
            "paint. In the example the normal (0.48, 0.6, 0.64) gives " +
                place + " and the color " + shown + ".");
  const double top = 74, width = 150, height = 84;
  const double lefts[] = {10, 245, 480};
  const std::string names[] = {"hit", "(u, v)", "color"};
  const std::string examples[] = {"normal", place, shown};
  for (int i = 0; i < 3; ++i) {
    const Spot middle{lefts[i] + width / 2, top + height / 2};
    d.rectangle({lefts[i], top}, width, height);
    d.text(middle + Spot{0, -14}, names[i], Anchor::middle, "strong");
    d.text(middle + Spot{0, 12}, examples[i], Anchor::middle, "small");
    if (i == 0) d.text(middle + Spot{0, 30}, "(0.48, 0.6, 0.64)", Anchor::middle, "small");
  }
  const std::string arrows[] = {"mapping", "texture"};
  for (int i = 0; i < 2; ++i) {
    const Spot from{lefts[i] + width + 6, top + height / 2};
    const Spot to{lefts[i + 1] - 6, top + height / 2};
    d.arrow(from, to, "blue");
    d.text((from + to) * 0.5 + Spot{-3, -12}, arrows[i], Anchor::middle, "blue");
  }
  const double high = 44;
  d.line({lefts[0] + width, top - 6}, {lefts[0] + width, high}, "red");
  d.line({lefts[0] + width, high}, {lefts[2], high}, "red");
  d.line({lefts[2], high}, {lefts[2], top - 6}, "red");
  d.text({320, high - 12}, "paint = Mapped<mapping, texture>", Anchor::middle, "red");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_how_to_change_things() { return {parts_of_a_paint()}; }

}  // namespace texmap::diagrams
