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

TEST_CASE("10.1: onto a cylinder") {
  check_start("10.1", start_1::on_cylinder);
  check_solution("10.1", solution_1::on_cylinder);

  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x) / (2 * pi) + 0.5, 1 - std::acos(p.y) / pi};
      },
      "equirectangular");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{std::atan2(p.z, p.x) / (2 * pi) + 0.5, 0.5 * p.y + 0.5};
      },
      "mirrored");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 + std::atan2(-p.z, p.x) / (2 * pi), 0.5 - 0.5 * p.y};
      },
      "upside down");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 + std::atan2(-p.z, p.x) / (2 * pi), p.y};
      },
      "lower half");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{(180 - std::atan2(p.z, p.x)) / 360, (p.y + 1) / 2};
      },
      "radians");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{-std::atan2(p.z, p.x) / 2 / pi, (p.y + 1) / 2};
      },
      "half is missing");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{(pi - std::atan2(p.x, p.z)) / (2 * pi), (p.y + 1) / 2};
      },
      "z first");
  check_unknown(
      "10.1", +[](Vec3 p) {
        return Uv{p.z, p.y};
      });
}

TEST_CASE("10.2: fold an octahedron out") {
  check_start("10.2", start_2::on_octahedron);
  check_solution("10.2", solution_2::on_octahedron);

  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        return Uv{0.5 + p.x / s / 2, 0.5 - p.z / s / 2};
      },
      "nothing is folded");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        const double a = std::abs(p.x) / s, b = std::abs(p.z) / s;
        if (p.y < 0) return Uv{1 - b / 2, 1 - a / 2};
        return Uv{(1 + p.x / s) / 2, (1 - p.z / s) / 2};
      },
      "signs are missing");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s, b = -p.z / s;
        if (p.y < 0) {
          a = a < 0 ? -1 - a : 1 - a;
          b = b < 0 ? -1 - b : 1 - b;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "exchanges them");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s, b = -p.z / s;
        if (p.y < 0) {
          a = (a < 0 ? -1 : 1) * (1 - std::abs(b));
          b = (b < 0 ? -1 : 1) * (1 - std::abs(a));
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "old a");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const Uv uv = solution_2::on_octahedron(p);
        return Uv{uv.u, 1 - uv.v};
      },
      "edges are exchanged");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        const double a = p.x / s, b = -p.z / s;
        if (p.y <= 0) return Uv{(1 + a) / 2, (1 + b) / 2};
        return Uv{(1 + std::copysign(1 - std::abs(b), a)) / 2,
                  (1 + std::copysign(1 - std::abs(a), b)) / 2};
      },
      "only the lower half");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
        const double a = p.x / s, b = -p.z / s;
        if (p.y >= 0) return Uv{(1 + a) / 2, (1 + b) / 2};
        return Uv{(1 + std::copysign(1 - std::abs(b), a)) / 2,
                  (1 + std::copysign(1 - std::abs(a), b)) / 2};
      },
      "not by the length");
  check_unknown(
      "10.2", +[](Vec3) {
        return Uv{0.5, 0.5};
      });
}

TEST_CASE("10.3: back from the cylinder") {
  check_start("10.3", start_3::direction_of);
  check_solution("10.3", solution_3::direction_of);

  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double angle = pi - uv.u * 2 * pi;
        return Vec3{std::cos(angle), uv.v * 2 - 1, std::sin(angle)};
      },
      "not on the sphere");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double angle = pi - uv.u * 2 * pi;
        const double radius = uv.v < 0.5 ? 2 * uv.v : 2 - 2 * uv.v;
        return Vec3{radius * std::cos(angle), uv.v * 2 - 1, radius * std::sin(angle)};
      },
      "Pythagoras");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double angle = 180 - uv.u * 360;
        const double radius = 2 * std::sqrt(uv.v - uv.v * uv.v);
        return Vec3{radius * std::cos(angle), uv.v * 2 - 1, radius * std::sin(angle)};
      },
      "degrees");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double angle = uv.u * 2 * pi - pi;
        const double radius = 2 * std::sqrt(uv.v - uv.v * uv.v);
        return Vec3{radius * std::cos(angle), uv.v * 2 - 1, radius * std::sin(angle)};
      },
      "mirrored");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double angle = pi - uv.u * 2 * pi;
        const double radius = 2 * std::sqrt(uv.v - uv.v * uv.v);
        return Vec3{radius * std::cos(angle), 1 - uv.v * 2, radius * std::sin(angle)};
      },
      "upside down");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double longitude = pi - uv.u * 2 * pi, latitude = (uv.v - 0.5) * pi;
        return Vec3{std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                    std::cos(latitude) * std::sin(longitude)};
      },
      "no latitude");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double angle = pi - uv.u * 2 * pi;
        const double radius = 2 * std::sqrt(uv.v - uv.v * uv.v);
        return Vec3{radius * std::sin(angle), uv.v * 2 - 1, radius * std::cos(angle)};
      },
      "exchanged");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double angle = pi - uv.u * 2 * pi;
        const double radius = std::sqrt(1 - uv.v * uv.v);
        return Vec3{radius * std::cos(angle), uv.v, radius * std::sin(angle)};
      },
      "southern half");
  check_unknown(
      "10.3", +[](Uv) {
        return Vec3{0, 0, 1};
      });
}

