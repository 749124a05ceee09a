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

TEST_CASE("05.1: more turns that students write") {
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * 180 / pi;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c + p.z * s, p.y, p.z * c - p.x * s};
      },
      "pi and 180");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees / 180 * 2 * pi;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c + p.z * s, p.y, p.z * c - p.x * s};
      },
      "twice the angle");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * 3.14159 / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c + p.z * s, p.y, p.z * c - p.x * s};
      },
      "digits");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * 3.14 / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c + p.z * s, p.y, p.z * c - p.x * s};
      },
      "digits");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c + p.z * s, p.y, p.z * c + p.x * s};
      },
      "one sine");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c - p.z * s, p.y, p.z * c - p.x * s};
      },
      "one sine");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        p.z = p.z * c - p.x * s;
        p.x = p.x * c + p.z * s;
        return p;
      },
      "new x is computed");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        p.x = p.x * c - p.z * s;
        p.z = p.z * c + p.x * s;
        return p;
      },
      "new z is computed");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c - p.y * s, p.x * s + p.y * c, p.z};
      },
      "z axis");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x, p.y * c - p.z * s, p.y * s + p.z * c};
      },
      "about the x axis");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        p.x = p.x * c + p.z * s;
        return p;
      },
      "z is not turned");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        p.z = p.z * c - p.x * s;
        return p;
      },
      "x is not turned");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        return Vec3{p.x + p.z * std::sin(a), p.y, p.z - p.x * std::sin(a)};
      },
      "cosines are missing");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        return Vec3{p.x * std::cos(a), p.y, p.z * std::cos(a)};
      },
      "sines are missing");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{s, p.y, c};
      },
      "+z alone");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.z * s, 0, p.z * c};
      },
      "+z alone");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c + p.z * s, 0, p.z * c - p.x * s};
      },
      "y is missing");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.z * c - p.x * s, p.y, p.x * c + p.z * s};
      },
      "in what you return");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * c + p.z * s, p.y, p.x * c - p.z * s};
      },
      "in the new z");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.x * s + p.z * c, p.y, p.z * c - p.x * s};
      },
      "in the new x");
  check_mistake(
      "05.1",
      +[](Vec3 p, double degrees) {
        const double a = degrees * pi / 180;
        const double s = std::sin(a);
        const double c = std::cos(a);
        return Vec3{p.z * c + p.x * s, p.y, p.x * c - p.z * s};
      },
      "keeps its cosine");
}

TEST_CASE("05.2: more u that students compute") {
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        double x = u + degrees / 360;
        while (x > 1) x -= 1;
        while (x < 0) x += 1;
        return x;
      },
      "seam again");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        double x = u + degrees / 360;
        if (x > 1) x -= 1;
        if (x < 0) x += 1;
        return x;
      },
      "several full turns");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u + degrees / 360;
        return std::abs(x - static_cast<int>(x));
      },
      "without its sign");
  check_mistake(
      "05.2", +[](double u, double degrees) { return std::remainder(u + degrees / 360, 1); },
      "nearest whole");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u + degrees / 360;
        return x - std::ceil(x);
      },
      "std::ceil");
  check_mistake(
      "05.2", +[](double u, double degrees) { return std::floor(u + degrees / 360); },
      "number of full turns");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = degrees / 360;
        return u + x - std::floor(x);
      },
      "add first");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = degrees / 360;
        return u + x - static_cast<int>(x);
      },
      "add first");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u + static_cast<int>(degrees) / 360.0;
        return x - std::floor(x);
      },
      "whole degrees");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const int whole = static_cast<int>(degrees);
        const int turns = whole % 360 / 360;
        return u + turns;
      },
      "no effect");
  check_mistake(
      "05.2", +[](double u, double degrees) { return u - degrees / 360; }, "wrong sign");
  check_mistake(
      "05.2", +[](double u, double degrees) { return std::fmod(u - degrees / 360, 1); },
      "wrong sign");
  check_mistake(
      "05.2", +[](double u, double degrees) { return std::fmod(u + degrees / 180, 1); },
      "not by 180");
  check_mistake(
      "05.2", +[](double u, double degrees) { return u + degrees / 180 * pi; }, "not radians");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u + degrees / (2 * pi);
        return x - std::floor(x);
      },
      "full turn in radians");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u + degrees;
        return x - std::floor(x);
      },
      "not degrees");
  check_mistake(
      "05.2", +[](double u, double degrees) { return (u + degrees) / 360; }, "same unit");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = (u + degrees) / 360;
        return x - std::floor(x);
      },
      "same unit");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double x = u * degrees / 360;
        return x - std::floor(x);
      },
      "not multiplied");
  check_mistake(
      "05.2",
      +[](double, double degrees) {
        const double x = degrees / 360;
        return x - std::floor(x);
      },
      "old u is missing");
  check_mistake(
      "05.2",
      +[](double u, double degrees) {
        const double a = u * 360 + degrees;
        return a - 360 * std::floor(a / 360);
      },
      "divide it by 360");
  check_mistake(
      "05.2", +[](double u, double degrees) { return std::fmod(u * 360 + degrees, 360); },
      "divide it by 360");
  check_mistake(
      "05.2", +[](double u, double degrees) { return std::fmod(u + degrees, 360) / 360; },
      "same unit");
}

