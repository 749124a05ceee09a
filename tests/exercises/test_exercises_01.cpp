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

TEST_CASE("the questions of chapter 01 have the answers of its page") {
  check_answer("01.a", 40);
  check_answer("01.b", std::acos(0.375) * 180 / pi);
}
