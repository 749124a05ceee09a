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
      "random samples");
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

TEST_CASE("the questions of chapter 07 have the answers of its page") {
  check_answer("07.a", 137);
  check_answer("07.b", 0);
}
