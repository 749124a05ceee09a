// The exercises of chapter 07: each fails as shipped, its solution passes, each known mistake gets
// its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/07_1.hpp"
}
namespace solution_1 {
#include "exercises/07_1.hpp"
}
namespace start_2 {
#include "starts/07_2.hpp"
}
namespace solution_2 {
#include "exercises/07_2.hpp"
}
namespace start_3 {
#include "starts/07_3.hpp"
}
namespace solution_3 {
#include "exercises/07_3.hpp"
}

using namespace texmap::test;

TEST_CASE("07.1: average light, not bytes") {
  check_start("07.1", start_1::mean_byte);
  check_solution("07.1", solution_1::mean_byte);

  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += byte;
        return static_cast<int>(sum / static_cast<double>(bytes.size()) + 0.5);
      },
      "mean of the bytes");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) {
          const int cut = byte / 255;
          sum += srgb_decode(1.0 * cut);
        }
        return static_cast<int>(255 * srgb_encode(sum / static_cast<double>(bytes.size())) + 0.5);
      },
      "255.0");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        return static_cast<int>(255 * sum / static_cast<double>(bytes.size()) + 0.5);
      },
      "encode it");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_encode(byte / 255.0);
        return static_cast<int>(255 * srgb_decode(sum / static_cast<double>(bytes.size())) + 0.5);
      },
      "exchanged");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += byte;
        return static_cast<int>(255 * srgb_encode(sum / 255 / static_cast<double>(bytes.size())) +
                                0.5);
      },
      "not decoded");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        return static_cast<int>(255 * srgb_encode(sum / static_cast<double>(bytes.size())));
      },
      "cut off");
  check_unknown(
      "07.1", +[](const std::vector<int>& bytes) { return 255 - bytes.back(); });
}

TEST_CASE("07.2: more light from above") {
  check_start("07.2", start_2::scattered);
  check_solution("07.2", solution_2::scattered);

  check_mistake(
      "07.2",
      +[](double a, double b) {
        return Vec3{a * std::cos(2 * pi * b), a * std::sin(2 * pi * b), std::sqrt(1 - a * a)};
      },
      "radius is a");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        return Vec3{std::sqrt(a) * std::cos(pi * b), std::sqrt(a) * std::sin(pi * b),
                    std::sqrt(1 - a)};
      },
      "half of the disk");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        return Vec3{std::sqrt(a) * std::cos(b), std::sqrt(a) * std::sin(b), std::sqrt(1 - a)};
      },
      "radians");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        return Vec3{std::sqrt(a) * std::cos(360 * b), std::sqrt(a) * std::sin(360 * b),
                    std::sqrt(1 - a)};
      },
      "degrees");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        return Vec3{std::sqrt(a) * std::cos(2 * pi * b), std::sqrt(a) * std::sin(2 * pi * b),
                    1 - a};
      },
      "needs a root");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        return Vec3{std::sqrt(a) * std::cos(2 * pi * b), std::sqrt(a) * std::sin(2 * pi * b),
                    1 - std::sqrt(a)};
      },
      "below the hemisphere");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        return Vec3{std::sqrt(a) * std::cos(2 * pi * b), std::sqrt(a) * std::sin(2 * pi * b), 0};
      },
      "on the disk");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double z = 1 - a;
        return Vec3{std::sqrt(1 - z * z) * std::cos(2 * pi * b),
                    std::sqrt(1 - z * z) * std::sin(2 * pi * b), z};
      },
      "equally likely");
  check_unknown(
      "07.2", +[](double a, double b) {
        return Vec3{b, 0, a};
      });
}

