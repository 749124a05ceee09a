// The exercises of chapter 01: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/01_1.hpp"
}
namespace solution_1 {
#include "exercises/01_1.hpp"
}
namespace start_2 {
#include "starts/01_2.hpp"
}
namespace solution_2 {
#include "exercises/01_2.hpp"
}
namespace start_3 {
#include "starts/01_3.hpp"
}
namespace solution_3 {
#include "exercises/01_3.hpp"
}

using namespace texmap::test;

TEST_CASE("01.1: where the ray meets the sphere") {
  check_start("01.1", start_1::distance_to_sphere);
  check_solution("01.1", solution_1::distance_to_sphere);

  check_mistake(
      "01.1",
      +[](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = origin - center;
        const double a = dot(direction, direction);
        const double b = 2 * dot(f, direction);
        const double discriminant = b * b - 4 * a * (dot(f, f) - radius * radius);
        if (discriminant < 0) return infinity;
        const double t = (-b + std::sqrt(discriminant)) / (2 * a);
        return t > 0 ? t : infinity;
      },
      "leaves the sphere: the smaller");
  check_mistake(
      "01.1",
      +[](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = origin - center;
        const double a = dot(direction, direction);
        const double b = 2 * dot(f, direction);
        const double discriminant = b * b - 4 * a * (dot(f, f) - radius * radius);
        return discriminant < 0 ? infinity : (-b + std::sqrt(discriminant)) / (2 * a);
      },
      "may be behind the origin");
  check_mistake(
      "01.1",
      +[](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = center - origin;
        const double a = dot(direction, direction);
        const double b = dot(f, direction);
        const double discriminant = b * b - a * (dot(f, f) - radius * radius);
        return discriminant < 0 ? infinity : (b - std::sqrt(discriminant)) / a;
      },
      "only t > 0 counts");
  check_mistake(
      "01.1",
      +[](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = center - origin;
        const double a = dot(direction, direction);
        const double b = dot(f, direction);
        const double discriminant = b * b - a * (dot(f, f) - radius * radius);
        if (discriminant < 0) return infinity;
        const double t = (b - std::sqrt(discriminant)) / a;
        return t > 0 ? t : infinity;
      },
      "starts inside");
  check_mistake(
      "01.1",
      +[](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = center - origin;
        const double a = dot(direction, direction);
        const double b = dot(f, direction);
        const double root = std::sqrt(b * b - a * (dot(f, f) - radius * radius));
        if (b + root < 0) return infinity;
        return b - root < 0 ? (b + root) / a : (b - root) / a;
      },
      "is NaN");
  check_mistake(
      "01.1",
      +[](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = origin - center;
        const double a = dot(direction, direction);
        const double b = dot(f, direction);
        const double discriminant = b * b - a * (dot(f, f) - radius * radius);
        if (discriminant < 0) return infinity;
        const double root = std::sqrt(discriminant);
        if (b - root > 0) return (b - root) / a;
        return b + root > 0 ? (b + root) / a : infinity;
      },
      "backward");
  check_mistake(
      "01.1",
      +[](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = center - origin;
        const double b = dot(f, direction);
        const double discriminant =
            b * b - dot(direction, direction) * (dot(f, f) - radius * radius);
        if (discriminant < 0) return infinity;
        const double root = std::sqrt(discriminant);
        if (b - root > 0) return b - root;
        return b + root > 0 ? b + root : infinity;
      },
      "divide by a");
  check_mistake(
      "01.1",
      +[](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        return solution_1::distance_to_sphere(origin, direction / length(direction), center,
                                              radius);
      },
      "length 1 alone");
  check_unknown(
      "01.1", +[](Vec3 origin, Vec3, Vec3, double) { return origin.z; });
}

