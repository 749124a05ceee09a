// The computed diagrams of chapter 10: the layouts unfolded, the stretch at a pole.
#include <cmath>
#include <numbers>

#include "diagrams.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::diagrams {
namespace {

constexpr double radians = std::numbers::pi / 180;

/// The direction at a longitude and a latitude; longitude 0 is the middle of the equirectangular
/// picture, east is to the right.
Vec3d direction_at(double longitude, double latitude) {
  const double l = longitude * radians, b = latitude * radians;
  return {std::cos(b) * std::cos(l), std::sin(b), -std::cos(b) * std::sin(l)};
}

/// A rectangle that shows the unit square of (u, v), v up.
struct Panel {
  Spot corner;
  double width, height;

  [[nodiscard]] Spot operator()(const Uv<double>& uv) const {
    return corner + Spot{uv.u * width, (1 - uv.v) * height};
  }
};

/// The distance of p from the line through a and b.
double distance_to_line(Spot p, Spot a, Spot b) {
  const Spot along = b - a, to = p - a;
  const double size = std::hypot(along.x, along.y);
  if (size < 1e-9) return std::hypot(to.x, to.y);
  return std::abs(along.x * to.y - along.y * to.x) / size;
}

/// The points that a polyline needs to stay within a fifth of a unit (Douglas and Peucker).
void add_needed(const std::vector<Spot>& run, std::size_t first, std::size_t last,
                std::vector<Spot>& needed) {
  std::size_t farthest = first;
  double most = 0.2;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double away = distance_to_line(run[i], run[first], run[last]);
    if (away > most) {
      most = away;
      farthest = i;
    }
  }
  if (farthest == first) {
    needed.push_back(run[last]);
    return;
  }
  add_needed(run, first, farthest, needed);
  add_needed(run, farthest, last, needed);
}

/// Draws a line of the sphere in a layout. It breaks where the layout is torn.
template <class Curve>
void draw_torn(Drawing& d, const Panel& panel, Projection projection, const Curve& direction,
               double from, double to, const std::string& style) {
  const int pieces = 1440;
  const double tear = 6;
  std::vector<Spot> run;
  const auto draw = [&] {
    if (run.size() > 1) {
      std::vector<Spot> needed{run.front()};
      add_needed(run, 0, run.size() - 1, needed);
      d.curve(needed, style);
    }
    run.clear();
  };
  for (int i = 0; i <= pieces; ++i) {
    const Spot at = panel(project(projection, direction(from + (to - from) * i / pieces)));
    if (!run.empty() && std::hypot(at.x - run.back().x, at.y - run.back().y) > tear) draw();
    run.push_back(at);
  }
  draw();
}

/// Meridians and parallels every 30 degrees: blue in the north, red in the south.
void draw_graticule(Drawing& d, const Panel& panel, Projection projection) {
  const bool whole = projection != Projection::plane;
  // A little off the seams and poles, where a point could fall on either side.
  const double off = 1e-4;
  for (int longitude = -180; longitude < 180; longitude += 30) {
    const auto meridian = [&](double latitude) { return direction_at(longitude + off, latitude); };
    draw_torn(d, panel, projection, meridian, off, 90 - off, "blue");
    if (whole) draw_torn(d, panel, projection, meridian, -off, off - 90, "red");
  }
  for (int latitude = whole ? -60 : 0; latitude <= 60; latitude += 30) {
    const auto parallel = [&](double longitude) { return direction_at(longitude, latitude + off); };
    const char* style = latitude == 0 ? "ink thick" : latitude > 0 ? "blue" : "red";
    draw_torn(d, panel, projection, parallel, off - 180, 180 - off, style);
  }
}

