// The computed diagrams of chapter 02: longitude and latitude on the sphere, and why an angle near
// 0 is not to be had from its cosine.
#include <cmath>
#include <string>

#include "diagrams.hpp"
#include "texture/uv.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::diagrams {
namespace {

// The point p of all of them.
constexpr Uv<double> uv_of_p{0.38, 0.66};

Vec3d at(double u, double v) { return direction_rtiow(Uv<double>{u, v}); }

/// The sphere with its axes, one point's longitude and latitude, the seam and the poles.
Drawing sphere_uv() {
  Drawing d("sphere_uv", 640, 400, "Longitude and latitude of a point",
            "A sphere with the axes x to the right, y up and z toward the reader. The seam runs "
            "from the south pole to the north pole through -x. u grows from the seam through +z, "
            "+x and -z; v grows from the south pole to the north pole.");
  const Vec3d from{0.45, 0.42, 1};
  const SpaceView view(from, {320, 205}, 150);
  const Uv<double> uv = uv_of_p;
  const Vec3d p = at(uv.u, uv.v);

  d.circle(view({0, 0, 0}), 150, "fill-soft");
  d.circle(view({0, 0, 0}), 150, "ink");
  for (const double v : {0.25, 0.75}) {
    view.draw(
        d, [&](double u) { return at(u, v); }, 0, 1, "soft");
  }
  for (int i = 1; i < 8; ++i) {
    view.draw(
        d, [&](double v) { return at(i / 8.0, v); }, 0, 1, "soft");
  }
  view.draw(
      d, [](double u) { return at(u, 0.5); }, 0, 1, "ink");
  view.draw(
      d, [](double v) { return at(0, v); }, 0, 1, "red thick");
  // The axes, from the surface outward.
  d.arrow(view({1, 0, 0}), view({1.35, 0, 0}), "ink");
  d.arrow(view({0, 1, 0}), view({0, 1.32, 0}), "ink");
  d.arrow(view({0, 0, 1}), view({0, 0, 2}), "ink");
  d.text(view({1.35, 0, 0}) + Spot{10, 5}, "x", Anchor::start);
  d.text(view({0, 1.32, 0}) + Spot{10, 6}, "y", Anchor::start);
  d.text(view({0, 0, 2}) + Spot{-8, 10}, "z", Anchor::end);
  // The way along the equator, then up: u and v of the point.
  view.draw(
      d, [](double u) { return at(u, 0.5); }, 0, uv.u, "blue thick");
  view.draw(
      d, [&](double v) { return at(uv.u, v); }, 0.0, uv.v, "green thick");
  d.dot(view(p), "fill-red");
  d.text(view(p) + Spot{10, -4}, "p", Anchor::start, "red");
  d.text(view(at(0.3, 0.5)) + Spot{0, 24}, "u", Anchor::middle, "blue strong");
  d.text(view(at(uv.u, 0.6)) + Spot{12, 4}, "v", Anchor::start, "green strong");
  d.dot(view(at(0, 1)));
  d.dot(view(at(0, 0)), "fill-ink");
  d.text({20, 60}, "seam: u = 0 and u = 1,", Anchor::start, "red small");
  d.text({20, 78}, "the line from pole to", Anchor::start, "red small");
  d.text({20, 96}, "pole through -x", Anchor::start, "red small");
  d.line({150, 84}, view(at(0, 0.62)) + Spot{-4, -4}, "soft");
  d.text({470, 40}, "north pole, v = 1", Anchor::start, "small");
  d.line({466, 38}, view(at(0, 1)) + Spot{6, -2}, "soft");
  d.text({470, 380}, "south pole, v = 0", Anchor::start, "small");
  d.line({466, 376}, view(at(0, 0)) + Spot{6, 2}, "soft");
  d.mark("point", view(p));
  d.mark("seam on the equator", view(at(0, 0.5)));
  d.mark("north", view(at(0, 1)));
  d.mark("south", view(at(0, 0)));
  d.mark("+x", view({1, 0, 0}));
  d.mark("+z", view({0, 0, 1}));
  return d;
}

/// Equal steps of the cosine and of the sine, and the angles that have them.
Drawing flat_cosine() {
  Drawing d("flat_cosine", 640, 300, "Angles found from a cosine and from a sine",
            "Left: the curve of the cosine is flat at the angle 0. Values in equal steps below 1 "
            "belong to angles with a wide gap next to 0. Right: the sine rises straight from 0, "
            "and equal steps of it belong to nearly equal steps of the angle.");
  const double step = 1.0 / 16, widest = 1.1, size = 210;
  const auto panel = [&](Spot origin, const std::string& name, const auto& value_of,
                         const auto& angle_of) {
    const auto place = [=](double angle, double value) {
      return origin + Spot{angle / widest * 240, -value * size};
    };
    for (int i = 1; i <= 16; ++i) {
      const double value = i * step;
      const double angle = angle_of(value);
      if (angle > 1) continue;
      d.line(place(0, value), place(angle, value), "soft");
      d.line(place(angle, value), place(angle, 0), "soft");
      d.dot(place(angle, 0), "fill-blue");
    }
    std::vector<Spot> curve;
    for (int i = 0; i <= 48; ++i) {
      const double angle = i / 48.0;
      curve.push_back(place(angle, value_of(angle)));
    }
    d.arrow(place(0, 0), place(widest, 0), "ink");
    d.arrow(place(0, 0), place(0, 1.1), "ink");
    d.curve(curve, "red thick");
    d.text(place(0, 1) + Spot{-8, 5}, "1", Anchor::end, "small");
    d.text(place(0, 0) + Spot{-8, 5}, "0", Anchor::end, "small");
    d.text(place(widest, 0) + Spot{4, 5}, "θ", Anchor::start);
    d.text(place(0, 1.1) + Spot{10, 4}, name, Anchor::start, "red");
    return place;
  };
  const auto left = panel(
      {40, 245}, "cos θ", [](double x) { return std::cos(x); },
      [](double y) { return std::acos(y); });
  const double gap = std::acos(1 - step);
  d.line(left(0, 0), left(gap, 0), "red thick");
  d.text(left(0.5, 0) + Spot{0, 28}, "next to θ = 0 no angle for a long way", Anchor::middle,
         "small");
  const auto right = panel(
      {360, 245}, "sin θ", [](double x) { return std::sin(x); },
      [](double y) { return std::asin(y); });
  d.text(right(0.5, 0) + Spot{0, 28}, "angles close to one another", Anchor::middle, "small");
  d.mark("pole", left(0, 0));
  d.mark("first angle from the cosine", left(gap, 0));
  d.mark("first angle from the sine", right(std::asin(step), 0));
  d.mark("pole of the sine", right(0, 0));
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_02() { return {sphere_uv(), flat_cosine()}; }

}  // namespace texmap::diagrams
