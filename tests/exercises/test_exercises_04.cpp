// The exercises of chapter 04: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "published/uv.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/04_1.hpp"
}
namespace solution_1 {
#include "exercises/04_1.hpp"
}
namespace start_2 {
#include "starts/04_2.hpp"
}
namespace solution_2 {
#include "exercises/04_2.hpp"
}
namespace start_3 {
#include "starts/04_3.hpp"
}
namespace solution_3 {
#include "exercises/04_3.hpp"
}

using namespace texmap::test;

TEST_CASE("04.1: another convention") {
  check_start("04.1", start_1::uv_of);
  check_solution("04.1", solution_1::uv_of);
  // The daily exercise's own formula normalizes its point first, so it is right at the pole.
  check_solution(
      "04.1", +[](Vec3 p) { return texmap::published::uv_daily(p); });

  const auto mistake = [](Uv (*function)(Vec3), const char* text) {
    check_mistake("04.1", function, text);
  };
  mistake(
      [](Vec3 p) {
        return Uv{(std::atan2(-p.z, p.x) + pi) / (2 * pi),
                  std::acos(std::clamp(p.y, -1., 1.)) / pi};
      },
      "u runs east:");
  mistake(
      [](Vec3 p) {
        return Uv{(std::atan2(p.z, p.x) + pi) / (2 * pi),
                  std::asin(std::clamp(p.y, -1., 1.)) / pi + 0.5};
      },
      "v runs up:");
  mistake(
      [](Vec3 p) {
        return Uv{1 - (std::atan2(p.z, p.x) + pi) / (2 * pi), std::acos(-p.y) / pi};
      },
      "chapter 02");
  mistake(
      [](Vec3 p) {
        return Uv{0.5 + std::atan2(p.z, p.x) / 360, std::acos(p.y) / 180};
      },
      "radians");
  mistake(
      [](Vec3 p) {
        return Uv{std::atan2(p.z, p.x) / (2 * pi), std::acos(p.y) / pi};
      },
      "1/2 is missing");
  mistake(
      [](Vec3 p) {
        return Uv{0.5 + std::atan2(p.x, p.z) / (2 * pi), 0.5 - std::asin(p.y) / pi};
      },
      "arguments of atan2");
  mistake(
      [](Vec3 p) {
        return Uv{0.5 + std::atan2(p.z, p.x) / (2 * pi), 0.5 - std::asin(p.y) / pi};
      },
      "beyond 1");
}

// Chapter 02's tests have the rest: both exercises share these mistakes.
TEST_CASE("04.1: mistakes in u and v, each with a right and a wrong sign") {
  const auto mistake = [](Uv (*function)(Vec3), const char* text) {
    check_mistake("04.1", function, text);
  };
  const auto wrong_u = [&](double (*u)(Vec3), const char* text) {
    static double (*wrong)(Vec3) = nullptr;
    wrong = u;
    mistake([](Vec3 p) { return Uv{wrong(p), std::acos(std::clamp(p.y, -1., 1.)) / pi}; }, text);
    mistake([](Vec3 p) { return Uv{wrong(p), std::acos(std::clamp(-p.y, -1., 1.)) / pi}; }, text);
    mistake([](Vec3 p) { return Uv{wrong(p), 0.5 - std::asin(p.y) / pi}; }, text);
  };
  wrong_u([](Vec3 p) { return 1 / 2 + std::atan2(p.z, p.x) / (2 * pi); }, "write 0.5");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(p.z, p.x) / 2 * pi; }, "(2 * pi)");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(p.z, -p.x) / (2 * pi); }, "half a turn");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(-p.x, p.z) / (2 * pi); }, "arguments of atan2");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(p.y, p.x) / (2 * pi); }, "between x and z");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(p.z, p.y) / (2 * pi); }, "between x and z");
  wrong_u([](Vec3 p) { return 0.5 + std::atan2(p.z, p.x) / pi; }, "goes around twice");
  mistake(
      [](Vec3 p) {
        return Uv{1 / 2 + std::atan2(p.z, p.x) / (2 * pi), 1 / 2 - std::asin(p.y) / pi};
      },
      "write 0.5");
  mistake(
      [](Vec3 p) {
        return Uv{0.5 + std::atan2(p.z, p.x) / (2 * pi), 1 / 2 - std::asin(p.y) / pi};
      },
      "add 0.5");
  mistake(
      [](Vec3 p) {
        return Uv{0.5 + std::atan2(-p.z, p.x) / (2 * pi), std::acos(-p.y)};
      },
      "v is in radians");
  check_unknown(
      "04.1", +[](Vec3 p) {
        return Uv{p.x, p.z};
      });
}

