// The exercises of chapter 12: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/12_1.hpp"
}
namespace solution_1 {
#include "exercises/12_1.hpp"
}
namespace start_2 {
#include "starts/12_2.hpp"
}
namespace solution_2 {
#include "exercises/12_2.hpp"
}
namespace start_3 {
#include "starts/12_3.hpp"
}
namespace solution_3 {
#include "exercises/12_3.hpp"
}

using namespace texmap::test;

TEST_CASE("12.1: light from four bytes") {
  check_start("12.1", start_1::light_of_texel);
  check_solution("12.1", solution_1::light_of_texel);

  check_mistake(
      "12.1",
      +[](int red, int green, int blue, int exponent) {
        return solution_1::light_of_texel(red, green, blue, exponent + 8);
      },
      "256 times");
  check_mistake(
      "12.1",
      +[](int red, int green, int blue, int exponent) {
        return Color{red / 256., green / 256., blue / 256.} * std::pow(2, exponent - 128);
      },
      "half is missing");
  check_mistake(
      "12.1",
      +[](int red, int green, int blue, int exponent) {
        return Color{red + 0.5, green + 0.5, blue + 0.5} * std::pow(2, exponent - 136);
      },
      "must not be added");
  check_mistake(
      "12.1",
      +[](int red, int green, int blue, int exponent) {
        const Color light = solution_1::light_of_texel(red, green, blue, exponent);
        return Color{light.b, light.g, light.r};
      },
      "BGR");
  check_mistake(
      "12.1",
      +[](int red, int green, int blue, int) {
        return Color{1. * red, 1. * green, 1. * blue} * (1 / 255.);
      },
      "PNG");
  check_mistake(
      "12.1",
      +[](int red, int green, int blue, int exponent) {
        const int k = 2 ^ (exponent - 136);
        return Color{red == 0 ? 0 : (red + 0.5) * k, green == 0 ? 0 : (green + 0.5) * k,
                     blue == 0 ? 0 : (blue + 0.5) * k};
      },
      "no power");
  check_mistake(
      "12.1",
      +[](int red, int green, int blue, int exponent) {
        const int k = exponent - 136;
        return Color{red == 0 ? 0 : (red + 0.5) * k, green == 0 ? 0 : (green + 0.5) * k,
                     blue == 0 ? 0 : (blue + 0.5) * k};
      },
      "multiply by it");
  check_unknown(
      "12.1", +[](int, int, int, int) {
        return Color{1, 1, 1};
      });
}

TEST_CASE("12.2: how much of the sphere is a texel") {
  check_start("12.2", start_2::solid_angle);
  check_solution("12.2", solution_2::solid_angle);

  check_mistake(
      "12.2", +[](int, int width, int height) { return (2 * pi / width) * (pi / height); },
      "sine is missing");
  check_mistake(
      "12.2", +[](int, int width, int height) { return 4 * pi / (width * height); },
      "not on the sphere");
  check_mistake(
      "12.2",
      +[](int row, int width, int height) {
        const double middle = (2 * row + 1) * pi / (2 * height);
        return std::sin(middle) * (2 * pi / width) * (pi / height);
      },
      "in the middle");
  check_mistake(
      "12.2",
      +[](int row, int width, int height) {
        return std::sin(row * pi / height) * (2 * pi / width) * (pi / height);
      },
      "upper edge");
  check_mistake(
      "12.2",
      +[](int row, int width, int height) {
        return (std::cos(pi * (row + 1) / height) - std::cos(pi * row / height)) * 2 * pi / width;
      },
      "above 0");
  check_mistake(
      "12.2",
      +[](int row, int, int height) {
        return (std::cos(pi * row / height) - std::cos(pi * (row + 1) / height)) * 2 * pi;
      },
      "whole row");
  check_mistake(
      "12.2",
      +[](int row, int width, int height) {
        return (std::cos(row * 180. / height) - std::cos((row + 1) * 180. / height)) * 2 * pi /
               width;
      },
      "radians");
  check_mistake(
      "12.2",
      +[](int row, int width, int height) {
        const double turn = 2 * pi;
        return turn / width * (std::cos(turn * row / height) - std::cos(turn * (row + 1) / height));
      },
      "2 pi for both");
  check_unknown(
      "12.2", +[](int, int, int) { return 1.0; });
}

