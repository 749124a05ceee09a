// The diagrams of chapter 04: where each convention begins and which way it runs, and two ways to a
// texel.
#include <array>
#include <string>

#include "diagrams.hpp"
#include "from_above.hpp"
#include "texture/conventions.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::diagrams {
namespace {

/// The direction with these coordinates in a convention. Each conversion from rtiow, done four
/// times, changes nothing; so three times is its inverse.
Vec3d direction_in(Convention convention, Uv<double> uv) {
  for (int i = 0; i < 3; ++i) uv = in_convention(convention, uv);
  return direction_rtiow(uv);
}

/// A direction by its place on a map with the east on the right and -x at its left edge.
Vec3d on_map(double east, double north) { return direction_rtiow(Uv<double>{east, north}); }

struct Panel {
  Convention convention;
  const char* documents;
  const char* runs;     ///< which way u and v run
  const char* at_x;     ///< u at -x
  const char* at_z;     ///< u at +z
  const char* verdict;  ///< what a picture looks like
};

constexpr std::array<Panel, 3> panels{{
    {Convention::daily, "daily exercise", "u west, v down", "u = 0", "u = 3/4", "mirrored"},
    {Convention::rtiow, "One Weekend 2020, Next Week", "u east, v up", "u = 0", "u = 1/4",
     "reads as printed"},
    {Convention::lecture, "lecture", "u east, v up", "u = 3/4", "u = 0", "reads as printed"},
}};

/// Draws the visible part of a curve on the sphere.
template <class Curve>
void draw_front(Drawing& d, const SpaceView& view, const Curve& point_at, double from, double to,
                const std::string& style) {
  const int pieces = 96;
  std::vector<Spot> run;
  for (int i = 0; i <= pieces; ++i) {
    const Vec3d p = point_at(from + (to - from) * i / pieces);
    const bool visible = view.is_in_front(p);
    if (visible) run.push_back(view(p));
    if ((!visible || i == pieces) && run.size() > 1) d.curve(run, style);
    if (!visible) run.clear();
  }
}

/// The letter F of a picture, placed by a convention around the meridian that faces the viewer.
void draw_letter(Drawing& d, const SpaceView& view, const Panel& panel, const std::string& name) {
  const double facing = uv_of(panel.convention, on_map(0.125, 0.5)).u;
  const bool up = v_axis_of(panel.convention) == VAxis::up;
  // right and high are measured in the picture: from its middle column, and from its lower edge.
  const auto at = [&](double right, double high) {
    return view(direction_in(panel.convention, {facing + right, up ? high : 1 - high}));
  };
  d.curve({at(-0.035, 0.56), at(-0.035, 0.68), at(-0.035, 0.8)}, "ink thick");
  d.curve({at(-0.035, 0.8), at(0.01, 0.8), at(0.055, 0.8)}, "ink thick");
  d.curve({at(-0.035, 0.69), at(0.03, 0.69)}, "ink thick");
  d.mark(name + " foot", at(-0.035, 0.56));
  d.mark(name + " corner", at(-0.035, 0.8));
  d.mark(name + " arm", at(0.055, 0.8));
}

/// The same globe with each of the three maps.
Drawing four_conventions() {
  Drawing d("four_conventions", 640, 300, "Four documents, three conventions, the same globe",
            "The same globe three times, seen from between -x and +z. Daily exercise: u is 0 at "
            "-x and runs west, v runs down, and a letter F on the picture is mirrored. One "
            "Weekend 2020 and Next Week: u is 0 at -x and runs east, v runs up, the F reads as "
            "printed. Lecture: u is 0 at +z and runs east, v runs up, the F reads as printed.");
  const double r = 72;
  double x = 108;
  for (const Panel& panel : panels) {
    const Spot center{x, 152};
    const SpaceView view({-1, 0.45, 1}, center, r);
    const std::string name = panel.documents;
    const auto in_this = [&](double u, double v) { return direction_in(panel.convention, {u, v}); };
    d.circle(center, r, "fill-soft");
    d.circle(center, r, "ink");
    for (int i = 0; i < 4; ++i) {
      draw_front(
          d, view, [&](double v) { return in_this(i / 4.0, v); }, 0, 1, "soft");
    }
    draw_front(
        d, view, [&](double u) { return in_this(u, 0.5); }, 0, 1, "soft");
    draw_front(
        d, view, [&](double v) { return in_this(0, v); }, 0, 1, "red thick");
    draw_letter(d, view, panel, name);

    // u and v, from one point of the southern hemisphere.
    const Uv<double> from = uv_of(panel.convention, on_map(0.125, 0.36));
    curved_arrow(
        d, [&](double u) { return view(in_this(u, from.v)); }, from.u, from.u + 0.1, "blue");
    curved_arrow(
        d, [&](double v) { return view(in_this(from.u, v)); }, from.v, from.v + 0.14, "green");
    const Spot u_tip = view(in_this(from.u + 0.1, from.v));
    const Spot v_tip = view(in_this(from.u, from.v + 0.14));
    const Spot start = view(in_this(from.u, from.v));
    d.text((start + u_tip) * 0.5 + Spot{0, 18}, "u", Anchor::middle, "blue strong");
    d.text((start + v_tip) * 0.5 + Spot{u_tip.x > start.x ? -10.0 : 10.0, 5}, "v", Anchor::middle,
           "green strong");

    // The axes, from the surface outward.
    for (const Vec3d& axis : {Vec3d{-1, 0, 0}, Vec3d{0, 0, 1}}) {
      const Spot tip = view(axis * 1.55);
      const bool is_x = axis.x != 0;
      const char* words = is_x ? panel.at_x : panel.at_z;
      const bool begins = std::string(words) == "u = 0";
      d.dot(view(axis), begins ? "fill-red" : "fill-ink");
      d.arrow(view(axis), tip, "ink");
      d.text(tip + Spot{is_x ? 4.0 : -4.0, 18}, is_x ? "-x" : "+z", Anchor::middle, "small");
      d.text(tip + Spot{is_x ? 4.0 : -4.0, 36}, words, Anchor::middle,
             begins ? "red small strong" : "small");
    }
    d.text(center + Spot{0, -r - 8}, panel.convention == Convention::daily ? "v = 0" : "v = 1",
           Anchor::middle, "small");
    d.text(center + Spot{0, r + 18}, panel.convention == Convention::daily ? "v = 1" : "v = 0",
           Anchor::middle, "small");
    d.text({x, 22}, panel.documents, Anchor::middle, "small strong");
    d.text({x, 42}, panel.runs, Anchor::middle, "small");
    d.text({x, 276}, panel.verdict, Anchor::middle,
           panel.convention == Convention::daily ? "red" : "plain");
    d.mark(name + " center", center);
    d.mark(name + " u = 0", view(in_this(0, 0.5)));
    d.mark(name + " start", start);
    d.mark(name + " u", u_tip);
    d.mark(name + " v", v_tip);
    x += 212;
  }
  return d;
}

/// A letter on a map: as printed, and by each fault of u and v.
Drawing letter_and_faults() {
  Drawing d("letter_and_faults", 720, 210, "A letter shows which way u and v run",
            "A letter F four times, east on the right and north up. As printed: u grows to the "
            "east and up in the picture is north. Mirrored: u grows to the west. Upside down and "
            "mirrored: up in the picture is south. Turned by half a turn: both faults.");
  struct Tile {
    Convention convention;
    VAxis axis;
    std::array<const char*, 4> words;
  };
  const std::array<Tile, 4> tiles{{
      {Convention::rtiow,
       VAxis::up,
       {"reads as printed", "u grows to the east;", "up in the picture: north", "(+)(+) = +"}},
      {Convention::daily,
       VAxis::down,
       {"mirrored", "u grows to the west;", "up in the picture: north", "(-)(+) = -"}},
      {Convention::rtiow,
       VAxis::down,
       {"upside down, mirrored", "u grows to the east;", "up in the picture: south", "(+)(-) = -"}},
      {Convention::daily,
       VAxis::up,
       {"turned by half a turn", "u grows to the west;", "up in the picture: south", "(-)(-) = +"}},
  }};
  double left = 9;
  for (const Tile& tile : tiles) {
    const Spot corner{left, 14};
    const double width = 168, height = 96;
    // right and high are measured in the picture, east and north on the map.
    const auto at = [&](double right, double high) {
      const double v = tile.axis == VAxis::up ? high : 1 - high;
      const Uv<double> map = uv_rtiow(direction_in(tile.convention, {right, v}));
      return corner + Spot{map.u * width, (1 - map.v) * height};
    };
    d.rectangle(corner, width, height, "fill-soft");
    d.curve({at(0.4, 0.2), at(0.4, 0.8), at(0.62, 0.8)}, "ink thick");
    d.line(at(0.4, 0.52), at(0.56, 0.52), "ink thick");
    const bool mirrored = (at(0.6, 0.5).x > at(0.4, 0.5).x) != (at(0.5, 0.6).y < at(0.5, 0.4).y);
    for (std::size_t i = 0; i < 4; ++i) {
      d.text(corner + Spot{width / 2, height + 22 + 20 * static_cast<double>(i)}, tile.words.at(i),
             Anchor::middle,
             i == 0               ? "small strong"
             : mirrored && i == 3 ? "small red"
                                  : "small");
    }
    const std::string name = tile.words[0];
    d.mark(name + " foot", at(0.4, 0.2));
    d.mark(name + " corner", at(0.4, 0.8));
    d.mark(name + " arm", at(0.62, 0.8));
    left += 178;
  }
  return d;
}

/// The equator from above, and the way of u in each convention.
Drawing u_from_above() {
  Drawing d("u_from_above", 640, 370, "Where u begins, seen from above the north pole",
            "A circle, the equator, with -x on the left, +z at the bottom toward the eye, +x on "
            "the right, -z at the top. Three arrows run around it. Daily exercise: from -x "
            "clockwise. One Weekend 2020 and Next Week: from -x against the clock. Lecture: from "
            "+z against the clock.");
  const Spot center{190, 170};
  const double r = 66;
  d.circle(center, r, "fill-soft");
  d.circle(center, r, "ink");
  d.text(center + Spot{-r + 8, 5}, "-x", Anchor::start, "small");
  d.text(center + Spot{0, r - 8}, "+z", Anchor::middle, "small");
  d.text(center + Spot{r - 8, 5}, "+x", Anchor::end, "small");
  d.text(center + Spot{0, -r + 18}, "-z", Anchor::middle, "small");
  const std::array<const char*, 3> styles{"red", "blue", "green"};
  const std::array<const char*, 3> begins{"begins at -x, runs west", "begins at -x, runs east",
                                          "begins at +z, runs east"};
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels.at(i);
    const std::string style = styles.at(i);
    const double radius = r + 24 * (static_cast<double>(i) + 1);
    const auto place = [&](double u) {
      return from_above(direction_in(panel.convention, {u, 0.5}), center, radius);
    };
    curved_arrow(d, place, 0, 0.94, style);
    d.dot(place(0), "fill-" + style);
    const double top = 90 + 80 * static_cast<double>(i);
    d.text({352, top}, panel.documents, Anchor::start, style + " strong");
    d.text({352, top + 20}, begins.at(i), Anchor::start, style + " small");
    d.text({352, top + 38}, std::string("the eye faces ") + panel.at_z, Anchor::start,
           style + " small");
    d.mark(std::string(panel.documents) + " begins", place(0));
    d.mark(std::string(panel.documents) + " a little later", place(0.05));
  }
  d.mark("center", center);
  const Spot eye = center + Spot{0, 178};
  d.dot(eye);
  d.text(eye + Spot{12, 5}, "the eye looks from +z", Anchor::start, "small");
  return d;
}