TEST_CASE("04.2: from one convention to another") {
  check_start("04.2", start_2::lecture_u);
  check_solution("04.2", solution_2::lecture_u);
  check_solution(
      "04.2", +[](double u) { return u + 0.75 - std::floor(u + 0.75); });

  const auto mistake = [](double (*function)(double), const char* text) {
    check_mistake("04.2", function, text);
  };
  mistake([](double u) { return std::fmod(u - 0.25, 1.0); }, "std::fmod");
  mistake([](double u) { return 1 + (u - 0.25); }, "too much: subtract");
  mistake([](double u) { return std::fmod(u + 0.25, 1.0); }, "+z has to get u = 0");
  mistake([](double u) { return 0.25 + u; }, "other way, and");
  mistake([](double u) { return u > 0.25 ? u - 0.25 : 0.25 - u; }, "reflect");
  mistake([](double u) { return u > 0.25 ? u - 0.25 : 0; }, "cut off");
  mistake(
      [](double u) {
        const double other = 0.25 - u;
        return other < 0 ? other + 1 : other;
      },
      "runs the other way");
}

TEST_CASE("04.2: wrong branches, wrong quarters") {
  const auto mistake = [](double (*function)(double), const char* text) {
    check_mistake("04.2", function, text);
  };
  mistake([](double u) { return u - 1 / 4; }, "1 / 4 is 0");
  mistake([](double u) { return std::fmod(u + 3 / 4, 1.0); }, "1 / 4 is 0");
  mistake([](double u) { return u < 0.25 ? u + 0.75 : u - 1 / 4; }, "three quarters stay");
  mistake([](double u) { return u < 0.25 ? u + 3 / 4 : u - 0.25; }, "first quarter stays");
  mistake([](double u) { return 1 - u; }, "runs the other way");
  mistake([](double u) { return 0.25 - u; }, "runs the other way");
  mistake([](double u) { return u <= 0.25 ? u + 0.75 : u - 0.25; }, "not <=");
  mistake([](double u) { return u > 0.25 ? u - 0.25 : u + 0.75; }, "not <=");
  mistake([](double u) { return u >= 0.25 ? u + 0.75 : u - 0.25; }, "cases are exchanged");
  mistake([](double u) { return u - 0.75; }, "and below 0");
  mistake([](double u) { return std::min(0.75 + u, 1.0); }, "cut off at 1");
  mistake([](double u) { return u >= 0.25 ? u - 0.25 : 1 - u; }, "add a whole turn to it");
  mistake([](double u) { return u >= 0.25 ? u - 0.25 : 1 + u; }, "add a whole turn to it");
  mistake([](double u) { return u - 0.25 < 0 ? u - 0.25 + 2 * pi : u - 0.25; }, "not in radians");
  mistake([](double u) { return u - pi / 2; }, "a quarter of a turn is 0.25");
  mistake([](double u) { return u - 90; }, "a quarter of a turn is 0.25");
  mistake([](double u) { return std::fmod(u + 0.5, 1.0); }, "not by half");
  mistake([](double u) { return u / 4; }, "do not multiply");
}