TEST_CASE("12.3: draw one of many") {
  check_start("12.3", start_3::drawn_thing);
  check_solution("12.3", solution_3::drawn_thing);

  using Sums = std::vector<double>;
  check_mistake(
      "12.3",
      +[](const Sums& sums, double r) {
        return static_cast<int>(std::floor(r * static_cast<double>(sums.size())));
      },
      "not used");
  check_mistake(
      "12.3",
      +[](const Sums& sums, double r) {
        int i = 0;
        for (const double sum : sums)
          if (r >= sum) ++i;
        return i;
      },
      "limit the index");
  check_mistake(
      "12.3",
      +[](const Sums& sums, double r) {
        return std::min(solution_3::drawn_thing(sums, r) + 1, static_cast<int>(sums.size()) - 1);
      },
      "too large");
  check_mistake(
      "12.3",
      +[](const Sums& sums, double r) {
        int i = 1;
        for (const double sum : sums)
          if (r >= sum) ++i;
        return i;
      },
      "too large");
  check_mistake(
      "12.3",
      +[](const Sums& sums, double r) { return std::max(0, solution_3::drawn_thing(sums, r) - 1); },
      "too small");
  check_mistake(
      "12.3",
      +[](const Sums& sums, double r) {
        int i = -1;
        for (const double sum : sums)
          if (r >= sum) ++i;
        return i;
      },
      "too small");
  check_mistake(
      "12.3",
      +[](const Sums& sums, double r) {
        int i = 0;
        for (const double sum : sums)
          if (r > sum && i + 1 < static_cast<int>(sums.size())) ++i;
        return i;
      },
      "probability 0 is drawn");
  check_mistake(
      "12.3",
      +[](const Sums& sums, double r) {
        int i = 0;
        for (const double sum : sums)
          if (r > sum) ++i;
        return i;
      },
      "and limit");
  check_unknown(
      "12.3", +[](const Sums&, double) { return 1; });
}

