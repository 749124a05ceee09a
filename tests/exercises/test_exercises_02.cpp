// The exercises of chapter 02: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/02_1.hpp"
}
namespace solution_1 {
#include "exercises/02_1.hpp"
}
namespace start_2 {
#include "starts/02_2.hpp"
}
namespace solution_2 {
#include "exercises/02_2.hpp"
}
namespace start_3 {
#include "starts/02_3.hpp"
}
namespace solution_3 {
#include "exercises/02_3.hpp"
}

using namespace texmap::test;

TEST_CASE("02.1: where on the map") {
  check_start("02.1", start_1::uv_of);
  check_solution("02.1", solution_1::uv_of);

  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(p.z, p.x) / (2 * pi) + 0.5, std::acos(-p.y) / pi};
      },
      "mirrored");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x) / (2 * pi) + 0.5, std::acos(std::clamp(p.y, -1., 1.)) / pi};
      },
      "upside down");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x) / (2 * pi) + 0.5, std::acos(-p.y) / pi};
      },
      "beyond 1 at the pole");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x) / (2 * pi), std::asin(std::clamp(p.y, -1., 1.)) / pi + 0.5};
      },
      "1/2 is missing");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x), std::acos(-p.y)};
      },
      "radians");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::acos(std::clamp(-p.y, -1., 1.)) / pi,
                  std::atan2(-p.z, p.x) / (2 * pi) + 0.5};
      },
      "exchanged");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / 360, std::acos(std::clamp(-p.y, -1., 1.)) / 180};
      },
      "not 360");
  check_unknown(
      "02.1", +[](Vec3 p) {
        return Uv{p.x, p.z};
      });
}

TEST_CASE("02.1: mistakes in u") {
  const auto mistake = [](Uv (*function)(Vec3), const char* text) {
    check_mistake("02.1", function, text);
  };
  const auto wrong_u = [&](double (*u)(Vec3), const char* text) {
    static double (*wrong)(Vec3) = nullptr;
    wrong = u;
    mistake([](Vec3 p) { return Uv{wrong(p), std::acos(std::clamp(-p.y, -1., 1.)) / pi}; }, text);
    mistake([](Vec3 p) { return Uv{wrong(p), std::acos(-p.y) / pi}; }, text);
    mistake([](Vec3 p) { return Uv{wrong(p), std::asin(p.y) / pi + 0.5}; }, text);
  };
  wrong_u([](Vec3 p) { return 1 / 2 - std::atan2(p.z, p.x) / (2 * pi); }, "write 0.5");
  wrong_u([](Vec3 p) { return 1 / 2 + std::atan2(p.z, p.x) / (2 * pi); }, "write 0.5");
  wrong_u([](Vec3 p) { return std::atan2(-p.z, p.x) / (2 * pi) - 0.5; }, "not subtracted");
  wrong_u([](Vec3 p) { return 0.5 - std::atan2(p.z, p.x) / 2 * pi; }, "(2 * pi)");
  wrong_u([](Vec3 p) { return (std::atan2(-p.z, p.x) + pi) / 2 * pi; }, "(2 * pi)");
  wrong_u([](Vec3 p) { return std::atan2(-p.z, p.x) + pi / (2 * pi); }, "u is in radians");
  wrong_u([](Vec3 p) { return pi + std::atan2(-p.z, p.x) / (2 * pi); }, "only the angle");
  wrong_u([](Vec3 p) { return 0.5 - std::atan2(p.z, p.x) / 360; }, "not 360");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(-p.z, p.x) / pi; }, "goes around twice");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(p.x, -p.z) / (2 * pi); }, "exchanged");
  wrong_u([](Vec3 p) { return 0.5 - std::atan2(p.x, p.z) / (2 * pi); }, "exchanged");
  wrong_u([](Vec3 p) { return 0.5 - std::atan2(-p.z, -p.x) / (2 * pi); }, "half a turn");
  wrong_u(
      [](Vec3 p) {
        const double u = std::atan2(-p.z, p.x) / (2 * pi);
        return u < 0 ? u + 1 : u;
      },
      "half a turn");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(p.y, p.x) / (2 * pi); }, "between x and z");
  wrong_u([](Vec3 p) { return 0.5 - std::atan(p.z / p.x) / pi; }, "std::atan2");
  wrong_u([](Vec3 p) { return 0.5 + 1 / 2 * std::atan2(-p.z, p.x) / pi; }, "u is 1/2 everywhere");
}

