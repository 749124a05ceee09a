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
      "whole level alone");
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

TEST_CASE("09.1: more columns that students compute") {
  check_mistake(
      "09.1",
      +[](int column, int width) { return column < 0 ? width - -column % width : column % width; },
      "not where the column is");
  check_mistake(
      "09.1", +[](int column, int width) { return column % width + width; }, "to every rest");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        const int rest = column % width;
        return rest < 0 ? width + rest - 1 : rest;
      },
      "no more and no less");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        const int rest = column % width;
        return rest < 0 ? rest + width + 1 : rest;
      },
      "no more and no less");
  check_mistake(
      "09.1", +[](int column, int width) { return column % (width - 1); }, "width - 1");
  check_mistake(
      "09.1",
      +[](int column, int width) { return (column % (width + 1) + width + 1) % (width + 1); },
      "width + 1");
  check_mistake(
      "09.1", +[](int column, int width) { return column % (width + 1); }, "width + 1");
  check_mistake(
      "09.1", +[](int column, int width) { return width % column; }, "write column % width");
  check_mistake(
      "09.1", +[](int column, int width) { return column / width; }, "which copy");
  check_mistake(
      "09.1", +[](int column, int width) { return column & (width - 1); }, "& is right");
  check_mistake(
      "09.1", +[](int column, int width) { return (column + width) % width; },
      "one width is not enough");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        if (column < 0) column = column + width;
        return column % width;
      },
      "one width is not enough");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        if (column < 0) return width + column;
        return column > width ? column - width : column;
      },
      "one width is not enough");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        while (column < 0) column += width;
        while (column > width) column -= width;
        return column;
      },
      "column >= width");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        while (column >= width) column -= width;
        return column;
      },
      "left of the picture stay");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        while (column < 0) column += width;
        return column;
      },
      "right of the picture stay");
  check_mistake(
      "09.1",
      +[](int column, int width) {
        if (column < 0 || column >= width) return 0;
        return column;
      },
      "always column 0");
}

TEST_CASE("09.2: more weights that students compute") {
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width;
        return std::array<double, 2>{x - std::floor(x), 1 - x + std::floor(x)};
      },
      "half a texel is missing");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = (u - 0.5) * width;
        const double right = x - std::floor(x);
        return std::array<double, 2>{1 - right, right};
      },
      "subtracted from u");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * (width - 1) - 0.5;
        const double right = x - std::floor(x);
        return std::array<double, 2>{1 - right, right};
      },
      "width - 1");
  check_mistake(
      "09.2",
      +[](double u, int) {
        const double x = u - 0.5;
        const double right = x - std::floor(x);
        return std::array<double, 2>{1 - right, right};
      },
      "multiply it by width");
  check_mistake(
      "09.2",
      +[](double u, int) {
        const double x = u;
        const double right = x;
        return std::array<double, 2>{1 - right, right};
      },
      "multiply it by width");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const int x = static_cast<int>(u * width - 0.5);
        const double right = x - std::floor(x);
        return std::array<double, 2>{1 - right, right};
      },
      "must be a double");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double right = std::abs(x - static_cast<int>(x));
        return std::array<double, 2>{1 - right, right};
      },
      "loses its sign");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double right = std::abs(x - std::round(x));
        return std::array<double, 2>{1 - right, right};
      },
      "nearest center");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double right = x - std::round(x);
        return std::array<double, 2>{1 - right, right};
      },
      "nearest center");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double right = std::ceil(x) - x;
        return std::array<double, 2>{1 - right, right};
      },
      "std::ceil");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double right = x;
        return std::array<double, 2>{1 - right, right};
      },
      "a place and no part");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double right = std::floor(x);
        return std::array<double, 2>{1 - right, right};
      },
      "a place and no part");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double right = x - std::floor(x);
        return std::array<double, 2>{right, right};
      },
      "both weights are the same");
  check_mistake(
      "09.2",
      +[](double u, int width) {
        const double x = u * width - 0.5;
        const double left = 1 - x + std::floor(x);
        return std::array<double, 2>{left, left};
      },
      "both weights are the same");
}

TEST_CASE("09.3: more levels that students compute") {
  check_mistake(
      "09.3",
      +[](double width) {
        int scaled = static_cast<int>(std::max(width, 1.0));
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + (scaled * scaled - 1) / 3.0;
      },
      "not int");
  check_mistake(
      "09.3", +[](double width) { return std::log(width); }, "natural");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::min(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + (scaled * scaled - 1) / 3;
      },
      "std::min");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return (scaled * scaled - 1) / 3;
      },
      "f alone");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level - 1 + (scaled * scaled - 1) / 3;
      },
      "one too low");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + (scaled - 1) / 3;
      },
      "square of the width");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = width;
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + (scaled - 1) / 3;
      },
      "square of the width");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + scaled * scaled - 1;
      },
      "divide by 3");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + (scaled * scaled - 1) / 2;
      },
      "another number");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + scaled * scaled / 3;
      },
      "not reduced by 1");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + scaled * scaled - 1.0 / 3;
      },
      "before -");
  check_mistake(
      "09.3",
      +[](double width) {
        const int third = 1 / 3;
        double scaled = width;
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + scaled * scaled - third;
      },
      "before -");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + (1 - scaled * scaled) / 3;
      },
      "f is 0 or more");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level - (scaled * scaled - 1) / 3;
      },
      "f is 0 or more");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level * (scaled * scaled - 1) / 3;
      },
      "not multiplied");
  check_mistake(
      "09.3",
      +[](double width) {
        double scaled = std::max(width, 1.0);
        int level = 0;
        while (scaled >= 2) {
          scaled = scaled / 2;
          level++;
        }
        return level + (width * width - 1) / 3;
      },
      "whole width");
  check_mistake(
      "09.3",
      +[](double width) {
        const double l = std::floor(std::log2(std::max(width, 1.0)));
        const double scaled = width / (2 * l);
        return l + (scaled * scaled - 1) / 3;
      },
      "not 2 * l");
  check_mistake(
      "09.3",
      +[](double width) {
        const int l = static_cast<int>(std::log2(std::max(width, 1.0)));
        const double scaled = std::max(width, 1.0) / (2 ^ l);
        return l + (scaled * scaled - 1) / 3;
      },
      "no power");
  check_mistake(
      "09.3",
      +[](double width) {
        width = std::max(width, 1.0);
        const double l = std::ceil(std::log2(width));
        const double scaled = width / std::exp2(l);
        return l + (scaled * scaled - 1) / 3;
      },
      "by std::floor");
  check_mistake(
      "09.3",
      +[](double width) {
        width = std::max(width, 1.0);
        const double l = std::round(std::log2(width));
        const double scaled = width / std::exp2(l);
        return l + (scaled * scaled - 1) / 3;
      },
      "by std::floor");
}

TEST_CASE("the questions of chapter 09 have the answers of its page") {
  check_answer("09.a", 188);
  check_answer("09.b", 1398101);
}
