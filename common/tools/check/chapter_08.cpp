// The exercises of chapter 08. The lesson is the chapter's own. It uses first_hit and MeshMapping
// by name; here those names, in the lesson's namespace, lead to the student's function.
#include "engine/run/mesh_options.hpp"
#include "exercises.hpp"
#include "texture/mesh_mapping.hpp"

namespace texmap::chapter_08 {

static std::function<bool(Vec3d, Vec3d, Vec3d)> is_hit;
static std::function<std::array<double, 3>(Vec3d, Vec3d, Vec3d)> weights;
static std::function<Uv<double>(Uv<double>, Uv<double>, Uv<double>, std::array<double, 3>)> mixed;

static double edge(const Vec3d& a, const Vec3d& b) { return a.x * b.y - a.y * b.x; }

/// The corners of a triangle as a ray sees them.
static std::array<Vec3d, 3> seen(const Mesh& mesh, double triangle, const Ray<double>& ray) {
  auto corners = corners_of(mesh, triangle);
  for (Vec3d& corner : corners) corner = seen_along(RaySpace<double>(ray), corner);
  return corners;
}

/// The nearest triangle that the student lets the ray hit; `met` is false if there is none.
static MeshHit<double> first_hit_by_student(const Mesh& mesh, const Ray<double>& ray) {
  MeshHit<double> nearest;
  for (std::size_t number = 0; number < mesh.triangles.size(); ++number) {
    const auto i = double(number);
    const auto [a, b, c] = seen(mesh, i, ray);
    if (!is_hit(a, b, c)) continue;
    // The triangle alone, as wide as needed for the ray to hit it.
    const auto [p, q, r] = corners_of(mesh, i);
    const Vec3d normal = cross(q - p, r - p);
    const double distance = dot(p - ray.origin, normal) / dot(ray.direction, normal);
    if (!(distance > 0) || (nearest.met && distance >= nearest.distance)) continue;
    nearest.met = true;
    nearest.distance = distance;
    nearest.triangle = i;
    const double whole = edge(a, b) + edge(b, c) + edge(c, a);
    nearest.a = edge(b, c) / whole;
    nearest.b = edge(c, a) / whole;
    nearest.c = edge(a, b) / whole;
    nearest.normal = normalize(dot(normal, ray.direction) > 0 ? -normal : normal);
    nearest.point = ray.origin + ray.direction * distance;
    nearest.outside = nearest.point + nearest.normal * 1e-9;
  }
  return nearest;
}

inline constexpr struct {
  MeshHit<double> operator()(const Mesh& mesh, const Ray<double>& ray) const {
    if (is_hit) return first_hit_by_student(mesh, ray);
    MeshHit<double> hit = texmap::first_hit(mesh, ray);
    if (weights && hit.met) {
      const auto [a, b, c] = seen(mesh, hit.triangle, ray);
      const auto [of_a, of_b, of_c] = weights(a, b, c);
      hit.a = of_a;
      hit.b = of_b;
      hit.c = of_c;
    }
    return hit;
  }
} first_hit;

struct MeshMapping : texmap::MeshMapping {
  Uv<double> operator()(const MeshHit<double>& hit) const {
    if (!mixed) return texmap::MeshMapping::operator()(hit);
    const auto& uv = corners[static_cast<std::size_t>(hit.triangle)];
    return mixed(uv[0], uv[1], uv[2], {hit.a, hit.b, hit.c});
  }
};

}  // namespace texmap::chapter_08

#include "08_triangle_uv/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_08;

using Weights = std::array<double, 3>;

/// The crate on one of its edges, from the front: some rays pass exactly through the edge between
/// the two triangles of a side.
Image crate_on_its_edge() {
  auto lesson = prepared<Lesson>({"--degrees", "0"});
  Mesh& mesh = lesson.scene.mesh;
  mesh.triangles.resize(12);  // without the floor
  for (Point& p : mesh.points) p = {(p.x - p.y) * sqrt(0.5), (p.x + p.y) * sqrt(0.5), p.z};
  lesson.stage.camera = {
      .eye = {0, 0, 4.5}, .target = {0, 0, 0}, .fov_y_degrees = 50, .anchor = PixelAnchor::corner};
  return picture_of(lesson);
}

/// Is the ray on the left of all these edges, or is it on the right?
constexpr auto left = [](auto... sides) { return (... && (sides >= 0)); };
constexpr auto right = [](auto... sides) { return (... && (sides <= 0)); };
constexpr auto same = [](auto... sides) { return left(sides...) || right(sides...); };

