// The exercises of chapter 10: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/10_1.hpp"
}
namespace solution_1 {
#include "exercises/10_1.hpp"
}
namespace start_2 {
#include "starts/10_2.hpp"
}
namespace solution_2 {
#include "exercises/10_2.hpp"
}
namespace start_3 {
#include "starts/10_3.hpp"
}
namespace solution_3 {
#include "exercises/10_3.hpp"
}

using namespace texmap::test;

using V = Vec3;
using D = double;
using std::abs, std::acos, std::atan2, std::copysign, std::cos, std::sin, std::sqrt;

namespace {

// 10.1: the angle around the axis, and the right u
double angle(V p) { return atan2(p.z, p.x); }
double right_u(V p) { return 0.5 - angle(p) / (2 * pi); }

// 10.2: places from -1 to 1, folded out or not, and moved to 0 to 1
double sum(V p) { return abs(p.x) + abs(p.y) + abs(p.z); }
Uv folded(D a, D b) { return {copysign(1 - abs(b), a), copysign(1 - abs(a), b)}; }
Uv place(V p, D s, bool fold) { return fold ? folded(p.x / s, -p.z / s) : Uv{p.x / s, -p.z / s}; }
Uv moved(Uv p) { return {(1 + p.u) / 2, (1 + p.v) / 2}; }

// 10.3: points at the angle w and at the height y
V on_circle(D w, D y, D radius) { return {radius * cos(w), y, radius * sin(w)}; }
V on_sphere(D w, D y) { return on_circle(w, y, sqrt(1 - y * y)); }

}  // namespace

TEST_CASE("10.1: onto a cylinder") {
  check_start("10.1", start_1::on_cylinder);
  check_solution("10.1", solution_1::on_cylinder);

  const auto named = [](Uv (*on)(V p), const char* text) { check_mistake("10.1", on, text); };
  named(
      [](V p) {
        return Uv{atan2(-p.z, p.x) / (2 * pi) + 0.5, 1 - acos(p.y) / pi};
      },
      "equirectangular");
  named([](V p) { return Uv{right_u(p), acos(p.y) / pi}; }, "equirectangular");
  named([](V p) { return Uv{angle(p) / (2 * pi) + 0.5, 0.5 * p.y + 0.5}; }, "mirrored");
  named([](V p) { return Uv{0.5 + atan2(-p.z, p.x) / (2 * pi), 0.5 - 0.5 * p.y}; }, "upside down");
  named([](V p) { return Uv{0.5 + atan2(-p.z, p.x) / (2 * pi), p.y}; }, "lower half");
  named([](V p) { return Uv{right_u(p), abs(p.y)}; }, "lower half");
  named([](V p) { return Uv{right_u(p), 1 + p.y}; }, "halve 1 + y");
  named([](V p) { return Uv{right_u(p), 1 + p.y / 2}; }, "write (1 + y) / 2");
  named([](V p) { return Uv{right_u(p), p.y / 2}; }, "-1/2 to 1/2");
  named([](V p) { return Uv{right_u(p), p.y + 0.5}; }, "halve it");
  named([](V p) { return Uv{right_u(p), 2 * p.y - 1}; }, "goes back");
  named([](V p) { return Uv{(180 - angle(p)) / 360, (p.y + 1) / 2}; }, "radians");
  named([](V p) { return Uv{-angle(p) / 2 / pi, (p.y + 1) / 2}; }, "half is missing");
  named([](V p) { return Uv{-angle(p) / (2 * pi), p.y}; }, "int is 0");
  named([](V p) { return Uv{angle(p) / (2 * pi), (p.y + 1) / 2}; }, "and begins at -1/2");
  named([](V p) { return Uv{0.5 - angle(p) / pi, (p.y + 1) / 2}; }, "not pi: u");
  named([](V p) { return Uv{0.5 - angle(p) / 2 * pi, (p.y + 1) / 2}; }, "multiplies by pi");
  named([](V p) { return Uv{0.5 - angle(p), (p.y + 1) / 2}; }, "no share");
  named([](V p) { return Uv{(0.5 - angle(p)) / (2 * pi), (p.y + 1) / 2}; }, "the angle alone");
  named([](V p) { return Uv{1 - angle(p) / (2 * pi), (p.y + 1) / 2}; }, "off by 1/2");
  named([](V p) { return Uv{(pi - atan2(p.x, p.z)) / (2 * pi), (p.y + 1) / 2}; }, "z first");
  named([](V p) { return Uv{0.5 + atan2(p.x, p.z) / (2 * pi), (p.y + 1) / 2}; }, "z first");
  named(
      [](V p) {
        return Uv{0.5 - std::atan(p.z / p.x) / (2 * pi), (p.y + 1) / 2};
      },
      "from the back");
  named([](V p) { return Uv{0.5 - atan2(p.y, p.x) / (2 * pi), (p.y + 1) / 2}; }, "y is the axis");
  named([](V p) { return Uv{(p.y + 1) / 2, right_u(p)}; }, "u and v are exchanged");

  check_unknown(
      "10.1", +[](V p) {
        return Uv{p.z, p.y};
      });
}

