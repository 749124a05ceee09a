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

Exercise hit_or_miss() {
  using Corners = Place<Vector, Vector, Vector>;
  const Vector a{-1, -1, 0};
  const Vector b{2, -1, 0};
  const Vector c{0, 3, 0};
  const auto moved = [=](const std::string& law, double x, double y) {
    const Vector by{x, y, 0};
    return Corners{law, {a + by, b + by, c + by}};
  };
  const auto all = [](auto&& test) {
    return [=](Vector p, Vector q, Vector r) {
      return test(edge(p, q)) && test(edge(q, r)) && test(edge(r, p));
    };
  };
  Law<bool(Vector, Vector, Vector)> law{
      .right =
          [=](Vector p, Vector q, Vector r) {
            return all([](double side) { return side >= 0; })(p, q, r) ||
                   all([](double side) { return side <= 0; })(p, q, r);
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
                  {Vector{1, 1, 0}, Vector{3, -2, 0}, Vector{-1, -1, 0}}}},
      .mistakes = {
          {"triangles with clockwise corners are missed: from there the ray is right of all three "
           "edges",
           all([](double side) { return side >= 0; })},
          {"triangles with clockwise corners are missed: from there the ray is right of all three "
           "edges",
           all([](double side) { return side > 0; })},
          {"triangles with counterclockwise corners are missed: there the ray is left of all three "
           "edges",
           all([](double side) { return side <= 0; })},
          {"a ray exactly through an edge hits neither triangle: you see cracks. Take >= and <=",
           [=](Vector p, Vector q, Vector r) {
             return all([](double side) { return side > 0; })(p, q, r) ||
                    all([](double side) { return side < 0; })(p, q, r);
           }},
          {"one edge is enough for you: the ray must be on the same side of all three",
           [](Vector p, Vector q, Vector r) {
             return edge(p, q) >= 0 || edge(q, r) >= 0 || edge(r, p) >= 0;
           }},
          {"the edge c to a is missing: two edges leave a triangle open",
           [](Vector p, Vector q, Vector r) {
             return (edge(p, q) >= 0 && edge(q, r) >= 0) || (edge(p, q) <= 0 && edge(q, r) <= 0);
           }},
          {"the edge from a to c has the wrong direction: go around, from c to a",
           [](Vector p, Vector q, Vector r) {
             return (edge(p, q) >= 0 && edge(q, r) >= 0 && edge(p, r) >= 0) ||
                    (edge(p, q) <= 0 && edge(q, r) <= 0 && edge(p, r) <= 0);
           }},
          {"you compare with the box around the triangle: a triangle is only half of it",
           [](Vector p, Vector q, Vector r) {
             return std::min({p.x, q.x, r.x}) <= 0 && std::max({p.x, q.x, r.x}) >= 0 &&
                    std::min({p.y, q.y, r.y}) <= 0 && std::max({p.y, q.y, r.y}) >= 0;
           }}}};
  return exercise("08.1", "bool is_hit(Vec3 a, Vec3 b, Vec3 c)", std::move(law), is_hit,
                  crate_on_its_edge);
}

Exercise three_weights() {
  const auto right = [](Vector a, Vector b, Vector c) {
    const RaySpace<double> along_z(Ray<double>{{0, 0, 0}, {0, 0, 1}});
    const Crossing<double> found = crossing(along_z, a, b, c);
    return Weights{found.a, found.b, found.c};
  };
  Law<Weights(Vector, Vector, Vector)> law{
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
      .mistakes =
          {{"the weights belong to the wrong corners: that of a is the share opposite a, of b, c "
            "and the ray",
            [=](Vector a, Vector b, Vector c) {
              const Weights w = right(a, b, c);
              return Weights{w[2], w[0], w[1]};
            }},
           {"the weights belong to the wrong corners: that of a is the share opposite a, of b, c "
            "and the ray",
            [=](Vector a, Vector b, Vector c) {
              const Weights w = right(a, b, c);
              return Weights{w[1], w[2], w[0]};
            }},
           {"the weights of b and c are exchanged: b is opposite the edge c to a",
            [=](Vector a, Vector b, Vector c) {
              const Weights w = right(a, b, c);
              return Weights{w[0], w[2], w[1]};
            }},
           {"these are areas, not shares: divide by the area of the whole triangle",
            [](Vector a, Vector b, Vector c) {
              return Weights{edge(b, c), edge(c, a), edge(a, b)};
            }},
           {"the two products of the edge function are subtracted, not added",
            [](Vector a, Vector b, Vector c) {
              const auto sum = [](Vector p, Vector q) { return p.x * q.y + p.y * q.x; };
              const double whole = sum(a, b) + sum(b, c) + sum(c, a);
              return Weights{sum(b, c) / whole, sum(c, a) / whole, sum(a, b) / whole};
            }},
           {"the sum is no more than 1/2: the whole triangle is the sum of the three small ones, "
            "not twice that",
            [=](Vector a, Vector b, Vector c) {
              const Weights w = right(a, b, c);
              return Weights{w[0] / 2, w[1] / 2, w[2] / 2};
            }}},
      .tolerance = 1e-6};
  return exercise("08.2", "std::array<double, 3> weights(Vec3 a, Vec3 b, Vec3 c)", std::move(law),
                  weights, crate);
}

