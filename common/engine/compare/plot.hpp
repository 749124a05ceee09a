// Plots as SVG: points and lines over two logarithmic axes, with labels that do not cover each
// other.
#pragma once
#include <string>
#include <vector>

namespace texmap {

/// A point of a plot, both coordinates above 0; its label may be empty.
struct PlotPoint {
  double x, y;
  std::string label;
  double x_to = 0;  ///< a bar goes from x to here; 0: none
};

/// Points that belong together.
struct PlotSeries {
  std::string name;  ///< in the legend; without one it is not listed there
  int style = 0;     ///< a color and a shape, 0 to 8
  std::vector<PlotPoint> points = {};
  bool joined = false;  ///< by a line
};

/// A plot as it is described; svg_of draws it.
struct Plot {
  std::string title, x_title, y_title;
  std::vector<PlotSeries> series = {};
  std::vector<PlotPoint> front = {};  ///< joined by a line of its own, if there is any
};

/// The plot as an SVG picture of 940 x 600 on white paper, so that it reads on pages of any color.
[[nodiscard]] std::string svg_of(const Plot& plot);

}  // namespace texmap
