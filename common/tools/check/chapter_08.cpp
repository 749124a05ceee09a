// The exercises of chapter 08. The lesson is the chapter's own. It uses first_hit by name; here
// that name, in the lesson's namespace, leads to the student's function.
#include "engine/run/mesh_options.hpp"
#include "exercises.hpp"

namespace texmap::chapter_08 {

static std::function<bool(const std::vector<Vec3d>&)> is_hit;
static std::function<Vec3d(Uv<double>, Vec3d, Vec3d, Vec3d, Uv<double>, Uv<double>, Uv<double>)>
    point_of;

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
    if (!is_hit({a, b, c})) continue;
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
    if (point_of && hit.met) {
      // The triangle as the ray sees it is the texture, so this is the point of the hit.
      const auto [a, b, c] = seen(mesh, hit.triangle, ray);
      const auto [p, q, r] = corners_of(mesh, hit.triangle);
      const auto uv = [](const Vec3d& place) { return Uv<double>{place.x + 0.3, place.y + 0.2}; };
      const Vec3d found = point_of(uv({0, 0, 0}), p, q, r, uv(a), uv(b), uv(c));
      const Vec3d normal = cross(q - p, r - p);
      const auto share = [&, found = found](const Vec3d& from, const Vec3d& to) {
        return dot(cross(from - found, to - found), normal) / dot(normal, normal);
      };
      hit.a = share(q, r);
      hit.b = share(r, p);
      hit.c = share(p, q);
    }
    return hit;
  }
} first_hit;

}  // namespace texmap::chapter_08

#include "08_triangle_uv/lesson.hpp"

