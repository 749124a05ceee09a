// The exercises of chapter 05: each fails as shipped, its solution passes, each known mistake gets
// its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/05_1.hpp"
}
namespace solution_1 {
#include "exercises/05_1.hpp"
}
namespace start_2 {
#include "starts/05_2.hpp"
}
namespace solution_2 {
#include "exercises/05_2.hpp"
}
namespace start_3 {
#include "starts/05_3.hpp"
}
namespace solution_3 {
#include "exercises/05_3.hpp"
}

using namespace texmap::test;

TEST_CASE("05.1: turn a direction") {
  check_start("05.1", start_1::turned);
  check_solution("05.1", solution_1::turned);

  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        return Vec3{std::cos(degrees) * p.x + std::sin(degrees) * p.z, p.y,
                    std::cos(degrees) * p.z - std::sin(degrees) * p.x};
      },
      "radians");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees / 180 * pi;
        return Vec3{std::cos(a) * p.x - std::sin(a) * p.z, p.y,
                    std::sin(a) * p.x + std::cos(a) * p.z};
      },
      "other way around");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees / 180 * pi;
        p.x = std::cos(a) * p.x + std::sin(a) * p.z;
        p.z = std::cos(a) * p.z - std::sin(a) * p.x;
        return p;
      },
      "new z");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = pi / 2 - degrees / 180 * pi;
        return Vec3{std::cos(a) * p.x + std::sin(a) * p.z, p.y,
                    std::cos(a) * p.z - std::sin(a) * p.x};
      },
      "exchanged");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees / 360 * pi;
        return Vec3{std::cos(a) * p.x + std::sin(a) * p.z, p.y,
                    std::cos(a) * p.z - std::sin(a) * p.x};
      },
      "half of the angle");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees / 180 * pi;
        return Vec3{std::cos(a) * p.x + std::sin(a) * p.y, std::cos(a) * p.y - std::sin(a) * p.x,
                    p.z};
      },
      "z axis");
  check_unknown(
      "05.1", +[](Vec3 p, double degrees) {
        return Vec3{p.z, p.y, p.x * degrees};
      });
}

TEST_CASE("05.2: u after a turn") {
  check_start("05.2", start_2::u_after);
  check_solution("05.2", solution_2::u_after);

  check_mistake(
      "05.2", +[](double u, double degrees) { return u + degrees / 360; }, "leaves 0 to 1");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u + degrees / 360;
        return x - static_cast<int>(x);
      },
      "std::floor");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        double x = u + degrees / 360;
        if (x >= 1) x -= 1;
        if (x < 0) x += 1;
        return x;
      },
      "several");
  check_mistake(
      "05.2",
      +[](double u, double degrees) { return std::max(0., std::min(1., u + degrees / 360)); },
      "limit");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u - degrees / 360;
        return x - std::floor(x);
      },
      "wrong sign");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u + degrees / 180;
        return x - std::floor(x);
      },
      "not by 180");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u + degrees * pi / 180;
        return x - std::floor(x);
      },
      "not radians");
  check_unknown(
      "05.2", +[](double u, double degrees) { return u * u + degrees; });
}

TEST_CASE("05.3: a leaning axis") {
  check_start("05.3", start_3::looked_up);
  check_solution("05.3", solution_3::looked_up);

  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(b) + p.z * std::sin(b), p.y,
                     p.z * std::cos(b) - p.x * std::sin(b)};
        return Vec3{q.x * std::cos(a) - q.y * std::sin(a), q.x * std::sin(a) + q.y * std::cos(a),
                    q.z};
      },
      "turn comes first");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const double x = p.x * std::cos(a) + p.y * std::sin(a);
        return Vec3{x * std::cos(b) + p.z * std::sin(b), p.y * std::cos(a) - p.x * std::sin(a),
                    p.z * std::cos(b) - x * std::sin(b)};
      },
      "to the left");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const double x = p.x * std::cos(a) - p.y * std::sin(a);
        return Vec3{x * std::cos(b) - p.z * std::sin(b), p.y * std::cos(a) + p.x * std::sin(a),
                    p.z * std::cos(b) + x * std::sin(b)};
      },
      "wrong sign");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double x = p.x * std::cos(lean) - p.y * std::sin(lean);
        return Vec3{x * std::cos(turn) + p.z * std::sin(turn),
                    p.y * std::cos(lean) + p.x * std::sin(lean),
                    p.z * std::cos(turn) - x * std::sin(turn)};
      },
      "radians");
  check_mistake(
      "05.3",
      +[](Vec3 p, double, double turn) {
        const double b = turn * pi / 180;
        return Vec3{p.x * std::cos(b) + p.z * std::sin(b), p.y,
                    p.z * std::cos(b) - p.x * std::sin(b)};
      },
      "does not lean");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double) {
        const double a = lean * pi / 180;
        return Vec3{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                    p.z};
      },
      "does not turn");
}

TEST_CASE("the questions of chapter 05 have the answers of its page") {
  check_answer("05.a", 45);
  check_answer("05.b", 90);
}
