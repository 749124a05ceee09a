// The exercises of chapter 08. The lesson is the chapter's own. It uses first_hit and MeshMapping
// by name; here those names, in the lesson's namespace, lead to the student's function.
#include <cmath>

#include "engine/app/mesh_options.hpp"
#include "exercises.hpp"
#include "texture/mesh_mapping.hpp"

namespace texmap::check {

static Hook<bool(Vec3<double>, Vec3<double>, Vec3<double>)> is_hit;
static Hook<std::array<double, 3>(Vec3<double>, Vec3<double>, Vec3<double>)> weights;
static Hook<Uv<double>(Uv<double>, Uv<double>, Uv<double>, std::array<double, 3>)> mixed;

/// The corners of a triangle as a ray sees them.
static std::array<Vec3<double>, 3> seen(const Mesh& mesh, int triangle, const Ray<double>& ray) {
  const RaySpace<double> space(ray);
  const auto corner = [&](int number) { return seen_along(space, mesh.corner(triangle, number)); };
  return {corner(0), corner(1), corner(2)};
}

/// The nearest triangle that the student lets the ray hit; `met` is false if there is none.
static MeshHit<double> first_hit_by_student(const Mesh& mesh, const Ray<double>& ray) {
  MeshHit<double> nearest;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const auto [a, b, c] = seen(mesh, i, ray);
    if (!is_hit.yours(a, b, c)) continue;
    // The triangle alone, as wide as needed for the ray to hit it.
    const auto corner = [&](int number) { return mesh.corner(i, number); };
    const Point normal = cross(corner(1) - corner(0), corner(2) - corner(0));
    const double distance = dot(corner(0) - ray.origin, normal) / dot(ray.direction, normal);
    if (!(distance > 0) || (nearest.met && distance >= nearest.distance)) continue;
    const double ab = a.x * b.y - a.y * b.x;
    const double bc = b.x * c.y - b.y * c.x;
    const double ca = c.x * a.y - c.y * a.x;
    nearest.met = true;
    nearest.distance = distance;
    nearest.triangle = i;
    nearest.a = bc / (ab + bc + ca);
    nearest.b = ca / (ab + bc + ca);
    nearest.c = ab / (ab + bc + ca);
    nearest.normal = normalize(dot(normal, ray.direction) > 0 ? -normal : normal);
    nearest.point = ray.origin + ray.direction * distance;
    nearest.outside = nearest.point + nearest.normal * 1e-9;
    nearest.inside = nearest.point - nearest.normal * 1e-9;
  }
  return nearest;
}

}  // namespace texmap::check

namespace texmap::chapter_08 {

inline constexpr struct {
  MeshHit<double> operator()(const Mesh& mesh, const Ray<double>& ray) const {
    if (check::is_hit) return check::first_hit_by_student(mesh, ray);
    MeshHit<double> hit = texmap::first_hit(mesh, ray);
    if (check::weights && hit.met) {
      const auto [a, b, c] = check::seen(mesh, static_cast<int>(hit.triangle), ray);
      const auto weights = check::weights.yours(a, b, c);
      hit.a = weights[0];
      hit.b = weights[1];
      hit.c = weights[2];
    }
    return hit;
  }
} first_hit;

struct MeshMapping : texmap::MeshMapping {
  MeshMapping() = default;
  MeshMapping(const texmap::MeshMapping& common) : texmap::MeshMapping(common) {}

  Uv<double> operator()(const MeshHit<double>& hit) const {
    if (!check::mixed) return texmap::MeshMapping::operator()(hit);
    const auto& uv = corners[static_cast<std::size_t>(hit.triangle)];
    return check::mixed.yours(uv[0], uv[1], uv[2], {hit.a, hit.b, hit.c});
  }
};

}  // namespace texmap::chapter_08

#include "08_triangle_uv/lesson.hpp"

