// Plots as SVG: points and lines over two logarithmic axes, with labels that do not cover each
// other.
#pragma once
#include <cmath>
#include <string>
#include <vector>

namespace texmap {

/// A point of a plot, both coordinates above 0; its label may be empty.
struct PlotPoint {
  double x, y;
  std::string label;
  double x_to = 0;        ///< a bar goes from x to here; 0: none
  std::string name = {};  ///< shown where the mouse rests on the point
};

/// Points that belong together.
struct PlotSeries {
  std::string name;  ///< in the legend; without one it is not listed there
  int style = 0;     ///< a color and a shape, 0 to 8
  std::vector<PlotPoint> points = {};
  bool joined = false;  ///< by a line
  bool dashed = false;  ///< the line alone, without points
};

/// A plot as it is described; svg_of draws it.
struct Plot {
  std::string title, x_title, y_title;
  std::vector<PlotSeries> series = {};
  std::vector<PlotPoint> front = {};  ///< joined by a line of its own, if there is any
  std::vector<double> x_ticks = {};   ///< where the axis is marked; powers of ten if empty
};

/// The plot as an SVG picture of 940 x 600 on white paper, so that it reads on pages of any color.
[[nodiscard]] std::string svg_of(const Plot& plot);

// The parts of a plot, here for their tests.
namespace plotting {

/// A rectangle that is taken.
struct Taken {
  double left, top, right, bottom;
  [[nodiscard]] bool meets(const Taken& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// A logarithmic axis: from values to pixels.
struct Axis {
  double low, high;  ///< the ends, powers of ten or parts of them
  double from, to;   ///< where they are drawn

  [[nodiscard]] double place(double value) const {
    return from + (to - from) * (std::log10(value) - std::log10(low)) /
                      (std::log10(high) - std::log10(low));
  }
  /// Values to be marked: 1, 2 and 5 of each decade, or at most ten powers of ten.
  [[nodiscard]] std::vector<double> ticks() const;
};

/// The axis for values, with a little room at both ends.
[[nodiscard]] Axis axis_for(double least, double most, double from, double to);

/// The number at a mark: 0.001 to 1000 written out, others as 1e-5.
[[nodiscard]] std::string tick_text(double value);

/// Where a label goes: the nearest free place round its point.
[[nodiscard]] Taken place_label(double x, double y, const std::string& label,
                                const std::vector<Taken>& taken, const Taken& inside);

}  // namespace plotting
}  // namespace texmap
