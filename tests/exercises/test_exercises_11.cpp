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
      "11.3", +[](Vec3 n, Vec3, double) { return n * 7.0; });
}

TEST_CASE("11.1: more normals that students compute") {
  const auto named = [](Vec3 (*mistaken)(double, double, double, double), const char* text) {
    check_mistake("11.1", mistaken, text);
  };
  using D = double;
  named(
      [](D here, D right, D up, D step) {
        return Vec3{right - here, up - here, step};
      },
      "uphill, and it is not");
  named(
      [](D here, D right, D up, D step) {
        return Vec3{here - right, here - up, step};
      },
      "divide it by its length");
  named(
      [](D here, D right, D up, D step) {
        const Vec3 n{(here - right) / step, (here - up) / step, 1};
        return n / (n.x * n.x + n.y * n.y + n.z * n.z);
      },
      "not by its square");
  named(
      [](D here, D right, D up, D step) {
        return Vec3{right - here, up - here, -step} / step;
      },
      "all three numbers");
  named(
      [](D here, D right, D up, D step) {
        return Vec3{(here - right) / step, (up - here) / step, 1};
      },
      "along y");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{(right - here) / step, (here - up) / step, 1});
      },
      "along x");
  named(
      [](D here, D right, D up, D step) {
        return Vec3{(right - here) / step, (here - up) / step, 1};
      },
      "along x");
  named(
      [](D here, D right, D up, D) {
        return Vec3{here - right, here - up, 1};
      },
      "and make the length 1");
  named(
      [](D here, D right, D up, D) {
        return Vec3{right - here, up - here, 1};
      },
      "and subtract the gradient");
  named(
      [](D here, D right, D up, D step) {
        const D x = (here - right) / step;
        const D y = (here - up) / step;
        return Vec3{x, y, std::sqrt(1 - (x * x + y * y))};
      },
      "no root");
  named(
      [](D here, D right, D up, D step) {
        const D x = (here - right) / step;
        const D y = (here - up) / step;
        return normalize(Vec3{x, y, std::sqrt(1 - (x * x + y * y))});
      },
      "no root");
  named(
      [](D here, D right, D, D step) {
        return normalize(Vec3{step, 0, right - here});
      },
      "along the surface");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{step, 0, right - here} + Vec3{0, step, up - here});
      },
      "along the surface");
  named(
      [](D here, D right, D up, D step) {
        return cross(Vec3{step, 0, right - here}, Vec3{0, step, up - here});
      },
      "divide it by its length");
  named(
      [](D here, D right, D up, D step) {
        return cross(Vec3{0, step, up - here}, Vec3{step, 0, right - here});
      },
      "not up x right");
}

TEST_CASE("11.1: more slopes that students compute") {
  const auto named = [](Vec3 (*mistaken)(double, double, double, double), const char* text) {
    check_mistake("11.1", mistaken, text);
  };
  using D = double;
  named(
      [](D, D right, D up, D step) {
        return normalize(Vec3{-right, -up, step});
      },
      "here is missing");
  named(
      [](D, D right, D up, D step) {
        return Vec3{right / step, up / step, 1};
      },
      "here is missing");
  named([](D, D right, D up, D) { return normalize(Vec3{-right, -up, 1}); }, "here is missing");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{-(right - here / step), -(up - here / step), 1});
      },
      "comes before");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{here - right / step, here - up / step, 1});
      },
      "comes before");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{(here - right) * step, (here - up) * step, 1});
      },
      "you multiply");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{-step / (right - here), -step / (up - here), 1});
      },
      "not the step by the difference");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{here - right, here - up, 2 * step});
      },
      "not two");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{-std::abs(right - here) / step, -std::abs(up - here) / step, 1});
      },
      "has a sign");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{std::atan2(here - right, step), std::atan2(here - up, step), 1});
      },
      "angle of the slope");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{here - right, right - up, step});
      },
      "compares up with right");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{up - right, here - up, step});
      },
      "compares right with up");
  named(
      [](D here, D right, D, D step) {
        return normalize(Vec3{here - right, here - right, step});
      },
      "both slopes");
  named(
      [](D here, D right, D, D step) {
        return normalize(Vec3{here - right, 0, step});
      },
      "upward is missing");
  named(
      [](D here, D, D up, D step) {
        return normalize(Vec3{0, here - up, step});
      },
      "to the right is missing");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{-(right - here) / step, -(up - here), 1});
      },
      "only that to the right");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{up - here, right - here, step});
      },
      "exchanged");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{here - right, step, here - up});
      },
      "not y");
  named(
      [](D here, D right, D up, D) {
        return normalize(Vec3{here - right, here - up, 0});
      },
      "the third number is missing");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{-(right - here) / step, -(up - here) / step, step});
      },
      "not the step again");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{-(right - here) / step, -(up - here) / step, 1 + here});
      },
      "for a ball");
  named(
      [](D here, D right, D up, D step) {
        return normalize(Vec3{-(right - here) / step, -(up - here) / step, here});
      },
      "only its slopes");
}

