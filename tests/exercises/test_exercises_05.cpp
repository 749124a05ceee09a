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

using V = Vec3;
using D = double;
using std::cos, std::floor, std::fmod, std::sin;

namespace {

double radians(D degrees) { return degrees * pi / 180; }
double radians_too(D degrees) { return degrees / 180 * pi; }  // rounds in another way

// What is left without full turns.
double rest(D x) { return x - floor(x); }

// Turned about the y axis and about the z axis, by an angle with this sine and cosine.
V about_y(V p, D s, D c) { return {p.x * c + p.z * s, p.y, p.z * c - p.x * s}; }
V about_z(V p, D s, D c) { return {p.x * c - p.y * s, p.x * s + p.y * c, p.z}; }

// A point after the turn by b, and after the lean by a.
V spun(V p, D b) { return about_y(p, sin(b), cos(b)); }
V tilted(V p, D a) { return about_z(p, sin(a), cos(a)); }

}  // namespace

TEST_CASE("05.1: turn a direction") {
  check_start("05.1", start_1::turned);
  check_solution("05.1", solution_1::turned);

  const auto named = [](V (*turned)(V p, D s, D c), const char* text, D (*angle)(D) = radians) {
    static V (*by_sine)(V, D, D);
    static D (*angle_of)(D);
    by_sine = turned;
    angle_of = angle;
    check_mistake(
        "05.1",
        +[](V p, D degrees) { return by_sine(p, sin(angle_of(degrees)), cos(angle_of(degrees))); },
        text);
  };
  named(about_y, "radians", [](D degrees) { return degrees; });
  named(about_y, "exchanged", [](D degrees) { return pi / 2 - degrees / 180 * pi; });
  named(about_y, "half of the angle", [](D degrees) { return degrees / 360 * pi; });
  named(about_y, "pi and 180", [](D degrees) { return degrees * 180 / pi; });
  named(about_y, "twice the angle", [](D degrees) { return degrees / 180 * 2 * pi; });
  named(about_y, "digits", [](D degrees) { return degrees * 3.14159 / 180; });
  named(about_y, "digits", [](D degrees) { return degrees * 3.14 / 180; });
  named([](V p, D s, D c) { return about_y(p, -s, c); }, "other way around", radians_too);
  named(
      [](V p, D s, D c) {
        return V{p.x * c + p.z * s, p.y, p.z * c - (p.x * c + p.z * s) * s};
      },
      "new z", radians_too);
  named(
      [](V p, D s, D c) {
        return V{p.x * c + p.y * s, p.y * c - p.x * s, p.z};
      },
      "z axis", radians_too);
  named([](V p, D s, D c) { return V{p.x * c + p.z * s, p.y, p.z * c + p.x * s}; }, "one sine");
  named([](V p, D s, D c) { return V{p.x * c - p.z * s, p.y, p.z * c - p.x * s}; }, "one sine");
  named(
      [](V p, D s, D c) {
        return V{p.x * c + (p.z * c - p.x * s) * s, p.y, p.z * c - p.x * s};
      },
      "new x is computed");
  named(
      [](V p, D s, D c) {
        return V{p.x * c - p.z * s, p.y, p.z * c + (p.x * c - p.z * s) * s};
      },
      "new z is computed");
  named(about_z, "z axis");
  named(
      [](V p, D s, D c) {
        return V{p.x, p.y * c - p.z * s, p.y * s + p.z * c};
      },
      "about the x axis");
  named([](V p, D s, D c) { return V{p.x * c + p.z * s, p.y, p.z}; }, "z is not turned");
  named([](V p, D s, D c) { return V{p.x, p.y, p.z * c - p.x * s}; }, "x is not turned");
  named([](V p, D s, D) { return V{p.x + p.z * s, p.y, p.z - p.x * s}; }, "cosines are missing");
  named([](V p, D, D c) { return V{p.x * c, p.y, p.z * c}; }, "sines are missing");
  named([](V p, D s, D c) { return V{s, p.y, c}; }, "+z alone");
  named([](V p, D s, D c) { return V{p.z * s, 0, p.z * c}; }, "+z alone");
  named([](V p, D s, D c) { return V{p.x * c + p.z * s, 0, p.z * c - p.x * s}; }, "y is missing");
  named(
      [](V p, D s, D c) {
        return V{p.z * c - p.x * s, p.y, p.x * c + p.z * s};
      },
      "in what you return");
  named([](V p, D s, D c) { return V{p.x * c + p.z * s, p.y, p.x * c - p.z * s}; }, "in the new z");
  named([](V p, D s, D c) { return V{p.x * s + p.z * c, p.y, p.z * c - p.x * s}; }, "in the new x");
  named(
      [](V p, D s, D c) {
        return V{p.z * c + p.x * s, p.y, p.x * c - p.z * s};
      },
      "keeps its cosine");

  check_unknown(
      "05.1", +[](V p, D degrees) {
        return V{p.z, p.y, p.x * degrees};
      });
}