TEST_CASE("10.2: fold an octahedron out") {
  check_start("10.2", start_2::on_octahedron);
  check_solution("10.2", solution_2::on_octahedron);

  const auto folds = [](Uv (*fold)(D a, D b), const char* text) {
    static Uv (*fold_out)(D, D);
    fold_out = fold;
    check_mistake(
        "10.2",
        +[](V p) {
          const Uv flat = place(p, sum(p), false);
          return moved(p.y < 0 ? fold_out(flat.u, flat.v) : flat);
        },
        text);
  };
  folds([](D a, D b) { return Uv{a, b}; }, "nothing is folded");
  folds(
      [](D a, D b) {
        return Uv{a < 0 ? -1 - a : 1 - a, b < 0 ? -1 - b : 1 - b};
      },
      "exchanges them");
  folds(
      [](D a, D b) {
        return Uv{copysign(1 - abs(b), a), copysign(1 - abs(1 - abs(b)), b)};
      },
      "old a");
  folds(
      [](D a, D b) {
        return Uv{copysign(1 - abs(b), b), copysign(1 - abs(a), a)};
      },
      "signs are exchanged");
  folds([](D a, D b) { return folded(-a, -b); }, "turned around");
  folds(
      [](D a, D b) {
        return Uv{(a < 0 ? -1 : 1) * (1 - b), (b < 0 ? -1 : 1) * (1 - a)};
      },
      "bars are missing: it is");
  folds([](D a, D b) { return Uv{1 - b, 1 - a}; }, "bars and the signs");
  folds([](D a, D b) { return Uv{a * (1 - abs(b)), b * (1 - abs(a))}; }, "counts twice");
  folds(
      [](D a, D b) {
        return Uv{copysign(1 + abs(b), a), copysign(1 + abs(a), b)};
      },
      "leaves the square");
  folds([](D a, D b) { return Uv{copysign(1 - abs(b), a), b}; }, "b is not folded");
  folds([](D a, D b) { return Uv{a, copysign(1 - abs(a), b)}; }, "a is not folded");

  // These begin with the right place (a, b).
  const auto moves = [](Uv (*move)(D a, D b), const char* text) {
    static Uv (*to_uv)(D, D);
    to_uv = move;
    check_mistake(
        "10.2",
        +[](V p) {
          const Uv right = place(p, sum(p), p.y < 0);
          return to_uv(right.u, right.v);
        },
        text);
  };
  moves([](D a, D b) { return Uv{(1 + a) / 2, 1 - (1 + b) / 2}; }, "edges are exchanged");
  moves([](D a, D b) { return Uv{a, b}; }, "from -1 to 1");
  moves([](D a, D b) { return Uv{a / 2, b / 2}; }, "from -1 to 1");
  moves([](D a, D b) { return Uv{1 + a, 1 + b}; }, "from -1 to 1");
  moves([](D a, D b) { return Uv{1 + a / 2, 1 + b / 2}; }, "comes before");
  moves([](D a, D b) { return Uv{(1 + b) / 2, (1 + a) / 2}; }, "u and v are exchanged");

  const auto named = [](Uv (*on)(V p), const char* text) { check_mistake("10.2", on, text); };
  named([](V p) { return moved(place(p, sum(p), p.y > 0)); }, "only the lower half");
  named([](V p) { return moved(place(p, sum(p), true)); }, "everywhere");
  named([](V p) { return moved(place(p, sum(p), p.z < 0)); }, "where z is below");
  named([](V p) { return moved(place(p, sqrt(p.x * p.x + p.y * p.y + p.z * p.z), p.y < 0)); },
        "not by the length");
  named([](V p) { return moved(place(p, 1, p.y < 0)); }, "any length");
  named([](V p) { return moved(place(p, p.x + p.y + p.z, p.y < 0)); },
        "missing in the sum: divide by |x|");
  named([](V p) { return moved(place(p, abs(p.x) + abs(p.z), p.y < 0)); }, "y is missing");
  named(
      [](V p) {
        return moved(place(p, std::max({abs(p.x), abs(p.y), abs(p.z)}), p.y < 0));
      },
      "cube");
  named([](V p) { return moved(place(V{-p.x, p.y, p.z}, sum(p), p.y < 0)); }, "west and east");
  named([](V p) { return moved(place(V{p.x, p.y, -p.y}, sum(p), p.y < 0)); }, "from the front");
  named(
      [](V p) {
        const double a = abs(p.x) / sum(p), b = abs(p.z) / sum(p);
        return p.y < 0 ? Uv{1 - b / 2, 1 - a / 2} : moved(place(p, sum(p), false));
      },
      "signs are missing");

  check_unknown(
      "10.2", +[](V) {
        return Uv{0.5, 0.5};
      });
}

