// The exercises of chapter 01. The lesson is the chapter's own. Its color_along and sample_light
// are these here, which call the student's function.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "exercises.hpp"
#include "scene/light.hpp"

namespace texmap::check {

using Vector = Vec3<double>;
using FirstHit = std::function<double(Vector, Vector)>;

static Hook<double(Vector, Vector, Vector, double)> distance_to_sphere;
static Hook<double(Vector, Vector, Vector)> cosine_of;
static Hook<bool(Vector, Vector, Vector, const FirstHit&)> in_shadow;

/// The distance to the first of `objects`, each with a `shape`, along a ray; infinity for a miss.
template <class Objects>
[[nodiscard]] static FirstHit first_hit_on(const Objects& objects) {
  return [&objects](const Vector& origin, const Vector& direction) {
    return find_nearest(objects, Ray<double>{origin, direction}).distance;
  };
}

}  // namespace texmap::check

namespace texmap::chapter_01 {

inline constexpr struct {
  template <class Objects, class Background, class Shade>
  Color<double> operator()(const Objects& objects, const Ray<double>& ray,
                           const Background& background, const Shade& shade) const {
    if (!check::distance_to_sphere) return texmap::color_along(objects, ray, background, shade);
    auto first = infinity<double>();
    auto found = objects.end();
    for (auto object = objects.begin(); object != objects.end(); ++object) {
      const double distance = check::distance_to_sphere.yours(
          ray.origin, ray.direction, object->shape.center, object->shape.radius);
      if (distance < first) {
        first = distance;
        found = object;
      }
    }
    if (found == objects.end()) return background(ray);
    return shade(*found, hit_at(found->shape, ray, first));
  }
} color_along;

inline constexpr struct {
  template <class Objects>
  LightSample<double> operator()(const PointLight& light, const Objects& objects,
                                 const Hit<double>& hit) const {
    const Vec3<double> path = light.position - hit.point;
    const Vec3<double> to_light = normalize(path);
    const double cosine = check::cosine_of
                              ? check::cosine_of.yours(hit.point, hit.normal, light.position)
                              : std::max(dot(hit.normal, to_light), 0.0);
    if (cosine <= 0) return {to_light, cosine};
    const bool hidden =
        check::in_shadow
            ? check::in_shadow.yours(hit.point, hit.normal, light.position,
                                     check::first_hit_on(objects))
            : is_occluded(objects, Ray<double>{hit.outside, to_light}, length(path), hit.shape);
    return {to_light, hidden ? 0 : cosine};
  }
} sample_light;

}  // namespace texmap::chapter_01

#include "01_plain_spheres/lesson.hpp"

