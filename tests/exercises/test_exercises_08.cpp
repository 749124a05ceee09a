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

using V = Vec3;
using D = double;
using Weights = std::array<double, 3>;
using Edge = double (*)(V a, V b);
using std::abs;

namespace {

double right_edge(V a, V b) { return a.x * b.y - a.y * b.x; }

// Is the ray on this side of all three edges?
bool left(D ab, D bc, D ca) { return ab >= 0 && bc >= 0 && ca >= 0; }
bool right(D ab, D bc, D ca) { return ab <= 0 && bc <= 0 && ca <= 0; }
bool inside(D ab, D bc, D ca) { return left(ab, bc, ca) || right(ab, bc, ca); }

double mix(Weights w, D a, D b, D c) { return w[0] * a + w[1] * b + w[2] * c; }

}  // namespace

TEST_CASE("08.1: hit or miss") {
  check_start("08.1", start_1::is_hit);
  check_solution("08.1", solution_1::is_hit);

  const auto named = [](bool (*hit)(D ab, D bc, D ca), const char* text, Edge edge = right_edge) {
    static bool (*of_edges)(D, D, D);
    static Edge edge_of;
    of_edges = hit;
    edge_of = edge;
    check_mistake(
        "08.1",
        +[](V a, V b, V c) { return of_edges(edge_of(a, b), edge_of(b, c), edge_of(c, a)); }, text);
  };
  named(left, "clockwise corners are missed");
  named([](D ab, D bc, D ca) { return ab > 0 && bc > 0 && ca > 0; },
        "clockwise corners are missed");
  named([](D ab, D bc, D ca) { return !(ab > 0 || bc > 0 || ca > 0); },
        "counterclockwise corners are missed");
  named(
      [](D ab, D bc, D ca) {
        const bool first = ab > 0;
        return ab * bc * ca != 0 && (bc > 0) == first && (ca > 0) == first;
      },
      "cracks");
  named([](D ab, D bc, D ca) { return left(ab, bc, ca) || (ab < 0 && bc < 0 && ca < 0); },
        "has cracks");
  named([](D ab, D bc, D ca) { return (ab > 0) == (bc > 0) && (bc > 0) == (ca > 0); },
        "has cracks");
  named([](D ab, D bc, D ca) { return (ab >= 0) == (bc >= 0) && (bc >= 0) == (ca >= 0); },
        "has cracks");
  named([](D ab, D bc, D ca) { return !(ab < 0 && bc < 0 && ca < 0); }, "one edge is enough");
  named([](D ab, D bc, D ca) { return ab > 0 || bc > 0 || ca > 0; }, "one edge is enough");
  named([](D ab, D bc, D ca) { return ab <= 0 || bc <= 0 || ca <= 0; }, "one edge is enough");
  named([](D p, D q, D r) { return (p >= 0 || q >= 0 || r >= 0) || (p <= 0 || q <= 0 || r <= 0); },
        "every ray hits");
  named([](D ab, D bc, D ca) { return left(ab, bc, ca) && right(ab, bc, ca); }, "no ray hits");
  named([](D ab, D bc, D ca) { return !inside(ab, bc, ca); }, "hits and misses");
  named([](D ab, D bc, D) { return ab * bc >= 0; }, "two edges");
  named([](D ab, D, D ca) { return (ab >= 0 && ca >= 0) || (ab <= 0 && ca <= 0); },
        "b to c is missing");
  named([](D, D bc, D ca) { return (bc >= 0 && ca >= 0) || (bc <= 0 && ca <= 0); },
        "a to b is missing");
  named([](D ab, D bc, D) { return ab >= 0 && bc >= 0; }, "c to a is missing");
  named([](D ab, D bc, D ca) { return ab * bc >= 0 && bc * ca >= 0; }, "on the line through");
  named([](D ab, D bc, D ca) { return ab * ca >= 0 && bc * ca >= 0; }, "on the line through");
  named([](D ab, D bc, D ca) { return ab * bc >= 0 && ab * ca >= 0; }, "on the line through");
  named([](D ab, D bc, D ca) { return ab * bc * ca >= 0; }, "product of three");
  named([](D ab, D bc, D ca) { return ((ab >= 0) == (bc >= 0)) == (ca >= 0); }, "p == q == r");
  named([](D ab, D bc, D ca) { return ab + bc + ca >= 0; }, "the sum says");
  named([](D ab, D bc, D ca) { return ab + bc + ca < 0; }, "the sum says");
  named([](D ab, D bc, D ca) { return left(ab, bc, -ca); }, "wrong direction");
  named([](D ab, D bc, D ca) { return inside(ab, bc, -ca); }, "wrong direction");
  named([](D ab, D bc, D ca) { return inside(-ab, bc, ca); }, "wrong direction");
  named(inside, "not added", [](V a, V b) { return a.x * b.y + a.y * b.x; });
  named(left, "not added", [](V a, V b) { return a.x * b.y + a.y * b.x; });
  named(inside, "x by y", [](V a, V b) { return a.x * b.x + a.y * b.y; });
  named(inside, "x by y", [](V a, V b) { return a.x * b.x - a.y * b.y; });

  check_mistake(
      "08.1",
      +[](V a, V b, V c) {
        return !((a.x > 0 && b.x > 0 && c.x > 0) || (a.x < 0 && b.x < 0 && c.x < 0) ||
                 (a.y > 0 && b.y > 0 && c.y > 0) || (a.y < 0 && b.y < 0 && c.y < 0));
      },
      "box");
  check_unknown(
      "08.1", +[](V a, V b, V c) { return a.x + b.y + c.x > 1; });
}

