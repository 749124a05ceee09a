// The exercises of chapter 11: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/11_1.hpp"
}
namespace solution_1 {
#include "exercises/11_1.hpp"
}
namespace start_2 {
#include "starts/11_2.hpp"
}
namespace solution_2 {
#include "exercises/11_2.hpp"
}
namespace start_3 {
#include "starts/11_3.hpp"
}
namespace solution_3 {
#include "exercises/11_3.hpp"
}

using namespace texmap::test;

TEST_CASE("11.1: the normal of a bump") {
  check_start("11.1", start_1::bump_normal);
  check_solution("11.1", solution_1::bump_normal);

  check_mistake(
      "11.1",
      +[](double here, double right, double up, double step) {
        return normalize(Vec3{right - here, up - here, step});
      },
      "leans uphill: bumps");
  check_mistake(
      "11.1",
      +[](double here, double right, double up, double step) {
        return Vec3{(here - right) / step, (here - up) / step, 1};
      },
      "not a unit vector: the light");
  check_mistake(
      "11.1",
      +[](double here, double right, double up, double step) {
        return Vec3{(right - here) / step, (up - here) / step, 1};
      },
      "uphill, and it is not");
  check_mistake(
      "11.1",
      +[](double here, double right, double up, double step) {
        return normalize(Vec3{here - right, here - up, -step});
      },
      "away from the light");
  check_mistake(
      "11.1",
      +[](double here, double right, double up, double step) {
        return cross(normalize(Vec3{0, step, up - here}), Vec3{step, 0, right - here}) *
               (1 /
                length(cross(normalize(Vec3{0, step, up - here}), Vec3{step, 0, right - here})));
      },
      "all three numbers");
  check_mistake(
      "11.1",
      +[](double here, double right, double up, double step) {
        return normalize(Vec3{here - right, up - here, step});
      },
      "wrong side along y");
  check_mistake(
      "11.1",
      +[](double here, double right, double up, double step) {
        return normalize(Vec3{here - up, here - right, step});
      },
      "exchanged");
  check_mistake(
      "11.1",
      +[](double here, double right, double up, double) {
        return normalize(Vec3{here - right, here - up, 1});
      },
      "nearly flat");
  check_mistake(
      "11.1",
      +[](double here, double right, double up, double) {
        return normalize(Vec3{right - here, up - here, 1});
      },
      "and subtract");
  check_unknown(
      "11.1", +[](double, double, double, double) {
        return Vec3{0, 0, 1};
      });
}

TEST_CASE("11.2: a normal from three bytes") {
  check_start("11.2", start_2::normal_of_texel);
  check_solution("11.2", solution_2::normal_of_texel);

  check_mistake(
      "11.2",
      +[](int red, int green, int blue) {
        return Vec3{red / 255., green / 255., blue / 255.};
      },
      "never point left");
  check_mistake(
      "11.2",
      +[](int red, int green, int blue) {
        return Vec3{red / 255 * 2. - 1, green / 255 * 2. - 1, blue / 255 * 2. - 1};
      },
      "whole numbers");
  check_mistake(
      "11.2",
      +[](int red, int green, int blue) {
        return Vec3{blue / 127.5 - 1, green / 127.5 - 1, red / 127.5 - 1};
      },
      "BGR");
  check_mistake(
      "11.2",
      +[](int red, int green, int blue) {
        return Vec3{red / 127.5 - 1, 1 - green / 127.5, blue / 127.5 - 1};
      },
      "green points down");
  check_mistake(
      "11.2",
      +[](int red, int green, int blue) {
        return Vec3{red / 256. * 2 - 1, green / 256. * 2 - 1, blue / 256. * 2 - 1};
      },
      "not / 256");
  check_mistake(
      "11.2",
      +[](int red, int green, int blue) {
        return Vec3{red / 127. - 128 / 127., green / 127. - 128 / 127., blue / 127. - 128 / 127.};
      },
      "127.5");
  check_mistake(
      "11.2",
      +[](int red, int green, int blue) {
        const Vec3 n = solution_2::normal_of_texel(red, green, blue);
        return n * (1 / length(n));
      },
      "as they are");
  check_unknown(
      "11.2", +[](int, int, int) {
        return Vec3{0, 0, 1};
      });
}

TEST_CASE("11.3: the bitangent of a mirrored copy") {
  check_start("11.3", start_3::bitangent_of);
  check_solution("11.3", solution_3::bitangent_of);

  check_mistake(
      "11.3",
      +[](Vec3 n, Vec3 t, double) {
        return Vec3{n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x};
      },
      "on the mirrored copy bumps");
  check_mistake(
      "11.3", +[](Vec3 n, Vec3 t, double sign) { return cross(n, t) * -sign; }, "Everywhere");
  check_mistake(
      "11.3", +[](Vec3 n, Vec3 t, double) { return cross(t, n); }, "only the mirrored copy");
  check_mistake(
      "11.3",
      +[](Vec3, Vec3, double) {
        return Vec3{0, 1, 0};
      },
      "+y");
  check_mistake(
      "11.3",
      +[](Vec3, Vec3, double sign) {
        return Vec3{0, 1, 0} * sign;
      },
      "+y");
  check_unknown(
      "11.3", +[](Vec3 n, Vec3, double) { return n; });
}

TEST_CASE("the questions of chapter 11 have the answers of its page") {
  check_answer("11.a", 14.04);
  check_answer("11.b", 0.32);
}