TEST_CASE("10.3: back from the cylinder") {
  check_start("10.3", start_3::direction_of);
  check_solution("10.3", solution_3::direction_of);

  const auto named = [](V (*back)(D u, D v), const char* text) {
    static V (*direction)(D, D);
    direction = back;
    check_mistake(
        "10.3", +[](Uv uv) { return direction(uv.u, uv.v); }, text);
  };
  named([](D u, D v) { return on_circle(pi - u * 2 * pi, v * 2 - 1, 1); }, "not on the sphere");
  named([](D u, D v) { return on_circle(pi - u * 2 * pi, v * 2 - 1, v < 0.5 ? 2 * v : 2 - 2 * v); },
        "Pythagoras");
  named([](D u, D v) { return on_circle(180 - u * 360, v * 2 - 1, 2 * sqrt(v - v * v)); },
        "degrees");
  named([](D u, D v) { return on_circle(u * 2 * pi - pi, v * 2 - 1, 2 * sqrt(v - v * v)); },
        "mirrored");
  named([](D u, D v) { return on_circle(pi - u * 2 * pi, 1 - v * 2, 2 * sqrt(v - v * v)); },
        "upside down");
  named(
      [](D u, D v) { return on_circle(pi - u * 2 * pi, sin((v - 0.5) * pi), cos((v - 0.5) * pi)); },
      "no latitude");
  named(
      [](D u, D v) {
        const V right = on_circle(pi - u * 2 * pi, v * 2 - 1, 2 * sqrt(v - v * v));
        return V{right.z, right.y, right.x};
      },
      "exchanged");
  named([](D u, D v) { return on_sphere(pi - u * 2 * pi, v); }, "southern half");
  named([](D u, D v) { return on_sphere(-u * 2 * pi, 2 * v - 1); }, "half is missing");
  named([](D u, D v) { return on_sphere(u * 2 * pi, 2 * v - 1); }, "falls with u");
  named([](D u, D v) { return on_sphere((0.5 - u) * pi, 2 * v - 1); }, "half of the globe");
  named([](D u, D v) { return on_sphere((0.5 - u) / (2 * pi), 2 * v - 1); }, "do not divide");
  named([](D u, D v) { return on_sphere(0.5 - u, 2 * v - 1); }, "share of a turn");
  named([](D u, D v) { return on_sphere(0.5 - u * 2 * pi, 2 * v - 1); }, "comes before");
  named([](D u, D v) { return on_sphere((0.5 - u) * 2 * pi, v - 0.5); }, "from -1/2 to 1/2");
  named([](D u, D v) { return on_sphere((0.5 - u) * 2 * pi, v - 1); }, "then subtract 1");
  named([](D u, D v) { return on_sphere((0.5 - u) * 2 * pi, 2 * (v - 1)); }, "double v alone");
  named([](D u, D v) { return on_sphere((0.5 - u) * 2 * pi, 2 * v); }, "from 0 to 2");
  named([](D u, D v) { return on_sphere((0.5 - u) * 2 * pi, (1 + v) / 2); }, "goes forward");
  named([](D u, D v) { return on_sphere((0.5 - v) * 2 * pi, 2 * u - 1); }, "u makes the angle");

  // These begin with the right angle and the right height.
  const auto circles = [](V (*back)(D w, D y), const char* text) {
    static V (*direction)(D, D);
    direction = back;
    check_mistake(
        "10.3", +[](Uv uv) { return direction((0.5 - uv.u) * 2 * pi, 2 * uv.v - 1); }, text);
  };
  circles([](D w, D y) { return on_circle(w, y, 1 - y * y); }, "length of the result");
  circles([](D w, D y) { return on_circle(w, y, sqrt(1 - y)); }, "length of the result");
  circles([](D w, D y) { return on_circle(w, y, y); }, "length of the result");
  circles([](D w, D y) { return V{sqrt(1 - y * y) * cos(w), y, sin(w)}; }, "multiply both");
  circles([](D w, D y) { return V{cos(w), y, sqrt(1 - y * y) * sin(w)}; }, "multiply both");
  circles([](D w, D y) { return normalize(V{cos(w), y, sin(w)}); }, "do not normalize");
  circles(
      [](D w, D y) {
        return V{on_sphere(w, y).x, on_sphere(w, y).z, y};
      },
      "y is the height here");

  check_unknown(
      "10.3", +[](Uv) {
        return V{0, 0, 1};
      });
}

TEST_CASE("the questions of chapter 10 have the answers of its page") {
  check_answer("10.a", 1647100);
  check_answer("10.a", 1816 * 908);  // the smallest picture of this shape
  check_answer("10.b", 30);
}
