// The exercises of chapter 03: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"
#include "texture/image_texture.hpp"

namespace start_1 {
#include "starts/03_1.hpp"
}
namespace solution_1 {
#include "exercises/03_1.hpp"
}
namespace start_2 {
#include "starts/03_2.hpp"
}
namespace solution_2 {
#include "exercises/03_2.hpp"
}
namespace start_3 {
#include "starts/03_3.hpp"
}
namespace solution_3 {
#include "exercises/03_3.hpp"
}

using namespace texmap::test;

TEST_CASE("03.1: which column") {
  check_start("03.1", start_1::column_of);
  check_solution("03.1", solution_1::column_of);

  const auto mistake = [](int (*function)(double, int), const char* text) {
    check_mistake("03.1", function, text);
  };
  mistake([](double u, int width) { return static_cast<int>((width - 1) * u); }, "width - 1");
  mistake(
      [](double u, int width) {
        return std::max(0, std::min(width - 1, static_cast<int>((width - 1) * u)));
      },
      "width - 1");
  mistake([](double u,
             int width) { return std::clamp(static_cast<int>(u * width + 0.5), 0, width - 1); },
          "half a texel");
  mistake(
      [](double u, int width) {
        const double x = std::floor(u * width) + 1;
        return std::clamp(static_cast<int>(x), 0, width - 1);
      },
      "numbered from 0");
  mistake(
      [](double u, int width) {
        const int column = static_cast<int>(width * u);
        return std::clamp(width - 1 - column, 0, width - 1);
      },
      "mirrored");
  mistake([](double u, int width) { return static_cast<int>(width * u); }, "nothing limits");
  mistake(
      [](double u, int width) {
        const int column = static_cast<int>(width * u);
        return column >= width ? width - 1 : column;
      },
      "less than 0");
  mistake(
      [](double u, int width) {
        const int column = static_cast<int>(width * u);
        return column < 0 ? 0 : column;
      },
      "at u = 1");
}

TEST_CASE("03.1: wrong numbers and wrong ends") {
  const auto mistake = [](int (*function)(double, int), const char* text) {
    check_mistake("03.1", function, text);
  };
  mistake([](double u, int width) { return static_cast<int>(u) * width; }, "too early");
  mistake([](double u, int width) { return std::clamp(width * static_cast<int>(u), 0, width - 1); },
          "too early");
  mistake([](double u, int width) { return static_cast<int>(u * width + 0.5); }, "half a texel");
  mistake([](double u, int width) { return static_cast<int>(std::lround(u * (width - 1))); },
          "width - 1");
  mistake(
      [](double u, int width) { return std::clamp(static_cast<int>(u * width) - 1, 0, width - 1); },
      "too far left");
  mistake([](double u, int width) { return static_cast<int>(std::ceil(u * width)); }, "std::ceil");
  mistake(
      [](double u, int width) {
        return std::min(std::max(static_cast<int>((1 - u) * width), 0), width - 1);
      },
      "mirrored");
  mistake([](double u, int width) { return static_cast<int>(u / width); }, "multiply u by width");
  mistake([](double u, int width) { return std::clamp(static_cast<int>(u * width), 0, width); },
          "at u = 1");
  mistake([](double u, int width) { return std::min(static_cast<int>(u * width), width); },
          "at u = 1");
  mistake(
      [](double u, int width) {
        const int column = static_cast<int>(u * width);
        return column > width ? width - 1 : column < 0 ? 0 : column;
      },
      "at u = 1");
  mistake([](double u, int width) { return static_cast<int>(u * width) % width; }, "other end");
  mistake(
      [](double u, int width) { return std::clamp(static_cast<int>(u * width) % width, 0, width); },
      "other end");
  mistake(
      [](double u, int width) {
        const int column = static_cast<int>(u * width);
        return column == width ? width - 1 : column;
      },
      "above 1 goes on");
  mistake([](double u,
             int width) { return std::min(std::abs(static_cast<int>(u * width)), width - 1); },
          "std::abs");
  mistake([](double u,
             int width) { return std::max(std::min(static_cast<int>(u * width), 0), width - 1); },
          "not std::max");
}