TEST_CASE("05.2: u after a turn") {
  check_start("05.2", start_2::u_after);
  check_solution("05.2", solution_2::u_after);

  using After = D (*)(D u, D g);  // g is the degrees
  const auto named = [](After after, const char* text) { check_mistake("05.2", after, text); };
  named([](D u, D g) { return std::max(0., std::min(1., u + g / 360)); }, "limit");
  named([](D u, D g) { return rest(u - g / 360); }, "wrong sign");
  named([](D u, D g) { return rest(u + g / 180); }, "not by 180");
  named([](D u, D g) { return rest(u + g * pi / 180); }, "not radians");
  named([](D u, D g) { return u + g / 360 - floor(g / 360); }, "add first");
  named([](D u, D g) { return u + g / 360 - static_cast<int>(g / 360); }, "add first");
  named([](D u, D g) { return rest(u + static_cast<int>(g) / 360.0); }, "whole degrees");
  named([](D u, D g) { return u + static_cast<int>(g) % 360 / 360; }, "no effect");
  named([](D u, D g) { return u - g / 360; }, "wrong sign");
  named([](D u, D g) { return fmod(u - g / 360, 1); }, "wrong sign");
  named([](D u, D g) { return fmod(u + g / 180, 1); }, "not by 180");
  named([](D u, D g) { return u + g / 180 * pi; }, "not radians");
  named([](D u, D g) { return rest(u + g / (2 * pi)); }, "full turn in radians");
  named([](D u, D g) { return rest(u + g); }, "not degrees");
  named([](D u, D g) { return (u + g) / 360; }, "same unit");
  named([](D u, D g) { return rest((u + g) / 360); }, "same unit");
  named([](D u, D g) { return fmod(u + g, 360) / 360; }, "same unit");
  named([](D u, D g) { return rest(u * g / 360); }, "not multiplied");
  named([](D, D g) { return rest(g / 360); }, "old u is missing");
  named([](D u, D g) { return u * 360 + g - 360 * floor((u * 360 + g) / 360); },
        "divide it by 360");
  named([](D u, D g) { return fmod(u * 360 + g, 360); }, "divide it by 360");

  // These begin with the right sum.
  const auto wraps = [](D (*wrap)(D x), const char* text) {
    static D (*wrapped)(D);
    wrapped = wrap;
    check_mistake(
        "05.2", +[](D u, D degrees) { return wrapped(u + degrees / 360); }, text);
  };
  wraps([](D x) { return x; }, "leaves 0 to 1");
  wraps([](D x) { return x - static_cast<int>(x); }, "std::floor");
  wraps([](D x) { return x >= 1 ? x - 1 : x < 0 ? x + 1 : x; }, "several");
  wraps([](D x) { return x > 1 ? x - 1 : x < 0 ? x + 1 : x; }, "several full turns");
  wraps([](D x) { return std::abs(x - static_cast<int>(x)); }, "without its sign");
  wraps([](D x) { return std::remainder(x, 1); }, "nearest whole");
  wraps([](D x) { return x - std::ceil(x); }, "std::ceil");
  wraps([](D x) { return floor(x); }, "number of full turns");
  wraps(
      [](D x) {
        while (x > 1) x -= 1;
        while (x < 0) x += 1;
        return x;
      },
      "seam again");

  check_unknown(
      "05.2", +[](D u, D degrees) { return u * u + degrees; });
}