/// What many take for the edge function.
constexpr auto x_by_y = "the edge function multiplies x by y: a.x * b.y - a.y * b.x";
constexpr std::pair<const char*, double (*)(const Vec3d& p, const Vec3d& q)> wrong_edges[] = {
    {"the two products of the edge function are subtracted, not added",
     [](const Vec3d& p, const Vec3d& q) { return p.x * q.y + p.y * q.x; }},
    {x_by_y, [](const Vec3d& p, const Vec3d& q) { return p.x * q.x - p.y * q.y; }},
    {x_by_y, [](const Vec3d& p, const Vec3d& q) { return p.x * q.x + p.y * q.y; }},
    {x_by_y, [](const Vec3d& p, const Vec3d& q) { return p.x * p.y - q.x * q.y; }},
};

Slips<bool> wrong_hits(Vec3d a, Vec3d b, Vec3d c) {
  const double ab = edge(a, b), bc = edge(b, c), ca = edge(c, a);
  const bool inside_left = ab > 0 && bc > 0 && ca > 0;
  const bool inside_right = ab < 0 && bc < 0 && ca < 0;
  const bool all_left = left(ab, bc, ca);
  const bool all_right = right(ab, bc, ca);
  Slips<bool> wrong = {
      {"clockwise corners are missed: the ray is on the right", {all_left, inside_left}},
      {"counterclockwise corners are missed: the ray is on the left", {all_right, inside_right}},
      {"a ray through an edge hits nothing: cracks. Take >= and <=", inside_left || inside_right},
      {"one direction of the corners has cracks: take >= and <=, 0 belongs to both",
       {all_left || inside_right, inside_left || all_right}},
      {"the ray must be on the left of all three edges, or on the right of all three",
       {{"one edge is enough for you", {!inside_right, !all_right, !inside_left, !all_left}},
        {"every ray hits, or none", {true, all_left && all_right}}}},
      {"hits and misses are exchanged", !all_left && !all_right},
      {"a product of three does not say that all are on the same side: compare each one with 0",
       {ab * bc * ca >= 0, ab * bc * ca > 0}},
      {"p == q == r compares the answer of p == q with r: write p == q && q == r",
       {((ab >= 0) == (bc >= 0)) == (ca >= 0), ((ab > 0) == (bc > 0)) == (ca > 0)}},
      {"the sum says how the corners run: compare each", {ab + bc + ca >= 0, ab + bc + ca <= 0}},
      {"you compare with the box around the triangle: a triangle is only half of it",
       min({a.x, b.x, c.x}) <= 0 && max({a.x, b.x, c.x}) >= 0 && min({a.y, b.y, c.y}) <= 0 &&
           max({a.y, b.y, c.y}) >= 0},
  };
  for (const auto& [name, one, next, last] :
       {std::tuple{"a to b", ab, bc, ca}, {"b to c", bc, ca, ab}, {"c to a", ca, ab, bc}}) {
    wrong += {
        {text("the edge %s is missing: two edges leave a triangle open", name),
         {left(next, last), same(next, last)}},
        {"a product is 0 on the line through an edge: compare each", left(one * next, next * last)},
        {"one edge has the wrong direction: go around, a to b, b to c, c to a",
         {same(-one, next, last), left(-one, next, last)}},
    };
  }
  for (const auto& [word, of] : wrong_edges)
    wrong += {{word, {same(of(a, b), of(b, c), of(c, a)), left(of(a, b), of(b, c), of(c, a))}}};
  return wrong;
}

bool is_inside(Vec3d p, Vec3d q, Vec3d r) { return same(edge(p, q), edge(q, r), edge(r, p)); }
/// A triangle around the ray, moved.
constexpr Place<Vec3d, Vec3d, Vec3d> moved(const char* law, double x, double y) {
  return {law, {{x - 1, y - 1, 0}, {x + 2, y - 1, 0}, {x, y + 3, 0}}};
}
constexpr Vec3d near{1, 0, 0}, far{3, 0, 0}, top{2, 2, 0};
constexpr Place<Vec3d, Vec3d, Vec3d> is_hit_places[] = {
    {"the ray is inside, corners counterclockwise: a hit", {{-1, -1, 0}, {2, -1, 0}, {0, 3, 0}}},
    {"the corners run clockwise: a hit, too", {{-1, -1, 0}, {0, 3, 0}, {2, -1, 0}}},
    moved("the ray is right of the triangle: a miss", -5, 0),
    moved("the ray is left of the triangle: a miss", 5, 0),
    moved("the ray is above the triangle: a miss", 0, -5),
    moved("the ray is below the triangle: a miss", 0, 5),
    moved("above an edge, but in the box around the triangle: a miss", -1.5, -2),
    {"clockwise, the ray is right of the triangle: a miss", {{-6, -1, 0}, {-5, 3, 0}, {-3, -1, 0}}},
    {"clockwise, the ray is below the triangle: a miss", {{-1, 4, 0}, {0, 8, 0}, {2, 4, 0}}},
    {"exactly on the edge a to b: a hit", {{-1, 0, 0}, {2, 0, 0}, {0, 3, 0}}},
    {"exactly on that edge of the neighbor: a hit, too", {{-1, 0, 0}, {0, -3, 0}, {2, 0, 0}}},
    {"exactly on edge c to a of clockwise corners: a hit", {{1, 1, 0}, {3, -2, 0}, {-1, -1, 0}}},
    {"on the line through a and b, but outside of the triangle: a miss", {near, far, top}},
    {"on the line through b and c, but outside of the triangle: a miss", {top, near, far}},
    {"on the line through c and a, but outside of the triangle: a miss", {far, top, near}},
};

