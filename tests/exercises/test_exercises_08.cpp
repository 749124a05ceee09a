// The exercises of chapter 08: each fails as shipped, its solution passes, each known mistake gets
// its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/08_1.hpp"
}
namespace solution_1 {
#include "exercises/08_1.hpp"
}
namespace start_2 {
#include "starts/08_2.hpp"
}
namespace solution_2 {
#include "exercises/08_2.hpp"
}
namespace start_3 {
#include "starts/08_3.hpp"
}
namespace solution_3 {
#include "exercises/08_3.hpp"
}

using namespace texmap::test;

TEST_CASE("08.1: hit or miss") {
  check_start("08.1", start_1::is_hit);
  check_solution("08.1", solution_1::is_hit);

  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        return ab >= 0 && bc >= 0 && ca >= 0;
      },
      "clockwise corners are missed");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        return ab > 0 && bc > 0 && ca > 0;
      },
      "clockwise corners are missed");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        return !(ab > 0 || bc > 0 || ca > 0);
      },
      "counterclockwise corners are missed");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        const bool left = ab > 0;
        return ab * bc * ca != 0 && (bc > 0) == left && (ca > 0) == left;
      },
      "cracks");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        return !(ab < 0 && bc < 0 && ca < 0);
      },
      "one edge is enough");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        return ab * bc >= 0;
      },
      "two edges");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        return (ab >= 0 && bc >= 0 && -ca >= 0) || (ab <= 0 && bc <= 0 && -ca <= 0);
      },
      "wrong direction");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        return !((a.x > 0 && b.x > 0 && c.x > 0) || (a.x < 0 && b.x < 0 && c.x < 0) ||
                 (a.y > 0 && b.y > 0 && c.y > 0) || (a.y < 0 && b.y < 0 && c.y < 0));
      },
      "box");
  check_unknown(
      "08.1", +[](Vec3 a, Vec3 b, Vec3 c) { return a.x + b.y + c.x > 1; });
}

TEST_CASE("08.2: the three weights") {
  check_start("08.2", start_2::weights);
  check_solution("08.2", solution_2::weights);

  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        const double s = ab + bc + ca;
        return std::array<double, 3>{ab / s, bc / s, ca / s};
      },
      "wrong corners");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        const double s = ab + bc + ca;
        return std::array<double, 3>{ca / s, ab / s, bc / s};
      },
      "wrong corners");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        const double s = ab + bc + ca;
        return std::array<double, 3>{bc / s, ab / s, ca / s};
      },
      "b and c are exchanged");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        return std::array<double, 3>{bc, ca, ab};
      },
      "areas");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - b.x * a.y;
        const double bc = b.x * c.y - c.x * b.y;
        const double ca = c.x * a.y - a.x * c.y;
        const double s = 2 * (ab + bc + ca);
        return std::array<double, 3>{bc / s, ca / s, ab / s};
      },
      "1/2");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double x = a.x * b.y + a.y * b.x;
        const double y = b.x * c.y + b.y * c.x;
        const double z = c.x * a.y + c.y * a.x;
        const double s = x + y + z;
        return std::array<double, 3>{y / s, z / s, x / s};
      },
      "subtracted");
  check_unknown(
      "08.2", +[](Vec3 a, Vec3 b, Vec3 c) {
        return std::array<double, 3>{length(a), length(b), length(c)};
      });
}

TEST_CASE("08.3: (u, v) between the corners") {
  check_start("08.3", start_3::mixed);
  check_solution("08.3", solution_3::mixed);

  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3>) {
        return Uv{a.u / 3 + b.u / 3 + c.u / 3, a.v / 3 + b.v / 3 + c.v / 3};
      },
      "count the same");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{(a.u * w[0] + b.u * w[1] + c.u * w[2]) / 3,
                  (a.v * w[0] + b.v * w[1] + c.v * w[2]) / 3};
      },
      "divided by 3");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        if (w[2] > w[0] && w[2] > w[1]) return c;
        return w[1] > w[0] ? b : a;
      },
      "largest weight");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{a.u * w[0] + c.u * w[1] + b.u * w[2], a.v * w[0] + c.v * w[1] + b.v * w[2]};
      },
      "b and c are exchanged");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{b.u * w[0] + a.u * w[1] + c.u * w[2], b.v * w[0] + a.v * w[1] + c.v * w[2]};
      },
      "a and b are exchanged");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{c.u * w[0] + b.u * w[1] + a.u * w[2], c.v * w[0] + b.v * w[1] + a.v * w[2]};
      },
      "a and c are exchanged");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{b.u * w[0] + c.u * w[1] + a.u * w[2], b.v * w[0] + c.v * w[1] + a.v * w[2]};
      },
      "next corners");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{a.v * w[0] + b.v * w[1] + c.v * w[2], a.u * w[0] + b.u * w[1] + c.u * w[2]};
      },
      "u and v are exchanged");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv, std::array<double, 3> w) {
        return Uv{a.u * w[0] + b.u * w[1], a.v * w[0] + b.v * w[1]};
      },
      "corner c is missing");
  check_unknown(
      "08.3", +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[0] + b.u, w[1] + a.v + c.u};
      });
}