TEST_CASE("05.3: a leaning axis") {
  check_start("05.3", start_3::looked_up);
  check_solution("05.3", solution_3::looked_up);

  const auto degrees = [](V (*up)(V p, D lean, D turn), const char* text) {
    check_mistake("05.3", up, text);
  };
  degrees([](V p, D lean, D turn) { return spun(tilted(p, lean), turn); }, "radians");
  degrees([](V p, D lean, D turn) { return spun(tilted(p, radians(lean)), turn); }, "radians");
  degrees([](V p, D lean, D turn) { return spun(tilted(p, lean), radians(turn)); }, "radians");
  degrees([](V p, D lean, D turn) { return spun(p, radians(lean + turn)); }, "turn of x and y");
  degrees([](V p, D lean, D turn) { return spun(tilted(p, lean * pi / 360), turn * pi / 360); },
          "half of the angles");

  // These begin with the right angles: a is the lean, b is the turn.
  const auto named = [](V (*up)(V p, D a, D b), const char* text) {
    static V (*looked_up)(V, D, D);
    looked_up = up;
    check_mistake(
        "05.3", +[](V p, D lean, D turn) { return looked_up(p, radians(lean), radians(turn)); },
        text);
  };
  named([](V p, D a, D b) { return tilted(spun(p, b), a); }, "turn comes first");
  named([](V p, D a, D b) { return spun(tilted(p, -a), b); }, "to the left");
  named([](V p, D a, D b) { return spun(tilted(p, a), -b); }, "wrong sign");
  named([](V p, D, D b) { return spun(p, b); }, "does not lean");
  named([](V p, D a, D) { return tilted(p, a); }, "does not turn");
  named([](V p, D a, D) { return tilted(p, -a); }, "does not turn");
  named([](V p, D a, D b) { return tilted(spun(p, b), -a); }, "and the axis leans");
  named([](V p, D a, D b) { return spun(tilted(p, -a), -b); }, "both turns");
  named([](V p, D a, D b) { return tilted(spun(tilted(p, a), b), -a); }, "comes back");
  named([](V p, D a, D b) { return spun(tilted(p, b), a); }, "two angles are exchanged");
  named([](V p, D, D b) { return spun(tilted(p, radians(23.4)), b); }, "always leans");
  named(
      [](V p, D a, D b) {
        return spun(V{p.x, p.y * cos(a) - p.z * sin(a), p.y * sin(a) + p.z * cos(a)}, b);
      },
      "to the eye");
  named(
      [](V p, D a, D b) {
        return spun(V{tilted(p, a).x, tilted(p, a).x * sin(a) + p.y * cos(a), p.z}, b);
      },
      "new y is computed");
  named(
      [](V p, D a, D b) {
        return spun(V{tilted(p, a).x, tilted(p, -a).y, p.z}, b);
      },
      "sine of the lean");
  named(
      [](V p, D a, D b) {
        return spun(V{tilted(p, -a).x, tilted(p, a).y, p.z}, b);
      },
      "sine of the lean");
  named([](V p, D a, D b) { return spun(about_z(p, cos(a), sin(a)), b); },
        "of the lean are exchanged");
  named([](V p, D a, D b) { return about_y(about_z(p, cos(a), sin(a)), cos(b), sin(b)); },
        "both angles are exchanged");

  // These begin with the right angles and with q, the point after the lean.
  const auto turns = [](V (*up)(V p, V q, D b), const char* text) {
    static V (*looked_up)(V, V, D);
    looked_up = up;
    check_mistake(
        "05.3",
        +[](V p, D lean, D turn) { return looked_up(p, tilted(p, radians(lean)), radians(turn)); },
        text);
  };
  turns([](V p, V q, D b) { return V{spun(p, b).x, q.y, spun(p, b).z}; }, "you turn p");
  turns([](V p, V q, D b) { return V{spun(q, b).x, q.y, spun(p, b).z}; }, "you turn p");
  turns([](V p, V q, D b) { return V{spun(q, b).x, p.y, spun(q, b).z}; }, "y comes from p");
  turns(
      [](V, V q, D b) {
        return V{spun(q, b).x, q.y, q.z * cos(b) - spun(q, b).x * sin(b)};
      },
      "new z is computed");
  turns([](V, V q, D b) { return V{spun(q, b).x, q.y, spun(q, -b).z}; }, "sine of the turn");
}

TEST_CASE("the questions of chapter 05 have the answers of its page") {
  check_answer("05.a", 45);
  check_answer("05.b", 90);
}
