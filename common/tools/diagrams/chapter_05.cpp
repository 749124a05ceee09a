// The diagrams of chapter 05: the rotation from above, and the look-up against the picture.
#include <string>

#include "diagrams.hpp"
#include "from_above.hpp"
#include "math/rotation.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::diagrams {
namespace {

/// Where the two unit vectors go, and a point with them.
Drawing rotation_from_above() {
  Drawing d("rotation_from_above", 640, 320, "A rotation about y, seen from above",
            "A circle seen from above the north pole, x to the right, z down toward the eye. A "
            "positive angle beta turns against the clock: the unit vector along x goes to (cos "
            "beta, minus sin beta), the one along z goes to (sin beta, cos beta). A point p turns "
            "with them to p'.");
  const Spot center{180, 160};
  const double r = 110;
  const double beta = 35;
  const RotationY rotation = rotation_y(beta);
  const auto at = [&](const Vec3d& p) { return from_above(p, center, r); };
  const Vec3d x{1, 0, 0}, z{0, 0, 1};
  const Vec3d p = direction_rtiow(Uv<double>{0.08, 0.5});
  d.circle(center, r, "fill-soft");
  d.circle(center, r, "ink");
  d.arrow(at({-1.15, 0, 0}), at({1.35, 0, 0}), "soft");
  d.arrow(at({0, 0, -1.15}), at({0, 0, 1.35}), "soft");
  d.text(at({1.35, 0, 0}) + Spot{10, 5}, "x", Anchor::start);
  d.text(at({0, 0, 1.35}) + Spot{12, 4}, "z", Anchor::start);
  d.arrow(center, at(rotation(x)), "blue");
  d.arrow(center, at(rotation(z)), "green");
  const auto turned = [&](const Vec3d& from, double radius) {
    return [from, radius, center, r](double degrees) {
      return from_above(rotation_y(degrees)(from), center, radius * r);
    };
  };
  curved_arrow(d, turned(x, 0.5), 0, beta, "ink");
  curved_arrow(d, turned(z, 0.5), 0, beta, "ink");
  d.text(turned(x, 0.5)(beta / 2) + Spot{8, 2}, "β", Anchor::start);
  d.text(turned(z, 0.5)(beta / 2) + Spot{4, 18}, "β", Anchor::start);
  d.dot(at(p), "fill-red");
  d.dot(at(rotation(p)), "fill-red");
  curved_arrow(d, turned(p, 1.12), 3, beta - 3, "red");
  d.text(at(p) + Spot{8, -4}, "p", Anchor::start, "red strong");
  d.text(at(rotation(p)) + Spot{2, -10}, "p'", Anchor::start, "red strong");
  d.text({370, 90}, "the x axis turns to", Anchor::start, "blue small");
  d.text({370, 112}, "x = cos β,  z = -sin β", Anchor::start, "blue");
  d.text({370, 160}, "the z axis turns to", Anchor::start, "green small");
  d.text({370, 182}, "x = sin β,  z = cos β", Anchor::start, "green");
  d.text({370, 230}, "p = (x, z) turns with them to", Anchor::start, "red small");
  d.text({370, 252}, "p' = (x', z')", Anchor::start, "red");
  d.mark("center", center);
  d.mark("x'", at(rotation(x)));
  d.mark("z'", at(rotation(z)));
  d.mark("p", at(p));
  d.mark("p'", at(rotation(p)));
  return d;
}

/// What the eye sees without and with the rotation of the look-up.
Drawing look_up_and_picture() {
  Drawing d("look_up_and_picture", 640, 330, "The look-up turns forward, the picture backward",
            "Twice the globe from above, the eye at the bottom. Left, without rotation: a "
            "continent lies to the right of the point p that faces the eye. Right: p looks up the "
            "color of p', which is beta further east, so the continent now lies at p. The look-up "
            "went to the right, the picture to the left.");
  const double r = 92;
  const double beta = 50;
  const Vec3d p{0, 0, 1};
  const auto panel = [&](Spot center, bool turns) {
    const auto at = [&](double degrees, double radius) {
      return from_above(rotation_y(degrees)(p), center, radius * r);
    };
    const auto along = [&](double radius) {
      return [&at, radius](double degrees) { return at(degrees, radius); };
    };
    const auto continent = [&](double degrees, const std::string& style) {
      std::vector<Spot> through;
      for (int i = -14; i <= 14; i += 2) through.push_back(at(degrees + i, 1));
      d.curve(through, style);
    };
    d.circle(center, r, "fill-soft");
    d.circle(center, r, "ink");
    d.dot(center);
    d.text(center + Spot{0, -10}, "north pole", Anchor::middle, "small");
    d.dot(at(0, 1), "fill-red");
    d.text(at(0, 1) + Spot{0, -14}, "p", Anchor::middle, "red strong");
    const Spot eye = center + Spot{0, r + 58};
    d.dot(eye);
    d.text(eye + Spot{10, 5}, "eye", Anchor::start, "small");
    d.line(eye + Spot{0, -8}, at(0, 1.3), "soft dashed");
    d.text(center + Spot{0, -r - 18}, turns ? "the look-up turned by β" : "without rotation",
           Anchor::middle, "small strong");
    if (!turns) {
      continent(beta, "green thick");
      d.text(at(beta, 1.12) + Spot{0, 8}, "a continent", Anchor::start, "green small");
      d.mark("continent before", at(beta, 1));
      return;
    }
    d.dot(at(beta, 1), "fill-red");
    d.text(at(beta, 0.84) + Spot{-4, 2}, "p'", Anchor::end, "red strong");
    continent(0, "green thick");
    curved_arrow(d, along(1.2), 0, beta, "blue");
    curved_arrow(d, along(1.42), beta, 0, "green");
    d.text(at(beta / 2, 1.55) + Spot{8, 8}, "the picture", Anchor::start, "green small");
    d.text(at(beta, 1.2) + Spot{10, -2}, "the look-up", Anchor::start, "blue small");
    d.mark("p", at(0, 1));
    d.mark("p'", at(beta, 1));
    d.mark("continent after", at(0, 1));
    d.mark("center", center);
  };
  panel({150, 140}, false);
  panel({420, 140}, true);
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_05() { return {rotation_from_above(), look_up_and_picture()}; }

}  // namespace texmap::diagrams
