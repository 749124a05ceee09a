// The diagrams of chapter 02: longitude and latitude on the sphere, the square they unfold to, and
// why an angle near 0 is not to be had from its cosine.
#include <cmath>
#include <numbers>
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

/// The sphere cut at the seam and unfolded to the unit square.
Drawing unfolding() {
  Drawing d("unfolding", 640, 330, "The sphere, cut at the seam and laid flat",
            "A square with u from 0 to 1 to the right and v from 0 to 1 upward. Along the middle "
            "line stand the directions: -x at u = 0, +z at 1/4, +x at 1/2, -z at 3/4, -x again at "
            "1. The whole upper edge is the north pole, the whole lower edge the south pole.");
  const double left = 80, top = 40, width = 480, height = 240;
  const auto place = [&](Uv<double> uv) {
    return Spot{left + uv.u * width, top + (1 - uv.v) * height};
  };
  d.rectangle({left, top}, width, height, "fill-soft");
  for (int i = 1; i < 8; ++i) d.line(place({i / 8.0, 0}), place({i / 8.0, 1}), "soft");
  for (int i = 1; i < 4; ++i) d.line(place({0, i / 4.0}), place({1, i / 4.0}), "soft");
  d.line(place({0, 0}), place({0, 1}), "red thick");
  d.line(place({1, 0}), place({1, 1}), "red thick");
  d.line(place({0, 1}), place({1, 1}), "ink thick");
  d.line(place({0, 0}), place({1, 0}), "ink thick");
  d.line(place({0, 0.5}), place({1, 0.5}), "blue");
  const auto name = [&](const Vec3d& p, const char* words, double shift) {
    const Spot spot = place(uv_rtiow(p)) + Spot{shift, 0};
    d.dot(spot, "fill-blue");
    d.text(spot + Spot{shift > 0 ? -8.0 : 8.0, -10}, words, shift > 0 ? Anchor::end : Anchor::start,
           "blue");
    d.mark(words, spot);
  };
  name({-1, 0, 0}, "-x", 0);
  name({0, 0, 1}, "+z", 0);
  name({1, 0, 0}, "+x", 0);
  name({0, 0, -1}, "-z", 0);
  d.dot(place({1, 0.5}), "fill-blue");
  d.text(place({1, 0.5}) + Spot{-8, -10}, "-x", Anchor::end, "blue");
  const Uv<double> uv = uv_of_p;
  d.line(place({0, uv.v}), place(uv), "blue thick");
  d.line(place({uv.u, 0}), place(uv), "green thick");
  d.dot(place(uv), "fill-red");
  d.text(place(uv) + Spot{10, -6}, "p", Anchor::start, "red");
  d.text(place({0.19, uv.v}) + Spot{0, -8}, "u", Anchor::middle, "blue strong");
  d.text(place({uv.u, 0.3}) + Spot{10, 0}, "v", Anchor::start, "green strong");
  d.text({left, top + height + 24}, "u = 0", Anchor::middle);
  d.text({left + width, top + height + 24}, "u = 1", Anchor::middle);
  d.text({left - 10, top + 6}, "v = 1", Anchor::end);
  d.text({left - 10, top + height + 5}, "v = 0", Anchor::end);
  d.text({left + width / 2, top - 12}, "north pole: the whole edge is one point", Anchor::middle,
         "small");
  d.text({left + width / 2, top + height + 24}, "south pole", Anchor::middle, "small");
  d.text({left + width + 10, top + 60}, "seam", Anchor::start, "red small");
  d.text({left - 10, top + 60}, "seam", Anchor::end, "red small");
  d.mark("p", place(uv));
  return d;
}