/// The seven layouts of one sphere, and the sphere.
Drawing seven_layouts() {
  Drawing d{"seven_layouts", 680, 400, "A sphere in seven layouts",
            "The meridians and parallels of a sphere, every 30 degrees, in seven flat layouts. The "
            "northern half is blue, the southern half red, the equator thick. In the "
            "equirectangular map and on the cylinder they are straight lines; the plane shows the "
            "northern half alone; the two cubes have six faces; in the two octahedral maps the "
            "north is a square on its corner in the middle and the south is folded out into the "
            "four corners."};
  const SpaceView view({1, 0.5, 0.35}, {82, 88}, 66);
  d.circle({82, 88}, 66, "soft");
  for (int longitude = -180; longitude < 180; longitude += 30) {
    const auto meridian = [&](double latitude) { return direction_at(longitude, latitude); };
    view.draw(d, "blue", 0, 90, meridian);
    view.draw(d, "red", -90, 0, meridian);
  }
  for (int latitude = -60; latitude <= 60; latitude += 30) {
    const auto parallel = [&](double longitude) { return direction_at(longitude, latitude); };
    const char* style = latitude == 0 ? "ink thick" : latitude > 0 ? "blue" : "red";
    view.draw(d, style, -180, 180, parallel);
  }
  d.text({82, 182}, "the sphere", Anchor::middle, "small");

  struct Cell {
    Projection projection;
    const char* words;
    double middle, bottom, width;
  };
  for (const Cell& cell : {Cell{Projection::equirect, "equirect", 248, 160, 150},
                           Cell{Projection::cylinder, "cylinder", 420, 160, 156},
                           Cell{Projection::plane, "plane: the north alone", 594, 160, 130},
                           Cell{Projection::cube, "cube", 88, 352, 150},
                           Cell{Projection::equi_angular, "equi-angular cube", 258, 352, 150},
                           Cell{Projection::octahedral, "octahedral", 424, 352, 140},
                           Cell{Projection::equal_area, "equal-area octahedral", 594, 352, 140}}) {
    const double height = cell.width / facts_of(cell.projection).aspect;
    const Panel panel{{cell.middle - cell.width / 2, cell.bottom - height}, cell.width, height};
    draw_graticule(d, panel, cell.projection);
    if (cell.projection != Projection::plane) {
      d.rectangle(panel.corner, cell.width, height, "soft");
    }
    if (cell.projection == Projection::cube || cell.projection == Projection::equi_angular) {
      const Spot top = panel.corner;
      for (int i = 1; i < 3; ++i) {
        const Spot right{cell.width * i / 3, 0};
        d.line(top + right, top + right + Spot{0, height}, "soft");
      }
      d.line(top + Spot{0, height / 2}, top + Spot{cell.width, height / 2}, "ink");
    }
    d.text({cell.middle, cell.bottom + 22}, cell.words, Anchor::middle, "small");
  }
  return d;
}

/// Equal circles of a globe, and what the equirectangular map makes of them.
Drawing pole_stretch() {
  Drawing d{"pole_stretch", 680, 300, "Equal circles in the equirectangular map",
            "Left: a globe with equal small circles at latitudes 0, 45 and 70 degrees and one "
            "around the north pole. Right: in the equirectangular map the circle at the equator "
            "is a circle, the others are ellipses that grow wider and wider, and the one around "
            "the pole is a band as wide as the map."};
  const double size = 9;  // radius of the circles in degrees
  const SpaceView view({1, 0.62, 0}, {130, 140}, 112);
  const Panel panel{{290, 48}, 370, 185};
  d.circle({130, 140}, 112, "ink");
  d.rectangle(panel.corner, panel.width, panel.height, "ink");
  const auto circle_at = [&](double latitude) {
    const Vec3d n = direction_at(0, latitude);
    const Vec3d east{0, 0, -1};
    const Vec3d north = cross(n, east);
    return [=](double degrees) {
      const double a = degrees * radians, r = size * radians;
      return n * std::cos(r) + (east * std::cos(a) + north * std::sin(a)) * std::sin(r);
    };
  };
  const auto equator = [](double longitude) { return direction_at(longitude, 0); };
  view.draw(d, "soft", -180, 180, equator);
  d.line(panel({0, 0.5}), panel({1, 0.5}), "soft");
  for (const int latitude : {0, 45, 70}) {
    const auto circle = circle_at(latitude);
    std::vector<Spot> on_globe, on_map;
    for (int i = 0; i <= 72; ++i) {
      on_globe.push_back(view(circle(i * 5.0)));
      on_map.push_back(panel(project(Projection::equirect, circle(i * 5.0))));
    }
    for (auto* outline : {&on_globe, &on_map}) {
      d.area(*outline, "fill-blue");
      d.curve(*outline, "blue");
    }
    const double wide = 1 / std::cos(latitude * radians);
    const std::string words = latitude == 0    ? "1"
                              : latitude == 45 ? "√2 = 1.41"
                                               : "1 / cos 70° = 2.92";
    const Spot at = panel({0.5 + wide * size / 360 + 0.03, 0.5 + latitude / 180.0});
    d.text(at + Spot{0, latitude == 0 ? -8.0 : 5.0}, words, Anchor::start, "small");
  }
  // Around the pole: everything north of 90 degrees minus the radius.
  const double band = size / 180;
  d.area({panel({0, 1}), panel({1, 1}), panel({1, 1 - band}), panel({0, 1 - band})}, "fill-red");
  d.line(panel({0, 1 - band}), panel({1, 1 - band}), "red");
  std::vector<Spot> cap;
  for (int i = 0; i <= 72; ++i) cap.push_back(view(direction_at(i * 5.0, 90 - size)));
  d.area(cap, "fill-red");
  d.curve(cap, "red");
  d.text(panel({0.5, 1}) + Spot{0, -10}, "the circle around the pole: as wide as the map",
         Anchor::middle, "red small");
  d.text({130, 282}, "equal circles on the globe", Anchor::middle, "small");
  d.text(panel({0.5, 0}) + Spot{0, 26}, "how many times as wide as high, in the map",
         Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_10() { return {seven_layouts(), pole_stretch()}; }

}  // namespace texmap::diagrams