TEST_CASE("03.2: which row") {
  check_start("03.2", start_2::row_of);
  check_solution("03.2", solution_2::row_of);
  // As the textbook has it. It differs where v is on the edge of a row, and is right, too.
  check_solution(
      "03.2", +[](double v, int height) {
        return std::min(static_cast<int>((1 - std::clamp(v, 0.0, 1.0)) * height), height - 1);
      });

  const auto mistake = [](int (*function)(double, int), const char* text) {
    check_mistake("03.2", function, text);
  };
  mistake(
      [](double v, int height) {
        const int row = static_cast<int>(height * v);
        return row < 0 ? 0 : row >= height ? height - 1 : row;
      },
      "upside down");
  mistake([](double v, int height) { return static_cast<int>(height * v); }, "upside down");
  mistake(
      [](double v, int height) {
        const int row = static_cast<int>((height - 1) * std::clamp(v, 0.0, 1.0));
        return height - 1 - row;
      },
      "height - 1: now");
  mistake([](double v, int height) { return height - static_cast<int>(height * v); },
          "one too far down");
  mistake(
      [](double v, int height) {
        const int row = height - 1 - static_cast<int>(std::lround(height * v));
        return std::clamp(row, 0, height - 1);
      },
      "half a texel");
  mistake([](double v, int height) { return height - 1 - static_cast<int>(height * v); },
          "nothing limits");
  mistake(
      [](double v, int height) {
        const int row = height - 1 - static_cast<int>(height * v);
        return row < 0 ? 0 : row;
      },
      "more than height - 1");
}

TEST_CASE("03.2: wrong numbers and wrong ends") {
  const auto mistake = [](int (*function)(double, int), const char* text) {
    check_mistake("03.2", function, text);
  };
  mistake(
      [](double v, int height) {
        return std::clamp(height - static_cast<int>(v * height), 0, height - 1);
      },
      "you forgot the - 1");
  mistake(
      [](double v, int height) {
        return height - std::clamp(static_cast<int>(v * height), 0, height - 1);
      },
      "you forgot the - 1");
  mistake([](double v, int height) { return static_cast<int>((1 - v) * (height - 1)); },
          "not by height - 1");
  mistake(
      [](double v, int height) {
        return std::clamp(static_cast<int>((1 - v) * height + 0.5), 0, height - 1);
      },
      "half a texel");
  mistake(
      [](double v, int height) {
        return std::clamp(height - 1 - static_cast<int>(std::ceil(v * height)), 0, height - 1);
      },
      "too far up");
  mistake([](double v, int height) { return static_cast<int>((1 - v) * height) - 1; },
          "too far up");
  mistake([](double v, int height) { return height - 1 - static_cast<int>(v) * height; },
          "too early");
  mistake([](double v, int height) { return static_cast<int>(1 - v) * height; }, "too early");
  mistake(
      [](double v, int height) { return std::clamp(static_cast<int>(1 - v * height), 0, height); },
      "(1 - v) * height");
  mistake([](double v, int height) { return static_cast<int>((1 - v) * height); },
          "at v = 0 it is height");
  mistake(
      [](double v, int height) {
        return std::min(height - 1 - static_cast<int>(v * height), height - 1);
      },
      "less than 0");
  mistake([](double v,
             int height) { return std::clamp(static_cast<int>((1 - v) * height), 0, height); },
          "more than height - 1");
  mistake([](double v, int height) { return height - 1 - static_cast<int>(v * height) % height; },
          "other end");
  mistake(
      [](double v, int height) { return v == 1.0 ? 0 : height - 1 - static_cast<int>(v * height); },
      "you have v = 1");
}

static texmap::Image two_by_one() {
  texmap::Image image(2, 1, {1, 2, 3});
  image.at(1, 0) = {4, 5, 6};
  return image;
}