/// The circle of p's latitude, seen from above: x and z are cosine and sine of an angle.
Drawing longitude() {
  Drawing d("longitude", 640, 340, "The longitude, seen from above",
            "A circle of radius r, seen from above, with x to the right and z downward on the "
            "page. The angle phi goes from the x axis toward z. The point p has x = r cos phi "
            "and z = r sin phi. u is 1/2 at +x, 1/4 at +z, 0 and 1 at -x, and 3/4 at -z; it "
            "grows against phi, to the east.");
  const Spot center{320, 165};
  const double radius = 115;
  const auto place = [&](double u) {
    const Vec3d p = at(u, 0.5);
    return center + Spot{p.x, p.z} * radius;
  };
  const Spot p = place(uv_of_p.u), on_x{p.x, center.y}, on_z{center.x, p.y};
  const double degrees = 360 * (0.5 - uv_of_p.u);
  d.circle(center, radius, "fill-soft");
  d.circle(center, radius, "ink");
  d.arrow(center, center + Spot{radius + 40, 0}, "ink");
  d.arrow(center, center + Spot{0, radius + 40}, "ink");
  d.line(center, center + Spot{-radius, 0}, "soft");
  d.line(center, center + Spot{0, -radius}, "soft");
  d.line(on_x, p, "soft");
  d.line(on_z, p, "soft");
  d.line(center, on_x, "blue thick");
  d.line(center, on_z, "green thick");
  d.line(center, p, "red");
  d.arc(center, 34, -degrees, 0, "ink");
  d.text(center + Spot{46, 22}, "φ", Anchor::middle, "strong");
  d.text((center + on_x) * 0.5 + Spot{0, -8}, "r cos φ", Anchor::middle, "blue small");
  d.text((center + on_z) * 0.5 + Spot{-8, 5}, "r sin φ", Anchor::end, "green small");
  d.text((center + p) * 0.5 + Spot{-4, 20}, "r", Anchor::end, "red small");
  d.text(p + Spot{10, 14}, "p", Anchor::start, "red");
  d.text(center + Spot{radius + 46, 5}, "x", Anchor::start);
  d.text(center + Spot{10, radius + 42}, "z", Anchor::start);
  // Which way u grows: from -x through +z to +x.
  d.arc(center, radius + 18, -170, -100, "blue");
  const Spot tip = center + Spot{std::cos(100 * std::numbers::pi / 180),
                                 std::sin(100 * std::numbers::pi / 180)} *
                                (radius + 18);
  d.arrow(tip + Spot{-4, -0.7}, tip + Spot{8, 1.4}, "blue");
  d.text({206, 275}, "u grows to the east", Anchor::end, "blue small");
  const auto side = [&](Vec3d axis, Spot shift, Anchor anchor, const std::string& first,
                        const std::string& second) {
    const Spot spot = place(uv_rtiow(axis).u);
    d.dot(spot, "fill-blue");
    d.text(spot + shift, first, anchor, "small");
    d.text(spot + shift + Spot{0, 17}, second, anchor, "small");
    d.mark(first, spot);
  };
  side({1, 0, 0}, {14, -36}, Anchor::start, "+x: φ = 0", "u = 1/2");
  side({0, 0, 1}, {26, 18}, Anchor::start, "+z: φ = π/2", "u = 1/4");
  side({-1, 0, 0}, {-12, -4}, Anchor::end, "-x: φ = π or -π", "u = 0 or 1: the seam");
  side({0, 0, -1}, {0, -28}, Anchor::middle, "-z: φ = -π/2", "u = 3/4");
  d.dot(p, "fill-red");
  d.mark("p", p);
  d.mark("center", center);
  return d;
}

