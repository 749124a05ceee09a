// The exercises of chapter 09: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include <cstdlib>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/09_1.hpp"
}
namespace solution_1 {
#include "exercises/09_1.hpp"
}
namespace start_2 {
#include "starts/09_2.hpp"
}
namespace solution_2 {
#include "exercises/09_2.hpp"
}
namespace start_3 {
#include "starts/09_3.hpp"
}
namespace solution_3 {
#include "exercises/09_3.hpp"
}

using namespace texmap::test;

TEST_CASE("09.1: the picture again and again") {
  check_start("09.1", start_1::repeated_column);
  check_solution("09.1", solution_1::repeated_column);

  check_mistake(
      "09.1", +[](int column, int width) { return column - column / width * width; }, "below 0");
  check_mistake(
      "09.1", +[](int column, int width) { return column < 0 ? -column % width : column % width; },
      "mirrored");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        const int rest = column - column / width * width;
        return rest > 0 ? rest : rest + width;
      },
      "0 must stay 0");
  check_mistake(
      "09.1",
      +[](int column, int width) { return ((column % (width - 1)) + width - 1) % (width - 1); },
      "width - 1");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        if (column < 0) return column + width;
        if (column >= width) return column - width;
        return column;
      },
      "one width is not enough");
  check_mistake(
      "09.1", +[](int column, int width) { return std::min(std::max(0, column), width - 1); },
      "clamp");
  check_unknown(
      "09.1", +[](int, int width) { return width - 1; });
}

TEST_CASE("09.2: mix two texels") {
  check_start("09.2", start_2::weights_of);
  check_solution("09.2", solution_2::weights_of);

  using Weights = std::array<double, 2>;
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        return Weights{x - std::floor(x), std::floor(x) + 1 - x};
      },
      "exchanged");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double right = std::fmod(u * width, 1.0);
        return Weights{1 - right, right};
      },
      "half a texel");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - u;
        return Weights{std::floor(x) + 1 - x, x - std::floor(x)};
      },
      "width - 1");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        return x - std::floor(x) < 0.5 ? Weights{1, 0} : Weights{0, 1};
      },
      "nearest");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double right = x - static_cast<int>(x);
        return Weights{1 - right, right};
      },
      "std::floor");
  check_mistake(
      "09.2",
      +[](double, int) {
        return Weights{0.5, 0.5};
      },
      "1/2 everywhere");
  check_unknown(
      "09.2", +[](double u, int) {
        return Weights{u, u};
      });
}

TEST_CASE("09.3: which level") {
  check_start("09.3", start_3::level_of_width);
  check_solution("09.3", solution_3::level_of_width);

  check_mistake(
      "09.3", +[](double width) { return width < 1 ? 0 : std::log(width) / std::log(2.0); },
      "logarithm log2");
  check_mistake(
      "09.3", +[](double width) { return std::log2(width); }, "below 1");
  check_mistake(
      "09.3",
      +[](double width) {
        int level = 0;
        while (width >= 2) {
          width = width * 0.5;
          ++level;
        }
        return level + (width * width - 1) / 3;
      },
      "below 1");
  check_mistake(
      "09.3", +[](double width) { return width > 1 ? std::log(width) : 0; }, "natural");
  check_mistake(
      "09.3",
      +[](double width) {
        int level = 0;
        for (double w = width; w >= 2; w /= 2) ++level;
        return static_cast<double>(level);
      },
      "steps");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        double level = 1;
        while (scaled >= 2) {
          scaled /= 2;
          level += 1;
        }
        return level + (scaled * scaled - 1) / 3;
      },
      "too high");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        double level = 0;
        for (; scaled >= 2; scaled /= 2) level += 1;
        return level + scaled - 1;
      },
      "square of the width");
  check_mistake(
      "09.3",
      +[](double width) {
        const double w = std::max(width, 1.0);
        double size = 1, level = 0;
        for (; 2 * size <= w; size *= 2) level += 1;
        return level + (w * w / size - 1) / 3;
      },
      "before you divide");
  check_unknown(
      "09.3", +[](double width) { return width; });
}

TEST_CASE("the questions of chapter 09 have the answers of its page") {
  check_answer("09.a", 188);
  check_answer("09.b", 1398101);
}
