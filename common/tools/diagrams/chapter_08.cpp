// The diagrams of chapter 08: the weights of a point in a triangle, the view along a ray, the edge
// that two triangles share, and what a texture shows beyond its edges.
#include <array>
#include <cmath>
#include <string>

#include "diagrams.hpp"
#include "scene/edge_function.hpp"
#include "texture/wrap.hpp"

namespace texmap::diagrams {
namespace {

/// Twice the area of a triangle, positive if a, b, c run counterclockwise for the reader.
double twice_area(Spot a, Spot b, Spot c) {
  const Spot ab = b - a, ac = c - a;
  return ab.y * ac.x - ab.x * ac.y;
}

/// A triangle cut into three by a point, and its place in the texture.
Drawing barycentric() {
  Drawing d("barycentric", 640, 340, "The weights of a point in a triangle",
            "Left: a triangle with the corners a, b and c. Lines from the point p to the corners "
            "cut it into three smaller triangles. The one opposite a has 0.4 of the whole area, "
            "the one opposite b has 0.2, the one opposite c has 0.4. Right: the same triangle in "
            "the texture, with a at (0, 0), b at (1, 0) and c at (1, 1); p is at (0.6, 0.4).");
  const Spot a{40, 270}, b{330, 225}, c{210, 45};
  const std::array<double, 3> weights{0.4, 0.2, 0.4};
  const Spot p = a * weights[0] + b * weights[1] + c * weights[2];
  d.area({p, b, c}, "fill-blue");
  d.area({p, c, a}, "fill-red");
  d.area({p, a, b}, "fill-green");
  for (const Spot corner : {a, b, c}) d.line(p, corner, "soft");
  d.line(a, b);
  d.line(b, c);
  d.line(c, a);
  const double whole = twice_area(a, b, c);
  const auto share = [&](Spot from, Spot to, const std::string& name, const std::string& style) {
    const double part = twice_area(p, from, to) / whole;
    const Spot middle = (p + from + to) * (1.0 / 3);
    d.text(middle + Spot{0, 5}, name + " = 0." + std::to_string(std::lround(10 * part)),
           Anchor::middle, style);
  };
  share(b, c, "α", "blue strong");
  // The red triangle is too narrow for its name.
  const Spot in_red = (p + c + a) * (1.0 / 3);
  d.line(in_red, {112, 112}, "soft");
  d.text({104, 106}, "β = 0." + std::to_string(std::lround(10 * twice_area(p, c, a) / whole)),
         Anchor::end, "red strong");
  share(a, b, "γ", "green strong");
  d.dot(p);
  d.text(p + Spot{9, -7}, "p", Anchor::start);
  d.text(a + Spot{-4, 24}, "a", Anchor::middle, "blue");
  d.text(a + Spot{10, 24}, "(u, v) = (0, 0)", Anchor::start, "small");
  d.text(b + Spot{-60, 34}, "b", Anchor::middle, "red");
  d.text(b + Spot{-46, 34}, "(1, 0)", Anchor::start, "small");
  d.text(c + Spot{-14, -10}, "c", Anchor::middle, "green");
  d.text(c + Spot{0, -10}, "(1, 1)", Anchor::start, "small");
  d.text({185, 328}, "in space", Anchor::middle, "small");

  // The same triangle in the texture.
  const Spot corner{400, 260};
  const double size = 200;
  const auto place = [&](double u, double v) { return corner + Spot{u, -v} * size; };
  const double u = weights[1] + weights[2], v = weights[2];
  d.rectangle(place(0, 1), size, size, "fill-soft");
  d.line(place(0, 0), place(1, 0));
  d.line(place(1, 0), place(1, 1));
  d.line(place(1, 1), place(0, 0));
  d.line(place(0, 0), place(0, 1), "soft");
  d.line(place(0, 1), place(1, 1), "soft");
  d.line(place(u, 0), place(u, v), "blue dashed");
  d.line(place(0, v), place(u, v), "green dashed");
  d.dot(place(u, v));
  d.text(place(u, v) + Spot{9, -5}, "p", Anchor::start);
  d.text(place(u, 0) + Spot{0, 20}, "u = 0.6", Anchor::middle, "blue small");
  d.text(place(0, v) + Spot{-6, 5}, "v = 0.4", Anchor::end, "green small");
  d.text(place(0, 0) + Spot{-8, 18}, "a", Anchor::end, "blue");
  d.text(place(1, 0) + Spot{8, 18}, "b", Anchor::start, "red");
  d.text(place(1, 1) + Spot{8, -4}, "c", Anchor::start, "green");
  d.text(place(0.5, 0) + Spot{0, 68}, "in the texture", Anchor::middle, "small");
  d.mark("a", a);
  d.mark("b", b);
  d.mark("c", c);
  d.mark("p", p);
  d.mark("origin of the texture", place(0, 0));
  d.mark("b in the texture", place(1, 0));
  d.mark("p in the texture", place(u, v));
  return d;
}

/// The corners of a triangle slide parallel to the ray onto the plane z = 0, where the ray is one
/// point.
Drawing view_along_ray() {
  Drawing d("view_along_ray", 720, 310, "Corners slide along the ray onto the plane z = 0",
            "Left: the plane z = 0 through the ray's origin, and a triangle with the corners a, b "
            "and c farther along the ray, which goes through it. A dashed line goes from each "
            "corner to the plane, parallel to the ray; its end is the corner's place in the "
            "plane. Right: the plane seen flat. The three places form a triangle, and the ray is "
            "the point (0, 0) in it. Lines from there to the places cut the triangle into three.");
  const Ray<double> ray{{0, 0, 0}, {0.4, 0.25, 1}};
  const RaySpace<double> space(ray);
  const std::array<Vec3d, 3> corners{
      Vec3d{-0.48, -0.45, 1.8}, {2.31, 0.225, 2.9}, {0.88, 1.65, 2.2}};
  const std::array<const char*, 3> names{"a", "b", "c"}, styles{"blue", "red", "green"};
  std::array<Vec3d, 3> places{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d seen = seen_along(space, corners[i]);
    places[i] = Vec3d{seen.x, seen.y, 0} * (1 / ray.direction.z);
  }

  // In space. The viewer is behind the triangle, so that x goes to the right in both halves.
  const SpaceView view({-0.9, 0.42, 0.6}, {104, 180}, 72);
  d.area({view({-1.6, -1.3, 0}), view({1.6, -1.3, 0}), view({1.6, 1.5, 0}), view({-1.6, 1.5, 0})});
  d.area({view(places[0]), view(places[1]), view(places[2])}, "fill-blue");
  d.area({view(corners[0]), view(corners[1]), view(corners[2])}, "fill-green");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    d.line(view(places[i]), view(places[next]));
    d.line(view(corners[i]), view(corners[next]));
    d.line(view(corners[i]), view(places[i]), std::string(styles[i]) + " dashed");
    d.dot(view(places[i]));
    d.dot(view(corners[i]));
    d.mark(std::string(names[i]) + " in space", view(corners[i]));
    d.mark(std::string(names[i]) + " on the plane", view(places[i]));
  }
  const Crossing<double> met =
      crossing(space, seen_along(space, corners[0]), seen_along(space, corners[1]),
               seen_along(space, corners[2]));
  const auto on_ray = [&](double t) { return view(ray.direction * t); };
  d.arrow(on_ray(0), on_ray(4.2), "red thick");
  d.dot(on_ray(0), "fill-red");
  d.dot(on_ray(met.distance), "fill-red");
  d.mark("hit", on_ray(met.distance));
  d.mark("ray's origin", on_ray(0));
  d.mark("ray's end", on_ray(4.2));
  d.text(view(corners[0]) + Spot{0, 22}, "a", Anchor::middle, "blue");
  d.text(view(corners[1]) + Spot{12, 10}, "b", Anchor::start, "red");
  d.text(view(corners[2]) + Spot{10, -4}, "c", Anchor::start, "green");
  d.text(on_ray(4.2) + Spot{-14, -12}, "the ray", Anchor::middle, "red");
  d.text(view({1.6, 1.5, 0}) + Spot{0, -8}, "the plane z = 0", Anchor::end, "small");
  d.text((view(corners[2]) + view(places[2])) * 0.5 + Spot{12, -14}, "parallel to the ray",
         Anchor::middle, "green small");
  d.text({200, 298}, "in space", Anchor::middle, "small");