TEST_CASE("05.3: more looks at a leaning globe") {
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(b) + p.z * std::sin(b), p.y,
                     p.z * std::cos(b) - p.x * std::sin(b)};
        return Vec3{q.x * std::cos(a) + q.y * std::sin(a), q.y * std::cos(a) - q.x * std::sin(a),
                    q.z};
      },
      "and the axis leans");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) + p.y * std::sin(a), p.y * std::cos(a) - p.x * std::sin(a),
                     p.z};
        return Vec3{q.x * std::cos(b) - q.z * std::sin(b), q.y,
                    q.z * std::cos(b) + q.x * std::sin(b)};
      },
      "both turns");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        const Vec3 r{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                     q.z * std::cos(b) - q.x * std::sin(b)};
        return Vec3{r.x * std::cos(a) + r.y * std::sin(a), r.y * std::cos(a) - r.x * std::sin(a),
                    r.z};
      },
      "comes back");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "radians");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "radians");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = turn * pi / 180;
        const double b = lean * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "two angles are exchanged");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = (lean + turn) * pi / 180;
        return Vec3{p.x * std::cos(a) + p.z * std::sin(a), p.y,
                    p.z * std::cos(a) - p.x * std::sin(a)};
      },
      "turn of x and y");
  check_mistake(
      "05.3",
      +[](Vec3 p, double, double turn) {
        const double a = 23.4 * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "always leans");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 360;
        const double b = turn * pi / 360;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "half of the angles");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x, p.y * std::cos(a) - p.z * std::sin(a),
                     p.y * std::sin(a) + p.z * std::cos(a)};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "to the eye");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{p.x * std::cos(b) + p.z * std::sin(b), q.y,
                    p.z * std::cos(b) - p.x * std::sin(b)};
      },
      "you turn p");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - p.x * std::sin(b)};
      },
      "you turn p");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), p.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "y comes from p");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        p.x = p.x * std::cos(a) - p.y * std::sin(a);
        p.y = p.x * std::sin(a) + p.y * std::cos(a);
        return Vec3{p.x * std::cos(b) + p.z * std::sin(b), p.y,
                    p.z * std::cos(b) - p.x * std::sin(b)};
      },
      "new y is computed");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a), p.z};
        q.x = q.x * std::cos(b) + q.z * std::sin(b);
        q.z = q.z * std::cos(b) - q.x * std::sin(b);
        return q;
      },
      "new z is computed");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double) {
        const double a = lean * pi / 180;
        return Vec3{p.x * std::cos(a) + p.y * std::sin(a), p.y * std::cos(a) - p.x * std::sin(a),
                    p.z};
      },
      "does not turn");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.y * std::cos(a) - p.x * std::sin(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "sine of the lean");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) + p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "sine of the lean");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) + q.x * std::sin(b)};
      },
      "sine of the turn");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::sin(a) - p.y * std::cos(a), p.x * std::cos(a) + p.y * std::sin(a),
                     p.z};
        return Vec3{q.x * std::cos(b) + q.z * std::sin(b), q.y,
                    q.z * std::cos(b) - q.x * std::sin(b)};
      },
      "of the lean are exchanged");
  check_mistake(
      "05.3",
      +[](Vec3 p, double lean, double turn) {
        const double a = lean * pi / 180;
        const double b = turn * pi / 180;
        const Vec3 q{p.x * std::sin(a) - p.y * std::cos(a), p.x * std::cos(a) + p.y * std::sin(a),
                     p.z};
        return Vec3{q.x * std::sin(b) + q.z * std::cos(b), q.y,
                    q.z * std::sin(b) - q.x * std::cos(b)};
      },
      "both angles are exchanged");
}

TEST_CASE("the questions of chapter 05 have the answers of its page") {
  check_answer("05.a", 45);
  check_answer("05.b", 90);
}
