// The computed diagram of chapter 04: where each convention begins and which way it runs.
#include <array>
#include <string>

#include "diagrams.hpp"
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
  const char* name;
  const char* runs;     ///< which way u and v run
  const char* at_x;     ///< u at -x
  const char* at_z;     ///< u at +z
  const char* verdict;  ///< what a picture looks like
};

constexpr std::array<Panel, 3> panels{{
    {Convention::daily, "daily", "u west, v down", "u = 0", "u = 3/4", "mirrored"},
    {Convention::rtiow, "rtiow", "u east, v up", "u = 0", "u = 1/4", "reads as printed"},
    {Convention::lecture, "lecture", "u east, v up", "u = 3/4", "u = 0", "reads as printed"},
}};

/// Draws the visible part of a curve on the sphere.
template <class Curve>
void draw_front(Drawing& d, const SpaceView& view, const std::string& style, double from, double to,
                const Curve& point_at) {
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

/// Draws a curve with an arrow's head at its end.
///
/// @param spot_at  called with numbers from `from` to `to`; returns a Spot
template <class Curve>
void curved_arrow(Drawing& drawing, const std::string& style, double from, double to,
                  const Curve& spot_at) {
  const int pieces = 64;
  std::vector<Spot> through;
  for (int i = 0; i <= pieces; ++i) through.push_back(spot_at(from + (to - from) * i / pieces));
  const Spot tip = through.back();
  // The line ends inside the head, which is 9 long.
  while (through.size() > 2) {
    const Spot rest = tip - through.back();
    if (rest.x * rest.x + rest.y * rest.y >= 81) break;
    through.pop_back();
  }
  drawing.curve(through, style);
  const Spot along = tip - through.back();
  drawing.arrow(tip - along * 1.01, tip, style);
}

/// The letter F of a picture, placed by a convention around the meridian that faces the viewer.
void draw_letter(Drawing& d, const SpaceView& view, const Panel& panel) {
  const double facing = uv_of(panel.convention, on_map(0.125, 0.5)).u;
  const bool up = v_axis_of(panel.convention) == VAxis::up;
  // right and high are measured in the picture: from its middle column, and from its lower edge.
  const auto at = [&](double right, double high) {
    return view(direction_in(panel.convention, {facing + right, up ? high : 1 - high}));
  };
  d.curve({at(-0.035, 0.56), at(-0.035, 0.68), at(-0.035, 0.8)}, "ink thick");
  d.curve({at(-0.035, 0.8), at(0.01, 0.8), at(0.055, 0.8)}, "ink thick");
  d.curve({at(-0.035, 0.69), at(0.03, 0.69)}, "ink thick");
}

/// The same globe with each of the three maps.
Drawing four_conventions() {
  Drawing d("four_conventions", 640, 300, "Three conventions, the same globe",
            "The same globe three times, seen from between -x and +z. daily: u is 0 at -x and runs "
            "west, v runs down, and a letter F on the picture is mirrored. rtiow: u is 0 at -x and "
            "runs east, v runs up, the F reads as printed. lecture: u is 0 at +z and runs east, v "
            "runs up, the F reads as printed.");
  const double r = 72;
  double x = 108;
  for (const Panel& panel : panels) {
    const Spot center{x, 152};
    const SpaceView view({-1, 0.45, 1}, center, r);
    const auto in_this = [&](double u, double v) { return direction_in(panel.convention, {u, v}); };
    d.circle(center, r, "fill-soft");
    d.circle(center, r, "ink");
    for (int i = 0; i < 4; ++i) {
      draw_front(d, view, "soft", 0, 1, [&](double v) { return in_this(i / 4.0, v); });
    }
    draw_front(d, view, "soft", 0, 1, [&](double u) { return in_this(u, 0.5); });
    draw_front(d, view, "red thick", 0, 1, [&](double v) { return in_this(0, v); });
    draw_letter(d, view, panel);

    // u and v, from one point of the southern hemisphere.
    const Uv<double> from = uv_of(panel.convention, on_map(0.125, 0.36));
    curved_arrow(d, "blue", from.u, from.u + 0.1,
                 [&](double u) { return view(in_this(u, from.v)); });
    curved_arrow(d, "green", from.v, from.v + 0.14,
                 [&](double v) { return view(in_this(from.u, v)); });
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
    d.text({x, 22}, panel.name, Anchor::middle, "small strong");
    d.text({x, 42}, panel.runs, Anchor::middle, "small");
    d.text({x, 276}, panel.verdict, Anchor::middle,
           panel.convention == Convention::daily ? "red" : "plain");
    x += 212;
  }
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_04() { return {four_conventions()}; }

}  // namespace texmap::diagrams