TEST_CASE("12.1: more lights that students compute") {
  const auto named = [](Color (*mistaken)(int, int, int, int), const char* text) {
    check_mistake("12.1", mistaken, text);
  };
  named(
      [](int red, int green, int blue, int exponent) {
        return Color{1. * red, 1. * green, 1. * blue} * std::exp2(exponent - 128);
      },
      "256 times");
  named(
      [](int red, int green, int blue, int exponent) {
        return Color{1 / 2 + 1. * red, 1 / 2 + 1. * green, 1 / 2 + 1. * blue} *
               std::exp2(exponent - 136);
      },
      "half is missing");
  named(
      [](int red, int green, int blue, int exponent) {
        const auto light = [&](int m) { return exponent == 0 ? 0 : m + 0.5; };
        return Color{light(red), light(green), light(blue)} * std::exp2(exponent - 136);
      },
      "must not be added");
  named(
      [](int red, int green, int blue, int exponent) {
        const double step = std::exp2(exponent - 136);
        return Color{red == 0 ? 0 : (red + 0.5) * step, (green + 0.5) * step, (blue + 0.5) * step};
      },
      "must not be added");
  named(
      [](int red, int green, int blue, int exponent) {
        const double step = std::exp2(exponent - 136);
        return Color{(red + 0.5) * step, green > 0 ? (green + 0.5) * step : 0,
                     blue > 0 ? (blue + 0.5) * step : 0};
      },
      "must not be added");
  named(
      [](int red, int green, int blue, int exponent) {
        if (red == 0 && green == 0 && blue == 0) return Color{0, 0, 0};
        return Color{red + 0.5, green + 0.5, blue + 0.5} * std::exp2(exponent - 136);
      },
      "must not be added");
  named(
      [](int red, int green, int blue, int exponent) {
        if (red * green * blue == 0) return Color{0, 0, 0};
        return Color{red + 0.5, green + 0.5, blue + 0.5} * std::exp2(exponent - 136);
      },
      "its own byte");
  named(
      [](int red, int green, int blue, int exponent) {
        if (red == 0) return Color{0, 0, 0};
        return Color{red + 0.5, green + 0.5, blue + 0.5} * std::exp2(exponent - 136);
      },
      "its own byte");
  named(
      [](int red, int green, int blue, int exponent) {
        if (red == 0) return Color{0, 0, 0};
        return solution_1::light_of_texel(red, green, blue, exponent);
      },
      "its own byte");
  named([](int red, int green, int,
           int exponent) { return solution_1::light_of_texel(red, green, green, exponent); },
        "line that was copied");
  named([](int red, int, int blue,
           int exponent) { return solution_1::light_of_texel(red, red, blue, exponent); },
        "line that was copied");
  named([](int red, int green, int,
           int exponent) { return solution_1::light_of_texel(red, green, red, exponent); },
        "line that was copied");
  named([](int red, int, int,
           int exponent) { return solution_1::light_of_texel(red, red, red, exponent); },
        "the texel is gray");
  named(
      [](int red, int green, int blue, int) {
        return Color{red / 255., green / 255., blue / 255.};
      },
      "PNG");
  named(
      [](int red, int green, int blue, int) {
        return Color{srgb_decode(red / 255.), srgb_decode(green / 255.), srgb_decode(blue / 255.)};
      },
      "and the bytes of this file are light");
}

