// The exercises of chapter 06: each fails as shipped, its solution passes, each known mistake gets
// its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/06_1.hpp"
}
namespace solution_1 {
#include "exercises/06_1.hpp"
}
namespace start_2 {
#include "starts/06_2.hpp"
}
namespace solution_2 {
#include "exercises/06_2.hpp"
}
namespace start_3 {
#include "starts/06_3.hpp"
}
namespace solution_3 {
#include "exercises/06_3.hpp"
}

using namespace texmap::test;

TEST_CASE("06.1: the mirrored direction") {
  check_start("06.1", start_1::mirrored);
  check_solution("06.1", solution_1::mirrored);

  check_mistake(
      "06.1",
      +[](Vec3 l, Vec3 n) {
        const double c = l.x * n.x + l.y * n.y + l.z * n.z;
        return l - n * (2 * c);
      },
      "points into the surface");
  check_mistake(
      "06.1",
      +[](Vec3 l, Vec3 n) {
        const double c = l.x * n.x + l.y * n.y + l.z * n.z;
        return n * c - l;
      },
      "counts once");
  check_mistake(
      "06.1",
      +[](Vec3 l, Vec3 n) {
        const double c = l.x * n.x + l.y * n.y + l.z * n.z;
        return l * (2 * c) - n;
      },
      "exchanged");
  check_mistake(
      "06.1",
      +[](Vec3 l, Vec3 n) {
        const double c = l.x * n.x + l.y * n.y + l.z * n.z;
        return l + n * c * 2.0;
      },
      "longer than 1");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3) { return l * -1.0; }, "opposite of l");
  check_unknown(
      "06.1", +[](Vec3 l, Vec3 n) { return cross(l, n); });
}

TEST_CASE("06.2: the highlight") {
  check_start("06.2", start_2::highlight);
  check_solution("06.2", solution_2::highlight);

  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = to_lamp * (1 / length(to_lamp));
        const Vec3 r = n * 2.0 * dot(n, l) - l;
        return dot(n, l) > 0 ? std::pow(std::max(0.0, dot(r, d)), shininess) : 0;
      },
      "wrong sign");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = to_lamp * (1 / length(to_lamp));
        const Vec3 r = n * 2.0 * dot(n, l) - l;
        return std::pow(dot(r, d), shininess);
      },
      "wrong sign");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 r = n * 2.0 * dot(n, to_lamp) - to_lamp;
        return dot(n, to_lamp) > 0 ? std::pow(std::max(0.0, -dot(r, d)), shininess) : 0;
      },
      "normalize");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = to_lamp * (1 / length(to_lamp));
        const Vec3 r = n * 2.0 * dot(n, l) - l;
        return dot(n, l) > 0 ? std::pow(-dot(r, d), shininess) : 0;
      },
      "not limited");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = to_lamp * (1 / length(to_lamp));
        const Vec3 r = n * 2.0 * dot(n, l) - l;
        return std::pow(std::max(0.0, -dot(r, d)), shininess);
      },
      "behind the surface");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = to_lamp * (1 / length(to_lamp));
        const Vec3 r = n * 2.0 * dot(n, l) - l;
        return dot(n, l) > 0 ? std::max(0.0, -dot(r, d)) * shininess : 0;
      },
      "std::pow");
  check_unknown(
      "06.2", +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        return dot(n, to_lamp) + dot(n, d) * shininess;
      });
}

TEST_CASE("06.3: the blend") {
  check_start("06.3", start_3::blended);
  check_solution("06.3", solution_3::blended);

  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture * (1 - t) + Color{x, x, x} * t;
      },
      "shares are exchanged");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        return texture * (1 - t) + Color{light, light, light} * t;
      },
      "shares are exchanged");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        return Color{texture.r * t + light * (1 - t), texture.g * t + light * (1 - t),
                     texture.b * t + light * (1 - t)};
      },
      "not limited");
  check_mistake(
      "06.3", +[](Color texture, double light, double) { return texture * std::min(light, 1.0); },
      "a blend is a sum");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double) {
        return Color{texture.r + light, texture.g + light, texture.b + light};
      },
      "added whole");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        return Color{light, light, light} + texture * t;
      },
      "1 - t");
  check_unknown(
      "06.3", +[](Color texture, double light, double t) {
        return Color{texture.g, light, t};
      });
}

TEST_CASE("the questions of chapter 06 have the answers of its page") {
  check_answer("06.a", 698.0 / 75);
  check_answer("06.b", 60);
}