/// The half circle through the poles and p: r and -y are sine and cosine of an angle.
Drawing polar_angle() {
  Drawing d("polar_angle", 640, 330, "The angle from the south pole",
            "A half circle of radius 1 from the south pole at the bottom to the north pole at the "
            "top. The angle theta goes from the south pole to the point p; the rest of the half "
            "turn, pi - theta, goes from p to the north pole. The distance of p from the axis is "
            "r = sin theta, its height is y = cos(pi - theta) = - cos theta.");
  const Spot center{250, 165};
  const double radius = 130;
  const double angle = uv_of_p.v * std::numbers::pi;
  // In the plane of the axis and p: r to the right, y up.
  const Vec3d on_sphere = at(uv_of_p.u, uv_of_p.v);
  const double r = std::hypot(on_sphere.x, on_sphere.z);
  const Spot p = center + Spot{r, -on_sphere.y} * radius, foot{center.x, p.y};
  d.arc(center, radius, -90, 90, "ink");
  d.line(center + Spot{0, -radius}, center + Spot{0, radius}, "soft");
  d.line(center, center + Spot{radius, 0}, "soft");
  d.arrow(center + Spot{0, -radius}, center + Spot{0, -radius - 28}, "ink");
  d.text(center + Spot{10, -radius - 18}, "y", Anchor::start);
  d.line(center, foot, "green thick");
  d.line(foot, p, "blue thick");
  d.line(center, p, "red");
  d.arc(center, 36, -90, angle * 180 / std::numbers::pi - 90, "ink");
  d.arc(center, 24, angle * 180 / std::numbers::pi - 90, 90, "ink");
  d.text(center + Spot{46, 28}, "θ", Anchor::middle, "strong");
  d.text(center + Spot{16, -38}, "π - θ", Anchor::start, "small");
  d.text((center + foot) * 0.5 + Spot{-10, 5}, "y = -cos θ", Anchor::end, "green");
  d.text((foot + p) * 0.5 + Spot{0, -10}, "r = sin θ", Anchor::middle, "blue");
  d.text((center + p) * 0.5 + Spot{4, 18}, "1", Anchor::start, "red small");
  d.dot(p, "fill-red");
  d.text(p + Spot{12, -2}, "p", Anchor::start, "red");
  const auto height = [&](double v, const std::string& words) {
    const double theta = v * std::numbers::pi;
    const Spot spot = center + Spot{std::sin(theta), std::cos(theta)} * radius;
    d.dot(spot);
    d.text(spot + Spot{v == 0.5 ? 12.0 : 20.0, v == 0   ? 18.0
                                               : v == 1 ? -6.0
                                                        : 5.0},
           words, Anchor::start, "small");
    d.mark(words.substr(0, words.find(':')), spot);
  };
  height(0, "south pole: θ = 0, v = 0");
  height(0.5, "equator: θ = π/2, v = 1/2");
  height(1, "north pole: θ = π, v = 1");
  d.mark("p", p);
  d.mark("center", center);
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

/// The unit square with the checkerboard, and the square that holds p.
Drawing checkerboard() {
  Drawing d("checkerboard", 640, 376, "The checkerboard on the flat square",
            "Ten columns and ten rows of squares in two colors. u goes to the right and v goes up, "
            "both from 0 to 1. The point p = (0.38, 0.66) is in column 3 and row 6; the sum is 9, "
            "an odd number, so the square is white.");
  const int count = 10;
  const double left = 140, top = 44, width = 480, height = 240;
  const double right = left + width, bottom = top + height;
  const auto place = [&](Uv<double> uv) {
    return Spot{left + uv.u * width, top + (1 - uv.v) * height};
  };
  const double wide = width / count, high = height / count;
  const auto corner = [&](int column, int row) { return place({column / 10.0, (row + 1) / 10.0}); };
  for (int row = 0; row < count; ++row) {
    for (int column = row % 2; column < count; column += 2)
      d.rectangle(corner(column, row), wide, high, "fill-blue");
  }
  const int column = static_cast<int>(std::floor(uv_of_p.u * count));
  const int row = static_cast<int>(std::floor(uv_of_p.v * count));
  d.rectangle({left, top}, width, height, "soft");
  d.rectangle(corner(column, row), wide, high, "red");
  d.dot(place(uv_of_p), "fill-red");
  d.line(place({uv_of_p.u, 1}) + Spot{0, -10}, place(uv_of_p) + Spot{0, -5}, "red");
  d.text(place({uv_of_p.u, 1}) + Spot{0, -16}, "p = (0.38, 0.66)", Anchor::middle, "red small");
  for (int i = 0; i < count; ++i) {
    d.text({left + (i + 0.5) * wide, bottom + 20}, std::to_string(i), Anchor::middle,
           i == column ? "red strong" : "small");
    d.text({left - 14, bottom - (i + 0.5) * high + 5}, std::to_string(i), Anchor::middle,
           i == row ? "red strong" : "small");
  }
  d.arrow({left, bottom + 34}, {right, bottom + 34}, "ink");
  d.arrow({left - 30, bottom}, {left - 30, top}, "ink");
  d.text({left, bottom + 54}, "0", Anchor::middle, "small");
  d.text({left + width / 2, bottom + 54}, "u");
  d.text({right, bottom + 54}, "1", Anchor::middle, "small");
  d.text({left - 40, bottom + 4}, "0", Anchor::end, "small");
  d.text({left - 40, top + height / 2 + 5}, "v", Anchor::end);
  d.text({left - 40, top + 8}, "1", Anchor::end, "small");
  d.text({left + width / 2, bottom + 80}, "column = floor(10 u)", Anchor::middle, "small");
  d.text({left - 58, top + height / 2 - 6}, "row =", Anchor::end, "small");
  d.text({left - 58, top + height / 2 + 12}, "floor(10 v)", Anchor::end, "small");
  d.mark("p", place(uv_of_p));
  d.mark("square", corner(column, row));
  d.mark("u = v = 0", {left, bottom});
  d.mark("u = v = 1", {right, top});
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_02() {
  return {sphere_uv(), unfolding(), longitude(), polar_angle(), flat_cosine(), checkerboard()};
}

}  // namespace texmap::diagrams