TEST_CASE("01.1: mistakes in the formula") {
  const auto mistake = [](double (*function)(Vec3, Vec3, Vec3, double), const char* text) {
    check_mistake("01.1", function, text);
  };
  mistake(
      [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = origin - center;
        const double b = -dot(f, direction);
        const double c = dot(f, f) - radius * radius;
        if (b * b < c) return infinity;
        const double root = std::sqrt(b * b - c);
        if (b - root > 0.001) return b - root;
        return b + root > 0.001 ? b + root : infinity;
      },
      "chapter 00's formula");
  mistake(
      [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = origin - center;
        const double a = dot(direction, direction);
        const double b = -dot(f, direction);
        const double c = dot(f, f) - radius * radius;
        return b * b < c ? infinity : (b - std::sqrt(b * b - c)) / a;
      },
      "you have no a there");
  mistake(
      [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = origin - center;
        const double a = dot(direction, direction);
        const double b = 2 * dot(f, direction);
        const double discriminant = b * b - 4 * a * (dot(f, f) - radius * radius);
        if (discriminant < 0) return infinity;
        const double t = (-b - std::sqrt(discriminant)) / 2 * a;
        return t > 0 ? t : infinity;
      },
      "(2 * a)");
  mistake(
      [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = origin - center;
        const double a = dot(direction, direction);
        const double b = 2 * dot(f, direction);
        const double discriminant = b * b - 4 * a * (dot(f, f) - radius * radius);
        return discriminant < 0 ? infinity : -b - std::sqrt(discriminant) / (2 * a);
      },
      "parentheses");
  // The rest is right, up to one number.
  struct Wrong {
    double a, b, c;
  };
  static double (*root_of)(double) = nullptr;
  static Wrong (*formula)(Vec3, Vec3, Vec3, double) = nullptr;
  const auto numbers = [&](
                           Wrong (*wrong)(Vec3, Vec3, Vec3, double), const char* text,
                           double (*root)(double) = [](double x) { return std::sqrt(x); }) {
    formula = wrong;
    root_of = root;
    mistake(
        [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
          const auto [a, b, c] = formula(origin, direction, center, radius);
          const double part = root_of(b * b - a * c);
          if (!(part >= 0)) return infinity;
          if ((b - part) / a > 0) return (b - part) / a;
          return (b + part) / a > 0 ? (b + part) / a : infinity;
        },
        text);
  };
  numbers(
      [](Vec3 o, Vec3 d, Vec3 center, double r) {
        const Vec3 f = o - center;
        return Wrong{dot(d, d), -2 * dot(f, d), dot(f, f) - r * r};
      },
      "2s and the 4");
  numbers(
      [](Vec3 o, Vec3 d, Vec3 center, double r) {
        const Vec3 f = o - center;
        return Wrong{length(d), -dot(f, d), dot(f, f) - r * r};
      },
      "a is the square");
  numbers(
      [](Vec3 o, Vec3 d, Vec3 center, double r) {
        const Vec3 f = o - center;
        return Wrong{dot(d, d), -dot(f, d), dot(f, f) - r};
      },
      "radius is not squared");
  numbers(
      [](Vec3 o, Vec3 d, Vec3 center, double r) {
        const Vec3 f = o - center;
        return Wrong{dot(d, d), -dot(f, d), dot(f, f) - 2 * r};
      },
      "yours is another one");
  numbers(
      [](Vec3 o, Vec3 d, Vec3, double r) {
        return Wrong{dot(d, d), -dot(o, d), dot(o, o) - r * r};
      },
      "center is not subtracted");
  numbers(
      [](Vec3 o, Vec3 d, Vec3 center, double r) {
        const Vec3 f = o - center;
        return Wrong{dot(d, d), -dot(f, d), dot(f, f) + r * r};
      },
      "infinity for every ray");
  const auto right = [](Vec3 o, Vec3 d, Vec3 center, double r) {
    const Vec3 f = o - center;
    return Wrong{dot(d, d), -dot(f, d), dot(f, f) - r * r};
  };
  numbers(right, "std::sqrt", [](double x) { return x; });
  numbers(right, "no point", [](double x) { return std::sqrt(std::fabs(x)); });
  mistake(
      [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const Vec3 f = origin - center;
        const double a = dot(direction, direction);
        const double b = -dot(f, direction);
        const double discriminant = b * b + a * (dot(f, f) - radius * radius);
        if (discriminant < 0) return infinity;
        return (b - std::sqrt(discriminant)) / a;
      },
      "yours has a plus");
}

