// The diagrams of chapter 02: longitude and latitude on the sphere, and the square they unfold to.
#include <cmath>

#include "diagrams.hpp"
#include "texture/uv.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::diagrams {
namespace {

Vec3d at(double u, double v) { return direction_rtiow(Uv<double>{u, v}); }

/// The sphere with its axes, one point's longitude and latitude, the seam and the poles.
Drawing sphere_uv() {
  Drawing d("sphere_uv", 640, 400, "Longitude and latitude of a point",
            "A sphere with the axes x to the right, y up and z toward the reader. The seam runs "
            "from the south pole to the north pole through -x. u grows from the seam through +z, "
            "+x and -z; v grows from the south pole to the north pole.");
  const Vec3d from{0.45, 0.42, 1};
  const SpaceView view(from, {320, 205}, 150);
  const Uv<double> uv{0.42, 0.7};
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
  d.arrow(view({0, 0, 1}), view({0, 0, 1.6}), "ink");
  d.text(view({1.35, 0, 0}) + Spot{10, 5}, "x", Anchor::start);
  d.text(view({0, 1.32, 0}) + Spot{10, 6}, "y", Anchor::start);
  d.text(view({0, 0, 1.6}) + Spot{-10, 12}, "z", Anchor::end);
  // The way along the equator, then up: u and v of the point.
  view.draw(
      d, [](double u) { return at(u, 0.5); }, 0, uv.u, "blue thick");
  view.draw(
      d, [&](double v) { return at(uv.u, v); }, 0.0, uv.v, "green thick");
  d.dot(view(p), "fill-red");
  d.text(view(p) + Spot{12, -8}, "p = (x, y, z)", Anchor::start, "red");
  d.text(view(at(0.3, 0.5)) + Spot{0, 24}, "u", Anchor::middle, "blue strong");
  d.text(view(at(uv.u, 0.6)) + Spot{12, 4}, "v", Anchor::start, "green strong");
  d.dot(view(at(0, 1)));
  d.dot(view(at(0, 0)), "fill-ink");
  d.text({20, 60}, "seam: u = 0 and u = 1,", Anchor::start, "red small");
  d.text({20, 78}, "the meridian through -x", Anchor::start, "red small");
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
  const Uv<double> uv{0.42, 0.7};
  d.line(place({0, uv.v}), place(uv), "blue thick");
  d.line(place({uv.u, 0}), place(uv), "green thick");
  d.dot(place(uv), "fill-red");
  d.text(place(uv) + Spot{10, -6}, "p", Anchor::start, "red");
  d.text(place({0.21, uv.v}) + Spot{0, -8}, "u", Anchor::middle, "blue strong");
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

}  // namespace

std::vector<Drawing> diagrams_of_02() { return {sphere_uv(), unfolding()}; }

}  // namespace texmap::diagrams