TEST_CASE("10.1: more places that students compute") {
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / (2 * pi), std::acos(p.y) / pi};
      },
      "equirectangular");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / (2 * pi), std::abs(p.y)};
      },
      "lower half");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / (2 * pi), 1 + p.y};
      },
      "halve 1 + y");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / (2 * pi), 1 + p.y / 2};
      },
      "write (1 + y) / 2");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / (2 * pi), p.y / 2};
      },
      "-1/2 to 1/2");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / (2 * pi), p.y + 0.5};
      },
      "halve it");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / (2 * pi), 2 * p.y - 1};
      },
      "goes back");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{-std::atan2(p.z, p.x) / (2 * pi), p.y};
      },
      "int is 0");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{std::atan2(p.z, p.x) / (2 * pi), (p.y + 1) / 2};
      },
      "and begins at -1/2");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / pi, (p.y + 1) / 2};
      },
      "not pi: u");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / 2 * pi, (p.y + 1) / 2};
      },
      "multiplies by pi");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x), (p.y + 1) / 2};
      },
      "no share");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{(0.5 - std::atan2(p.z, p.x)) / (2 * pi), (p.y + 1) / 2};
      },
      "the angle alone");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{1 - std::atan2(p.z, p.x) / (2 * pi), (p.y + 1) / 2};
      },
      "off by 1/2");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 + std::atan2(p.x, p.z) / (2 * pi), (p.y + 1) / 2};
      },
      "z first");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan(p.z / p.x) / (2 * pi), (p.y + 1) / 2};
      },
      "from the back");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.y, p.x) / (2 * pi), (p.y + 1) / 2};
      },
      "y is the axis");
  check_mistake(
      "10.1",
      +[](Vec3 p) {
        return Uv{(p.y + 1) / 2, 0.5 - std::atan2(p.z, p.x) / (2 * pi)};
      },
      "u and v are exchanged");
}

TEST_CASE("10.2: more folds that students write") {
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), b);
          const double d = std::copysign(1 - std::abs(a), a);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "signs are exchanged");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), -a);
          const double d = std::copysign(1 - std::abs(a), -b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "turned around");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = (a < 0 ? -1.0 : 1.0) * (1 - b);
          const double d = (b < 0 ? -1.0 : 1.0) * (1 - a);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "bars are missing: it is");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = 1 - b;
          const double d = 1 - a;
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "bars and the signs");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = a * (1 - std::abs(b));
          const double d = b * (1 - std::abs(a));
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "counts twice");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 + std::abs(b), a);
          const double d = std::copysign(1 + std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "leaves the square");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = b;
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "b is not folded");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = a;
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "a is not folded");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = -p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "west and east");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        const double c = std::copysign(1 - std::abs(b), a);
        return Uv{(1 + c) / 2, (1 + std::copysign(1 - std::abs(a), b)) / 2};
      },
      "everywhere");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.z < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "where z is below");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        double a = p.x;
        double b = -p.z;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "any length");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = p.x + p.y + p.z;
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "missing in the sum: divide by |x|");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "y is missing");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::max(std::abs(p.x), std::max(std::abs(p.y), std::abs(p.z)));
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "cube");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = p.y / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + a) / 2, (1 + b) / 2};
      },
      "from the front");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{a, b};
      },
      "from -1 to 1");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{a / 2, b / 2};
      },
      "from -1 to 1");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{1 + a, 1 + b};
      },
      "from -1 to 1");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{1 + a / 2, 1 + b / 2};
      },
      "comes before");
  check_mistake(
      "10.2",
      +[](Vec3 p) {
        const double s = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
        double a = p.x / s;
        double b = -p.z / s;
        if (p.y < 0) {
          const double c = std::copysign(1 - std::abs(b), a);
          const double d = std::copysign(1 - std::abs(a), b);
          a = c;
          b = d;
        }
        return Uv{(1 + b) / 2, (1 + a) / 2};
      },
      "u and v are exchanged");
}

TEST_CASE("10.3: more directions that students compute") {
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = 1 - y * y;
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "length of the result");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "length of the result");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = y;
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "length of the result");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, std::sin(w)};
      },
      "multiply both");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{std::cos(w), y, r * std::sin(w)};
      },
      "multiply both");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        return normalize(Vec3{std::cos(w), 2 * uv.v - 1, std::sin(w)});
      },
      "do not normalize");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = -uv.u * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "half is missing");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = uv.u * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "falls with u");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * pi;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "half of the globe");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) / (2 * pi);
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "do not divide");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = 0.5 - uv.u;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "share of a turn");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = 0.5 - uv.u * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "comes before");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = uv.v - 0.5;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "from -1/2 to 1/2");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "then subtract 1");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = 2 * (uv.v - 1);
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "double v alone");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = 2 * uv.v;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "from 0 to 2");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = (1 + uv.v) / 2;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "goes forward");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.u) * 2 * pi;
        const double y = 2 * uv.v - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), r * std::sin(w), y};
      },
      "y is the height here");
  check_mistake(
      "10.3",
      +[](Uv uv) {
        const double w = (0.5 - uv.v) * 2 * pi;
        const double y = 2 * uv.u - 1;
        const double r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(w), y, r * std::sin(w)};
      },
      "u makes the angle");
}

TEST_CASE("the questions of chapter 10 have the answers of its page") {
  check_answer("10.a", 1647100);
  check_answer("10.a", 1816 * 908);  // the smallest picture of this shape
  check_answer("10.b", 30);
}