TEST_CASE("03.3: the color of a texel") {
  check_start("03.3", start_3::color_of);
  check_solution("03.3", solution_3::color_of);
  const texmap::ImageTexture texture{two_by_one()};
  CHECK(solution_3::color_of(Bytes(texture.image), 2, 1, 0).g == texture(Uv{0.75, 0.5}).g);

  const auto mistake = [](Color (*function)(const Bytes&, int, int, int), const char* text) {
    check_mistake("03.3", function, text);
  };
  mistake(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = (column + width * row) * 3;
        return Color{bytes[i + 2] / 255.0, bytes[i + 1] / 255.0, bytes[i] / 255.0};
      },
      "red and blue are exchanged");
  mistake(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = (column + width * row) * 3;
        return Color{bytes[i] / 256.0, bytes[i + 1] / 256.0, bytes[i + 2] / 256.0};
      },
      "256");
  mistake(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = (column + width * row) * 3;
        return Color{1.0 * bytes[i], 1.0 * bytes[i + 1], 1.0 * bytes[i + 2]};
      },
      "from 0 to 1");
  mistake(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = (column + width * row) * 3;
        const int r = bytes[i] / 255;
        const int g = bytes[i + 1] / 255;
        const int b = bytes[i + 2] / 255;
        return Color{1.0 * r, 1.0 * g, 1.0 * b};
      },
      "without decimals");
  mistake(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = column + width * row;
        return Color{bytes[i] / 255.0, bytes[i + 1] / 255.0, bytes[i + 2] / 255.0};
      },
      "you count texels");
  mistake(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = width * row + column * 3;
        return Color{bytes[i] / 255.0, bytes[i + 1] / 255.0, bytes[i + 2] / 255.0};
      },
      "only the column");
  mistake(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = (row + width * column) * 3;
        return Color{bytes[i] / 255.0, bytes[i + 1] / 255.0, bytes[i + 2] / 255.0};
      },
      "column and row are exchanged");
}

TEST_CASE("03.3: wrong bytes") {
  static int (*number)(int, int, int) = nullptr;
  const auto mistake = [](int (*first)(int, int, int), const char* text) {
    number = first;
    check_mistake(
        "03.3",
        +[](const Bytes& bytes, int width, int column, int row) {
          const int i = number(width, column, row);
          return Color{bytes[i] / 255.0, bytes[i + 1] / 255.0, bytes[i + 2] / 255.0};
        },
        text);
    check_mistake(
        "03.3",
        +[](const Bytes& bytes, int width, int column, int row) {
          const int i = number(width, column, row);
          return Color{bytes[i] / 256.0, bytes[i + 1] / 256.0, bytes[i + 2] / 256.0};
        },
        text);
  };
  mistake([](int width, int column, int row) { return 3 * row * width + column; }, "only the row");
  mistake([](int width, int column, int row) { return width * row + 3 * column; },
          "only the column");
  mistake([](int, int column, int row) { return (row + column) * 3; }, "row whole rows, each");
  mistake([](int width, int column, int row) { return (row * (width - 1) + column) * 3; },
          "row whole rows, each");
  mistake([](int width, int column, int row) { return 3 * (row * width + column) + 1; },
          "one byte too late");
  mistake([](int width, int column, int row) { return 3 * (row * width + column) - 1; },
          "one byte too early");
  mistake([](int width, int column, int row) { return 3 * (row * width + column + 1); },
          "to the right");
  mistake([](int width, int column, int row) { return 3 * (row * width + column - 1); },
          "to the left");
  mistake([](int width, int column, int row) { return 3 * (width * (row - 1) + column); },
          "row above");
  mistake([](int width, int column, int row) { return 4 * (width * row + column); }, "not four");
  mistake([](int width, int column, int row) { return width * column + row; },
          "column and row are exchanged");
  const auto order = [](Color (*function)(const Bytes&, int, int, int), const char* text) {
    check_mistake("03.3", function, text);
  };
  order(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = 3 * (row * width + column);
        return Color{bytes[i + 1] / 255.0, bytes[i] / 255.0, bytes[i + 2] / 255.0};
      },
      "green comes after red");
  order(
      [](const Bytes& bytes, int width, int column, int row) {
        const double one = bytes[3 * (row * width + column)] / 255.0;
        return Color{one, one, one};
      },
      "the same byte");
  order(
      [](const Bytes& bytes, int width, int column, int row) {
        const int i = 3 * (row * width + column);
        return Color{bytes[i] / 255.0, bytes[i + 3] / 255.0, bytes[i + 6] / 255.0};
      },
      "follow each other");
}

TEST_CASE("a number beyond the bytes of a picture gives 0") {
  const texmap::Image image = two_by_one();
  const Bytes bytes(image);
  CHECK(bytes[0] == 1);
  CHECK(bytes[5] == 6);
  CHECK(bytes[6] == 0);
  CHECK(bytes[-1] == 0);
}

TEST_CASE("the questions of chapter 03 have the answers of its page") {
  check_answer("03.a", 1100);
  check_answer("03.b", 100.0 * 12644 / (2048 * 1024));
}