TEST_CASE("04.3: is it mirrored") {
  check_start("04.3", start_3::is_mirrored);
  check_solution("04.3", solution_3::is_mirrored);

  const auto mistake = [](bool (*function)(Uv, Uv, Uv), const char* text) {
    check_mistake("04.3", function, text);
  };
  mistake([](Uv here, Uv east, Uv) { return east.u <= here.u - 1e-9; }, "east alone");
  mistake([](Uv here, Uv, Uv north) { return here.v - north.v > 1e-9; }, "north alone");
  mistake([](Uv here, Uv east, Uv north) { return !(east.u >= here.u && north.v >= here.v); },
          "no mirror");
  mistake([](Uv here, Uv east, Uv north) { return !(east.u >= here.u || north.v >= here.v); },
          "ask for both");
  mistake(
      [](Uv here, Uv east, Uv north) {
        return (east.u > here.u && north.v < here.v) || (east.u < here.u && north.v > here.v);
      },
      "turned by a quarter");
  mistake(
      [](Uv here, Uv east, Uv north) {
        const double determinant =
            (east.u - here.u) * (north.v - here.v) + (north.u - here.u) * (east.v - here.v);
        return determinant < 0;
      },
      "subtracted");
  mistake([](Uv here, Uv east, Uv north) { return !solution_3::is_mirrored(here, east, north); },
          "exchanged");
}

TEST_CASE("04.3: wrong steps, wrong products") {
  const auto mistake = [](bool (*function)(Uv, Uv, Uv), const char* text) {
    check_mistake("04.3", function, text);
  };
  mistake([](Uv, Uv east, Uv north) { return east.u * north.v - north.u * east.v < 0; },
          "places, not steps");
  mistake([](Uv, Uv east, Uv north) { return north.v * east.u - east.v * north.u > 0; },
          "places, not steps");
  mistake([](Uv here, Uv east, Uv north) { return (east.u - here.u) * (north.v - here.v) > 0; },
          "exchanged, and a picture");
  mistake([](Uv here, Uv east, Uv north) { return (east.u - here.u) * (north.v - here.v) <= 0; },
          "a product of 0");
  mistake([](Uv here, Uv east, Uv) { return east.u > here.u; }, "east alone");
  mistake([](Uv here, Uv east, Uv north) { return east.u > here.u && north.v > here.v; },
          "multiply the signs");
  mistake([](Uv here, Uv east, Uv north) { return east.u > here.u || north.v > here.v; },
          "half a turn, no mirror");
  mistake([](Uv here, Uv east, Uv north) { return east.u < here.u && north.v > here.v; },
          "or the one to the north");
  mistake([](Uv here, Uv east, Uv) { return east.v < here.v; }, "if nothing is turned");
  mistake([](Uv here, Uv east, Uv north) { return east.u - here.u + north.v - here.v < 0; },
          "not added");
  mistake([](Uv, Uv east, Uv) { return east.u < 0; }, "never true");
  mistake(start_3::is_mirrored, "never true");
  mistake([](Uv here, Uv east, Uv) { return east.u != here.u || east.v != here.v; }, "always true");
  // With the four slopes.
  const auto product = [&](double (*function)(double, double, double, double), const char* text) {
    static double (*wrong)(double, double, double, double) = nullptr;
    wrong = function;
    mistake(
        [](Uv here, Uv east, Uv north) {
          return wrong(east.u - here.u, east.v - here.v, north.u - here.u, north.v - here.v) < 0;
        },
        text);
  };
  product([](double u_e, double v_e, double u_n, double v_n) { return u_e * u_n + v_e * v_n; },
          "dot product");
  product([](double u_e, double v_e, double u_n, double v_n) { return u_e * v_e - u_n * v_n; },
          "other factors");
  product([](double, double v_e, double u_n, double) { return u_n * v_e; },
          "half of the determinant");
}

TEST_CASE("the questions of chapter 04 have the answers of its page") {
  check_answer("04.a", 0.25);
  check_answer("04.b", 0.65);
}