/// Parts of a whole.
Weights shares(double whole, const Weights& parts) {
  return {parts[0] / whole, parts[1] / whole, parts[2] / whole};
}
Weights shares(const Weights& parts) { return shares(parts[0] + parts[1] + parts[2], parts); }

Slips<Weights> wrong_weights(Vec3d a, Vec3d b, Vec3d c) {
  const double ab = edge(a, b), bc = edge(b, c), ca = edge(c, a);
  const double whole = ab + bc + ca, other = ab + bc - ca;
  const Weights areas{bc, ca, ab}, sizes{abs(bc), abs(ca), abs(ab)};
  const Weights distances{length(a), length(b), length(c)};
  const auto [x, y, z] = shares(areas);
  Slips<Weights> wrong = {
      {"the weights belong to other corners: that of a is the share opposite a",
       {{z, x, y}, {y, z, x}, {x, z, y}, {y, x, z}, {z, y, x}}},
      {"these are areas, not shares: divide by the area of the whole triangle",
       {areas, shares(2, areas), sizes, shares(2, sizes)}},
      {"the sum is not 1: the whole triangle is the sum of the three small ones",
       {{x / 2, y / 2, z / 2}, {2 * x, 2 * y, 2 * z}}},
      {"/ comes before +: write bc / (ab + bc + ca), or keep the sum in a variable",
       {bc / ab + bc + ca, ca / ab + bc + ca, ab / ab + bc + ca}},
      {"clockwise corners: leave std::abs out, the signs cancel", shares(abs(whole), areas)},
      {"the edge from a to c has the wrong direction: go around, from c to a",
       {{bc / other, -ca / other, ab / other}, {x, -y, z}}},
      {"this is 1 minus the share, that of the other two corners", {1 - x, 1 - y, 1 - z}},
      {"the weights do not add up to 1: the third is 1 minus both others",
       {{x, y, 1}, {x, y, 1 - x}, {x, y, 1 - y}, {x, y, x + y}}},
      {"an area is missing in the sum: the whole triangle has all three",
       {shares(whole - ab, areas), shares(whole - bc, areas), shares(whole - ca, areas)}},
      {"all weights are 1/3: that is right in the middle alone", {1. / 3, 1. / 3, 1. / 3}},
      {"weights are shares of areas, not of distances",
       {shares(distances), shares({length(b - c), length(c - a), length(a - b)}),
        shares({1 / length(a), 1 / length(b), 1 / length(c)})}},
  };
  for (const auto& [word, of] : wrong_edges)
    wrong += {{word, shares(of(a, b) + of(b, c) + of(c, a), {of(b, c), of(c, a), of(a, b)})}};
  return wrong;
}

constexpr Place<Vec3d, Vec3d, Vec3d> weights_places[] = {
    {"in the middle of the triangle each weight is 1/3", {{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}}},
    {"in the middle between a and b, each has 1/2", {{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}}},
    {"close to a, a has the largest weight", {{-0.1, -0.1, 0}, {0.9, -0.1, 0}, {-0.1, 0.9, 0}}},
    {"close to c, c has the largest weight", {{-0.1, -0.8, 0}, {0.9, -0.8, 0}, {-0.1, 0.2, 0}}},
    {"(-0.6, -0.4), (0.4, -0.4), (0.4, 0.6)", {{-0.6, -0.4, 0}, {0.4, -0.4, 0}, {0.4, 0.6, 0}}},
    {"corners may run clockwise: the weights stay positive", {{-2, -1, 0}, {1, 3, 0}, {4, -2, 0}}},
};

Place2 sum_of(Place2 a, Place2 b, Place2 c, const Weights& w) {
  return {w[0] * a.u + w[1] * b.u + w[2] * c.u, w[0] * a.v + w[1] * b.v + w[2] * c.v};
}

