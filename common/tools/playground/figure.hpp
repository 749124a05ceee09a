// What a module tells of a pixel besides the ray: rows of words and numbers, and a drawing.
#pragma once
#include <string>
#include <vector>

#include "engine/draw/render.hpp"
#include "engine/files/json.hpp"
#include "math/color.hpp"
#include "what_a_ray_meets.hpp"

namespace texmap::live {

/// A row: its name, then texts and numbers in their order.
using Facts = std::vector<Json>;

/// The vector in a row.
inline void add_vector(Facts& row, const Vec3d& v) {
  for (const Json& part : Facts{"(", v.x, ", ", v.y, ", ", v.z, ")"}) row.push_back(part);
}
[[nodiscard]] inline Json fact(const char* name, const Vec3d& v, Facts rest = {}) {
  Facts row{name};
  add_vector(row, v);
  row.insert(row.end(), rest.begin(), rest.end());
  return Json::list(row);
}
[[nodiscard]] inline Json fact(Facts row) { return Json::list(row); }

/// A drawing of dots, lines and boxes; x runs right from 0 to `width`, y down from 0 to `height`.
struct Figure {
  const char* says;  ///< what it shows
  double width = 1, height = 1;
  std::vector<Json> shapes{};

  /// A color for the page: of light 0 to 1, or a word of the page's, such as "ink".
  [[nodiscard]] static std::string css(const Rgb& c) {
    return "rgb(" + std::to_string(byte_of(c.r)) + "," + std::to_string(byte_of(c.g)) + "," +
           std::to_string(byte_of(c.b)) + ")";
  }
  void dot(double x, double y, const std::string& color) {
    shapes.push_back(Json::list({"dot", color, x, y}));
  }
  void line(double x, double y, double to_x, double to_y, const std::string& color) {
    shapes.push_back(Json::list({"line", color, x, y, to_x, to_y}));
  }
  void box(double x, double y, double wide, double high, const std::string& color) {
    shapes.push_back(Json::list({"box", color, x, y, wide, high}));
  }
  void word(double x, double y, const std::string& text) {
    shapes.push_back(Json::list({"word", "ink", x, y, text}));
  }
  [[nodiscard]] Json json() const {
    return Json::object(
        {{"says", says}, {"width", width}, {"height", height}, {"shapes", Json::list(shapes)}});
  }
};

}  // namespace texmap::live
