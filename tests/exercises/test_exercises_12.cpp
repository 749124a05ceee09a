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

TEST_CASE("the questions of chapter 12 have the answers of its page") {
  check_answer("12.a", 600);
  check_answer("12.b", 122);
}