TEST_CASE("11.2: more numbers that students compute") {
  const auto named = [](double (*channel)(int), const char* text) {
    // A student writes the same line three times.
    static double (*same)(int);
    same = channel;
    check_mistake(
        "11.2",
        +[](int red, int green, int blue) {
          return Vec3{same(red), same(green), same(blue)};
        },
        text);
  };
  named([](int c) { return 2 * ((c + 0.5) / 256) - 1; }, "and 255 exactly 1");
  named([](int c) { return 2. * (c / 255) - 1; }, "divide whole numbers");
  named([](int c) { return 2 * c / 255 - 1.; }, "divide whole numbers");
  named([](int c) -> double { return c / 255; }, "divide whole numbers");
  named([](int c) -> double { return c / 128 - 1; }, "divide whole numbers");
  named([](int c) -> double { return (c - 128) / 127; }, "divide whole numbers");
  named([](int c) -> double { return (c - 128) / 128; }, "divide whole numbers");
  named([](int c) -> double { return (c - 127) / 128; }, "divide whole numbers");
  named([](int c) -> double { return c / 127 - 1; }, "divide whole numbers");
  named([](int c) { return (c - 128) / 128.0; }, "not / 256");
  named([](int c) { return (c - 128) / 127.5; }, "you begin at 128");
  named([](int c) { return (c - 127) / 128.0; }, "subtract 127.5");
  named([](int c) { return (c - 127) / 127.5; }, "subtract 127.5");
  named([](int c) { return (c - 127) / 127.0; }, "subtract 127.5");
  named([](int c) { return (c - 127.5) / 128; }, "and 255 exactly 1");
  named([](int c) { return (c - 127.5) / 127; }, "subtract 127.5");
  named([](int c) { return c / 127.5; }, "from 0 to 2");
  named([](int c) { return (c - 255) / 255.; }, "from -1 to 0");
  named([](int c) { return (c - 127.5) / 255; }, "from -1/2 to 1/2");
  named([](int c) { return (c / 255. - 1) * 2; }, "from -2 to 0");
  named([](int c) { return c / 127.5 - 0.5; }, "from -1/2 to 3/2");
  named([](int c) { return c / 127.5 + 1; }, "from 1 to 3");
  named([](int c) { return 1 - 2 * (c / 255.); }, "not 1 - 2c");
  named([](int c) { return (1 + c / 255.) / 2; }, "this goes back");
  named([](int c) { return c * 2 - 1 / 255.; }, "comes before -");
  named([](int c) { return (c * 2 - 1) / 255.; }, "comes before -");
  named([](int c) -> double { return c; }, "these are bytes");
  named([](int c) { return c * 2 - 1.; }, "these are bytes");
  named([](int c) { return c - 127.5; }, "then divide by 127.5");
  named([](int c) -> double { return c - 128; }, "then divide by 127.5");
  named([](int c) { return std::clamp(2 * c / 255. - 1, 0., 1.); }, "do not limit them");
  named([](int c) { return std::fabs(2 * c / 255. - 1); }, "keep their sign");
  named([](int c) { return srgb_decode(c / 255.) * 2 - 1; }, "not colors");
}