namespace texmap::check {
namespace {

/// A ray and a sphere, and the page's a, b and c.
struct Meeting {
  Vector origin, direction, center;
  double radius;
  Vector f = origin - center;
  double a = dot(direction, direction), b = -dot(f, direction), c = dot(f, f) - radius * radius;
};

/// The two t of a ray and a sphere, NaN if there are none.
struct Roots {
  double entry, exit;
};

Roots roots_of(double a, double b, double c) {
  const double root = std::sqrt(b * b - a * c);
  return {(b - root) / a, (b + root) / a};
}

constexpr double never = std::numeric_limits<double>::infinity();

// What to make of the roots.
double first_ahead(const Roots& t) { return t.entry > 0 ? t.entry : t.exit > 0 ? t.exit : never; }
double entry_alone(const Roots& t) { return std::isnan(t.entry) ? never : t.entry; }
double entry_ahead(const Roots& t) { return t.entry > 0 ? t.entry : never; }
double exit_alone(const Roots& t) { return std::isnan(t.exit) ? never : t.exit; }
double exit_ahead(const Roots& t) { return t.exit > 0 ? t.exit : never; }
double entry_or_any_exit(const Roots& t) { return t.entry > 0 ? t.entry : exit_alone(t); }

using ToSphere = double(Vector, Vector, Vector, double);

void add_mistakes_with_the_roots(Law<ToSphere>& law) {
  const auto wrong = [&](const char* word, double (*function)(const Roots&)) {
    law.mistakes.push_back(
        {word, [=](const Vector& o, const Vector& d, const Vector& center, double r) {
           const Meeting m{o, d, center, r};
           return function(roots_of(m.a, m.b, m.c));
         }});
  };
  wrong(
      "this is infinity for every ray: look at the signs in b * b - a * c, and at what you compare",
      [](const Roots&) { return never; });
  wrong("this is where the ray leaves the sphere: the smaller t comes first", exit_ahead);
  wrong("this is where the ray leaves the sphere, and it may be behind the origin", exit_alone);
  wrong("a t below 0 is behind the origin: only t > 0 counts", entry_alone);
  wrong("a sphere behind the origin is never met: the larger t counts only if it is above 0, too",
        entry_or_any_exit);
  for (const auto& positive :
       {+[](double t) { return std::abs(t); }, +[](double t) { return std::max(t, 0.0); }}) {
    law.mistakes.push_back(
        {"a t below 0 is behind the origin: no std::abs and no std::max makes it a distance",
         [=](const Vector& o, const Vector& d, const Vector& center, double r) {
           const Meeting m{o, d, center, r};
           return positive(entry_alone(roots_of(m.a, m.b, m.c)));
         }});
  }
  wrong("the smaller t is behind the origin if the ray starts inside: then take the larger one",
        entry_ahead);
  const char* const nan =
      "the square root of a negative number is NaN: if the discriminant is below 0, return first";
  wrong(nan, [](const Roots& t) {
    return t.entry > 0 || std::isnan(t.entry) ? t.entry : first_ahead(t);
  });
  wrong(nan, [](const Roots& t) { return t.entry; });
  wrong(nan, [](const Roots& t) { return t.exit; });
  wrong(nan, [](const Roots& t) { return t.entry > 0 ? t.entry : t.exit; });
  // Those who return another number for a miss do so in one place or in both, or in another way.
  const char* const miss = "the task wants infinity for a miss, and you return another number";
  wrong(miss, [](const Roots& t) { return std::isnan(t.entry) ? 0 : first_ahead(t); });
  wrong(miss, [](const Roots& t) { return std::isnan(t.entry) ? -1 : first_ahead(t); });
  wrong(miss, [](const Roots& t) { return t.exit > 0 ? first_ahead(t) : 0; });
  wrong(miss, [](const Roots& t) { return t.exit > 0 ? first_ahead(t) : -1; });
  wrong(miss, [](const Roots& t) { return std::isnan(t.entry) ? 0 : t.entry; });
  wrong(miss, [](const Roots& t) { return std::isnan(t.entry) ? -1 : t.entry; });
  wrong(miss, [](const Roots& t) { return t.entry > 0 ? t.entry : 0; });
  wrong(miss, [](const Roots& t) { return t.entry > 0 ? t.entry : -1; });
}

/// Roots whose 2s and 4 do not fit: school's formula and the page's, mixed.
template <int of_b, int of_ac, int of_a>
Roots mixed(const Meeting& m) {
  const double b = of_b * m.b;
  const double root = std::sqrt(b * b - of_ac * m.a * m.c);
  return {(b - root) / (of_a * m.a), (b + root) / (of_a * m.a)};
}

/// Other roots than the right ones, with their word.
struct Formula {
  const char* word;
  Roots (*roots)(const Meeting&);
};

constexpr const char* other_c = "c is dot(f, f) - radius * radius, and yours is another one";
constexpr const char* no_center = "the center is not subtracted everywhere: f is origin - center";
constexpr const char* fit =
    "the 2s and the 4 do not fit: with b = -dot(f, d), t is (b - sqrt(b * b - a * c)) / a";
constexpr const char* parentheses =
    "only the root is divided by a: write parentheses, (b - root) / a";
constexpr const char* no_point =
    "a discriminant below 0 means that there is no point: return infinity";

constexpr Formula formulas[] = {
    {"the ray runs backward: f is origin - center, and b is -dot(f, direction)",
     [](const Meeting& m) { return roots_of(m.a, -m.b, m.c); }},
    {"the direction may have any length: divide by a = dot(direction, direction)",
     [](const Meeting& m) { return roots_of(1, m.b, m.a * m.c); }},
    {"this is right for directions of length 1 alone: t counts in lengths of the direction",
     [](const Meeting& m) { return roots_of(1, m.b / std::sqrt(m.a), m.c); }},
    {"this is chapter 00's formula, for directions of length 1: here a = dot(d, d) is missing",
     [](const Meeting& m) { return roots_of(1, m.b, m.c); }},
    {"the discriminant is b * b - a * c: you have no a there",
     [](const Meeting& m) {
       const Roots t = roots_of(1, m.b, m.c);
       return Roots{t.entry / m.a, t.exit / m.a};
     }},
    {"a is the square of the direction's length: dot(direction, direction)",
     [](const Meeting& m) { return roots_of(std::sqrt(m.a), m.b, m.c); }},
    {"divide by a, do not multiply: C++ reads x / 2 * a as (x / 2) * a; write x / (2 * a)",
     [](const Meeting& m) {
       const Roots t = roots_of(1, m.b, m.a * m.c);
       return Roots{t.entry * m.a, t.exit * m.a};
     }},
    {parentheses,
     [](const Meeting& m) {
       const double root = std::sqrt(m.b * m.b - m.a * m.c) / m.a;
       return Roots{m.b - root, m.b + root};
     }},
    {parentheses,
     [](const Meeting& m) {
       const double root = std::sqrt(m.b * m.b - m.a * m.c) / m.a;
       return Roots{2 * m.b - root, 2 * m.b + root};  // school's formula
     }},
    {"the radius is not squared: c is dot(f, f) - radius * radius",
     [](const Meeting& m) { return roots_of(m.a, m.b, dot(m.f, m.f) - m.radius); }},
    {other_c, [](const Meeting& m) { return roots_of(m.a, m.b, dot(m.f, m.f)); }},
    {other_c,
     [](const Meeting& m) { return roots_of(m.a, m.b, dot(m.f, m.f) + m.radius * m.radius); }},
    {other_c, [](const Meeting& m) { return roots_of(m.a, m.b, dot(m.f, m.f) - 2 * m.radius); }},
    {other_c,
     [](const Meeting& m) { return roots_of(m.a, m.b, length(m.f) - m.radius * m.radius); }},
    {other_c,
     [](const Meeting& m) {
       return roots_of(m.a, m.b, (length(m.f) - m.radius) * (length(m.f) - m.radius));
     }},
    {no_center,
     [](const Meeting& m) {
       const Meeting there{m.origin, m.direction, Vector{}, m.radius};
       return roots_of(m.a, there.b, there.c);
     }},
    {no_center, [](const Meeting& m) { return roots_of(m.a, -dot(m.origin, m.direction), m.c); }},
    {no_center,
     [](const Meeting& m) {
       const Meeting there{m.origin, m.direction, m.center * -1.0, m.radius};
       return roots_of(m.a, there.b, there.c);
     }},
    {"the discriminant is b * b - a * c: yours has a plus",
     [](const Meeting& m) { return roots_of(m.a, m.b, -m.c); }},
    {"the square root of the discriminant is missing: std::sqrt",
     [](const Meeting& m) {
       const double inside = m.b * m.b - m.a * m.c;
       const double root = inside < 0 ? std::nan("") : inside;
       return Roots{(m.b - root) / m.a, (m.b + root) / m.a};
     }},
    {fit, mixed<2, 1, 1>},
    {fit, mixed<2, 1, 2>},
    {fit, mixed<1, 4, 2>},
    {fit, mixed<2, 4, 1>},
    {fit, mixed<1, 4, 1>},
    {fit, mixed<1, 1, 2>},
    {no_point,
     [](const Meeting& m) {
       const double root = std::sqrt(std::abs(m.b * m.b - m.a * m.c));
       return Roots{(m.b - root) / m.a, (m.b + root) / m.a};
     }},
    {no_point,
     [](const Meeting& m) {
       const double root = std::sqrt(std::max(m.b * m.b - m.a * m.c, 0.0));
       return Roots{(m.b - root) / m.a, (m.b + root) / m.a};
     }},
};

void add_mistakes_in_the_formula(Law<ToSphere>& law) {
  // Those who make another mistake often take the first root alone, too.
  for (double (*const pick)(const Roots&) : {first_ahead, entry_alone, entry_ahead}) {
    for (const Formula& formula : formulas) {
      law.mistakes.push_back(
          {formula.word, [=](const Vector& o, const Vector& d, const Vector& center, double r) {
             return pick(formula.roots({o, d, center, r}));
           }});
    }
  }
}

Exercise where_the_ray_meets_the_sphere() {
  const Vector middle{0, 0, 0};
  const Vector eye{0, 0, 5};
  Law<ToSphere> law{
      .right =
          [](const Vector& o, const Vector& d, const Vector& center, double r) {
            return distance_to(Sphere<>{center, r}, Ray<double>{o, d});
          },
      .places = {{"from (0, 0, 5) straight at the unit sphere, t is 4",
                  {eye, Vector{0, 0, -1}, middle, 1}},
                 {"from (0, 0.6, 5) in the direction (0, 0, -1), t is 4.2",
                  {Vector{0, 0.6, 5}, Vector{0, 0, -1}, middle, 1}},
                 {"a sphere of radius 1/2 around (3, 1, -2): from (3, 1, 4), t is 5.5",
                  {Vector{3, 1, 4}, Vector{0, 0, -1}, Vector{3, 1, -2}, 0.5}},
                 {"distances are in lengths of the direction: with (0, 0, -2), t is 2",
                  {eye, Vector{0, 0, -2}, middle, 1}},
                 {"a ray that passes the sphere never meets it",
                  {eye, Vector{0, 1, -1}, middle, 1}},
                 {"a sphere behind the origin is never met", {eye, Vector{0, 0, 1}, middle, 1}},
                 {"from inside, the ray meets the sphere where it leaves it",
                  {Vector{0, 0, 0.5}, Vector{0, 0, 1}, middle, 1}}},
      .mistakes = {},
      .tolerance = 1e-9};
  add_mistakes_with_the_roots(law);
  add_mistakes_in_the_formula(law);
  return exercise(
      "01.1", "double distance_to_sphere(Vec3 origin, Vec3 direction, Vec3 center, double radius)",
      std::move(law), distance_to_sphere, [] { return drawn<chapter_01::Lesson>(); });
}

using CosineOf = double(Vector, Vector, Vector);

void add_mistakes_with_the_cosine(Law<CosineOf>& law) {
  const auto cosine = [](const Vector& n, const Vector& v) { return dot(n, normalize(v)); };
  bool cut = true;
  const auto wrong = [&](const char* word, auto function) {
    law.mistakes.push_back(
        {word, [=](const Vector& point, const Vector& normal, const Vector& lamp) {
           const double value = function(point, normal, lamp);
           return cut ? std::max(value, 0.0) : value;
         }});
  };
  const char* const unit = "the direction to the lamp does not have length 1: normalize it";
  const char* const inward =
      "the signs are wrong: the direction or the normal points inward, so the dark side is lit";
  const char* const position =
      "lamp is a position: subtract the point to get the direction from there to the lamp";
  const char* const point = "point is a position, no direction: the surface faces along normal";
  const char* const whole = "subtract first: it is lamp - point as a whole that gets the length 1";
  const char* const color = "0.2 and 0.8 come later, with the color: return the cosine alone";
  // Those who make another mistake often forget to cut off, too.
  for (const bool at_0 : {true, false}) {
    cut = at_0;
    wrong(cut ? unit
              : "the direction to the lamp does not have length 1, and nothing is cut off at 0",
          [](Vector p, Vector n, Vector lamp) { return dot(n, lamp - p); });
    wrong(cut ? inward : "the signs are wrong, and nothing is cut off at 0",
          [=](Vector p, Vector n, Vector lamp) { return cosine(n, p - lamp); });
    wrong(inward, [](Vector p, Vector n, Vector lamp) { return dot(n, p - lamp); });
    wrong(position, [=](Vector, Vector n, Vector lamp) { return cosine(n, lamp); });
    wrong(position, [](Vector, Vector n, Vector lamp) { return dot(n, lamp); });
    wrong("between point and lamp is lamp - point, not their sum",
          [=](Vector p, Vector n, Vector lamp) { return cosine(n, lamp + p); });
    wrong("the direction to the lamp begins at the point: subtract point, not normal",
          [=](Vector, Vector n, Vector lamp) { return cosine(n, lamp - n); });
    wrong(whole, [](Vector p, Vector n, Vector lamp) { return dot(n, normalize(lamp) - p); });
    wrong(whole,
          [](Vector p, Vector n, Vector lamp) { return dot(n, normalize(lamp) - normalize(p)); });
    wrong(whole, [](Vector p, Vector n, Vector lamp) { return dot(n, lamp - p) / length(lamp); });
    wrong(point, [=](Vector p, Vector, Vector lamp) { return cosine(p, lamp - p); });
    wrong(point, [](Vector p, Vector, Vector lamp) { return dot(p, lamp - p); });
    wrong(point, [=](Vector p, Vector, Vector lamp) { return cosine(normalize(p), lamp - p); });
    wrong(point, [](Vector p, Vector, Vector lamp) { return dot(p, lamp); });
    wrong(point, [=](Vector p, Vector, Vector lamp) { return cosine(normalize(p), lamp); });
    wrong(
        "divide by the length of lamp - point, not by its square",
        [](Vector p, Vector n, Vector lamp) { return dot(n, lamp - p) / dot(lamp - p, lamp - p); });
    wrong("the distance of the lamp does not matter here: return the cosine alone",
          [=](Vector p, Vector n, Vector lamp) {
            return cosine(n, lamp - p) / dot(lamp - p, lamp - p);
          });
    wrong("this is the angle; the dot product already is its cosine",
          [=](Vector p, Vector n, Vector lamp) { return std::acos(cosine(n, lamp - p)); });
    wrong("the dot product already is the cosine: take no std::cos of it",
          [=](Vector p, Vector n, Vector lamp) { return std::cos(cosine(n, lamp - p)); });
    wrong("the cross product has the length of the sine: the cosine is the dot product",
          [](Vector p, Vector n, Vector lamp) { return length(cross(n, normalize(lamp - p))); });
    wrong(color, [=](Vector p, Vector n, Vector lamp) { return 0.2 + 0.8 * cosine(n, lamp - p); });
    wrong(color, [=](Vector p, Vector n, Vector lamp) { return 0.8 * cosine(n, lamp - p); });
  }
  // From here on each cuts off in its own way.
  const auto after = [&](const char* word, double (*function)(double)) {
    wrong(word, [=](Vector p, Vector n, Vector lamp) { return function(cosine(n, lamp - p)); });
  };
  after("a lamp behind the surface gives negative light: nothing is cut off at 0",
        [](double c) { return c; });
  after("the side away from the lamp is lit, too: use std::max(c, 0.0), not the absolute value",
        [](double c) { return std::abs(c); });
  after(color, [](double c) { return 0.2 + 0.8 * std::max(c, 0.0); });
  after("this is the angle; the dot product already is its cosine",
        [](double c) { return std::acos(std::max(c, 0.0)); });
  after("the dot product already is the cosine: take no std::cos of it",
        [](double c) { return std::cos(std::max(c, 0.0)); });
  after("this says only whether the lamp is in front: return the cosine itself",
        [](double c) { return c > 0 ? 1.0 : 0.0; });
  wrong("the side away from the lamp is lit, too: use std::max(c, 0.0), not the absolute value",
        [](Vector p, Vector n, Vector lamp) { return std::abs(dot(n, lamp - p)); });
  const char* const smaller =
      "std::min keeps the smaller number: std::max(c, 0.0) cuts off below 0";
  after(smaller, [](double c) { return std::min(c, 0.0); });
  after(smaller, [](double c) { return std::min(-c, 0.0); });
  wrong(smaller, [](Vector p, Vector n, Vector lamp) { return std::min(dot(n, lamp - p), 0.0); });
}

Exercise how_straight_the_light_falls() {
  const Vector up{0, 1, 0};
  const Vector origin{0, 0, 0};
  Law<CosineOf> law{
      .right =
          [](const Vector& point, const Vector& normal, const Vector& lamp) {
            return std::max(dot(normal, normalize(lamp - point)), 0.0);
          },
      .places = {{"a lamp straight above, at distance 1: the cosine is 1",
                  {origin, up, Vector{0, 1, 0}}},
                 {"a lamp straight above, at distance 3: the cosine is 1, too",
                  {origin, up, Vector{0, 3, 0}}},
                 {"a lamp at 60 degrees from the normal: the cosine is 1/2",
                  {origin, up, Vector{std::sqrt(3.0), 1, 0}}},
                 {"point (5, 0, 2), lamp at 60 degrees from the normal there: the cosine is 1/2",
                  {Vector{5, 0, 2}, up, Vector{5 + std::sqrt(3.0), 1, 2}}},
                 {"normal (1, 0, 0), point (0, 0, 0), lamp (3, 0, 4): the cosine is 0.6",
                  {origin, Vector{1, 0, 0}, Vector{3, 0, 4}}},
                 {"normal (0, 1, 0), point (0, 2, 0), lamp (3, 6, 0): the cosine is 0.8",
                  {Vector{0, 2, 0}, up, Vector{3, 6, 0}}},
                 {"a lamp behind the surface: return 0", {origin, up, Vector{1, -2, 0}}},
                 {"a lamp in the plane of the surface: the cosine is 0",
                  {origin, up, Vector{0, 0, 2}}}},
      .mistakes = {},
      .tolerance = 1e-9};
  add_mistakes_with_the_cosine(law);
  return exercise("01.2", "double cosine_of(Vec3 point, Vec3 normal, Vec3 lamp)", std::move(law),
                  cosine_of, [] { return drawn<chapter_01::Lesson>(); });
}

/// The chapter's scene with the lamp between the left and the middle sphere: now spheres are
/// behind the lamp, too.
Image with_a_low_lamp() {
  auto lesson = prepared<chapter_01::Lesson>();
  lesson.stage.light.position = {-1.3, 0.8, 1.2};
  return picture_of(lesson);
}

using InShadow = bool(Vector, Vector, Vector, const FirstHit&);

/// Whether a ray from the point, so far above the surface, meets something before the limit.
struct Look {
  double lift = 0.001;
  Vector (*direction)(const Vector& start, const Vector& lamp, const Vector& normal);
  double (*limit)(const Vector& start, const Vector& lamp);