  // The plane, seen flat.
  const Spot origin{580, 148};
  const double size = 85;
  const auto flat = [&](const Vec3d& p) { return origin + Spot{p.x, -p.y} * size; };
  d.rectangle(flat({-1.6, 1.5, 0}), 3.2 * size, 2.8 * size, "fill-soft");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    d.area({origin, flat(places[next]), flat(places[last])}, std::string("fill-") + styles[i]);
    d.line(flat(places[i]), flat(places[next]));
    d.line(flat(places[i]), origin, "soft");
    d.dot(flat(places[i]));
    d.mark(std::string(names[i]) + " seen flat", flat(places[i]));
  }
  d.dot(origin, "fill-red");
  d.text(origin + Spot{8, -8}, "(0, 0)", Anchor::start, "red");
  d.text(flat(places[0]) + Spot{-6, 20}, "a", Anchor::middle, "blue");
  d.text(flat(places[1]) + Spot{8, 18}, "b", Anchor::middle, "red");
  d.text(flat(places[2]) + Spot{0, -12}, "c", Anchor::middle, "green");
  d.text({580, 298}, "the plane z = 0, seen flat", Anchor::middle, "small");
  d.mark("ray seen flat", origin);
  return d;
}

/// The view along a ray: two triangles, the edge that they share, and what goes wrong if each of
/// them has an edge of its own.
Drawing shared_edge() {
  Drawing d("shared_edge", 640, 300, "A ray near the edge of two triangles",
            "Left: a square of two triangles that share the edge between a and c, seen along the "
            "ray, which is a dot close to that edge. The lower triangle goes along the edge from "
            "c to a, the upper one from a to c. Middle: each triangle has its own rounded edge, "
            "with a gap between them; the dot is in the gap, in no triangle. Right: the rounded "
            "edges overlap, and the dot is in both triangles.");
  const double size = 210;
  const Spot a{40, 250}, b = a + Spot{size, 0}, c = a + Spot{size, -size}, e = a + Spot{0, -size};
  const auto seen = [&](Spot at) { return Vec3d{at.x, -at.y, 1}; };
  const Spot ray = (a + c) * 0.5 + Spot{3, 8};
  const auto from_ray = [&](Spot at) { return seen(at) - seen(ray) + Vec3d{0, 0, 1}; };
  const bool lower = side_of_edge(from_ray(c), from_ray(a)).left;
  d.area({a, b, c}, lower ? "fill-blue" : "fill-soft");
  d.area({a, c, e}, lower ? "fill-soft" : "fill-blue");
  for (const auto& [from, to] : {std::array{a, b}, {b, c}, {c, e}, {e, a}}) d.line(from, to);
  d.line(a, c, "ink");
  // Along the edge in both directions, a little to the side.
  const Spot along = (c - a) * (1 / (size * std::sqrt(2.0))), aside{along.y, -along.x};
  d.arrow(a + along * 228 - aside * 13, a + along * 185 - aside * 13, "blue thick");
  d.arrow(a + along * 70 + aside * 13, a + along * 113 + aside * 13, "red thick");
  d.text(a + along * 205 - aside * 13 + Spot{12, 22}, "c to a", Anchor::start, "blue small");
  d.text(a + along * 92 + aside * 13 + Spot{-12, -12}, "a to c", Anchor::end, "red small");
  d.dot(ray, "fill-red");
  d.text(ray + Spot{12, 14}, "the ray", Anchor::start, "red");
  d.text(a + Spot{-8, 18}, "a");
  d.text(b + Spot{8, 18}, "b");
  d.text(c + Spot{10, -6}, "c");
  d.text(e + Spot{-10, -6}, "d");
  d.text({a.x + size / 2, 290}, "one edge: exactly one triangle", Anchor::middle, "small");

  // Two edges, rounded by each triangle for itself.
  const auto panel = [&](Spot corner, double gap, const std::string& words) {
    const double side = 130;
    const Spot low = corner, high = corner + Spot{side, -side};
    const Spot right = corner + Spot{side, 0}, left = corner + Spot{0, -side};
    const Spot shift{gap, gap};
    d.area({low + shift, right + shift, high + shift}, "fill-blue");
    d.area({low - shift, high - shift, left - shift}, "fill-green");
    d.line(low + shift, high + shift, "blue");
    d.line(low - shift, high - shift, "green");
    const Spot dot = (low + high) * 0.5;
    d.dot(dot, "fill-red");
    d.text({corner.x + side / 2, corner.y + 40}, words, Anchor::middle, "small");
    return dot;
  };
  d.mark("in the crack", panel({320, 215}, 9, "a crack: no triangle"));
  d.mark("in both", panel({490, 215}, -9, "a double hit: both"));
  d.text({470, 40}, "If each triangle rounds the edge for itself:", Anchor::middle, "small");
  d.mark("a", a);
  d.mark("c", c);
  d.mark("ray", ray);
  return d;
}