TEST_CASE("07.3: one sample in each cell") {
  check_start("07.3", start_3::place_of_sample);
  check_solution("07.3", solution_3::place_of_sample);

  check_mistake(
      "07.3",
      +[](int i, int n, double, double) {
        const int row = i / n;
        return Uv{(i % n) * 1.0 / n, row * 1.0 / n};
      },
      "at its corner");
  check_mistake(
      "07.3",
      +[](int i, int n, double, double) {
        const int row = i / n;
        return Uv{(i % n) * 1.0 / n + 0.5 / n, row * 1.0 / n + 0.5 / n};
      },
      "stripes");
  check_mistake(
      "07.3",
      +[](int, int, double a, double b) {
        return Uv{a, b};
      },
      "without cells");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int row = i / n;
        return Uv{(row + a) / n, (i % n + b) / n};
      },
      "rows are exchanged");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int row = i / n;
        return Uv{(i % n + a) / n / n, (row + b) / n / n};
      },
      "n x n");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const double row = 1.0 * i / n;
        return Uv{(i % n + a) / n, (row + b) / n};
      },
      "no whole number");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int row = i / n;
        return Uv{(i + a) / n, (row + b) / n};
      },
      "remainder");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int row = i / n;
        return Uv{1.0 * (i % n) / n + a, 1.0 * row / n + b};
      },
      "leave their cells");
  check_unknown(
      "07.3", +[](int i, int n, double a, double b) {
        return Uv{b * n, a * i};
      });
}

TEST_CASE("07.1: more means that students compute") {
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        int sum = 0;
        for (const int byte : bytes) sum = static_cast<int>(sum + srgb_decode(byte / 255.0));
        const double mean = 1.0 * sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(255 * srgb_encode(mean)));
      },
      "add in a double");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(255.999 * srgb_encode(mean));
      },
      "cut off");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(256 * srgb_encode(mean));
      },
      "cut off");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(256 * srgb_encode(mean)));
      },
      "not 256");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 256.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(255 * srgb_encode(mean)));
      },
      "not 256");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(srgb_encode(mean)));
      },
      "multiply it by 255");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(srgb_encode(mean));
      },
      "multiply it by 255");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(mean));
      },
      "multiply it by 255");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        return static_cast<int>(std::lround(255 * srgb_encode(sum)));
      },
      "no mean");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        return static_cast<int>(
            std::lround(255 * srgb_encode(sum) / static_cast<double>(bytes.size())));
      },
      "before it is divided");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(255 * srgb_decode(mean)));
      },
      "mean again");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte / 255.0);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(mean * 255);
      },
      "encode it");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        int sum = 0;
        for (const int byte : bytes) sum += byte;
        return sum;
      },
      "no mean");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += byte;
        return static_cast<int>(
            std::lround(255 * srgb_decode(sum / 255 / static_cast<double>(bytes.size()))));
      },
      "mean of the bytes is decoded");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += byte;
        return static_cast<int>(std::lround(
            255 * srgb_encode(srgb_decode(sum / 255 / static_cast<double>(bytes.size())))));
      },
      "mean of the bytes, not");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(1.0 * byte);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(255 * srgb_encode(mean)));
      },
      "from 0 to 1: give");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(1.0 * byte);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(srgb_encode(mean)));
      },
      "from 0 to 1: give");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += srgb_decode(byte);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(255 * srgb_encode(mean)));
      },
      "from 0 to 1: give");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += std::pow(byte / 255.0, 2.2);
        const double mean = sum / static_cast<double>(bytes.size());
        return static_cast<int>(std::lround(255 * std::pow(mean, 1 / 2.2)));
      },
      "power");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (const int byte : bytes) sum += byte * byte;
        return static_cast<int>(std::lround(std::sqrt(sum / static_cast<double>(bytes.size()))));
      },
      "power");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        double sum = 0;
        for (std::size_t i = 1; i < bytes.size(); i++) sum += srgb_decode(bytes[i] / 255.0);
        return static_cast<int>(
            std::lround(255 * srgb_encode(sum / static_cast<double>(bytes.size()))));
      },
      "missing in the sum");
}