TEST_CASE("12.1: more channels that students compute") {
  // A student writes the same line three times.
  const auto named = [](double (*channel)(int m, int k), const char* text) {
    static double (*same)(int, int);
    same = channel;
    check_mistake(
        "12.1",
        +[](int red, int green, int blue, int exponent) {
          return Color{same(red, exponent), same(green, exponent), same(blue, exponent)};
        },
        text);
  };
  named([](int m, int k) { return m > 0 ? (m + 0.5) / 255 * std::pow(2., k - 128) : 0; },
        "not 1 / 255");
  named([](int m, int k) { return m / 255. * std::pow(2., k - 128); }, "not 1 / 255");
  named([](int m, int k) { return m > 0 ? (m + 0.5) / 256 * std::exp2(k - 127) : 0; },
        "twice as bright");
  named([](int m, int k) { return m > 0 ? (m + 0.5) * std::exp2(k - 137) : 0; }, "half as bright");
  named([](int m, int k) { return m > 0 ? (m + 0.5) * std::exp2(136 - k) : 0; }, "wrong sign");
  named([](int m, int k) { return m > 0 ? (m + 0.5) / std::exp2(k - 136) : 0; }, "wrong sign");
  named([](int m, int k) { return m * std::exp2(136 - k); }, "wrong sign");
  named([](int m, int k) { return m > 0 ? (m + 0.5) * std::exp(k - 136) : 0; }, "power of e");
  named([](int m, int k) { return m > 0 ? (m + 0.5) * std::pow(10., k - 136) : 0; }, "power of 10");
  named([](int m, int k) { return m > 0 ? (m + 0.5) * std::pow(k - 136., 2.) : 0; }, "base first");
  named([](int m, int k) { return m > 0 ? (m + 0.5) * 2 * (k - 136) : 0; }, "2 * x is no power");
  named([](int m, int k) { return (m + 0.5) * (2 ^ (k - 136)); }, "compares bits");
  named([](int m, int k) { return (m + 0.5) * (1 << ((k - 136) & 31)); }, "1 << x");
  named([](int m, int k) { return m > 0 ? (m + 0.5) * (std::exp2(k) - 136) : 0; },
        "before the power");
  named([](int m, int k) { return m > 0 ? (m + 0.5) * std::exp2(k) - 136 : 0; },
        "before the power");
  named(
      [](int m, int k) {
        const int step = static_cast<int>(std::exp2(k - 136));
        return m > 0 ? (m + 0.5) * step : 0;
      },
      "0 as an int");
  named([](int m, int k) { return m > 0 ? (m + 0.5) / 256 * std::exp2(k - 136) : 0; },
        "8 bits of m in it already");
  named([](int m, int k) { return m / 255. * std::exp2(k - 136); }, "8 bits of m in it already");
  named([](int m, int k) { return m > 0 ? std::pow(m + 0.5, k - 136) : 0; }, "base of the power");
  named([](int m, int k) { return std::pow(m + 0.5, k - 136); }, "base of the power");
  named([](int m, int) { return m > 0 ? m + 0.5 : 0; }, "2 to the power");
  named([](int m, int) { return m > 0 ? (m + 0.5) / 256 : 0; }, "PNG");
  named([](int m, int k) { return m > 0 ? m * std::exp2(k - 136) + 0.5 : 0; }, "comes before +");
  named([](int m, int k) { return m + 0.5 * std::exp2(k - 136); }, "comes before +");
  named([](int m, int k) { return m > 0 ? m + 0.5 * std::exp2(k - 136) : 0; }, "comes before +");
  named([](int m, int k) { return m > 0 ? (m - 0.5) * std::exp2(k - 136) : 0; }, "it is m + 1/2");
  named([](int m, int k) { return m > 0 ? (m + 1) * std::exp2(k - 136) : 0; }, "it is m + 1/2");
  named([](int m, int k) { return std::fmin(1, m > 0 ? (m + 0.5) * std::exp2(k - 136) : 0); },
        "do not limit");
  named([](int m, int k) { return std::clamp(m * std::exp2(k - 136), 0., 1.); }, "do not limit");
  named([](int m,
           int k) { return 1. * static_cast<int>((m > 0 ? m + 0.5 : 0) * std::exp2(k - 136)); },
        "no whole number");
  named([](int m, int k) { return srgb_decode(m > 0 ? (m + 0.5) * std::exp2(k - 136) : 0); },
        "leave srgb_decode out");
  named([](int m, int k) { return srgb_encode(m > 0 ? (m + 0.5) * std::exp2(k - 136) : 0); },
        "leave srgb_encode out");
}

TEST_CASE("12.2: more angles that students compute") {
  const auto named = [](double (*mistaken)(int, int, int), const char* text) {
    check_mistake("12.2", mistaken, text);
  };
  using std::cos;
  using std::sin;
  named([](int row, int width,
           int height) { return sin(pi * (row + 0.5) / height) * 4 * pi / (width * height); },
        "in the middle");
  named([](int row, int width,
           int height) { return sin(pi * (row + 1 / 2) / height) * 2 * pi / width * pi / height; },
        "upper edge");
  named([](int row, int width,
           int height) { return sin(pi * (row + 1) / height) * 2 * pi / width * pi / height; },
        "the row's lower edge");
  named(
      [](int row, int width, int height) {
        const double a = sin(pi * row / height);
        const double b = sin(pi * (row + 1) / height);
        return 2 * pi / width * pi / height * 0.5 * (a + b);
      },
      "mean of two sines");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(180 * row / height) - cos(180 * (row + 1) / height));
      },
      "radians");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(pi / 2 * row / height) - cos(pi / 2 * (row + 1) / height));
      },
      "ends at the equator");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(row / height * pi) - cos((row + 1) / height * pi));
      },
      "whole numbers");
  named([](int row, int width,
           int height) { return 2 * pi / width * (cos(row / height) - cos((row + 1) / height)); },
        "whole numbers");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(1.0 * row / height) - cos(1.0 * (row + 1) / height));
      },
      "pi is missing");
  named([](int row, int width, int) { return 2 * pi / width * (cos(row) - cos(row + 1)); },
        "not row alone");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(pi * (row + 1) / height) - cos(pi * (row + 2) / height));
      },
      "too far down");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(pi * (row - 1) / height) - cos(pi * row / height));
      },
      "too far up");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(pi * (row - 0.5) / height) - cos(pi * (row + 0.5) / height));
      },
      "leave the half out");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(pi * (row + 0.5) / height) - cos(pi * (row + 1.5) / height));
      },
      "leave the half out");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(pi * row / (height - 1)) - cos(pi * (row + 1) / (height - 1)));
      },
      "not by height - 1");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(pi * row / height) - cos(pi * row / height));
      },
      "both edges are the same");
  named(
      [](int row, int width, int height) {
        return 2 * pi / width * (cos(pi * row / height) - cos(pi * (row - 1) / height));
      },
      "that of row - 1");
  named(
      [](int row, int width, int height) { return 2 * pi / width * (cos(pi * row / height) + 1); },
      "south pole");
}

