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

TEST_CASE("06.1: more directions that students write") {
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return l - n * (2 * dot(n, l)); }, "points into");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return normalize(n * dot(n, l) - l); }, "counts once");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return n * (-2 * dot(n, l)) - l; }, "wrong sign: add it");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3) { return l; }, "you return l");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return n * (2 * dot(n, l)); }, "no more than");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return dot(n, l) * n; }, "no more than");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return l - dot(n, l) * n; }, "part of l along the surface");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return n * 2.0 - l; }, "shorter than n");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return n - l; }, "shorter than n");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return 2 * dot(n, n) * n - l; }, "shorter than n");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return 2 * dot(n, l) * (n - l); }, "alone: subtract");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return 2 * dot(n, l) * (n + l); }, "not a sum");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return normalize(n + l); }, "other side of n");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return normalize((l + n) / 2); }, "other side of n");
  check_mistake(
      "06.1",
      +[](Vec3 l, Vec3) {
        return Vec3{-l.x, l.y, -l.z};
      },
      "n = +y at most");
  check_mistake(
      "06.1",
      +[](Vec3 l, Vec3) {
        return Vec3{-l.x, l.y, l.z};
      },
      "n = +y at most");
  check_mistake(
      "06.1", +[](Vec3 l, Vec3 n) { return normalize(n * (2 * dot(n, l)) + l); }, "longer than 1");
}

TEST_CASE("06.2: more highlights that students write") {
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = l - 2 * dot(n, l) * n;
        return std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "wrong sign");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = d - 2 * dot(n, d) * n;
        return std::pow(std::max(dot(r, -l), 0.0), shininess);
      },
      "wrong sign");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, to_lamp) * n - l;
        return std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "normalize");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - to_lamp;
        return std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "normalize");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::max(std::pow(dot(r, -d), shininess), 0.0);
      },
      "not limited");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::pow(std::abs(dot(r, d)), shininess);
      },
      "std::abs");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::pow(std::min(dot(r, -d), 0.0), shininess);
      },
      "std::min keeps");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::pow(std::max(dot(r, -d), 1.0), shininess);
      },
      "not to 1");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        return std::pow(std::max(dot(n, l), 0.0), shininess);
      },
      "diffuse light");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        return std::pow(std::max(dot(l, -d), 0.0), shininess);
      },
      "not mirrored");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        return std::pow(std::max(dot(n, -d), 0.0), shininess);
      },
      "between n and the eye");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        const Vec3 h = normalize(l - d);
        return std::pow(std::max(dot(n, h), 0.0), shininess);
      },
      "Blinn");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        return std::pow(std::max(dot(dot(n, l) * n - l, -d), 0.0), shininess);
      },
      "counts once");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        return std::pow(std::max(dot(2 * dot(n, l) * l - n, -d), 0.0), shininess);
      },
      "exchanged in r");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        return std::pow(std::max(dot(2 * dot(n, l) * n + l, -d), 0.0), shininess);
      },
      "added in r");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        return std::pow(std::max(dot(2 * dot(n, l) * n, -d), 0.0), shininess);
      },
      "l is missing in r");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        return std::pow(std::max(dot(2 * n - l, -d), 0.0), shininess);
      },
      "n . l is missing in r");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::pow(shininess, std::max(dot(r, -d), 0.0));
      },
      "base and exponent");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::max(dot(r, -d), 0.0);
      },
      "this is the cosine");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::pow(std::acos(std::max(dot(r, -d), 0.0)), shininess);
      },
      "the angle");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return 0.3 * std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "0.3");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        const double c = std::max(dot(n, l), 0.0);
        const Vec3 r = 2 * c * n - l;
        return std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "not enough");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, d) > 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "where the eye is");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, d) < 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "where the eye is");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) > 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "wrong way around");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        if (dot(n, l) <= 0) return 0.0;
        const Vec3 r = 2 * dot(n, l) * n - l;
        return dot(n, l) * std::pow(std::max(dot(r, -d), 0.0), shininess);
      },
      "factor of the diffuse");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 l = normalize(to_lamp);
        const Vec3 r = 2 * dot(n, l) * n - l;
        return std::max(dot(r, -d), 0.0) * shininess;
      },
      "std::pow");
  check_mistake(
      "06.2",
      +[](Vec3 n, Vec3 to_lamp, Vec3 d, double shininess) {
        const Vec3 r = 2 * dot(n, to_lamp) * n - to_lamp;
        return std::pow(dot(r, d), shininess);
      },
      "wrong sign");
}

TEST_CASE("06.3: more blends that students write") {
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::max(light, 1.0);
        return texture * t + Color{x, x, x} * (1 - t);
      },
      "std::max");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::fmod(light, 1.0);
        return texture * t + Color{x, x, x} * (1 - t);
      },
      "begin again");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        if (light > 1) light = 0;
        return texture * t + Color{light, light, light} * (1 - t);
      },
      "not as 0");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light * (1 - t), 1.0);
        return texture * t + Color{x, x, x};
      },
      "light alone");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = light * (1 - t);
        return Color{std::min(texture.r * t + x, 1.0), std::min(texture.g * t + x, 1.0),
                     std::min(texture.b * t + x, 1.0)};
      },
      "light alone");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture * (x * (1 - t));
      },
      "a blend is a sum");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture * t + texture * (x * (1 - t));
      },
      "a blend is a sum");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture * t * x + Color{x, x, x} * (1 - t);
      },
      "a blend is a sum");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture + Color{x, x, x} * (1 - t);
      },
      "texture has no share");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return (texture + Color{x, x, x}) * t;
      },
      "same share");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return (texture + Color{x, x, x}) * (1 - t);
      },
      "same share");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double) {
        const double x = std::min(light, 1.0);
        return (texture + Color{x, x, x}) * 0.5;
      },
      "share 1/2");
  check_mistake(
      "06.3", +[](Color texture, double, double t) { return texture * t; }, "light is missing");
  check_mistake(
      "06.3",
      +[](Color, double light, double t) {
        const double x = std::min(light, 1.0);
        return Color{x, x, x} * (1 - t);
      },
      "texture is missing");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture * t + Color{1 - x, 1 - x, 1 - x};
      },
      "not 1 minus");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture * t + Color{x, x, x} * (1 - x);
      },
      "by 1 minus the light");
  check_mistake(
      "06.3",
      +[](Color texture, double, double t) {
        return texture * t + Color{1 - t, 1 - t, 1 - t};
      },
      "share 1");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture * t + Color{x, x, x} * (t - 1);
      },
      "negative share");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        const double x = std::min(light, 1.0);
        return texture * t + Color{x} * (1 - t);
      },
      "three equal parts");
  check_mistake(
      "06.3",
      +[](Color texture, double light, double t) {
        return texture + Color{light, light, light} * (1 - t);
      },
      "texture has no share");
}

TEST_CASE("the questions of chapter 06 have the answers of its page") {
  check_answer("06.a", 698.0 / 75);
  check_answer("06.b", 60);
}