  bool operator()(const Vector& point, const Vector& normal, const Vector& lamp,
                  const FirstHit& first_hit) const {
    const Vector start = point + normal * lift;
    return first_hit(start, direction(start, lamp, normal)) < limit(start, lamp);
  }
};

// Directions and limits of a Look: the right ones first.
Vector to(const Vector& start, const Vector& lamp, const Vector& /*normal*/) {
  return normalize(lamp - start);
}
Vector all_the_way(const Vector& start, const Vector& lamp, const Vector& /*normal*/) {
  return lamp - start;
}
Vector away(const Vector& start, const Vector& lamp, const Vector& /*normal*/) {
  return normalize(start - lamp);
}
Vector far_away(const Vector& start, const Vector& lamp, const Vector& /*normal*/) {
  return start - lamp;
}
Vector position(const Vector& /*start*/, const Vector& lamp, const Vector& /*normal*/) {
  return lamp;
}
Vector unit_position(const Vector& /*start*/, const Vector& lamp, const Vector& /*normal*/) {
  return normalize(lamp);
}
Vector sum(const Vector& start, const Vector& lamp, const Vector& /*normal*/) {
  return normalize(lamp + start);
}
Vector upward(const Vector& /*start*/, const Vector& /*lamp*/, const Vector& normal) {
  return normal;
}
double distance(const Vector& start, const Vector& lamp) { return length(lamp - start); }
double one(const Vector& /*start*/, const Vector& /*lamp*/) { return 1; }
double anywhere(const Vector& /*start*/, const Vector& /*lamp*/) { return infinity<double>(); }
double from_the_origin(const Vector& /*start*/, const Vector& lamp) { return length(lamp); }

void add_mistakes_with_the_look(Law<InShadow>& law) {
  const auto wrong = [&](const char* word, std::function<InShadow> function) {
    law.mistakes.push_back({word, std::move(function)});
  };
  const auto not_this = [](const Look& look) {
    return [=](const Vector& p, const Vector& n, const Vector& lamp, const FirstHit& hit) {
      return !look(p, n, lamp, hit);
    };
  };
  wrong("the ray starts on the sphere, and rounding lets it meet that sphere: start 0.001 above",
        Look{0, to, distance});
  wrong("the ray starts below the surface: add normal * 0.001, do not subtract it",
        Look{-0.001, to, distance});
  wrong("the ray starts too far above the surface and misses what is nearer: add normal * 0.001",
        Look{1, to, distance});
  wrong("this is never true: compare what first_hit returns with the distance of the lamp",
        [](const Vector&, const Vector&, const Vector&, const FirstHit&) { return false; });
  wrong("this is true everywhere: compare what first_hit returns with the distance of the lamp",
        [](const Vector&, const Vector&, const Vector&, const FirstHit&) { return true; });
  wrong("this says whether the lamp is behind the surface: ask first_hit what is in between",
        [](const Vector& p, const Vector& n, const Vector& lamp, const FirstHit&) {
          return dot(n, lamp - p) < 0;
        });
  // Those who make another mistake often forget the 0.001, too.
  for (const double lift : {0.001, 0.0}) {
    for (const auto direction : {to, all_the_way}) {
      wrong("a sphere behind the lamp casts no shadow: compare with the distance of the lamp",
            Look{lift, direction, anywhere});
    }
    wrong("distances are in lengths of the direction: normalize it; the lamp is length(path) away",
          Look{lift, all_the_way, distance});
    wrong("a normalized direction has length 1: compare with length(lamp - start), not with 1",
          Look{lift, to, one});
    for (const auto direction : {to, all_the_way}) {
      wrong("length(lamp) is the distance from (0, 0, 0): compare with length(lamp - start)",
            Look{lift, direction, from_the_origin});
    }
    for (const auto limit : {distance, one, anywhere, from_the_origin}) {
      for (const auto direction : {away, far_away}) {
        wrong("the ray runs away from the lamp: its direction is lamp - point",
              Look{lift, direction, limit});
      }
      for (const auto direction : {position, unit_position}) {
        wrong("lamp is a position: the direction is lamp - start", Look{lift, direction, limit});
      }
      wrong("the direction to the lamp is lamp - start, not their sum", Look{lift, sum, limit});
      wrong("you look along the normal: the direction to the lamp is lamp - start",
            Look{lift, upward, limit});
    }
    wrong("first_hit takes the start first, then the direction",
          [=](const Vector& p, const Vector& n, const Vector& lamp, const FirstHit& hit) {
            const Vector start = p + n * lift;
            return hit(normalize(lamp - start), start) < length(lamp - start);
          });
    for (const Look& look : {Look{lift, to, distance}, Look{lift, to, anywhere},
                             Look{lift, all_the_way, distance}, Look{lift, to, one}}) {
      wrong("true and false are exchanged: the lamp is hidden if something is nearer than it",
            not_this(look));
    }
  }
  wrong("a ray from the lamp meets the sphere of the point, too: start at the point",
        [](const Vector& p, const Vector&, const Vector& lamp, const FirstHit& hit) {
          return hit(lamp, normalize(p - lamp)) < length(lamp - p);
        });
}

Exercise is_the_lamp_hidden() {
  struct Ball {
    Sphere<> shape;
  };
  static const std::vector<Ball> balls = {{{{0, 0, 0}, 1}},
                                          {{{0, 4, 0}, 0.5}},
                                          {{{0, 20, 0}, 1}},
                                          {{{6, 0, 0}, 1}},
                                          {{{0, -1.5, 0}, 0.25}}};
  const FirstHit scene = first_hit_on(balls);
  const Vector up{0, 1, 0};
  const Vector top{0, 1, 0};
  const Vector bottom{0, -1, 0};
  const Vector down{0, -1, 0};
  Law<InShadow> law{
      .right = Look{0.001, to, distance},
      .places =
          {{"a sphere is between the point and the lamp: the lamp is hidden",
            {top, up, Vector{0, 8, 0}, scene}},
           {"nothing is between the point and the lamp: the lamp is not hidden",
            {top, up, Vector{5, 5, 0}, scene}},
           {"rounding put the point 1e-12 below its own sphere: this sphere does not hide the lamp",
            {Vector{0, 1 - 1e-12, 0}, up, Vector{5, 5, 0}, scene}},
           {"a point under a sphere, and nothing between it and the lamp below: it is not hidden",
            {bottom, down, Vector{5, -5, 0}, scene}},
           {"a sphere behind the lamp does not hide the lamp", {top, up, Vector{0, 3, 0}, scene}},
           {"a sphere 5 times as far away as the lamp does not hide the lamp",
            {Vector{0, 4.5, 0}, up, Vector{0, 7.3, 0}, scene}},
           {"a sphere on the other side of the point does not hide the lamp",
            {Vector{0, 7, 0}, up, Vector{0, 10, 0}, scene}},
           {"point (5, 0, 0), normal (-1, 0, 0), lamp (1, 6, 0): nothing is in between",
            {Vector{5, 0, 0}, Vector{-1, 0, 0}, Vector{1, 6, 0}, scene}},
           {"point (5, 0, 0), normal (-1, 0, 0), lamp (-2, 4, 0): nothing is in between",
            {Vector{5, 0, 0}, Vector{-1, 0, 0}, Vector{-2, 4, 0}, scene}},
           {"point (6, 1, 0), normal (0, 1, 0), lamp (9, 5, 0): nothing is in between",
            {Vector{6, 1, 0}, up, Vector{9, 5, 0}, scene}},
           {"a sphere that is 4 away does not hide a lamp that is 0.8 away",
            {Vector{5, 0, 0}, Vector{-1, 0, 0}, Vector{4.2, 0, 0}, scene}},
           {"a sphere that is 4 away hides a lamp that is 8 away",
            {Vector{5, 0, 0}, Vector{-1, 0, 0}, Vector{-3, 0, 0}, scene}},
           {"a sphere that is 1/4 away hides the lamp", {bottom, down, Vector{0, -6, 0}, scene}},
           {"a lamp behind the surface: the point's own sphere hides it",
            {Vector{7, 0, 0}, Vector{1, 0, 0}, Vector{2, 3, 0}, scene}}},
      .mistakes = {}};
  add_mistakes_with_the_look(law);
  return exercise("01.3",
                  "bool in_shadow(Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit)",
                  std::move(law), in_shadow, with_a_low_lamp);
}

/// The angle, in degrees, at which a surface of the lesson is half as bright as where light falls
/// straight on it.
double half_bright_angle() {
  const Lambertian surface = chapter_01::Lesson{}.surface;
  const double half = (surface.ambient + surface.diffuse) / 2;
  return std::acos((half - surface.ambient) / surface.diffuse) * 180 / std::numbers::pi;
}

}  // namespace

const ExercisesOfChapter& exercises_of_chapter() {
  static const ExercisesOfChapter chapter{
      .exercises = {where_the_ray_meets_the_sphere(), how_straight_the_light_falls(),
                    is_the_lamp_hidden()},
      .questions = {{"01.a",
                     "The right sphere has the color (0.2, 0.2, 0.8), and one of its points is in "
                     "shadow. Which number, 0 to 255, does the pixel there have for blue? "
                     "Decimals are cut off.",
                     [] {
                       const chapter_01::Lesson lesson;
                       const Rgb paint = lesson.objects[chapter_01::right].paint.color;
                       return static_cast<double>(byte_of(paint.b * lesson.surface.ambient));
                     },
                     "", 0},
                    {"01.b",
                     "At which angle of the light, in degrees from the normal, is a surface half "
                     "as bright as where the light falls straight on it?",
                     half_bright_angle, "degrees", 0.005}},
  };
  return chapter;
}

}  // namespace texmap::check