TEST_CASE("12.2: brackets that students forget") {
  const auto named = [](double (*lower)(int, int), const char* text) {
    static double (*edge)(int, int);
    edge = lower;
    check_mistake(
        "12.2",
        +[](int row, int width, int height) {
          return 2 * pi / width * (std::cos(pi * row / height) - std::cos(edge(row, height)));
        },
        text);
  };
  named([](int row, int height) { return pi * row + 1 / height; }, "brackets");
  named([](int row, int height) { return pi * row + 1. / height; }, "brackets");
  named([](int row, int) { return pi * row + 1; }, "brackets");
  named([](int row, int height) { return (pi * row + 1) / height; }, "brackets");
  named([](int row, int height) { return pi * row / height + 1; }, "brackets");
  named([](int row, int height) { return (1. * row / height + 1) * pi; }, "brackets");
  named([](int row, int height) { return pi * (row + 1. / height); }, "brackets");
  named([](int row, int height) { return row + 1 * pi / height; }, "brackets");
}

TEST_CASE("12.2: more integrals and factors that students compute") {
  const auto named = [](double (*angle)(double a, double b, int width, int height),
                        const char* text) {
    static double (*of_edges)(double, double, int, int);
    of_edges = angle;
    check_mistake(
        "12.2",
        +[](int row, int width, int height) {
          return of_edges(pi * row / height, pi * (row + 1) / height, width, height);
        },
        text);
  };
  using std::cos;
  using std::sin;
  using D = double;
  named([](D a, D b, int w, int) { return 2 * pi / w * (cos(a) + cos(b)); }, "not added");
  named([](D a, D b, int w, int) { return 2 * pi / w * cos(a) * cos(b); }, "not multiplied");
  named([](D a, D b, int w, int) { return 2 * pi / w * cos(b - a); }, "cosine of a - b");
  named([](D a, D b, int w, int) { return 2 * pi / w * (1 - cos(b - a)); }, "cosine of a - b");
  named([](D a, D b, int w, int) { return 2 * pi / w * (sin(a) - sin(b)); }, "yours are sines");
  named([](D a, D b, int w, int) { return 2 * pi / w * (sin(b) - sin(a)); }, "yours are sines");
  named([](D a, D b, int w, int) { return 2 * pi / w * (cos(pi / 2 - a) - cos(pi / 2 - b)); },
        "yours are sines");
  named([](D, D b, int w, int) { return 2 * pi / w * (1 - cos(b)); }, "down to b");
  named([](D a, D, int w, int) { return 2 * pi / w * (1 - cos(a)); }, "down to a");
  named([](D a, D, int w, int) { return 2 * pi / w * cos(a); }, "cos b is missing");
  named([](D a, D b, int w, int) { return 2 * pi / w * cos(a) - cos(b); }, "comes before -");
  named([](D a, D b, int w, int) { return 2 * pi / w * (b - a); }, "sine is missing");
  named([](D a, D b, int, int) { return 2 * pi * (cos(b) - cos(a)); }, "whole row");
  named([](D a, D b, int w, int) { return pi / w * (cos(a) - cos(b)); }, "not pi:");
  named([](D a, D b, int w, int) { return 4 * pi / w * (cos(a) - cos(b)); }, "not 4 pi");
  named([](D a, D b, int w, int) { return (cos(a) - cos(b)) / w; }, "2 pi is missing");
  named([](D a, D b, int, int) { return cos(a) - cos(b); }, "multiply by 2 pi / width");
  named([](D a, D b, int w, int) { return 360. / w * (cos(a) - cos(b)); }, "not 360");
  named([](D a, D b, int w, int h) { return 2 * pi / w * pi / h * (cos(a) - cos(b)); },
        "the other height");
  named([](D a, D b, int w, int h) { return 2 * pi / (w * h) * (cos(a) - cos(b)); },
        "the other height");
  named([](D a, D b, int w, int h) { return 4 * pi / (w * h) * (cos(a) - cos(b)); },
        "the other height");
  named([](D a, D b, int w, int) { return 2 * pi * w * (cos(a) - cos(b)); }, "you multiply");
  named([](D a, D b, int, int h) { return 2 * pi / h * (cos(a) - cos(b)); },
        "divide by the height here");
  named([](D a, D b, int w, int h) { return 2 * pi / h * (cos(a * h / w) - cos(b * h / w)); },
        "width and height are exchanged");
  named([](D a, D b, int w, int h) { return 2 * pi / w * (cos(a * h / w) - cos(b * h / w)); },
        "you divide it by the width");
}

