// Plots as SVG: points and lines over two logarithmic axes, with labels that do not cover each
// other.
#include "engine/compare/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/files/text.hpp"

namespace texmap {
namespace {

/// Colors that color-blind people tell apart too, on white and on dark paper. None is as red as the
/// front.
inline constexpr std::array<const char*, 9> colors = {"#000000", "#0072b2", "#7a7a7a",
                                                      "#882255", "#997700", "#e69f00",
                                                      "#009e73", "#cc79a7", "#00664b"};

std::string marker(int style, double x, double y) {
  const char* color = colors[static_cast<std::size_t>(style)];
  switch (style % 3) {
    case 0:
      return text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", x, y, color);
    case 1:
      return text("<rect x=\"%.1f\" y=\"%.1f\" width=\"7\" height=\"7\" fill=\"%s\"/>\n", x - 3.5,
                  y - 3.5, color);
    default:
      return text("<path d=\"M%.1f %.1fl5 9h-10z\" fill=\"%s\"/>\n", x, y - 6, color);
  }
}

/// A rectangle that is taken.
struct Taken {
  double left, top, right, bottom;
  [[nodiscard]] bool meets(const Taken& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// A logarithmic axis: from values to pixels.
struct Axis {
  double low, high;  ///< the ends of the values, with a little room
  double from, to;   ///< where they are drawn

  Axis(double least, double most, double first, double last) : from(first), to(last) {
    const double room = std::pow(10.0, 0.08 * std::max(std::log10(most / least), 0.3));
    low = least / room;
    high = most * room;
  }
  [[nodiscard]] double place(double value) const {
    return from + (to - from) * std::log10(value / low) / std::log10(high / low);
  }
  /// Values to be marked: 1, 2 and 5 of each decade, or at most ten powers of ten; the ends if that
  /// leaves one at most.
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> marked;
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::ceil(std::log10(high)));
    const int step = std::max(1, (last - first + 9) / 10);
    for (int exponent = first; exponent <= last; exponent += step) {
      for (const int digit : {1, 2, 5}) {
        const double value = digit * std::pow(10.0, exponent);
        if ((digit == 1 || last - first <= 3) && value >= low && value <= high)
          marked.push_back(value);
      }
    }
    if (marked.size() < 2) marked = {low, high};
    return marked;
  }
};

/// The number at a mark: 0.001 to 9999 written out, others as 1e-5.
std::string tick_text(double value) {
  if (value > 0.0009 && value < 10000) return text("%g", value);
  const double exponent = std::floor(std::log10(value) + 1e-9);
  return text("%.0fe%.0f", value / std::pow(10.0, exponent), exponent);
}

/// Where a label goes: the nearest free place round its point.
Taken place_label(double x, double y, const std::string& label, const std::vector<Taken>& taken,
                  const Taken& inside) {
  const double width = 6.3 * static_cast<double>(label.size()) + 2;
  const double height = 13;
  for (int away = 9; away < 200; away += 6) {
    for (const double degrees :
         {0.0, 180.0, 30.0, -30.0, 150.0, -150.0, 90.0, -90.0, 60.0, -60.0, 120.0, -120.0}) {
      const double to_x = std::cos(degrees * std::numbers::pi / 180);
      const double to_y = -std::sin(degrees * std::numbers::pi / 180);
      const double left = x + away * to_x + (to_x > 0.1 ? 0 : to_x < -0.1 ? -width : -width / 2);
      const double top = y + away * to_y - height / 2;
      const Taken box{left, top, left + width, top + height};
      if (box.left < inside.left || box.right > inside.right || box.top < inside.top ||
          box.bottom > inside.bottom)
        continue;
      if (std::none_of(taken.begin(), taken.end(),
                       [&box](const Taken& other) { return box.meets(other); }))
        return box;
    }
  }
  return {x + 9, y - 6, x + 9 + width, y + 7};
}

}  // namespace

std::string svg_of(const Plot& plot) {
  const Taken frame{80, 50, 740, 535};
  double least_x = std::numeric_limits<double>::infinity(), most_x = 0,
         least_y = std::numeric_limits<double>::infinity(), most_y = 0;
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) {
      least_x = std::min(least_x, point.x);
      most_x = std::max({most_x, point.x, point.x_to});
      least_y = std::min(least_y, point.y);
      most_y = std::max(most_y, point.y);
    }
  }
  const Axis across(least_x, most_x, frame.left, frame.right);
  const Axis up(least_y, most_y, frame.bottom, frame.top);

  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 940 600\" width=\"940\" "
      "height=\"600\" role=\"img\" "
      "font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n"
      // On a dark page: light on dark, in the same hues.
      "<style>svg{color-scheme:light dark}@media(prefers-color-scheme:dark)"
      "{svg{filter:invert(1) hue-rotate(180deg)}.paper{fill:none}}</style>\n";
  svg += "<title>" + escaped_markup(plot.title) +
         "</title>\n<rect class=\"paper\" width=\"940\" height=\"600\" fill=\"#fff\"/>\n";
  const double title_size = std::min(17.0, 1500 / static_cast<double>(plot.title.size() + 1));
  svg += text("<text x=\"80\" y=\"30\" font-size=\"%.3g\">%s</text>\n", title_size,
              escaped_markup(plot.title).c_str());

  // The axes, with a line of the grid at every mark.
  for (const double value : across.ticks()) {
    const double x = across.place(value);
    svg += text(
        "<path d=\"M%.1f %.1fV%.1f\" stroke=\"#ddd\"/><text x=\"%.1f\" y=\"%.1f\" "
        "text-anchor=\"middle\">%s</text>\n",
        x, frame.top, frame.bottom, x, frame.bottom + 18, tick_text(value).c_str());
  }
  for (const double value : up.ticks()) {
    const double y = up.place(value);
    svg += text(
        "<path d=\"M%.1f %.1fH%.1f\" stroke=\"#ddd\"/><text x=\"%.1f\" y=\"%.1f\" "
        "text-anchor=\"end\">%s</text>\n",
        frame.left, y, frame.right, frame.left - 8, y + 4, tick_text(value).c_str());
  }
  svg += text(
      "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" "
      "stroke=\"#555\"/>\n",
      frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top);
  svg += text("<text x=\"%.1f\" y=\"580\" text-anchor=\"middle\" font-size=\"14\">%s</text>\n",
              (frame.left + frame.right) / 2, escaped_markup(plot.x_title).c_str());
  svg += text(
      "<text transform=\"translate(22 %.1f) rotate(-90)\" text-anchor=\"middle\" "
      "font-size=\"14\">%s</text>\n",
      (frame.top + frame.bottom) / 2, escaped_markup(plot.y_title).c_str());

  // Lines first, so that no point is under one. What they cross is taken, as what points cover is.
  std::vector<Taken> taken;
  const auto line = [&](const std::vector<PlotPoint>& points, const std::string& look) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      for (int percent = 0; percent <= 100; ++percent) {
        const double t = percent / 100.0;
        const double x = across.place(points[i].x) * (1 - t) + across.place(points[i + 1].x) * t;
        const double y = up.place(points[i].y) * (1 - t) + up.place(points[i + 1].y) * t;
        taken.push_back({x - 1, y - 1, x + 1, y + 1});
      }
    }
    std::string path = "<path fill=\"none\" d=\"";
    for (std::size_t i = 0; i < points.size(); ++i) {
      path +=
          text("%c%.1f %.1f", i == 0 ? 'M' : 'L', across.place(points[i].x), up.place(points[i].y));
    }
    return path + "\" " + look + "/>\n";
  };
  for (const PlotSeries& series : plot.series) {
    if (!series.joined) continue;
    svg += line(series.points, text("stroke=\"%s\" stroke-width=\"1.5\"",
                                    colors[static_cast<std::size_t>(series.style)]));
  }
  if (!plot.front.empty()) {  // stairs: between two points there is nothing
    std::vector<PlotPoint> stairs = {plot.front.front()};
    for (std::size_t i = 1; i < plot.front.size(); ++i) {
      stairs.push_back({plot.front[i].x, stairs.back().y, ""});
      stairs.push_back(plot.front[i]);
    }
    svg += line(stairs, "stroke=\"#c00\" stroke-width=\"5\" stroke-opacity=\"0.6\"");
  }

  // Points, and then the labels that find room between them.
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) {
      const double x = across.place(point.x);
      const double y = up.place(point.y);
      const double to = point.x_to > 0 ? across.place(point.x_to) : x;
      if (to > x) {
        svg += text("<path d=\"M%.1f %.1fH%.1fm0 -3v6\" stroke=\"%s\" fill=\"none\"/>\n", x, y, to,
                    colors[static_cast<std::size_t>(series.style)]);
      }
      svg += marker(series.style, x, y);
      taken.push_back({x - 5, y - 5, to + 5, y + 5});
    }
  }
  const auto label = [&](const PlotPoint& point) {
    if (point.label.empty()) return;
    const double x = across.place(point.x);
    const double y = up.place(point.y);
    const Taken box = place_label(x, y, point.label, taken, frame);
    const double to_x = std::clamp(x, box.left, box.right);
    const double to_y = std::clamp(y, box.top, box.bottom);
    if (std::hypot(to_x - x, to_y - y) > 14) {
      svg += text("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#999\" stroke-width=\"0.8\"/>\n", x, y,
                  to_x, to_y);
    }
    svg += text("<text x=\"%.1f\" y=\"%.1f\">%s</text>\n", box.left + 1, box.bottom - 3,
                escaped_markup(point.label).c_str());
    taken.push_back(box);
  };
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) label(point);
  }
  for (const PlotPoint& point : plot.front) label(point);

  // The legend, to the right of the frame.
  double y = frame.top + 10;
  for (const PlotSeries& series : plot.series) {
    if (series.name.empty()) continue;
    svg += marker(series.style, 760, y);
    svg +=
        text("<text x=\"774\" y=\"%.1f\">%s</text>\n", y + 4, escaped_markup(series.name).c_str());
    y += 20;
  }
  if (!plot.front.empty()) {
    svg += text(
        "<path d=\"M752 %.1fh16\" stroke=\"#c00\" stroke-width=\"5\" stroke-opacity=\"0.6\"/>"
        "<text x=\"774\" y=\"%.1f\">the front</text>\n",
        y, y + 4);
  }
  return svg + "</svg>\n";
}

}  // namespace texmap