namespace texmap::check {
namespace {

using Vector = Vec3<double>;
using Place2 = Uv<double>;
using Weights = std::array<double, 3>;
using chapter_08::Lesson;

double edge(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

Image crate() { return drawn<Lesson>(); }

/// The crate on one of its edges, from the front: some rays pass exactly through the edge between
/// the two triangles of a side.
Image crate_on_its_edge() {
  auto lesson = prepared<Lesson>({"--degrees", "0"});
  Mesh& mesh = lesson.scene.mesh;
  mesh.triangles.resize(12);  // without the floor
  for (Point& p : mesh.points)
    p = {(p.x - p.y) * std::sqrt(0.5), (p.x + p.y) * std::sqrt(0.5), p.z};
  lesson.stage.camera = {
      .eye = {0, 0, 4.5}, .target = {0, 0, 0}, .fov_y_degrees = 50, .anchor = PixelAnchor::corner};
  return render<double>(lesson, view_of(lesson.stage.camera, 400, 300));
}

using IsHit = bool(Vector, Vector, Vector);

/// On which side of the edges the ray is: more than 0 is left.
struct Sides {
  double ab, bc, ca;

  [[nodiscard]] bool all_left() const { return ab >= 0 && bc >= 0 && ca >= 0; }
  [[nodiscard]] bool all_right() const { return ab <= 0 && bc <= 0 && ca <= 0; }
  [[nodiscard]] bool inside_left() const { return ab > 0 && bc > 0 && ca > 0; }
  [[nodiscard]] bool inside_right() const { return ab < 0 && bc < 0 && ca < 0; }
};

/// Answers to the sides of the three edges as many give them.
void add_wrong_answers(std::vector<Mistake<IsHit>>& mistakes) {
  const auto wrong = [&](const char* word, bool (*answer)(const Sides&)) {
    mistakes.push_back({word, [=](Vector p, Vector q, Vector r) {
                          return answer({edge(p, q), edge(q, r), edge(r, p)});
                        }});
  };
  const char* clockwise =
      "triangles with clockwise corners are missed: from there the ray is right of all three edges";
  wrong(clockwise, [](const Sides& is) { return is.all_left(); });
  wrong(clockwise, [](const Sides& is) { return is.inside_left(); });
  const char* counterclockwise =
      "triangles with counterclockwise corners are missed: there the ray is left of all three "
      "edges";
  wrong(counterclockwise, [](const Sides& is) { return is.all_right(); });
  wrong(counterclockwise, [](const Sides& is) { return is.inside_right(); });
  wrong("a ray exactly through an edge hits neither triangle: you see cracks. Take >= and <=",
        [](const Sides& is) { return is.inside_left() || is.inside_right(); });
  const char* half = "one direction of the corners has cracks: take >= and <=, 0 belongs to both";
  wrong(half, [](const Sides& is) { return is.all_left() || is.inside_right(); });
  wrong(half, [](const Sides& is) { return is.inside_left() || is.all_right(); });
  const char* one = "one edge is enough for you: the ray must be on the same side of all three";
  wrong(one, [](const Sides& is) { return !is.inside_right(); });
  wrong(one, [](const Sides& is) { return !is.all_right(); });
  wrong(one, [](const Sides& is) { return !is.inside_left(); });
  wrong(one, [](const Sides& is) { return !is.all_left(); });
  wrong("every ray hits: on the same side means >= 0 for all three, or <= 0 for all three",
        [](const Sides&) { return true; });
  wrong("no ray hits: it is on the left of all three edges or on the right, not both",
        [](const Sides& is) { return is.all_left() && is.all_right(); });
  wrong("hits and misses are exchanged",
        [](const Sides& is) { return !is.all_left() && !is.all_right(); });
  const char* ab = "the edge a to b is missing: two edges leave a triangle open";
  const char* bc = "the edge b to c is missing: two edges leave a triangle open";
  const char* ca = "the edge c to a is missing: two edges leave a triangle open";
  wrong(ab, [](const Sides& is) { return Sides{is.bc, is.bc, is.ca}.all_left(); });
  wrong(bc, [](const Sides& is) { return Sides{is.ab, is.ab, is.ca}.all_left(); });
  wrong(ca, [](const Sides& is) { return Sides{is.ab, is.bc, is.bc}.all_left(); });
  wrong(ab, [](const Sides& is) {
    const Sides two{is.bc, is.bc, is.ca};
    return two.all_left() || two.all_right();
  });
  wrong(bc, [](const Sides& is) {
    const Sides two{is.ab, is.ab, is.ca};
    return two.all_left() || two.all_right();
  });
  wrong(ca, [](const Sides& is) {
    const Sides two{is.ab, is.bc, is.bc};
    return two.all_left() || two.all_right();
  });
  const char* product = "a product is 0 on the line through an edge: compare each one with 0";
  wrong(product, [](const Sides& is) { return is.ab * is.bc >= 0 && is.bc * is.ca >= 0; });
  wrong(product, [](const Sides& is) { return is.bc * is.ca >= 0 && is.ca * is.ab >= 0; });
  wrong(product, [](const Sides& is) { return is.ca * is.ab >= 0 && is.ab * is.bc >= 0; });
  wrong("a product of three does not say that all are on the same side: compare each one with 0",
        [](const Sides& is) { return is.ab * is.bc * is.ca >= 0; });
  wrong("p == q == r compares the answer of p == q with r: write p == q && q == r",
        [](const Sides& is) { return ((is.ab >= 0) == (is.bc >= 0)) == (is.ca >= 0); });
  wrong("p == q == r compares the answer of p == q with r: write p == q && q == r",
        [](const Sides& is) { return ((is.ab > 0) == (is.bc > 0)) == (is.ca > 0); });
  const char* sum = "the sum says which way the corners run: compare each of the three with 0";
  wrong(sum, [](const Sides& is) { return is.ab + is.bc + is.ca >= 0; });
  wrong(sum, [](const Sides& is) { return is.ab + is.bc + is.ca <= 0; });
}

/// What many do with the corners.
std::vector<Mistake<IsHit>> wrong_hits() {
  std::vector<Mistake<IsHit>> mistakes;
  add_wrong_answers(mistakes);
  const auto wrong = [&](const char* word,
                         Sides (*sides)(const Vector&, const Vector&, const Vector&)) {
    mistakes.push_back({word, [=](Vector p, Vector q, Vector r) {
                          const Sides is = sides(p, q, r);
                          return is.all_left() || is.all_right();
                        }});
    mistakes.push_back(
        {word, [=](Vector p, Vector q, Vector r) { return sides(p, q, r).all_left(); }});
  };
  const char* way = "one edge has the wrong direction: go around, a to b, b to c, c to a";
  wrong(way, [](const Vector& p, const Vector& q, const Vector& r) {
    return Sides{edge(p, q), edge(q, r), edge(p, r)};
  });
  wrong(way, [](const Vector& p, const Vector& q, const Vector& r) {
    return Sides{edge(q, p), edge(q, r), edge(r, p)};
  });
  wrong(way, [](const Vector& p, const Vector& q, const Vector& r) {
    return Sides{edge(p, q), edge(r, q), edge(r, p)};
  });
  wrong("the two products of the edge function are subtracted, not added",
        [](const Vector& p, const Vector& q, const Vector& r) {
          const auto sum = [](const Vector& a, const Vector& b) { return a.x * b.y + a.y * b.x; };
          return Sides{sum(p, q), sum(q, r), sum(r, p)};
        });
  const char* cross = "the edge function multiplies x by y: a.x * b.y - a.y * b.x";
  wrong(cross, [](const Vector& p, const Vector& q, const Vector& r) {
    const auto of = [](const Vector& a, const Vector& b) { return a.x * b.x - a.y * b.y; };
    return Sides{of(p, q), of(q, r), of(r, p)};
  });
  wrong(cross, [](const Vector& p, const Vector& q, const Vector& r) {
    const auto of = [](const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; };
    return Sides{of(p, q), of(q, r), of(r, p)};
  });
  wrong(cross, [](const Vector& p, const Vector& q, const Vector& r) {
    const auto of = [](const Vector& a, const Vector& b) { return a.x * a.y - b.x * b.y; };
    return Sides{of(p, q), of(q, r), of(r, p)};
  });
  mistakes.push_back({"you compare with the box around the triangle: a triangle is only half of it",
                      [](Vector p, Vector q, Vector r) {
                        return std::min({p.x, q.x, r.x}) <= 0 && std::max({p.x, q.x, r.x}) >= 0 &&
                               std::min({p.y, q.y, r.y}) <= 0 && std::max({p.y, q.y, r.y}) >= 0;
                      }});
  return mistakes;
}

Exercise hit_or_miss() {
  using Corners = Place<Vector, Vector, Vector>;
  const Vector a{-1, -1, 0};
  const Vector b{2, -1, 0};
  const Vector c{0, 3, 0};
  const auto moved = [=](const std::string& law, double x, double y) {
    const Vector by{x, y, 0};
    return Corners{law, {a + by, b + by, c + by}};
  };
  const Vector left{1, 0, 0};
  const Vector right{3, 0, 0};
  const Vector top{2, 2, 0};
  Law<IsHit> law{
      .right =
          [](Vector p, Vector q, Vector r) {
            const Sides is{edge(p, q), edge(q, r), edge(r, p)};
            return is.all_left() || is.all_right();
          },
      .places = {{"the ray is inside, the corners run counterclockwise: a hit", {a, b, c}},
                 {"the corners run clockwise: a hit, too", {a, c, b}},
                 moved("the ray is right of the triangle: a miss", -5, 0),
                 moved("the ray is left of the triangle: a miss", 5, 0),
                 moved("the ray is above the triangle: a miss", 0, -5),
                 moved("the ray is below the triangle: a miss", 0, 5),
                 moved("above an edge, but in the box around the triangle: a miss", -1.5, -2),
                 {"clockwise, the ray is right of the triangle: a miss",
                  {Vector{-6, -1, 0}, Vector{-5, 3, 0}, Vector{-3, -1, 0}}},
                 {"clockwise, the ray is below the triangle: a miss",
                  {Vector{-1, 4, 0}, Vector{0, 8, 0}, Vector{2, 4, 0}}},
                 {"exactly on the edge a to b: a hit",
                  {Vector{-1, 0, 0}, Vector{2, 0, 0}, Vector{0, 3, 0}}},
                 {"exactly on that edge of the neighbor: a hit, too",
                  {Vector{-1, 0, 0}, Vector{0, -3, 0}, Vector{2, 0, 0}}},
                 {"exactly on the edge c to a of clockwise corners: a hit",
                  {Vector{1, 1, 0}, Vector{3, -2, 0}, Vector{-1, -1, 0}}},
                 {"on the line through a and b, but outside of the triangle: a miss",
                  {left, right, top}},
                 {"on the line through b and c, but outside of the triangle: a miss",
                  {top, left, right}},
                 {"on the line through c and a, but outside of the triangle: a miss",
                  {right, top, left}}},
      .mistakes = wrong_hits()};
  return exercise("08.1", "bool is_hit(Vec3 a, Vec3 b, Vec3 c)", std::move(law), is_hit,
                  crate_on_its_edge);
}

using WeightsOf = Weights(Vector, Vector, Vector);

/// Twice the areas of the small triangles, and of the whole one.
struct Areas {
  double ab, bc, ca, whole;
};

Mistake<WeightsOf> wrong_share(const char* word, Weights (*shares)(const Areas&)) {
  return {word, [=](Vector a, Vector b, Vector c) {
            const double ab = edge(a, b);
            const double bc = edge(b, c);
            const double ca = edge(c, a);
            return shares({ab, bc, ca, ab + bc + ca});
          }};
}

/// The right shares, of other corners.
void add_wrong_corners(std::vector<Mistake<WeightsOf>>& mistakes) {
  const auto wrong = [&](const char* word, Weights (*shares)(const Areas&)) {
    mistakes.push_back(wrong_share(word, shares));
  };
  const char* corners =
      "the weights belong to the wrong corners: that of a is the share opposite a, of b, c and the "
      "ray";
  wrong(corners, [](const Areas& t) {
    return Weights{t.ab / t.whole, t.bc / t.whole, t.ca / t.whole};
  });
  wrong(corners, [](const Areas& t) {
    return Weights{t.ca / t.whole, t.ab / t.whole, t.bc / t.whole};
  });
  wrong("the weights of b and c are exchanged: b is opposite the edge c to a", [](const Areas& t) {
    return Weights{t.bc / t.whole, t.ab / t.whole, t.ca / t.whole};
  });
  wrong("the weights of a and b are exchanged: a is opposite the edge b to c", [](const Areas& t) {
    return Weights{t.ca / t.whole, t.bc / t.whole, t.ab / t.whole};
  });
  wrong("the weights of a and c are exchanged: a is opposite the edge b to c", [](const Areas& t) {
    return Weights{t.ab / t.whole, t.ca / t.whole, t.bc / t.whole};
  });
}

/// Shares of what is no area.
void add_no_areas(std::vector<Mistake<WeightsOf>>& mistakes) {
  const auto wrong_edge = [&](const char* word, double (*of)(const Vector&, const Vector&)) {
    mistakes.push_back({word, [=](Vector a, Vector b, Vector c) {
                          const double whole = of(a, b) + of(b, c) + of(c, a);
                          return Weights{of(b, c) / whole, of(c, a) / whole, of(a, b) / whole};
                        }});
  };
  wrong_edge("the two products of the edge function are subtracted, not added",
             [](const Vector& p, const Vector& q) { return p.x * q.y + p.y * q.x; });
  const char* cross = "the edge function multiplies x by y: a.x * b.y - a.y * b.x";
  wrong_edge(cross, [](const Vector& p, const Vector& q) { return p.x * q.x - p.y * q.y; });
  wrong_edge(cross, [](const Vector& p, const Vector& q) { return p.x * q.x + p.y * q.y; });
  wrong_edge(cross, [](const Vector& p, const Vector& q) { return p.x * p.y - q.x * q.y; });
  const auto wrong_distance = [&](const char* word, double (*of)(double)) {
    mistakes.push_back({word, [=](Vector a, Vector b, Vector c) {
                          const Weights w{of(length(a)), of(length(b)), of(length(c))};
                          const double sum = w[0] + w[1] + w[2];
                          return Weights{w[0] / sum, w[1] / sum, w[2] / sum};
                        }});
  };
  const char* distance = "weights are shares of areas, not of distances to the corners";
  wrong_distance(distance, [](double x) { return x; });
  wrong_distance(distance, [](double x) { return 1 / x; });
}

/// Shares of the areas as many compute them.
std::vector<Mistake<WeightsOf>> wrong_weights() {
  std::vector<Mistake<WeightsOf>> mistakes;
  const auto wrong = [&](const char* word, Weights (*shares)(const Areas&)) {
    mistakes.push_back(wrong_share(word, shares));
  };
  add_wrong_corners(mistakes);
  const char* areas = "these are areas, not shares: divide by the area of the whole triangle";
  wrong(areas, [](const Areas& t) { return Weights{t.bc, t.ca, t.ab}; });
  wrong(areas, [](const Areas& t) { return Weights{t.bc / 2, t.ca / 2, t.ab / 2}; });
  wrong(areas, [](const Areas& t) {
    return Weights{std::abs(t.bc), std::abs(t.ca), std::abs(t.ab)};
  });
  wrong(areas, [](const Areas& t) {
    return Weights{std::abs(t.bc) / 2, std::abs(t.ca) / 2, std::abs(t.ab) / 2};
  });
  wrong(
      "the sum is no more than 1/2: the whole triangle is the sum of the three small ones, not "
      "twice that",
      [](const Areas& t) {
        return Weights{t.bc / t.whole / 2, t.ca / t.whole / 2, t.ab / t.whole / 2};
      });
  wrong("the sum is 2: halve all four areas or none of them", [](const Areas& t) {
    return Weights{t.bc / t.whole * 2, t.ca / t.whole * 2, t.ab / t.whole * 2};
  });
  wrong("/ comes before +: write bc / (ab + bc + ca), or keep the sum in a variable",
        [](const Areas& t) {
          return Weights{t.bc / t.ab + t.bc + t.ca, t.ca / t.ab + t.bc + t.ca,
                         t.ab / t.ab + t.bc + t.ca};
        });
  const char* sign =
      "clockwise corners have negative weights: leave std::abs out, the signs cancel";
  wrong(sign, [](const Areas& t) {
    const double whole = std::abs(t.whole);
    return Weights{t.bc / whole, t.ca / whole, t.ab / whole};
  });
  wrong("the edge from a to c has the wrong direction: go around, from c to a", [](const Areas& t) {
    const double whole = t.ab + t.bc - t.ca;
    return Weights{t.bc / whole, -t.ca / whole, t.ab / whole};
  });
  wrong("the edge from a to c has the wrong direction: go around, from c to a", [](const Areas& t) {
    return Weights{t.bc / t.whole, -t.ca / t.whole, t.ab / t.whole};
  });
  wrong("these are the shares of the other two corners: the weight is the share, not 1 minus it",
        [](const Areas& t) {
          return Weights{1 - t.bc / t.whole, 1 - t.ca / t.whole, 1 - t.ab / t.whole};
        });
  const char* third = "the weights do not add up to 1: the third is 1 minus both others";
  wrong(third, [](const Areas& t) { return Weights{t.bc / t.whole, t.ca / t.whole, 1}; });
  wrong(third, [](const Areas& t) {
    return Weights{t.bc / t.whole, t.ca / t.whole, 1 - t.bc / t.whole};
  });
  wrong(third, [](const Areas& t) {
    return Weights{t.bc / t.whole, t.ca / t.whole, 1 - t.ca / t.whole};
  });
  const char* part = "an area is missing in the sum: the whole triangle has all three";
  wrong(part, [](const Areas& t) {
    const double sum = t.whole - t.ab;
    return Weights{t.bc / sum, t.ca / sum, t.ab / sum};
  });
  wrong(part, [](const Areas& t) {
    const double sum = t.whole - t.bc;
    return Weights{t.bc / sum, t.ca / sum, t.ab / sum};
  });
  wrong(part, [](const Areas& t) {
    const double sum = t.whole - t.ca;
    return Weights{t.bc / sum, t.ca / sum, t.ab / sum};
  });
  wrong("all weights are 1/3: that is right in the middle alone", [](const Areas&) {
    return Weights{1. / 3, 1. / 3, 1. / 3};
  });
  add_no_areas(mistakes);
  return mistakes;
}

Exercise three_weights() {
  const auto right = [](Vector a, Vector b, Vector c) {
    const RaySpace<double> along_z(Ray<double>{{0, 0, 0}, {0, 0, 1}});
    const Crossing<double> found = crossing(along_z, a, b, c);
    return Weights{found.a, found.b, found.c};
  };
  Law<WeightsOf> law{
      .right = right,
      .places = {{"in the middle of the triangle each weight is 1/3",
                  {Vector{-1, -1, 0}, Vector{1, -1, 0}, Vector{0, 2, 0}}},
                 {"in the middle between a and b, each has 1/2",
                  {Vector{-1, 0, 0}, Vector{1, 0, 0}, Vector{0, 2, 0}}},
                 {"close to a, a has the largest weight",
                  {Vector{-0.1, -0.1, 0}, Vector{0.9, -0.1, 0}, Vector{-0.1, 0.9, 0}}},
                 {"close to c, c has the largest weight",
                  {Vector{-0.1, -0.8, 0}, Vector{0.9, -0.8, 0}, Vector{-0.1, 0.2, 0}}},
                 {"with the corners (-0.6, -0.4), (0.4, -0.4) and (0.4, 0.6)",
                  {Vector{-0.6, -0.4, 0}, Vector{0.4, -0.4, 0}, Vector{0.4, 0.6, 0}}},
                 {"the corners may run clockwise: the weights stay positive",
                  {Vector{-2, -1, 0}, Vector{1, 3, 0}, Vector{4, -2, 0}}}},
      .mistakes = wrong_weights(),
      .tolerance = 1e-6};
  return exercise("08.2", "std::array<double, 3> weights(Vec3 a, Vec3 b, Vec3 c)", std::move(law),
                  weights, crate);
}

using Mixed = Place2(Place2, Place2, Place2, Weights);

/// The sums of the corners' coordinates with these weights.
constexpr auto by = [](int of_a, int of_b, int of_c) {
  return [=](Place2 a, Place2 b, Place2 c, Weights w) {
    const auto at = [&w](int i) { return w[static_cast<std::size_t>(i)]; };
    return Place2{at(of_a) * a.u + at(of_b) * b.u + at(of_c) * c.u,
                  at(of_a) * a.v + at(of_b) * b.v + at(of_c) * c.v};
  };
};

/// The right mix, with its coordinates changed.
void add_wrong_coordinates(std::vector<Mistake<Mixed>>& mistakes) {
  const auto wrong = [&](const char* word, std::function<Mixed> function) {
    mistakes.push_back({word, std::move(function)});
  };
  const auto mixed_right = by(0, 1, 2);
  const auto then = [=](Place2 (*change)(const Place2&)) {
    return [=](Place2 p, Place2 q, Place2 r, Weights w) { return change(mixed_right(p, q, r, w)); };
  };
  wrong("u and v are exchanged: your picture is mirrored at a diagonal", then([](const Place2& uv) {
          return Place2{uv.v, uv.u};
        }));
  wrong("v is a mix of u: take a.v, b.v and c.v", then([](const Place2& uv) {
          return Place2{uv.u, uv.u};
        }));
  wrong("u is a mix of v: take a.u, b.u and c.u", then([](const Place2& uv) {
          return Place2{uv.v, uv.v};
        }));
  for (std::size_t i = 0; i < 3; ++i) {
    wrong("one product of v has a u: take a.v, b.v and c.v",
          [=](Place2 p, Place2 q, Place2 r, Weights w) {
            const Place2 uv = mixed_right(p, q, r, w);
            const Place2 corner = std::array{p, q, r}[i];
            return Place2{uv.u, uv.v + w[i] * (corner.u - corner.v)};
          });
    wrong("one product of u has a v: take a.u, b.u and c.u",
          [=](Place2 p, Place2 q, Place2 r, Weights w) {
            const Place2 uv = mixed_right(p, q, r, w);
            const Place2 corner = std::array{p, q, r}[i];
            return Place2{uv.u + w[i] * (corner.v - corner.u), uv.v};
          });
  }
  wrong("the sum is divided by 3, but the weights add up to 1 already", then([](const Place2& uv) {
          return Place2{uv.u / 3, uv.v / 3};
        }));
  wrong("v is turned over: the corners have the v that the texture needs",
        then([](const Place2& uv) {
          return Place2{uv.u, 1 - uv.v};
        }));
  wrong("coordinates may leave 0 to 1: the wrap mode comes later, so leave them",
        then([](const Place2& uv) {
          return Place2{std::clamp(uv.u, 0., 1.), std::clamp(uv.v, 0., 1.)};
        }));
  wrong("coordinates may leave 0 to 1: the wrap mode comes later, so leave them",
        then([](const Place2& uv) {
          return Place2{uv.u - std::floor(uv.u), uv.v - std::floor(uv.v)};
        }));
}

/// Mixes as many write them.
std::vector<Mistake<Mixed>> wrong_mixes() {
  std::vector<Mistake<Mixed>> mistakes;
  const auto wrong = [&](const char* word, std::function<Mixed> function) {
    mistakes.push_back({word, std::move(function)});
  };
  const auto mixed_right = by(0, 1, 2);
  /// The right sum of other weights.
  const auto with = [=](Weights (*weights_of)(const Weights&)) {
    return [=](Place2 p, Place2 q, Place2 r, Weights w) {
      return mixed_right(p, q, r, weights_of(w));
    };
  };
  wrong("all corners count the same: multiply each by its own weight", with([](const Weights&) {
          return Weights{1. / 3, 1. / 3, 1. / 3};
        }));
  wrong("the corners have no weights: multiply each by its own weight, then add",
        with([](const Weights&) {
          return Weights{1, 1, 1};
        }));
  wrong("all corners have weights[0]: multiply each by its own weight", with([](const Weights& w) {
          return Weights{w[0], w[0], w[0]};
        }));
  wrong("this is 1 minus each weight: multiply each corner by its own weight",
        with([](const Weights& w) {
          return Weights{1 - w[0], 1 - w[1], 1 - w[2]};
        }));
  wrong("the weights are added: multiply each corner by its own weight, then add",
        [](Place2 p, Place2 q, Place2 r, Weights w) {
          const double sum = w[0] + w[1] + w[2];
          return Place2{p.u + q.u + r.u + sum, p.v + q.v + r.v + sum};
        });
  wrong("you take the corner with the largest weight: mix all three",
        [](Place2 p, Place2 q, Place2 r, Weights w) {
          if (w[0] >= w[1] && w[0] >= w[2]) return p;
          return w[1] >= w[2] ? q : r;
        });
  wrong("the weights of b and c are exchanged", by(0, 2, 1));
  wrong("the weights of a and b are exchanged", by(1, 0, 2));
  wrong("the weights of a and c are exchanged", by(2, 1, 0));
  wrong("the weights are those of the next corners: weights[0] belongs to a", by(1, 2, 0));
  wrong("the weights are those of the next corners: weights[0] belongs to a", by(2, 0, 1));
  wrong("corner a is missing", with([](const Weights& w) { return Weights{0, w[1], w[2]}; }));
  wrong("corner b is missing", with([](const Weights& w) { return Weights{w[0], 0, w[2]}; }));
  wrong("corner c is missing", with([](const Weights& w) { return Weights{w[0], w[1], 0}; }));
  add_wrong_coordinates(mistakes);
  return mistakes;
}

Exercise between_corners() {
  const Place2 a{0, 0};
  const Place2 b{1, 0};
  const Place2 c{1, 1};
  Law<Mixed> law{
      .right =
          [](Place2 p, Place2 q, Place2 r, Weights w) {
            const MeshMapping mapping{{{p, q, r}}};
            MeshHit<double> hit;
            hit.a = w[0];
            hit.b = w[1];
            hit.c = w[2];
            return mapping(hit);
          },
      .places =
          {{"at corner a it is a", {a, b, c, Weights{1, 0, 0}}},
           {"at corner b it is b", {a, b, c, Weights{0, 1, 0}}},
           {"at corner c it is c", {a, b, c, Weights{0, 0, 1}}},
           {"in the middle between a and b, u is 1/2", {a, b, c, Weights{0.5, 0.5, 0}}},
           {"with the weights 0.4, 0.2 and 0.4 it is (0.6, 0.4)",
            {a, b, c, Weights{0.4, 0.2, 0.4}}},
           {"with corners (0.1, 0.7), (0.9, 0.2), (0.4, 0.6), weights 0.5, 0.3, 0.2: (0.4, 0.53)",
            {Place2{0.1, 0.7}, Place2{0.9, 0.2}, Place2{0.4, 0.6}, Weights{0.5, 0.3, 0.2}}},
           {"coordinates may be below 0 and above 1",
            {Place2{-4, -4}, Place2{5, -4}, Place2{5, 5}, Weights{0.3, 0.5, 0.2}}}},
      .mistakes = wrong_mixes(),
      .tolerance = 1e-9};
  return exercise("08.3", "Uv mixed(Uv a, Uv b, Uv c, std::array<double, 3> weights)",
                  std::move(law), mixed, crate);
}

/// The weight of an edge's far end at the point that is seen in the middle of its image.
double weight_in_the_middle(double near, double far) {
  const Ray<double> ray{{0, 0, 0}, {0, 0, 1}};
  const RaySpace<double> space(ray);
  // The image of a point is (x / z, y / z): both ends are as far from the middle.
  return crossing(space, seen_along(space, Vector{-near, -1e-9 * near, near}),
                  seen_along(space, Vector{far, -1e-9 * far, far}),
                  seen_along(space, Vector{0, near, near}))
      .b;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {hit_or_miss(), three_weights(), between_corners()},
      .questions = {{"08.a",
                     "An edge goes from depth 1 to depth 4. Which weight does its far end have at "
                     "the point that is seen in the middle of the edge's image?",
                     [] { return weight_in_the_middle(1, 4); }, "", 1e-3},
                    {"08.b",
                     "A point of the floor has u = -2.3. With the chapter's wrap mode, "
                     "which u of the texture does it show?",
                     [] { return wrapped_coordinate(Lesson().choice.wrap, -2.3); }, "", 1e-9}},
  };
  return chapter;
}

}  // namespace texmap::check