/// Eight columns by floor(8 u), and by the lecture's (int)(7 u).
Drawing texel_rounding() {
  Drawing d("texel_rounding", 640, 230, "Two ways from u to one of 8 columns",
            "Two bars over u from 0 to 1. Above, floor(8 u): eight cells of equal width, numbered "
            "0 to 7. Below, 7 u cut off: seven wider cells, 0 to 6; column 7 is met at u = 1 "
            "alone.");
  const int n = 8;
  const double left = 60, width = 480, height = 36;
  const auto bar = [&](double top, int cells, const std::string& name) {
    for (int i = 0; i < cells; ++i) {
      const double from = left + width * i / cells;
      if (i % 2 == 0) d.rectangle({from, top}, width / cells, height, "fill-blue");
      d.rectangle({from, top}, width / cells, height, "soft");
      d.text({from + width / cells / 2, top + height / 2 + 5}, std::to_string(i), Anchor::middle,
             "small");
      d.mark(name + std::to_string(i), {from, top});
    }
  };
  bar(46, n, "floor ");
  bar(126, n - 1, "lecture ");
  d.line({left + width, 126}, {left + width, 126 + height}, "red thick");
  d.text({left + width + 12, 149}, "7, at u = 1", Anchor::start, "red small");
  d.text({left, 36}, "floor(8 u)", Anchor::start, "small strong");
  d.text({left, 116}, "7 u, decimals cut off", Anchor::start, "small strong");
  d.arrow({left, 186}, {left + width, 186}, "ink");
  d.text({left, 208}, "u = 0");
  d.text({left + width, 208}, "u = 1");
  d.mark("end", {left + width, 186});
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_04() {
  return {four_conventions(), letter_and_faults(), u_from_above(), texel_rounding()};
}

}  // namespace texmap::diagrams