/// A row of four texels and what the three wrap modes show on both sides of it.
Drawing wrap_modes() {
  Drawing d("wrap_modes", 640, 290, "A texture beyond its edges",
            "A texture of four texels, 0 to 3, covers u from 0 to 1. With repeat the order 0 1 2 "
            "3 comes again on both sides. With mirror it is 3 2 1 0 on both sides. With clamp "
            "there are only texels 0 on the left, and only texels 3 on the right.");
  const double left = 86, size = 43;
  const int texels = 4;
  const auto place = [&](double u) { return left + (u + 1) * texels * size; };
  const std::array<const char*, 4> styles{"fill-blue", "fill-green", "fill-red", "fill-soft"};
  double top = 40;
  for (const auto& [wrap, name] :
       {std::pair{Wrap::repeat, "repeat"}, {Wrap::mirror, "mirror"}, {Wrap::clamp, "clamp"}}) {
    for (int i = -texels; i < 2 * texels; ++i) {
      const double u = (i + 0.5) / texels;
      const int texel = static_cast<int>(wrapped_coordinate(wrap, u) * texels * (1 - 1e-9));
      const Spot corner{place(u) - size / 2, top};
      d.rectangle(corner, size, 50, styles[static_cast<std::size_t>(texel)]);
      d.text(corner + Spot{size / 2, 31}, std::to_string(texel), Anchor::middle,
             i >= 0 && i < texels ? "strong" : "plain");
      d.mark(std::string(name) + " " + std::to_string(i) + " shows " + std::to_string(texel),
             corner);
    }
    for (int i = -1; i <= 2; ++i) d.line({place(i), top}, {place(i), top + 50}, "soft");
    d.rectangle({place(0), top}, texels * size, 50, "ink");
    d.text({left - 12, top + 31}, name, Anchor::end, "small");
    top += 66;
  }
  for (int i = -1; i <= 2; ++i) d.text({place(i), top + 14}, std::to_string(i));
  d.text({place(2) + 14, top + 14}, "u", Anchor::start);
  d.text({place(0.5), 26}, "the texture", Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_08() {
  return {barycentric(), view_along_ray(), shared_edge(), wrap_modes()};
}

}  // namespace texmap::diagrams