TEST_CASE("12.3: more things that students draw") {
  using Sums = std::vector<double>;
  const auto named = [](int (*mistaken)(const Sums&, double), const char* text) {
    check_mistake("12.3", mistaken, text);
  };
  static constexpr auto size_of = [](const Sums& sums) { return static_cast<int>(sums.size()); };
  named([](const Sums& sums, double r) { return static_cast<int>(r * (size_of(sums) - 1)); },
        "not used");
  named([](const Sums& sums,
           double r) { return static_cast<int>(std::lround(r * (size_of(sums) - 1))); },
        "not used");
  named(
      [](const Sums& sums, double r) {
        return static_cast<int>(std::upper_bound(sums.begin(), sums.end(), r) - sums.begin());
      },
      "limit the index");
  named(
      [](const Sums& sums, double r) {
        for (int i = 0; i < size_of(sums); ++i)
          if (r < sums[i]) return i;
        return -1;
      },
      "not -1");
  named(
      [](const Sums& sums, double r) {
        for (int i = 0; i < size_of(sums); ++i)
          if (r < sums[i]) return i;
        return 0;
      },
      "not the first");
  named(
      [](const Sums& sums, double r) {
        for (int i = 0; i < size_of(sums); ++i)
          if (sums[i] >= r) return i;
        return -1;
      },
      "and return the last");
  named(
      [](const Sums& sums, double r) {
        int i = 0;
        while (i < size_of(sums) - 1 && r < sums[i]) ++i;
        return i;
      },
      "turned around");
  named(
      [](const Sums& sums, double r) {
        for (int i = 0; i < size_of(sums); ++i)
          if (r > sums[i]) return i;
        return -1;
      },
      "turned around");
  named(
      [](const Sums& sums, double r) {
        for (int i = 0; i < size_of(sums); ++i)
          if (r == sums[i]) return i;
        return size_of(sums) - 1;
      },
      "hardly ever");
  named(
      [](const Sums& sums, double r) {
        int i = 1;
        while (i < size_of(sums) - 1 && r >= sums[i]) ++i;
        return i;
      },
      "thing 0 is never drawn");
  named(
      [](const Sums& sums, double r) {
        for (int i = 1; i < size_of(sums); ++i)
          if (sums[i - 1] <= r && r < sums[i]) return i;
        return size_of(sums) - 1;
      },
      "thing 0 is left out");
  named(
      [](const Sums& sums, double r) {
        if (r > 0 && r < sums[0]) return 0;
        for (int i = 1; i < size_of(sums); ++i)
          if (sums[i - 1] < r && r < sums[i]) return i;
        return size_of(sums) - 1;
      },
      "write >= there");
  named(
      [](const Sums& sums, double r) {
        double before = 0;
        for (int i = 0; i < size_of(sums); ++i) {
          if (r < sums[i] - before) return i;
          before = sums[i];
        }
        return size_of(sums) - 1;
      },
      "the probability of thing i alone");
  named(
      [](const Sums& sums, double r) {
        double sum = 0;
        for (int i = 0; i < size_of(sums); ++i) {
          sum += sums[i];
          if (r < sum) return i;
        }
        return size_of(sums) - 1;
      },
      "a sum already");
  named(
      [](const Sums& sums, double r) {
        for (int i = 0; i < size_of(sums); ++i) {
          if (r < sums[i]) return i;
          r -= sums[i];
        }
        return size_of(sums) - 1;
      },
      "a sum already");
  named(
      [](const Sums& sums, double r) {
        for (int i = 0; i < size_of(sums); ++i)
          if (1 - r < sums[i]) return i;
        return size_of(sums) - 1;
      },
      "1 - r");
}