TEST_CASE("07.2: more directions that students make") {
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = a;
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), 1 - r};
      },
      "radius is a:");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = a * a;
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "radius is a a");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(1 - a);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "radius is sqrt(1 - a)");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), 1 - r * r};
      },
      "half of the disk");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b * 180 / pi;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "into degrees");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b * pi / 180;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "in radians already");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = -2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "other way");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), -r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "other way");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{std::cos(w), std::sin(w), std::sqrt(1 - r * r)};
      },
      "edge of the disk");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r)};
      },
      "length is not 1");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - a * a)};
      },
      "length is not 1");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), 1};
      },
      "length is not 1");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), r};
      },
      "length is not 1");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double x = std::sqrt(a) * std::cos(2 * pi * b);
        return Vec3{x, std::sqrt(a) * std::sin(2 * pi * b), std::sqrt(1 - x * x)};
      },
      "length is not 1");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return normalize(Vec3{r * std::cos(w), r * std::sin(w), 1});
      },
      "move x and y");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), -std::sqrt(1 - r * r)};
      },
      "not negative");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double z = 1 - 2 * a;
        const double r = std::sqrt(1 - z * z);
        return Vec3{r * std::cos(2 * pi * b), r * std::sin(2 * pi * b), z};
      },
      "all sides");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(b);
        const double w = 2 * pi * a;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "a and b are exchanged");
  check_mistake(
      "07.2",
      +[](double a, double) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * a;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "a makes the radius and the angle");
  check_mistake(
      "07.2",
      +[](double, double b) {
        const double r = std::sqrt(b);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), r * std::sin(w), std::sqrt(1 - r * r)};
      },
      "b makes the radius and the angle");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{r * std::sin(w), r * std::cos(w), std::sqrt(1 - r * r)};
      },
      "cos and sin are exchanged");
  check_mistake(
      "07.2",
      +[](double a, double b) {
        const double r = std::sqrt(a);
        const double w = 2 * pi * b;
        return Vec3{r * std::cos(w), std::sqrt(1 - a), r * std::sin(w)};
      },
      "not y");
}

TEST_CASE("07.3: more places that students compute") {
  check_mistake(
      "07.3",
      +[](int i, int n, double, double) {
        const int column = i % n;
        const int row = i / n;
        return Uv{1.0 * column / n, 1.0 * row / n};
      },
      "at its corner");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int cell = i % n / n;
        return Uv{cell + a, cell + b};
      },
      "column / n is 0");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int cell = i % n / n;
        return Uv{cell + a / n, cell + b / n};
      },
      "first cell");
  check_mistake(
      "07.3",
      +[](int, int n, double a, double b) {
        return Uv{a / n, b / n};
      },
      "first cell");
  check_mistake(
      "07.3",
      +[](int i, int n, double, double) {
        const int column = i % n / n;
        const int row = i / n / n;
        return Uv{1.0 * column, 1.0 * row};
      },
      "then divide");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column + b) / n, (row + a) / n};
      },
      "a is across");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column + a) / n, (row + a) / n};
      },
      "across and up");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(row + b) / n, (column + a) / n};
      },
      "u and v are exchanged");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column + a) / (n - 1), (row + b) / (n - 1)};
      },
      "not by n - 1");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column + a) / (n + 1), (row + b) / (n + 1)};
      },
      "not by n + 1");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{column + a, row + b};
      },
      "these are cells");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{column + a / n, row + b / n};
      },
      "before the sum");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{column * a / n, row * b / n};
      },
      "are factors");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column + a - 0.5) / n, (row + b - 0.5) / n};
      },
      "1/2");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column + 0.5 + a) / n, (row + 0.5 + b) / n};
      },
      "1/2");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column + a) / n, 1 - (row + b) / n};
      },
      "upside down");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column + a) / n, (n - 1 - row + b) / n};
      },
      "upside down");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = i % n;
        const int row = i / n;
        return Uv{(column - 1 + a) / n, (row - 1 + b) / n};
      },
      "without 1");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int column = (i + 1) % n;
        const int row = (i + 1) / n;
        return Uv{(column + a) / n, (row + b) / n};
      },
      "without 1");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        return Uv{(i % n + a) / n, (i % n + b) / n};
      },
      "without the rest");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int row = i / n;
        return Uv{(row + a) / n, (row + b) / n};
      },
      "i / n is the row");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        return Uv{(i % n + a) / n, (i + b) / n};
      },
      "not rows");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        return Uv{(i + a) / n, (i + b) / n};
      },
      "i counts samples: the column");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        return Uv{(i % n + a) / n, b};
      },
      "v is random");
  check_mistake(
      "07.3",
      +[](int i, int n, double a, double b) {
        const int row = i / n;
        return Uv{a, (row + b) / n};
      },
      "u is random");
}

TEST_CASE("the questions of chapter 07 have the answers of its page") {
  check_answer("07.a", 137);
  check_answer("07.b", 0);
}