TEST_CASE("08.2: the three weights") {
  check_start("08.2", start_2::weights);
  check_solution("08.2", solution_2::weights);

  using W = Weights;
  using Shares = W (*)(D ab, D bc, D ca, D s);  // s is the sum of the three
  const auto named = [](Shares shares, const char* text, Edge edge = right_edge) {
    static Shares of_edges;
    static Edge edge_of;
    of_edges = shares;
    edge_of = edge;
    check_mistake(
        "08.2",
        +[](V a, V b, V c) {
          const double ab = edge_of(a, b), bc = edge_of(b, c), ca = edge_of(c, a);
          return of_edges(ab, bc, ca, ab + bc + ca);
        },
        text);
  };
  named([](D ab, D bc, D ca, D s) { return W{ab / s, bc / s, ca / s}; }, "wrong corners");
  named([](D ab, D bc, D ca, D s) { return W{ca / s, ab / s, bc / s}; }, "wrong corners");
  named([](D ab, D bc, D ca, D s) { return W{bc / s, ab / s, ca / s}; }, "b and c are exchanged");
  named([](D ab, D bc, D ca, D s) { return W{ca / s, bc / s, ab / s}; }, "a and b are exchanged");
  named([](D ab, D bc, D ca, D s) { return W{ab / s, ca / s, bc / s}; }, "a and c are exchanged");
  named([](D ab, D bc, D ca, D) { return W{bc, ca, ab}; }, "areas");
  named([](D ab, D bc, D ca, D) { return W{bc / 2, ca / 2, ab / 2}; }, "areas");
  named([](D ab, D bc, D ca, D) { return W{abs(bc) / 2, abs(ca) / 2, abs(ab) / 2}; }, "areas");
  named([](D ab, D bc, D ca, D s) { return W{bc / (2 * s), ca / (2 * s), ab / (2 * s)}; }, "1/2");
  named(
      [](D ab, D bc, D ca, D s) {
        return W{bc / (s / 2), ca / (s / 2), ab / (s / 2)};
      },
      "sum is 2");
  named(
      [](D ab, D bc, D ca, D) {
        return W{bc / ab + bc + ca, ca / ab + bc + ca, ab / ab + bc + ca};
      },
      "comes before");
  named(
      [](D ab, D bc, D ca, D s) {
        return W{bc / abs(s), ca / abs(s), ab / abs(s)};
      },
      "negative weights");
  named(
      [](D ab, D bc, D ca, D s) {
        return W{abs(bc) / s, abs(ca) / s, abs(ab) / s};
      },
      "negative weights");
  named(
      [](D ab, D bc, D ca, D) {
        return W{bc / (ab + bc - ca), -ca / (ab + bc - ca), ab / (ab + bc - ca)};
      },
      "wrong direction");
  named([](D ab, D bc, D ca, D s) { return W{1 - bc / s, 1 - ca / s, 1 - ab / s}; }, "1 minus it");
  named([](D, D bc, D ca, D s) { return W{bc / s, ca / s, 1}; }, "the third is");
  named([](D, D bc, D ca, D s) { return W{bc / s, ca / s, 1 - bc / s}; }, "the third is");
  named(
      [](D ab, D bc, D ca, D) {
        return W{bc / (bc + ca), ca / (bc + ca), ab / (bc + ca)};
      },
      "missing in the sum");
  named(
      [](D ab, D bc, D ca, D) {
        return W{bc / (ab + bc), ca / (ab + bc), ab / (ab + bc)};
      },
      "missing in the sum");
  named([](D, D, D, D) { return W{1.0 / 3, 1.0 / 3, 1.0 / 3}; }, "all weights are 1/3");

  const auto right = [](D ab, D bc, D ca, D s) { return W{bc / s, ca / s, ab / s}; };
  named(right, "subtracted", [](V a, V b) { return a.x * b.y + a.y * b.x; });
  named(right, "x by y", [](V a, V b) { return a.x * b.x - a.y * b.y; });
  named(right, "x by y", [](V a, V b) { return a.x * b.x + a.y * b.y; });
  const auto in_order = [](D a, D b, D c, D s) { return W{a / s, b / s, c / s}; };
  named(in_order, "not of distances", [](V a, V) { return length(a); });
  named(in_order, "not of distances", [](V a, V) { return 1 / length(a); });

  check_unknown(
      "08.2", +[](V a, V b, V c) {
        return W{length(a), length(b), length(c)};
      });
}