TEST_CASE("01.1: mistakes with the two roots") {
  const auto mistake = [](double (*function)(Vec3, Vec3, Vec3, double), const char* text) {
    check_mistake("01.1", function, text);
  };
  mistake(
      [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const double t = solution_1::distance_to_sphere(origin, direction, center, radius);
        return t == infinity ? -1 : t;
      },
      "infinity for a miss");
  static const auto roots = [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
    const Vec3 f = origin - center;
    const double a = dot(direction, direction);
    const double b = -dot(f, direction);
    const double root = std::sqrt(b * b - a * (dot(f, f) - radius * radius));
    return std::pair{(b - root) / a, (b + root) / a};
  };
  mistake(
      [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const auto [near, far] = roots(origin, direction, center, radius);
        if (std::isnan(near)) return infinity;
        return near < 0 ? far : near;
      },
      "only if it is above 0");
  mistake(
      [](Vec3 origin, Vec3 direction, Vec3 center, double radius) {
        const auto [near, far] = roots(origin, direction, center, radius);
        return std::isnan(near) ? infinity : std::fabs(near);
      },
      "std::abs");
}

TEST_CASE("01.2: how straight the light falls") {
  check_start("01.2", start_2::cosine_of);
  check_solution("01.2", solution_2::cosine_of);

  check_mistake(
      "01.2",
      +[](Vec3 point, Vec3 normal, Vec3 lamp) {
        const double c = dot(normal, lamp - point);
        return c > 0 ? c : 0;
      },
      "does not have length 1: normalize it");
  check_mistake(
      "01.2",
      +[](Vec3 point, Vec3 normal, Vec3 lamp) {
        const Vec3 l = (point - lamp) / length(point - lamp);
        return std::max(0.0, dot(normal, l));
      },
      "inward");
  check_mistake(
      "01.2",
      +[](Vec3 point, Vec3 normal, Vec3 lamp) {
        const Vec3 l = lamp - point;
        return dot(normal, l) / std::sqrt(dot(l, l));
      },
      "negative light");
  check_mistake(
      "01.2", +[](Vec3 point, Vec3 normal, Vec3 lamp) { return dot(normal, lamp - point); },
      "length 1, and nothing is cut off");
  check_mistake(
      "01.2",
      +[](Vec3 point, Vec3 normal, Vec3 lamp) {
        const Vec3 l = point - lamp;
        return dot(normal, l) / length(l);
      },
      "signs are wrong, and nothing");
  check_mistake(
      "01.2",
      +[](Vec3 point, Vec3 normal, Vec3 lamp) {
        const Vec3 l = lamp - point;
        return std::abs(dot(normal, l)) / length(l);
      },
      "absolute value");
  check_mistake(
      "01.2",
      +[](Vec3, Vec3 normal, Vec3 lamp) {
        const double c = dot(normal, lamp) / length(lamp);
        return c < 0 ? 0.0 : c;
      },
      "subtract the point");
  check_mistake(
      "01.2",
      +[](Vec3 point, Vec3 normal, Vec3 lamp) {
        const Vec3 l = lamp - point;
        return std::acos(dot(normal, l) / length(l));
      },
      "the angle");
}

TEST_CASE("01.2: other vectors, other functions") {
  const auto mistake = [](double (*function)(Vec3, Vec3, Vec3), const char* text) {
    check_mistake("01.2", function, text);
  };
  mistake([](Vec3 point, Vec3 normal,
             Vec3 lamp) { return std::min(dot(normal, normalize(lamp - point)), 0.0); },
          "std::min");
  mistake([](Vec3 point, Vec3,
             Vec3 lamp) { return std::max(dot(point, normalize(lamp - point)), 0.0); },
          "point is a position");
  mistake([](Vec3, Vec3 normal, Vec3 lamp) { return std::max(dot(normal, lamp), 0.0); },
          "lamp is a position");
  mistake([](Vec3 point, Vec3 normal,
             Vec3 lamp) { return std::max(dot(normal, normalize(point + lamp)), 0.0); },
          "not their sum");
  mistake([](Vec3, Vec3 normal,
             Vec3 lamp) { return std::max(dot(normal, normalize(lamp - normal)), 0.0); },
          "subtract point");
  mistake([](Vec3 point, Vec3 normal,
             Vec3 lamp) { return std::max(dot(normal, normalize(lamp) - point), 0.0); },
          "as a whole");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp) {
        const Vec3 l = lamp - point;
        return std::max(dot(normal, l) / dot(l, l), 0.0);
      },
      "not by its square");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp) {
        const double far = length(lamp - point);
        return std::max(dot(normal, normalize(lamp - point)) / (far * far), 0.0);
      },
      "does not matter");
  mistake([](Vec3 point, Vec3 normal,
             Vec3 lamp) { return std::cos(dot(normal, normalize(lamp - point))); },
          "no std::cos");
  mistake([](Vec3 point, Vec3 normal,
             Vec3 lamp) { return length(cross(normalize(lamp - point), normal)); },
          "cross product");
  mistake([](Vec3 point, Vec3 normal,
             Vec3 lamp) { return 0.2 + 0.8 * std::max(dot(normal, normalize(lamp - point)), 0.0); },
          "0.2 and 0.8");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp) { return dot(normal, lamp - point) > 0 ? 1.0 : 0.0; },
      "only whether");
  check_unknown(
      "01.2", +[](Vec3, Vec3, Vec3) { return 0.5; });
}