Exercise between_corners() {
  const auto by = [](int of_a, int of_b, int of_c) {
    return [=](Place2 a, Place2 b, Place2 c, Weights w) {
      const auto at = [&w](int i) { return w[static_cast<std::size_t>(i)]; };
      return Place2{at(of_a) * a.u + at(of_b) * b.u + at(of_c) * c.u,
                    at(of_a) * a.v + at(of_b) * b.v + at(of_c) * c.v};
    };
  };
  const Place2 a{0, 0};
  const Place2 b{1, 0};
  const Place2 c{1, 1};
  Law<Place2(Place2, Place2, Place2, Weights)> law{
      .right =
          [](Place2 p, Place2 q, Place2 r, Weights w) {
            const MeshMapping mapping{{{p, q, r}}};
            MeshHit<double> hit;
            hit.a = w[0];
            hit.b = w[1];
            hit.c = w[2];
            return mapping(hit);
          },
      .places = {{"at corner a it is a", {a, b, c, Weights{1, 0, 0}}},
                 {"at corner b it is b", {a, b, c, Weights{0, 1, 0}}},
                 {"at corner c it is c", {a, b, c, Weights{0, 0, 1}}},
                 {"in the middle between a and b, u is 1/2", {a, b, c, Weights{0.5, 0.5, 0}}},
                 {"with the weights 0.4, 0.2 and 0.4 it is (0.6, 0.4)",
                  {a, b, c, Weights{0.4, 0.2, 0.4}}},
                 {"coordinates may be below 0 and above 1",
                  {Place2{-4, -4}, Place2{5, -4}, Place2{5, 5}, Weights{0.3, 0.5, 0.2}}}},
      .mistakes = {{"all corners count the same: multiply each by its own weight",
                    [](Place2 p, Place2 q, Place2 r, Weights) {
                      return Place2{(p.u + q.u + r.u) / 3, (p.v + q.v + r.v) / 3};
                    }},
                   {"the sum is divided by 3, but the weights add up to 1 already",
                    [=](Place2 p, Place2 q, Place2 r, Weights w) {
                      const Place2 sum = by(0, 1, 2)(p, q, r, w);
                      return Place2{sum.u / 3, sum.v / 3};
                    }},
                   {"you take the corner with the largest weight: mix all three",
                    [](Place2 p, Place2 q, Place2 r, Weights w) {
                      if (w[0] >= w[1] && w[0] >= w[2]) return p;
                      return w[1] >= w[2] ? q : r;
                    }},
                   {"the weights of b and c are exchanged", by(0, 2, 1)},
                   {"the weights of a and b are exchanged", by(1, 0, 2)},
                   {"the weights of a and c are exchanged", by(2, 1, 0)},
                   {"the weights are those of the next corners: weights[0] belongs to a",
                    by(1, 2, 0)},
                   {"the weights are those of the next corners: weights[0] belongs to a",
                    by(2, 0, 1)},
                   {"u and v are exchanged: your picture is mirrored at a diagonal",
                    [=](Place2 p, Place2 q, Place2 r, Weights w) {
                      const Place2 uv = by(0, 1, 2)(p, q, r, w);
                      return Place2{uv.v, uv.u};
                    }},
                   {"corner c is missing",
                    [=](Place2 p, Place2 q, Place2 r, Weights w) {
                      return by(0, 1, 2)(p, q, r, {w[0], w[1], 0});
                    }}},
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