namespace texmap::check {
namespace {

using namespace chapter_08;

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

using Window = std::vector<Vec3d>;

/// The edge functions of a window, or what others take for them.
std::vector<double> sides_of(const Window& corners,
                             double (*side)(const Vec3d& a, const Vec3d& b) = edge) {
  std::vector<double> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(side(corners[i], corners[(i + 1) % corners.size()]));
  return sides;
}

Slips<bool> wrong_hits(const Window& corners) {
  const std::vector<double> sides = sides_of(corners);
  const auto all = [](const std::vector<double>& of, auto compare) {
    return std::all_of(of.begin(), of.end(), [&](double side) { return compare(side, 0.0); });
  };
  const auto same = [&](const std::vector<double>& of) {
    const bool left = all(of, std::greater_equal()), right = all(of, std::less_equal());
    return std::vector<bool>{left != right, left || right,  // without an area, too; or no edge
                             all(of, std::greater()) || all(of, std::less())};
  };
  const bool left = all(sides, std::greater()), right = all(sides, std::less());
  const bool on_left = all(sides, std::greater_equal()), on_right = all(sides, std::less_equal());
  double sum = 0, product = 1;
  for (const double side : sides) {
    sum += side;
    product *= side;
  }
  std::vector<double> open = sides;
  open.pop_back();
  const auto outside = [&](double Vec3d::*along) {
    const auto [low, high] =
        std::minmax_element(corners.begin(), corners.end(),
                            [=](const Vec3d& a, const Vec3d& b) { return a.*along < b.*along; });
    return (*low).*along > 0 || (*high).*along < 0;
  };
  return {
      {"a window without an area is hit: there all edge functions are 0", on_left || on_right},
      {"clockwise corners are missed: the ray is on the right of their edges",
       {on_left, left, on_left && !on_right}},
      {"counterclockwise corners are missed: the ray is on the left of their edges",
       {on_right, right, on_right && !on_left}},
      {"a ray through an edge hits nothing: 0 is on no side, and no reason to miss", left || right},
      {"the edge from the last corner to the first is missing", same(open)},
      {"there can be more than three corners: go through all of them",
       same(sides_of({corners[0], corners[1], corners[2]}))},
      {"the ray must be on the same side of all edges",
       {{"for you one edge is enough", {!right, !left, !on_right, !on_left}},
        {"for you every ray hits, or none", {true, false}},
        {"hits and misses are exchanged", {on_left == on_right, !on_left && !on_right}}}},
      {"the sum or product of edge functions does not say that all have one sign: compare each",
       {sum > 0, sum >= 0, sum != 0, product > 0, product >= 0}},
      {"this is the box around the corners: the window is only a part of it",
       !outside(&Vec3d::x) && !outside(&Vec3d::y)},
      {"the edge function is a.x * b.y - a.y * b.x",
       {{"", same(sides_of(corners,
                           [](const Vec3d& p, const Vec3d& q) { return p.x * q.y + p.y * q.x; }))},
        {"yours is the dot product",
         same(sides_of(corners,
                       [](const Vec3d& p, const Vec3d& q) { return p.x * q.x + p.y * q.y; }))}}},
  };
}

/// If all have one sign, the sizes add up to the size of the sum.
bool right_hit(const Window& corners) {
  double sum = 0, sizes = 0;
  for (const double side : sides_of(corners)) {
    sum += side;
    sizes += abs(side);
  }
  return sizes > 0 && sizes == abs(sum);
}

Slips<Vec3d> wrong_points(Place2 at, Vec3d a, Vec3d b, Vec3d c, Place2 uv_a, Place2 uv_b,
                          Place2 uv_c) {
  const auto weighed = [=](double x, double y, double z) { return a * x + b * y + c * z; };
  const auto area = [](Place2 p, Place2 q, Place2 r) {
    return (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
  };
  const auto shares = [=](double x, double y, double z, double whole) {
    return weighed(x / whole, y / whole, z / whole);
  };
  const double bc = area(at, uv_b, uv_c), ca = area(at, uv_c, uv_a), ab = area(at, uv_a, uv_b);
  const double whole = ab + bc + ca, x = bc / whole, y = ca / whole, z = ab / whole;
  constexpr Place2 zero{0, 0};
  const double o_bc = area(zero, uv_b, uv_c), o_ca = area(zero, uv_c, uv_a),
               o_ab = area(zero, uv_a, uv_b);
  const double sizes = abs(bc) + abs(ca) + abs(ab);
  return {
      {"the weight of a is the share of the small triangle opposite a: `at`, b and c",
       {weighed(z, x, y), weighed(y, z, x), weighed(x, z, y), weighed(y, x, z), weighed(z, y, x)}},
      {"these are areas, not shares: divide by the area of the whole triangle of the texture",
       {weighed(bc, ca, ab), weighed(bc / 2, ca / 2, ab / 2)}},
      {"the weights must add up to 1: both the parts and the whole are twice the area, or once",
       {weighed(x / 2, y / 2, z / 2), weighed(2 * x, 2 * y, 2 * z), weighed(x, y, 1),
        weighed(x, y, 0), weighed(-x, -y, -z)}},
      {"leave std::abs out: signs cancel inside, and outside a weight is below 0",
       {weighed(abs(x), abs(y), abs(z)), shares(abs(bc), abs(ca), abs(ab), sizes),
        shares(bc, ca, ab, abs(whole)), weighed(abs(x), abs(y), 1 - abs(x) - abs(y))}},
      {"the edge function is about (0, 0), and here the point is `at`: subtract it",
       {shares(o_bc, o_ca, o_ab, o_bc + o_ca + o_ab)}},
      {"beyond an edge the plane goes on: do not limit the weights",
       {weighed(max(x, 0.), max(y, 0.), max(z, 0.)),
        weighed(clamp(x, 0., 1.), clamp(y, 0., 1.), clamp(z, 0., 1.))}},
      {"this is right if the edges from a run along u and along v, as from (0, 0)",
       {a + (b - a) * at.u + (c - a) * at.v,
        a + (b - a) * (at.u - uv_a.u) + (c - a) * (at.v - uv_a.v),
        a + (b - a) * ((at.u - uv_a.u) / (uv_b.u - uv_a.u)) +
            (c - a) * ((at.v - uv_a.v) / (uv_c.v - uv_a.v))}},
      {"an edge has the wrong direction: go around, from b to c, from c to a, from a to b",
       {weighed(x, -y, z), weighed(x, -y, 1 - x + y), shares(bc, -ca, ab, bc - ca + ab)}},
  };
}

/// By two steps along the edges from a: Cramer's rule.
Vec3d right_point(Place2 at, Vec3d a, Vec3d b, Vec3d c, Place2 uv_a, Place2 uv_b, Place2 uv_c) {
  const double b_u = uv_b.u - uv_a.u, b_v = uv_b.v - uv_a.v, c_u = uv_c.u - uv_a.u,
               c_v = uv_c.v - uv_a.v, u = at.u - uv_a.u, v = at.v - uv_a.v;
  const double determinant = b_u * c_v - b_v * c_u;
  return a + (b - a) * ((u * c_v - v * c_u) / determinant) +
         (c - a) * ((b_u * v - b_v * u) / determinant);
}

constexpr Place2 none{0, 0}, u_one{1, 0}, v_one{0, 1}, both{1, 1};
constexpr Vec3d a_side{2, 0, 0}, b_side{0, 4, 0}, c_side{0, 0, 6};
constexpr Place<Place2, Vec3d, Vec3d, Vec3d, Place2, Place2, Place2> point_of_places[] = {
    {"at the texture coordinates of b it is b", {u_one, a_side, b_side, c_side, none, u_one, both}},
    {"in the middle between those of a and b it is (1, 2, 0)",
     {{0.5, 0}, a_side, b_side, c_side, none, u_one, both}},
    {"at (0.6, 0.4), with the page's weights 0.4, 0.2, 0.4: (0.8, 0.8, 2.4)",
     {{0.6, 0.4}, a_side, b_side, c_side, none, u_one, both}},
    {"clockwise: (0, 0), (0, 1), (1, 1)", {{0.3, 0.8}, a_side, b_side, c_side, none, v_one, both}},
    {"corners at (0.2, 0.3), (0.8, 0.5), (0.3, 0.9)",
     {{0.4, 0.6}, {1, 2, 3}, {-2, 1, 4}, {0, 5, -1}, {0.2, 0.3}, {0.8, 0.5}, {0.3, 0.9}}},
    {"the same, at a place beyond an edge",
     {{0.9, 0.7}, {1, 2, 3}, {-2, 1, 4}, {0, 5, -1}, {0.2, 0.3}, {0.8, 0.5}, {0.3, 0.9}}},
    {"clockwise, and beyond a corner",
     {{-1, -0.5}, {1, 2, 3}, {-2, 1, 4}, {0, 5, -1}, {0.2, 0.3}, {0.3, 0.9}, {0.8, 0.5}}},
};

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
  /// A triangle around the ray, moved.
  const auto moved = [](double x, double y) {
    return Window{{x - 1, y - 1, 0}, {x + 2, y - 1, 0}, {x, y + 3, 0}};
  };
  const auto moved_house = [](double x, double y) {
    return Window{
        {x - 2, y - 2, 0}, {x + 2, y - 2, 0}, {x + 2, y + 1, 0}, {x, y + 3, 0}, {x - 2, y + 1, 0}};
  };
  const Vec3d near{1, 0, 0}, far{3, 0, 0}, top{2, 2, 0};
  static const Place<Window> is_hit_places[] = {
      {"the ray is inside a triangle, corners counterclockwise: a hit", moved(0, 0)},
      {"the corners run clockwise: a hit, too", Window{{-1, -1, 0}, {0, 3, 0}, {2, -1, 0}}},
      {"the ray is right of the triangle: a miss", moved(-5, 0)},
      {"the ray is below the triangle: a miss", moved(0, 5)},
      {"above an edge, but in the box around the triangle: a miss", moved(-1.5, -2)},
      {"clockwise, the ray is right of it: a miss", Window{{-6, -1, 0}, {-5, 3, 0}, {-3, -1, 0}}},
      {"inside of five corners: a hit", moved_house(0, 0)},
      {"inside of five corners, beyond the first three: a hit", moved_house(1.5, -0.5)},
      {"above the roof of five corners: a miss", moved_house(-1.5, -2.5)},
      {"exactly on an edge of five corners: a hit", moved_house(0, 2)},
      {"exactly on that edge of a neighbor: a hit, too", Window{{-2, 0, 0}, {0, -3, 0}, {2, 0, 0}}},
      {"exactly through a corner: a hit", moved_house(0, -3)},
      {"on the line through an edge, but outside: a miss", Window{near, far, top}},
      {"on the lines through two edges, but outside: a miss",
       Window{{1, 1, 0}, {2, 2, 0}, {2, -2, 0}, {1, -1, 0}}},
      {"from the side, all on a line beside the ray: a miss",
       Window{{-1, 1, 0}, {1, 1, 0}, {3, 1, 0}}},
      {"from the side, all on a line through the ray: a miss",
       Window{{-1, -1, 0}, {1, 1, 0}, {3, 3, 0}}},
      {"the same with four corners, all on one side of the ray: a miss",
       Window{{1, 2, 0}, {2, 4, 0}, {4, 8, 0}, {3, 6, 0}}},
  };
  return {
      "08",
      {exercise(is_hit, crate_on_its_edge, {right_hit, wrong_hits, is_hit_places}),
       exercise(point_of, picture<Lesson>(), {right_point, wrong_points, point_of_places})},
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
}

}  // namespace texmap::check