TEST_CASE("02.1: mistakes in v") {
  const auto wrong_v = [](double (*v)(Vec3), const char* text) {
    static double (*wrong)(Vec3) = nullptr;
    wrong = v;
    check_mistake(
        "02.1",
        +[](Vec3 p) {
          return Uv{std::atan2(-p.z, p.x) / (2 * pi) + 0.5, wrong(p)};
        },
        text);
  };
  wrong_v([](Vec3 p) { return 1 / 2 + std::asin(p.y) / pi; }, "add 0.5");
  wrong_v([](Vec3 p) { return std::atan2(p.y, std::hypot(p.x, p.z)) / pi; }, "add 0.5");
  wrong_v([](Vec3 p) { return std::acos(std::clamp(-p.y, -1., 1.)); }, "v is in radians");
  wrong_v([](Vec3 p) { return std::acos(-p.y) / 180; }, "not 360");
  wrong_v([](Vec3 p) { return std::acos(-p.y) / (2 * pi); }, "acos runs");
  wrong_v([](Vec3 p) { return std::asin(p.y) / (2 * pi) + 0.5; }, "asin runs");
  wrong_v([](Vec3 p) { return 0.5 * (1 + p.y); }, "not with the height");
  wrong_v([](Vec3 p) { return std::acos(-p.z) / pi; }, "axis from pole to pole");
  wrong_v([](Vec3 p) { return std::acos(std::clamp(-p.y, 0., 1.)) / pi; }, "not to 0 and 1");
  wrong_v([](Vec3 p) { return -std::acos(p.y) / pi; }, "no negative angle");
  wrong_v([](Vec3 p) { return std::atan2(p.x * p.x + p.z * p.z, -p.y) / pi; }, "square root");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x) * 180 / pi, std::acos(-p.y) * 180 / pi};
      },
      "not degrees");
}

TEST_CASE("02.2: which square") {
  check_start("02.2", start_2::is_first_color);
  check_solution("02.2", solution_2::is_first_color);

  check_mistake(
      "02.2", +[](Uv uv, int squares) { return static_cast<int>(uv.u * squares) % 2 == 0; },
      "stripes");
  check_mistake(
      "02.2",
      +[](Uv uv, int squares) {
        return (static_cast<int>(uv.u * squares) + static_cast<int>(uv.v * squares)) % 2 != 0;
      },
      "exchanged");
  check_mistake(
      "02.2",
      +[](Uv uv, int squares) {
        return (static_cast<int>(uv.u * squares) + static_cast<int>(uv.v * squares)) % 2 == 0;
      },
      "v = 1");
  check_mistake(
      "02.2",
      +[](Uv uv, int squares) {
        return (static_cast<int>(uv.u * squares) * static_cast<int>(uv.v * squares)) % 2 == 0;
      },
      "added");
}

