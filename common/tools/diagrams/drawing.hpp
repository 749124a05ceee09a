// Diagrams as SVG: lines, arrows and labels, readable on a light and on a dark page.
#pragma once
#include <string>
#include <vector>

#include "math/vec3.hpp"

namespace texmap::diagrams {

/// A place in a drawing, in SVG's units: x to the right, y down.
struct Spot {
  double x, y;

  friend Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
  friend Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y}; }
  friend Spot operator*(Spot a, double s) { return {a.x * s, a.y * s}; }
};

/// The style sheet of all diagrams.
[[nodiscard]] const char* style();

/// Where a label begins, is centered, or ends.
enum class Anchor { start, middle, end };

/// A drawing under construction. A style is a list of CSS classes, of those in drawing.cpp:
/// lines are ink, soft (thin, gray), blue, red, green, and dashed together with one of these;
/// areas are fill-soft, fill-blue, fill-red, fill-green, fill-ink; text is plain, small or strong,
/// and blue, red or green like the line that it names.
struct Drawing {
  std::string name;  ///< of its file, without .svg
  int width, height;
  std::string title;        ///< in a few words
  std::string description;  ///< for readers who do not see it
  std::string body{};       ///< what is drawn so far

  void line(Spot from, Spot to, const std::string& style = "ink");
  void arrow(Spot from, Spot to, const std::string& style = "ink");
  void curve(const std::vector<Spot>& through, const std::string& style = "ink");
  void area(const std::vector<Spot>& corners, const std::string& style = "fill-soft");
  void rectangle(Spot corner, double wide, double high, const std::string& style = "ink");
  void circle(Spot center, double radius, const std::string& style = "ink");
  void dot(Spot center, const std::string& style = "fill-ink");
  /// A label; its baseline is at `at`.
  void text(Spot at, const std::string& words, Anchor anchor = Anchor::middle,
            const std::string& style = "plain");

  /// The whole file.
  [[nodiscard]] std::string svg() const;
};

/// A view of space without perspective, centered on the origin.
class SpaceView {
 public:
  /// @param from    direction from the origin to the viewer; not along y
  /// @param center  where the origin is drawn
  /// @param scale   units of the drawing for a length of 1 across the view
  SpaceView(const Vec3d& from, Spot center, double scale);

  [[nodiscard]] Spot operator()(const Vec3d& p) const;
  /// Whether a point of a sphere around the origin is on the viewer's side.
  [[nodiscard]] bool is_in_front(const Vec3d& p) const { return dot(toward_, p) >= 0; }

  /// Draws a curve on a sphere around the origin: what lies behind it is dashed.
  template <class Curve>
  void draw(Drawing& drawing, const std::string& style, double from, double to,
            const Curve& point_at) const {
    const int pieces = 96;
    std::vector<Spot> run;
    bool in_front = is_in_front(point_at(from));
    for (int i = 0; i <= pieces; ++i) {
      const Vec3d p = point_at(from + (to - from) * i / pieces);
      run.push_back((*this)(p));
      if (is_in_front(p) != in_front || i == pieces) {
        drawing.curve(run, in_front ? style : style + " dashed");
        run = {run.back()};
        in_front = is_in_front(p);
      }
    }
  }

 private:
  Vec3d right_, up_, toward_;
  Spot center_;
  double scale_;
};

}  // namespace texmap::diagrams
