// The computed diagram of chapter 02: longitude and latitude on the sphere.
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
  const Uv<double> uv{0.38, 0.66};
  const Vec3d p = at(uv.u, uv.v);

  d.circle(view({0, 0, 0}), 150, "fill-soft");
  d.circle(view({0, 0, 0}), 150, "ink");
  for (const double v : {0.25, 0.75}) {
    view.draw(d, "soft", 0, 1, [&](double u) { return at(u, v); });
  }
  for (int i = 1; i < 8; ++i) {
    view.draw(d, "soft", 0, 1, [&](double v) { return at(i / 8.0, v); });
  }
  view.draw(d, "ink", 0, 1, [](double u) { return at(u, 0.5); });
  view.draw(d, "red thick", 0, 1, [](double v) { return at(0, v); });
  // The axes, from the surface outward.
  d.arrow(view({1, 0, 0}), view({1.35, 0, 0}), "ink");
  d.arrow(view({0, 1, 0}), view({0, 1.32, 0}), "ink");
  d.arrow(view({0, 0, 1}), view({0, 0, 2}), "ink");
  d.text(view({1.35, 0, 0}) + Spot{10, 5}, "x", Anchor::start);
  d.text(view({0, 1.32, 0}) + Spot{10, 6}, "y", Anchor::start);
  d.text(view({0, 0, 2}) + Spot{-8, 10}, "z", Anchor::end);
  // The way along the equator, then up: u and v of the point.
  view.draw(d, "blue thick", 0, uv.u, [](double u) { return at(u, 0.5); });
  view.draw(d, "green thick", 0.0, uv.v, [&](double v) { return at(uv.u, v); });
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
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_02() { return {sphere_uv()}; }

}  // namespace texmap::diagrams