TEST_CASE("02.2: wrong numbers, wrong questions") {
  const auto mistake = [](bool (*function)(int, int, int), const char* text) {
    static bool (*wrong)(int, int, int) = nullptr;
    wrong = function;
    check_mistake(
        "02.2",
        +[](Uv uv, int squares) {
          const int column = static_cast<int>(uv.u * squares);
          const int row = static_cast<int>(uv.v * squares);
          return wrong(column, row == squares ? squares - 1 : row, squares);
        },
        text);
    check_mistake(
        "02.2",
        +[](Uv uv, int squares) {
          return wrong(static_cast<int>(uv.u * squares), static_cast<int>(uv.v * squares), squares);
        },
        text);
  };
  mistake([](int column, int, int) { return column % 2 == 1; }, "stripes");
  mistake([](int, int row, int) { return row % 2 == 0; }, "rings");
  mistake([](int column, int row, int) { return column % 2 == 0 || row % 2 == 0; }, "product");
  mistake([](int column, int row, int) { return column % 2 == 0 && row % 2 == 0; }, "both be even");
  mistake([](int column, int row, int) { return row == column; }, "diagonal");
  mistake([](int column, int row, int squares) { return (column + row) % squares == 0; },
          "not modulo squares");
  mistake([](int column, int row, int) { return (row + column) / 2 == 0; }, "quotient");
  mistake([](int column, int row, int) { return column + row % 2 == 0; }, "(a + b) % 2");
  mistake([](int column, int row, int) { return (column - row) % 2 == 1; }, "can be -1");

  const auto other = [](bool (*function)(Uv, int), const char* text) {
    check_mistake("02.2", function, text);
  };
  other(
      [](Uv uv, int) {
        return (static_cast<int>(uv.u * 10) + std::min(static_cast<int>(uv.v * 10), 9)) % 2 == 0;
      },
      "not always 10");
  other(
      [](Uv uv, int squares) {
        const int column = static_cast<int>(uv.u * (squares - 1));
        return (column + static_cast<int>(uv.v * (squares - 1))) % 2 == 0;
      },
      "not by squares - 1");
  other(
      [](Uv uv, int squares) {
        const long row = std::lround(uv.v * squares);
        return (std::lround(uv.u * squares) + std::min(row, squares - 1L)) % 2 == 0;
      },
      "do not round");
  other(
      [](Uv uv, int squares) { return static_cast<int>(uv.u * squares + uv.v * squares) % 2 == 0; },
      "slanted");
  other(
      [](Uv uv, int squares) {
        return (static_cast<int>(uv.u) * squares + static_cast<int>(uv.v) * squares) % 2 == 0;
      },
      "too early");
  other(
      [](Uv uv, int squares) {
        const int row = std::max(static_cast<int>(uv.v * squares), squares - 1);
        return (static_cast<int>(uv.u * squares) + row) % 2 == 0;
      },
      "std::max");
}

TEST_CASE("02.3: square squares") {
  check_start("02.3", start_3::twice_around);
  check_solution("02.3", solution_3::twice_around);

  check_mistake(
      "02.3",
      +[](Uv uv) {
        return Uv{2 * uv.u, 2 * uv.v};
      },
      "v");
  check_mistake(
      "02.3",
      +[](Uv uv) {
        return Uv{uv.u / 2, uv.v};
      },
      "once in two turns");

  const auto mistake = [](Uv (*function)(Uv), const char* text) {
    check_mistake("02.3", function, text);
  };
  mistake([](Uv uv) { return Uv{uv.u, 2 * uv.v}; }, "four times as wide");
  mistake([](Uv uv) { return Uv{uv.u / 2, uv.v / 2}; }, "and leave v");
  mistake([](Uv uv) { return Uv{uv.u, uv.v / 2}; }, "larger and not twice");
  mistake([](Uv uv) { return Uv{0.5 * uv.u, 2 * uv.v}; }, "eight times");
  mistake([](Uv uv) { return Uv{2 * uv.u, 0.5 * uv.v}; }, "twice as high");
  mistake([](Uv uv) { return Uv{1 / 2 * uv.u, uv.v}; }, "u is 0 everywhere");
  mistake([](Uv uv) { return Uv{2 * uv.u, 1 / 2 * uv.v}; }, "you lose it");
  mistake([](Uv uv) { return Uv{10 * uv.u, uv.v}; }, "more than twice");
  mistake([](Uv uv) { return Uv{20 * uv.u, 10 * uv.v}; }, "20 times around");
  mistake([](Uv uv) { return Uv{4 * uv.u, uv.v}; }, "four times around");
  mistake([](Uv uv) { return Uv{2 * pi * uv.u, uv.v}; }, "no angle");
  mistake([](Uv uv) { return Uv{std::fmod(2 * uv.u, 1.0), uv.v}; }, "goes on there");
  mistake([](Uv uv) { return Uv{std::min(1.0, 2 * uv.u), uv.v}; }, "goes on there");
  mistake([](Uv uv) { return Uv{uv.u + 1, uv.v}; }, "only turns");
  mistake([](Uv uv) { return Uv{2 * uv.u, 2 * uv.u}; }, "comes from v");
  mistake([](Uv uv) { return Uv{uv.v, 2 * uv.u}; }, "exchanged");
  mistake([](Uv uv) { return Uv{uv.u * uv.u, uv.v}; }, "not u * u");
  mistake([](Uv uv) { return Uv{1.0 * static_cast<int>(2 * uv.u), uv.v}; }, "no static_cast");
  mistake(start_3::twice_around, "stay as they were");
}

TEST_CASE("the questions of chapter 02 have the answers of its page") {
  check_answer("02.a", 60);
  check_answer("02.b", 80);
}