TEST_CASE("12.3: searches that end elsewhere") {
  using Sums = std::vector<double>;
  const auto named = [](int (*mistaken)(const Sums&, double), const char* text) {
    check_mistake("12.3", mistaken, text);
  };
  static constexpr auto size_of = [](const Sums& sums) { return static_cast<int>(sums.size()); };
  named([](const Sums& sums, double r) { return solution_3::drawn_thing(sums, r) + 1; },
        "too large");
  named([](const Sums& sums, double r) { return solution_3::drawn_thing(sums, r) - 1; },
        "too small");
  named(
      [](const Sums& sums, double r) {
        int i = size_of(sums) - 1;
        while (i > 0 && r < sums[i]) --i;
        return i;
      },
      "too small");
  named(
      [](const Sums& sums, double r) {
        int i = 0;
        while (i < size_of(sums) - 2 && r >= sums[i]) ++i;
        return i;
      },
      "the last thing is never drawn");
  named(
      [](const Sums& sums, double r) {
        for (int i = size_of(sums) - 1; i >= 0; --i)
          if (r < sums[i]) return i;
        return size_of(sums) - 1;
      },
      "always draw the last");
  named([](const Sums&, double r) { return static_cast<int>(r); }, "always draw the first");
  named(
      [](const Sums& sums, double r) {
        for (int i = 0; i < size_of(sums); ++i)
          if (r >= sums[i]) return i;
        return 0;
      },
      "always draw the first");
  named(
      [](const Sums& sums, double r) {
        int found = 0;
        for (int i = 0; i < size_of(sums); ++i)
          if (r < sums[i]) found = i;
        return found;
      },
      "your search goes on");
  named(
      [](const Sums& sums, double r) {
        for (int i = size_of(sums) - 1; i >= 0; --i)
          if (r < sums[i]) return i;
        return -1;
      },
      "your search goes on");
  named(
      [](const Sums& sums, double r) {
        int count = 0;
        for (const double sum : sums)
          if (sum > r) ++count;
        return count;
      },
      "you count the sums");
  named(
      [](const Sums& sums, double r) {
        int best = 0;
        for (int i = 1; i < size_of(sums); ++i)
          if (std::fabs(sums[i] - r) < std::fabs(sums[best] - r)) best = i;
        return best;
      },
      "nearest to r");
}

TEST_CASE("the questions of chapter 12 have the answers of its page") {
  check_answer("12.a", 600);
  check_answer("12.b", 122);
}
