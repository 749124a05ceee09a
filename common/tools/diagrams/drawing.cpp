#include "drawing.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

#include "engine/files/text.hpp"

namespace texmap::diagrams {
namespace {

// A drawing in an <img> has styles of its own and knows whether the reader's page is dark.
constexpr const char* style_sheet = R"(
svg {
  color-scheme: light dark;
  --ink: #1b1f24; --soft: #8a919b; --blue: #0b5cad; --red: #b3261e; --green: #1a7040;
}
@media (prefers-color-scheme: dark) {
  svg { --ink: #e8eaed; --soft: #8f98a3; --blue: #7fb7ff; --red: #ff9a8f; --green: #74d39c; }
}
line, path, rect, circle {
  fill: none; stroke-width: 1.6; stroke-linecap: round; stroke-linejoin: round;
}
.ink { stroke: var(--ink); }
.blue { stroke: var(--blue); }
.red { stroke: var(--red); }
.green { stroke: var(--green); }
.soft { stroke: var(--soft); stroke-width: 1; }
.thick { stroke-width: 3; }
.dashed { stroke-dasharray: 4 4; opacity: .7; }
.fill-ink { fill: var(--ink); stroke: none; }
.fill-soft { fill: var(--soft); fill-opacity: .18; stroke: none; }
.fill-blue { fill: var(--blue); fill-opacity: .18; stroke: none; }
.fill-red { fill: var(--red); fill-opacity: .18; stroke: none; }
.fill-green { fill: var(--green); fill-opacity: .18; stroke: none; }
.dot { fill-opacity: 1; }
text, text.blue, text.red, text.green, text.soft { stroke: none; }
text { font: 15px system-ui, sans-serif; fill: var(--ink); }
text.small { font-size: 13px; }
text.strong { font-weight: 600; }
text.blue { fill: var(--blue); }
text.red { fill: var(--red); }
text.green { fill: var(--green); }
text.soft { fill: var(--soft); }
)";

/// A coordinate with at most one decimal: enough for a screen, and the same on every machine.
std::string number(double x) {
  std::string rounded = texmap::text("%.1f", x);
  while (rounded.back() == '0') rounded.pop_back();
  if (rounded.back() == '.') rounded.pop_back();
  return rounded == "-0" ? "0" : rounded;
}

/// A number of tenths in as few letters as SVG allows, after what may end in a digit.
std::string tenths(long number, bool first) {
  std::string digits = std::to_string(std::abs(number) / 10);
  if (digits == "0" && number % 10 != 0) digits.clear();
  if (number % 10 != 0) digits.append(".").append(std::to_string(std::abs(number) % 10));
  if (number < 0) return "-" + digits;
  return first ? digits : " " + digits;
}

/// Lines through places: the first as it is, each other as its way from the one before, both in
/// whole tenths, so that roundings do not add up.
std::string path_through(const std::vector<Spot>& spots) {
  std::string path;
  long x = 0, y = 0;
  for (const Spot& spot : spots) {
    const long to_x = std::lround(10 * spot.x);
    const long to_y = std::lround(10 * spot.y);
    const std::size_t before = path.size();
    if (before == 0) path += "M";
    if (before > 0 && to_x == x && to_y == y && &spot != &spots.back()) continue;
    if (path.find('l') == std::string::npos && before > 0) path += "l";
    const bool first = path.back() == 'M' || path.back() == 'l';
    path.append(tenths(to_x - x, first)).append(tenths(to_y - y, false));
    x = to_x;
    y = to_y;
  }
  return path;
}

}  // namespace

const char* style() { return style_sheet; }

void Drawing::line(Spot from, Spot to, const std::string& style) {
  body += "<line class=\"" + style + "\" x1=\"" + number(from.x) + "\" y1=\"" + number(from.y) +
          "\" x2=\"" + number(to.x) + "\" y2=\"" + number(to.y) + "\"/>\n";
}

void Drawing::arrow(Spot from, Spot to, const std::string& style) {
  const Spot along = to - from;
  const double length = std::hypot(along.x, along.y);
  const Spot unit = along * (1 / length);
  const Spot across{-unit.y, unit.x};
  const Spot neck = to - unit * 9;
  line(from, neck, style);
  // The head is filled with the line's color: its class says which.
  std::string head = "dot fill-";
  head += style.substr(0, style.find(' '));
  area({to, neck + across * 4, neck - across * 4}, head);
}

void Drawing::curve(const std::vector<Spot>& through, const std::string& style) {
  body += "<path class=\"" + style + "\" d=\"" + path_through(through) + "\"/>\n";
}

void Drawing::area(const std::vector<Spot>& corners, const std::string& style) {
  body += "<path class=\"" + style + "\" d=\"" + path_through(corners) + "z\"/>\n";
}

void Drawing::rectangle(Spot corner, double wide, double high, const std::string& style) {
  body += "<rect class=\"" + style + "\" x=\"" + number(corner.x) + "\" y=\"" + number(corner.y) +
          "\" width=\"" + number(wide) + "\" height=\"" + number(high) + "\"/>\n";
}

void Drawing::circle(Spot center, double radius, const std::string& style) {
  body += "<circle class=\"" + style + "\" cx=\"" + number(center.x) + "\" cy=\"" +
          number(center.y) + "\" r=\"" + number(radius) + "\"/>\n";
}

void Drawing::dot(Spot center, const std::string& style) { circle(center, 4, style + " dot"); }

void Drawing::text(Spot at, const std::string& words, Anchor anchor, const std::string& style) {
  constexpr std::array names{"start", "middle", "end"};
  body += "<text class=\"" + style + "\" x=\"" + number(at.x) + "\" y=\"" + number(at.y) +
          "\" text-anchor=\"" + names.at(static_cast<std::size_t>(anchor)) + "\">" +
          escaped_markup(words) + "</text>\n";
}

std::string Drawing::svg() const {
  const std::string size = std::to_string(width) + " " + std::to_string(height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
         "viewBox=\"0 0 " +
         size + "\" width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) +
         "\">\n<title>" + escaped_markup(title) + "</title>\n<desc>" + escaped_markup(description) +
         "</desc>\n<style>" + style_sheet + "</style>\n" + body + "</svg>\n";
}

SpaceView::SpaceView(const Vec3d& from, Spot center, double scale)
    : toward_(normalize(from)), center_(center), scale_(scale) {
  right_ = normalize(cross(Vec3d{0, 1, 0}, toward_));
  up_ = cross(toward_, right_);
}

Spot SpaceView::operator()(const Vec3d& p) const {
  return center_ + Spot{dot(right_, p), -dot(up_, p)} * scale_;
}

}  // namespace texmap::diagrams