TEST_CASE("01.3: is the lamp hidden") {
  check_start("01.3", start_3::in_shadow);
  check_solution("01.3", solution_3::in_shadow);

  check_mistake(
      "01.3",
      +[](Vec3 point, Vec3, Vec3 lamp, const FirstHit& first_hit) {
        const double distance = length(lamp - point);
        return first_hit(point, (lamp - point) / distance) < distance;
      },
      "start 0.001 above");
  check_mistake(
      "01.3",
      +[](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const double distance = length(lamp - point);
        return first_hit(point - 0.001 * normal, (lamp - point) / distance) < distance;
      },
      "below the surface");
  check_mistake(
      "01.3",
      +[](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        return first_hit(point + 0.001 * normal, normalize(lamp - point)) != infinity;
      },
      "behind the lamp");
  check_mistake(
      "01.3",
      +[](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const Vec3 start = point + 0.001 * normal;
        const Vec3 path = lamp - start;
        return first_hit(start, path) < std::sqrt(dot(path, path));
      },
      "lengths of the direction");
  check_mistake(
      "01.3",
      +[](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const Vec3 start = point + 0.001 * normal;
        const double distance = length(lamp - start);
        return first_hit(start, (start - lamp) / distance) < distance;
      },
      "away from the lamp");
  check_mistake(
      "01.3",
      +[](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const Vec3 start = point + 0.001 * normal;
        const double distance = length(lamp - start);
        return first_hit(start, (lamp - start) / distance) >= distance;
      },
      "exchanged");
}

TEST_CASE("01.3: other rays, other distances") {
  const auto mistake = [](bool (*function)(Vec3, Vec3, Vec3, const FirstHit&), const char* text) {
    check_mistake("01.3", function, text);
  };
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const Vec3 start = point + 0.001 * normal;
        return first_hit(start, lamp) < length(lamp - start);
      },
      "lamp is a position");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const Vec3 start = point + 0.001 * normal;
        return first_hit(start, normalize(lamp)) < length(lamp);
      },
      "lamp is a position");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const Vec3 start = point + 0.001 * normal;
        return first_hit(start, normalize(lamp - start)) < 1;
      },
      "not with 1");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const Vec3 start = point + 0.001 * normal;
        return first_hit(start, normalize(lamp - start)) < length(lamp);
      },
      "from (0, 0, 0)");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        const Vec3 start = point + 0.001 * normal;
        return first_hit(start, normalize(start + lamp)) < length(lamp - start);
      },
      "not their sum");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        return first_hit(point + 0.001 * normal, normal) < length(lamp - point);
      },
      "along the normal");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        return first_hit(normalize(lamp - point), point + 0.001 * normal) < length(lamp - point);
      },
      "start first");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        return first_hit(point + normal, normalize(lamp - point - normal)) <
               length(lamp - point - normal);
      },
      "too far above");
  mistake(
      [](Vec3 point, Vec3, Vec3 lamp, const FirstHit& first_hit) {
        return first_hit(lamp, normalize(point - lamp)) < length(lamp - point);
      },
      "a ray from the lamp");
  mistake(
      [](Vec3 point, Vec3 normal, Vec3 lamp, const FirstHit& first_hit) {
        return first_hit(point + 0.001 * normal, normalize(lamp - point)) > 0;
      },
      "true everywhere");
  mistake([](Vec3 point, Vec3 normal, Vec3 lamp,
             const FirstHit&) { return dot(normal, normalize(lamp - point)) <= 0; },
          "behind the surface");
  mistake(start_3::in_shadow, "never true");
}

TEST_CASE("the questions of chapter 01 have the answers of its page") {
  check_answer("01.a", 40);
  check_answer("01.b", std::acos(0.375) * 180 / pi);
}