TEST_CASE("08.3: (u, v) between the corners") {
  check_start("08.3", start_3::mixed);
  check_solution("08.3", solution_3::mixed);

  using W = Weights;
  // These mix u and v in the same way.
  const auto named = [](double (*mix_of)(D a, D b, D c, W w), const char* text) {
    static double (*channel)(D, D, D, W);
    channel = mix_of;
    check_mistake(
        "08.3",
        +[](Uv a, Uv b, Uv c, W w) {
          return Uv{channel(a.u, b.u, c.u, w), channel(a.v, b.v, c.v, w)};
        },
        text);
  };
  named([](D a, D b, D c, W) { return a / 3 + b / 3 + c / 3; }, "count the same");
  named([](D a, D b, D c, W w) { return mix(w, a, b, c) / 3; }, "divided by 3");
  named([](D a, D b, D c, W w) { return mix(w, a, c, b); }, "b and c are exchanged");
  named([](D a, D b, D c, W w) { return mix(w, b, a, c); }, "a and b are exchanged");
  named([](D a, D b, D c, W w) { return mix(w, c, b, a); }, "a and c are exchanged");
  named([](D a, D b, D c, W w) { return mix(w, b, c, a); }, "next corners");
  named([](D a, D b, D c, W w) { return w[2] * a + w[0] * b + w[1] * c; }, "next corners");
  named([](D, D b, D c, W w) { return w[1] * b + w[2] * c; }, "corner a is missing");
  named([](D a, D, D c, W w) { return w[0] * a + w[2] * c; }, "corner b is missing");
  named([](D a, D b, D, W w) { return w[0] * a + w[1] * b; }, "corner c is missing");
  named([](D a, D b, D c, W) { return a + b + c; }, "no weights");
  named([](D a, D b, D c, W w) { return w[0] * (a + b + c); }, "weights[0]: multiply");
  named([](D a, D b, D c, W w) { return (1 - w[0]) * a + (1 - w[1]) * b + (1 - w[2]) * c; },
        "1 minus each");
  named([](D a, D b, D c, W w) { return w[0] + a + w[1] + b + w[2] + c; }, "weights are added");
  named([](D a, D b, D c, W w) { return std::clamp(mix(w, a, b, c), 0.0, 1.0); }, "leave 0 to 1");
  named([](D a, D b, D c, W w) { return mix(w, a, b, c) - std::floor(mix(w, a, b, c)); },
        "leave 0 to 1");

  // These begin with the right u and v.
  const auto mixed = [](Uv (*result)(D u, D v), const char* text) {
    static Uv (*of_mix)(D, D);
    of_mix = result;
    check_mistake(
        "08.3",
        +[](Uv a, Uv b, Uv c, W w) { return of_mix(mix(w, a.u, b.u, c.u), mix(w, a.v, b.v, c.v)); },
        text);
  };
  mixed([](D u, D v) { return Uv{v, u}; }, "u and v are exchanged");
  mixed([](D u, D) { return Uv{u, u}; }, "v is a mix of u");
  mixed([](D, D v) { return Uv{v, v}; }, "u is a mix of v");
  mixed([](D u, D v) { return Uv{u, 1 - v}; }, "turned over");

  using Mixed = Uv (*)(Uv a, Uv b, Uv c, W w);
  const auto whole = [](Mixed mix_of, const char* text) { check_mistake("08.3", mix_of, text); };
  whole(
      [](Uv a, Uv b, Uv c, W w) {
        return Uv{mix(w, a.u, b.u, c.u), mix(w, a.v, b.v, c.u)};
      },
      "one product of v");
  whole(
      [](Uv a, Uv b, Uv c, W w) {
        return Uv{mix(w, a.u, b.u, c.u), mix(w, a.u, b.v, c.v)};
      },
      "one product of v");
  whole(
      [](Uv a, Uv b, Uv c, W w) {
        return Uv{mix(w, a.u, b.v, c.u), mix(w, a.v, b.v, c.v)};
      },
      "one product of u");
  whole(
      [](Uv a, Uv b, Uv c, W w) {
        if (w[2] > w[0] && w[2] > w[1]) return c;
        return w[1] > w[0] ? b : a;
      },
      "largest weight");

  check_unknown(
      "08.3", +[](Uv a, Uv b, Uv c, W w) {
        return Uv{w[0] + b.u, w[1] + a.v + c.u};
      });
}

TEST_CASE("the questions of chapter 08 have the answers of its page") {
  check_answer("08.a", 0.2);
  check_answer("08.b", 0.3);
}