TEST_CASE("11.2: more normals that students read") {
  const auto named = [](Vec3 (*mistaken)(int, int, int), const char* text) {
    check_mistake("11.2", mistaken, text);
  };
  static constexpr auto part = [](int byte) { return byte / 127.5 - 1; };
  named(
      [](int red, int green, int blue) {
        return normalize(Vec3{(red - 128) / 128., (green - 128) / 128., (blue - 128) / 128.});
      },
      "127.5, not 128");
  named(
      [](int red, int green, int blue) {
        return normalize(Vec3{red - 127.5, green - 127.5, blue - 127.5});
      },
      "as they are");
  named(
      [](int red, int green, int blue) {
        return normalize(Vec3{1. * red, 1. * green, 1. * blue});
      },
      "never point left");
  named(
      [](int red, int green, int blue) {
        return normalize(Vec3{part(red), part(255 - green), part(blue)});
      },
      "green points down");
  named(
      [](int red, int green, int blue) {
        return Vec3{-part(red), part(green), part(blue)};
      },
      "red points left");
  named(
      [](int red, int green, int blue) {
        return Vec3{part(red), part(blue), part(green)};
      },
      "z from blue: yours are exchanged");
  named(
      [](int red, int green, int blue) {
        return Vec3{part(green), part(red), part(blue)};
      },
      "y from green: yours are exchanged");
  named([](int red, int, int) { return Vec3{part(red), part(red), part(red)}; }, "all three");
  named(
      [](int red, int green, int) {
        return Vec3{part(red), part(green), part(green)};
      },
      "yours comes from green");
  named(
      [](int red, int, int blue) {
        return Vec3{part(red), part(red), part(blue)};
      },
      "yours comes from red");
  named(
      [](int red, int green, int blue) {
        return Vec3{part(red), part(green), blue / 255.};
      },
      "blue means 2c - 1");
  named(
      [](int red, int green, int blue) {
        return Vec3{part(red), part(green), blue / 127.5};
      },
      "blue means 2c - 1");
  named(
      [](int red, int green, int) {
        const double x = part(red);
        const double y = part(green);
        return Vec3{x, y, std::sqrt(1 - x * x - y * y)};
      },
      "z is in the file");
  named(
      [](int red, int green, int) {
        const double x = part(red);
        const double y = part(green);
        return Vec3{x, y, std::sqrt(std::max(0., 1 - x * x - y * y))};
      },
      "z is in the file");
  named(
      [](int red, int green, int) {
        return Vec3{part(red), part(green), 1};
      },
      "z is in the file");
  named(
      [](int red, int green, int blue) {
        return Vec3{part(red), part(green), std::fmax(0, part(blue))};
      },
      "do not limit z");
}

/// The sign turns one coordinate alone.
template <double Vec3::*coordinate>
Vec3 bitangent_with_sign_of(Vec3 n, Vec3 t, double sign) {
  Vec3 b = cross(n, t);
  b.*coordinate *= sign;
  return b;
}