TEST_CASE("08.1: more answers that students give") {
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return (ab >= 0 && bc >= 0 && ca >= 0) || (ab < 0 && bc < 0 && ca < 0);
      },
      "has cracks");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return (ab > 0) == (bc > 0) && (bc > 0) == (ca > 0);
      },
      "has cracks");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return (ab >= 0) == (bc >= 0) && (bc >= 0) == (ca >= 0);
      },
      "has cracks");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return ab > 0 || bc > 0 || ca > 0;
      },
      "one edge is enough");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return ab <= 0 || bc <= 0 || ca <= 0;
      },
      "one edge is enough");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return (ab >= 0 || bc >= 0 || ca >= 0) || (ab <= 0 || bc <= 0 || ca <= 0);
      },
      "every ray hits");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return (ab >= 0 && bc >= 0 && ca >= 0) && (ab <= 0 && bc <= 0 && ca <= 0);
      },
      "no ray hits");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return !((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0));
      },
      "hits and misses");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double ca = c.x * a.y - c.y * a.x;
        return (ab >= 0 && ca >= 0) || (ab <= 0 && ca <= 0);
      },
      "b to c is missing");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return (bc >= 0 && ca >= 0) || (bc <= 0 && ca <= 0);
      },
      "a to b is missing");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        return ab >= 0 && bc >= 0;
      },
      "c to a is missing");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return ab * bc >= 0 && bc * ca >= 0;
      },
      "on the line through");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return ab * ca >= 0 && bc * ca >= 0;
      },
      "on the line through");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return ab * bc >= 0 && ab * ca >= 0;
      },
      "on the line through");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return ab * bc * ca >= 0;
      },
      "product of three");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const bool first = (ab >= 0) == (bc >= 0);
        return first == (ca >= 0);
      },
      "p == q == r");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return ab + bc + ca >= 0;
      },
      "the sum says");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return ab + bc + ca < 0;
      },
      "the sum says");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ac = a.x * c.y - a.y * c.x;
        return ab >= 0 && bc >= 0 && ac >= 0;
      },
      "wrong direction");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double ba = b.x * a.y - b.y * a.x;
        return (ba >= 0 && bc >= 0 && ca >= 0) || (ba <= 0 && bc <= 0 && ca <= 0);
      },
      "wrong direction");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y + a.y * b.x;
        const double bc = b.x * c.y + b.y * c.x;
        const double ca = c.x * a.y + c.y * a.x;
        return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
      },
      "not added");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y + a.y * b.x;
        const double bc = b.x * c.y + b.y * c.x;
        const double ca = c.x * a.y + c.y * a.x;
        return ab >= 0 && bc >= 0 && ca >= 0;
      },
      "not added");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.x + a.y * b.y;
        const double bc = b.x * c.x + b.y * c.y;
        const double ca = c.x * a.x + c.y * a.y;
        return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
      },
      "x by y");
  check_mistake(
      "08.1",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.x - a.y * b.y;
        const double bc = b.x * c.x - b.y * c.y;
        const double ca = c.x * a.x - c.y * a.y;
        return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
      },
      "x by y");
}

TEST_CASE("08.2: more shares that students compute") {
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = ab + bc + ca;
        return std::array<double, 3>{ca / s, bc / s, ab / s};
      },
      "a and b are exchanged");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = ab + bc + ca;
        return std::array<double, 3>{ab / s, ca / s, bc / s};
      },
      "a and c are exchanged");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return std::array<double, 3>{bc / 2, ca / 2, ab / 2};
      },
      "areas");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return std::array<double, 3>{std::abs(bc) / 2, std::abs(ca) / 2, std::abs(ab) / 2};
      },
      "areas");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = (ab + bc + ca) / 2;
        return std::array<double, 3>{bc / s, ca / s, ab / s};
      },
      "sum is 2");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        return std::array<double, 3>{bc / ab + bc + ca, ca / ab + bc + ca, ab / ab + bc + ca};
      },
      "comes before");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = std::abs(ab + bc + ca);
        return std::array<double, 3>{bc / s, ca / s, ab / s};
      },
      "negative weights");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = ab + bc + ca;
        return std::array<double, 3>{std::abs(bc) / s, std::abs(ca) / s, std::abs(ab) / s};
      },
      "negative weights");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ac = a.x * c.y - a.y * c.x;
        const double s = ab + bc + ac;
        return std::array<double, 3>{bc / s, ac / s, ab / s};
      },
      "wrong direction");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = ab + bc + ca;
        return std::array<double, 3>{1 - bc / s, 1 - ca / s, 1 - ab / s};
      },
      "1 minus it");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = ab + bc + ca;
        return std::array<double, 3>{bc / s, ca / s, 1};
      },
      "the third is");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = ab + bc + ca;
        return std::array<double, 3>{bc / s, ca / s, 1 - bc / s};
      },
      "the third is");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = bc + ca;
        return std::array<double, 3>{bc / s, ca / s, ab / s};
      },
      "missing in the sum");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.y - a.y * b.x;
        const double bc = b.x * c.y - b.y * c.x;
        const double ca = c.x * a.y - c.y * a.x;
        const double s = ab + bc;
        return std::array<double, 3>{bc / s, ca / s, ab / s};
      },
      "missing in the sum");
  check_mistake(
      "08.2",
      +[](Vec3, Vec3, Vec3) {
        return std::array<double, 3>{1.0 / 3, 1.0 / 3, 1.0 / 3};
      },
      "all weights are 1/3");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.x - a.y * b.y;
        const double bc = b.x * c.x - b.y * c.y;
        const double ca = c.x * a.x - c.y * a.y;
        const double s = ab + bc + ca;
        return std::array<double, 3>{bc / s, ca / s, ab / s};
      },
      "x by y");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double ab = a.x * b.x + a.y * b.y;
        const double bc = b.x * c.x + b.y * c.y;
        const double ca = c.x * a.x + c.y * a.y;
        const double s = ab + bc + ca;
        return std::array<double, 3>{bc / s, ca / s, ab / s};
      },
      "x by y");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double s = length(a) + length(b) + length(c);
        return std::array<double, 3>{length(a) / s, length(b) / s, length(c) / s};
      },
      "not of distances");
  check_mistake(
      "08.2",
      +[](Vec3 a, Vec3 b, Vec3 c) {
        const double p = 1 / length(a);
        const double q = 1 / length(b);
        const double r = 1 / length(c);
        return std::array<double, 3>{p / (p + q + r), q / (p + q + r), r / (p + q + r)};
      },
      "not of distances");
}