Slips<Place2> wrong_mixes(Place2 a, Place2 b, Place2 c, Weights weights) {
  const auto mix = [&](double x, double y, double z) { return sum_of(a, b, c, {x, y, z}); };
  const auto [x, y, z] = weights;
  const auto [u, v] = mix(x, y, z);
  const double sum = x + y + z;
  const Place2 heaviest = x >= y && x >= z ? a : y >= z ? b : c;
  Slips<Place2> wrong = {
      {"multiply each corner by its own weight, then add",
       {{"all corners count the same", {mix(1. / 3, 1. / 3, 1. / 3), mix(x, x, x)}},
        {"this is 1 minus each weight", mix(1 - x, 1 - y, 1 - z)},
        {"the weights are added", {a.u + b.u + c.u + sum, a.v + b.v + c.v + sum}},
        {"you take the corner with the largest weight", heaviest},
        {"a corner has no weight", {mix(1, 1, 1), mix(1, y, z), mix(x, 1, z), mix(x, y, 1)}}}},
      {"weights[0] belongs to a, [1] to b, [2] to c",
       {changed(slips_of_parts(weights), [&](const Weights& w) { return sum_of(a, b, c, w); }),
        {"yours are those of the next corners", {mix(y, z, x), mix(z, x, y)}},
        {"a corner is used twice",
         {sum_of(a, b, b, weights), sum_of(a, a, c, weights), sum_of(a, c, c, weights),
          sum_of(b, b, c, weights)}}}},
      {"the sum is divided by 3, but the weights add up to 1 already", {u / 3, v / 3}},
      {"v is turned over: the corners have the v that the texture needs", {u, 1 - v}},
      {"coordinates may leave 0 to 1: the wrap mode comes later, so leave them",
       {{clamp(u, 0., 1.), clamp(v, 0., 1.)}, {fraction(u), fraction(v)}}},
  };
  for (const auto& [w, p] : {std::pair{x, a}, {y, b}, {z, c}}) {
    wrong += {{"one product of v has a u: take a.v, b.v and c.v", {u, v + w * (p.u - p.v)}},
              {"one product of u has a v: take a.u, b.u and c.u", {u + w * (p.v - p.u), v}}};
  }
  return wrong;
}

constexpr Place2 first{0, 0}, second{1, 0}, third{1, 1};
constexpr Place<Place2, Place2, Place2, Weights> mixed_places[] = {
    {"at corner a it is a", {first, second, third, {1, 0, 0}}},
    {"at corner b it is b", {first, second, third, {0, 1, 0}}},
    {"at corner c it is c", {first, second, third, {0, 0, 1}}},
    {"in the middle between a and b, u is 1/2", {first, second, third, {0.5, 0.5, 0}}},
    {"with the weights 0.4, 0.2 and 0.4 it is (0.6, 0.4)", {first, second, third, {0.4, 0.2, 0.4}}},
    {"with corners (0.1, 0.7), (0.9, 0.2), (0.4, 0.6), weights 0.5, 0.3, 0.2: (0.4, 0.53)",
     {{0.1, 0.7}, {0.9, 0.2}, {0.4, 0.6}, {0.5, 0.3, 0.2}}},
    {"coordinates may be below 0 and above 1", {{-4, -4}, {5, -4}, {5, 5}, {0.3, 0.5, 0.2}}},
};

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      "08",
      {exercise(is_hit, crate_on_its_edge, {is_inside, wrong_hits, is_hit_places}),
       exercise(weights, picture<Lesson>(),
                {[](Vec3d a, Vec3d b, Vec3d c) {
                   const RaySpace<double> along_z(Ray<double>{{0, 0, 0}, {0, 0, 1}});
                   const Crossing<double> found = crossing(along_z, a, b, c);
                   return Weights{found.a, found.b, found.c};
                 },
                 wrong_weights, weights_places}),
       exercise(mixed, picture<Lesson>(), {sum_of, wrong_mixes, mixed_places})},
      {{"An edge goes from depth 1 to depth 4. Which weight does its far end have at the point "
        "that is seen in the middle of the edge's image?",
        [] { return 1. / (1 + 4); },
        {"", 1e-3},
        "Draw it from above: the two ends are equally far from the middle of the image. How far "
        "are they from the axis in space?",
        {{0.5, "the middle of the image is not the middle of the edge: its far half looks smaller"},
         {0.8, "this is the weight of the near end"}}},
       {"A point of the floor has u = -2.3. With the chapter's wrap mode, which u of the texture "
        "does it show?",
        [] { return wrapped_coordinate(Lesson().choice.uv.look_up->wrap, -2.3); },
        {"", 1e-9},
        "Between which whole numbers is -2.3, and is the picture mirrored there?",
        {{0.7, "this is the wrap mode repeat: with mirror every second picture runs backward"}}}},
  };
  return chapter;
}

}  // namespace texmap::check