TEST_CASE("11.3: more bitangents that students compute") {
  const auto named = [](Vec3 (*mistaken)(Vec3, Vec3, double), const char* text) {
    check_mistake("11.3", mistaken, text);
  };
  named(bitangent_with_sign_of<&Vec3::x>, "turns one alone");
  named(bitangent_with_sign_of<&Vec3::y>, "turns one alone");
  named(bitangent_with_sign_of<&Vec3::z>, "turns one alone");
  named([](Vec3 n, Vec3 t, double sign) { return cross(n * sign, t * sign); },
        "on the mirrored copy bumps");
  named([](Vec3 n, Vec3 t, double sign) { return cross(n, t) * std::abs(sign); },
        "on the mirrored copy bumps");
  named([](Vec3 n, Vec3 t, double sign) { return sign < 0 ? cross(n, t) : cross(t, n); },
        "Everywhere");
  named([](Vec3 n, Vec3 t, double) { return -cross(n, t); }, "only the mirrored copy");
  named(
      [](Vec3 n, Vec3 t, double sign) {
        return sign > 0 ? cross(n, t) : Vec3{0, 0, 0};
      },
      "B is (0, 0, 0)");
  named(
      [](Vec3 n, Vec3 t, double sign) {
        const Vec3 b = cross(n, t) * sign;
        if (b.y < 0) return -b;
        return b;
      },
      "need not grow upward");
  named(
      [](Vec3 n, Vec3 t, double) {
        Vec3 b = cross(n, t);
        b.y = std::fabs(b.y);
        return b;
      },
      "need not grow upward");
  named([](Vec3 n, Vec3 t, double) { return t.x < 0 ? cross(t, n) : cross(n, t); },
        "T alone does not say");
  named([](Vec3 n, Vec3 t, double sign) { return sign * (t + n); }, "at a right angle to both");
  named([](Vec3 n, Vec3 t, double sign) { return normalize(n + t) * sign; },
        "at a right angle to both");
  named([](Vec3 n, Vec3 t, double) { return n - t; }, "at a right angle to both");
  named([](Vec3 n, Vec3 t, double sign) { return (t - n) * sign; }, "at a right angle to both");
  named([](Vec3, Vec3 t, double sign) { return t * sign; }, "this is T");
  named([](Vec3 n, Vec3, double sign) { return n * sign; }, "this is n");
  named([](Vec3 n, Vec3, double sign) { return cross(Vec3{0, 1, 0}, n) * sign; }, "not +y");
  named([](Vec3 n, Vec3, double) { return cross(n, cross(Vec3{0, 1, 0}, n)); }, "not +y");
  named([](Vec3 n, Vec3, double) { return normalize(cross(n, Vec3{0, 1, 0})); }, "not +y");
  named(
      [](Vec3, Vec3 t, double sign) {
        return cross(Vec3{0, 0, 1}, t) * sign;
      },
      "without an axis");
  named([](Vec3, Vec3 t, double sign) { return Vec3{-t.y, t.x, 0} * sign; }, "without an axis");
  named([](Vec3, Vec3 t, double) { return Vec3{t.y, -t.x, 0}; }, "without an axis");
  named([](Vec3, Vec3 t, double) { return cross(t, Vec3{0, 1, 0}); }, "without an axis");
  named([](Vec3, Vec3 t, double) { return cross(Vec3{0, 1, 0}, t); }, "without an axis");
  named([](Vec3 n, Vec3 t, double sign) { return dot(n, t) * sign * n; }, "no direction");
  named(
      [](Vec3 n, Vec3 t, double sign) {
        return Vec3{n.x * t.x, n.y * t.y, n.z * t.z} * sign;
      },
      "no cross product");
  named(
      [](Vec3 n, Vec3 t, double sign) {
        return Vec3{n.y * t.z, n.z * t.x, n.x * t.y} * sign;
      },
      "no cross product");
  named(
      [](Vec3 n, Vec3 t, double sign) {
        return Vec3{n.z * t.y + n.y * t.z, n.z * t.x + n.x * t.z, n.x * t.y + n.y * t.x} * sign;
      },
      "no cross product");
  named(
      [](Vec3 n, Vec3 t, double sign) {
        return Vec3{n.y * t.z - n.z * t.y, n.x * t.z - n.z * t.x, n.x * t.y - n.y * t.x} * sign;
      },
      "middle number");
}

TEST_CASE("the questions of chapter 11 have the answers of its page") {
  check_answer("11.a", 14.04);
  check_answer("11.b", 0.32);
}