TEST_CASE("08.3: more mixes that students write") {
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3>) {
        return Uv{a.u + b.u + c.u, a.v + b.v + c.v};
      },
      "no weights");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[0] * (a.u + b.u + c.u), w[0] * (a.v + b.v + c.v)};
      },
      "weights[0]: multiply");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{(1 - w[0]) * a.u + (1 - w[1]) * b.u + (1 - w[2]) * c.u,
                  (1 - w[0]) * a.v + (1 - w[1]) * b.v + (1 - w[2]) * c.v};
      },
      "1 minus each");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[0] + a.u + w[1] + b.u + w[2] + c.u, w[0] + a.v + w[1] + b.v + w[2] + c.v};
      },
      "weights are added");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[0] * a.u + w[1] * b.u + w[2] * c.u, w[0] * a.u + w[1] * b.u + w[2] * c.u};
      },
      "v is a mix of u");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[0] * a.v + w[1] * b.v + w[2] * c.v, w[0] * a.v + w[1] * b.v + w[2] * c.v};
      },
      "u is a mix of v");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[0] * a.u + w[1] * b.u + w[2] * c.u, w[0] * a.v + w[1] * b.v + w[2] * c.u};
      },
      "one product of v");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[0] * a.u + w[1] * b.u + w[2] * c.u, w[0] * a.u + w[1] * b.v + w[2] * c.v};
      },
      "one product of v");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[0] * a.u + w[1] * b.v + w[2] * c.u, w[0] * a.v + w[1] * b.v + w[2] * c.v};
      },
      "one product of u");
  check_mistake(
      "08.3",
      +[](Uv, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[1] * b.u + w[2] * c.u, w[1] * b.v + w[2] * c.v};
      },
      "corner a is missing");
  check_mistake(
      "08.3",
      +[](Uv a, Uv, Uv c, std::array<double, 3> w) {
        return Uv{w[0] * a.u + w[2] * c.u, w[0] * a.v + w[2] * c.v};
      },
      "corner b is missing");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        const double u = w[0] * a.u + w[1] * b.u + w[2] * c.u;
        const double v = w[0] * a.v + w[1] * b.v + w[2] * c.v;
        return Uv{u, 1 - v};
      },
      "turned over");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        const double u = w[0] * a.u + w[1] * b.u + w[2] * c.u;
        const double v = w[0] * a.v + w[1] * b.v + w[2] * c.v;
        return Uv{std::min(1.0, std::max(0.0, u)), std::min(1.0, std::max(0.0, v))};
      },
      "leave 0 to 1");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        const double u = w[0] * a.u + w[1] * b.u + w[2] * c.u;
        const double v = w[0] * a.v + w[1] * b.v + w[2] * c.v;
        return Uv{u - std::floor(u), v - std::floor(v)};
      },
      "leave 0 to 1");
  check_mistake(
      "08.3",
      +[](Uv a, Uv b, Uv c, std::array<double, 3> w) {
        return Uv{w[2] * a.u + w[0] * b.u + w[1] * c.u, w[2] * a.v + w[0] * b.v + w[1] * c.v};
      },
      "next corners");
}

TEST_CASE("the questions of chapter 08 have the answers of its page") {
  check_answer("08.a", 0.2);
  check_answer("08.b", 0.3);
}
