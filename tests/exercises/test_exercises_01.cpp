// The exercises of chapter 01: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/01_1.hpp"
}
namespace solution_1 {
#include "exercises/01_1.hpp"
}
namespace start_2 {
#include "starts/01_2.hpp"
}
namespace solution_2 {
#include "exercises/01_2.hpp"
}
namespace start_3 {
#include "starts/01_3.hpp"
}
namespace solution_3 {
#include "exercises/01_3.hpp"
}

using namespace texmap::test;

using D = double;
using V = Vec3;
using std::max;
using std::sqrt;

TEST_CASE("01.1: where the ray meets the sphere") {
  check_start("01.1", start_1::distance_to_sphere);
  check_solution("01.1", solution_1::distance_to_sphere);

  // o and d are the ray, s is the sphere's center and r its radius.
  const auto whole = [](D (*mistaken)(V o, V d, V s, D r), const char* text) {
    check_mistake("01.1", mistaken, text);
  };
  static constexpr auto right = solution_1::distance_to_sphere;
  whole([](V o, V d, V s, D r) { return right(o, d / length(d), s, r); }, "length 1 alone");
  whole([](V o, V d, V s, D r) { return right(o, d, s, r) == infinity ? -1 : right(o, d, s, r); },
        "infinity for a miss");
  check_unknown(
      "01.1", +[](V o, V, V, D) { return o.z; });

  // A student makes a distance from a, b and the root q, which is NaN if there is none.
  struct Formula {
    D a, b, under_root;
  };
  using FormulaOf = Formula (*)(V o, V d, V s, D r);
  const auto named = [&](D (*distance)(D a, D b, D q), const char* text, FormulaOf formula) {
    static D (*distance_of)(D, D, D);
    static FormulaOf formula_of;
    distance_of = distance;
    formula_of = formula;
    whole(
        [](V o, V d, V s, D r) {
          const auto [a, b, under_root] = formula_of(o, d, s, r);
          return distance_of(a, b, sqrt(under_root));
        },
        text);
  };
  static constexpr auto above_0 = [](D t) { return t > 0 ? t : infinity; };
  static constexpr auto first_above = [](D least, D near, D far) {
    return near > least ? near : far > least ? far : infinity;
  };
  static constexpr auto c_of = [](V f, D r) { return dot(f, f) - r * r; };

  const auto twice = [](V o, V d, V s, D r) {
    const D a = dot(d, d);
    const D b = 2 * dot(o - s, d);
    return Formula{a, b, b * b - 4 * a * c_of(o - s, r)};
  };
  named([](D a, D b, D q) { return above_0((-b + q) / (2 * a)); }, "leaves the sphere: the smaller",
        twice);
  named([](D a, D b, D q) { return q >= 0 ? (-b + q) / (2 * a) : infinity; },
        "may be behind the origin", twice);
  named([](D a, D b, D q) { return above_0((-b - q) / 2 * a); }, "(2 * a)", twice);
  named([](D a, D b, D q) { return q >= 0 ? -b - q / (2 * a) : infinity; }, "parentheses", twice);

  // The other formula, without 2 and 4.
  static constexpr auto once = [](D a, D b, D c) { return Formula{a, b, b * b - a * c}; };
  const auto toward = [](V o, V d, V s, D r) {
    return once(dot(d, d), dot(s - o, d), c_of(s - o, r));
  };
  static constexpr auto nearest = [](D a, D b, D q) { return q >= 0 ? (b - q) / a : infinity; };
  named(nearest, "only t > 0 counts", toward);
  named([](D a, D b, D q) { return above_0((b - q) / a); }, "starts inside", toward);
  named([](D a, D b, D q) { return b + q < 0   ? infinity
                                   : b - q < 0 ? (b + q) / a
                                               : (b - q) / a; },
        "is NaN", toward);
  named([](D, D b, D q) { return first_above(0, b - q, b + q); }, "divide by a", toward);
  named([](D a, D b, D q) { return b - q > 0   ? (b - q) / a
                                   : b + q > 0 ? (b + q) / a
                                               : infinity; },
        "backward",
        [](V o, V d, V s, D r) { return once(dot(d, d), dot(o - s, d), c_of(o - s, r)); });

  const auto chapter_00 = [](V o, V d, V s, D r) {
    const D b = -dot(o - s, d);
    return Formula{dot(d, d), b, b * b - c_of(o - s, r)};
  };
  named([](D, D b, D q) { return first_above(0.001, b - q, b + q); }, "chapter 00's formula",
        chapter_00);
  named(nearest, "you have no a there", chapter_00);

  static constexpr auto minus = [](V o, V d, V s, D r) {
    return once(dot(d, d), -dot(o - s, d), c_of(o - s, r));
  };
  named(
      [](D a, D b, D q) {
        const D t = (b - q) / a;
        return std::isnan(t) ? infinity : t < 0 ? (b + q) / a : t;
      },
      "only if it is above 0", minus);
  named([](D a, D b, D q) { return q >= 0 ? std::fabs((b - q) / a) : infinity; }, "std::abs",
        minus);
  named(nearest, "yours has a plus", [](V o, V d, V s, D r) {
    const auto [a, b, under_root] = minus(o, d, s, r);
    return Formula{a, b, b * b + a * c_of(o - s, r)};
  });
  whole(
      [](V o, V d, V s, D r) {
        const auto [a, b, q] = minus(o, d, s, r);
        return q >= 0 ? first_above(0, (b - q) / a, (b + q) / a) : infinity;
      },
      "std::sqrt");

  // The rest is right, up to one number.
  const auto number = [&](const char* text, FormulaOf formula) {
    named([](D a, D b, D q) { return first_above(0, (b - q) / a, (b + q) / a); }, text, formula);
  };
  number("no point", [](V o, V d, V s, D r) {
    const auto [a, b, under_root] = minus(o, d, s, r);
    return Formula{a, b, std::fabs(under_root)};
  });
  number("2s and the 4",
         [](V o, V d, V s, D r) { return once(dot(d, d), -2 * dot(o - s, d), c_of(o - s, r)); });
  number("a is the square",
         [](V o, V d, V s, D r) { return once(length(d), -dot(o - s, d), c_of(o - s, r)); });
  number("radius is not squared",
         [](V o, V d, V s, D r) { return once(dot(d, d), -dot(o - s, d), dot(o - s, o - s) - r); });
  number("yours is another one", [](V o, V d, V s, D r) {
    return once(dot(d, d), -dot(o - s, d), dot(o - s, o - s) - 2 * r);
  });
  number("center is not subtracted",
         [](V o, V d, V, D r) { return once(dot(d, d), -dot(o, d), c_of(o, r)); });
  number("infinity for every ray", [](V o, V d, V s, D r) {
    return once(dot(d, d), -dot(o - s, d), dot(o - s, o - s) + r * r);
  });
}

TEST_CASE("01.2: how straight the light falls") {
  check_start("01.2", start_2::cosine_of);
  check_solution("01.2", solution_2::cosine_of);

  // p is the point, n its normal and l the lamp.
  const auto named = [](D (*mistaken)(V p, V n, V l), const char* text) {
    check_mistake("01.2", mistaken, text);
  };
  named([](V p, V n, V l) { return max(0.0, dot(n, l - p)); },
        "does not have length 1: normalize it");
  named([](V p, V n, V l) { return max(0.0, dot(n, (p - l) / length(p - l))); }, "inward");
  named([](V p, V n, V l) { return dot(n, l - p) / sqrt(dot(l - p, l - p)); }, "negative light");
  named([](V p, V n, V l) { return dot(n, l - p); }, "length 1, and nothing is cut off");
  named([](V p, V n, V l) { return dot(n, p - l) / length(p - l); },
        "signs are wrong, and nothing");
  named([](V p, V n, V l) { return std::abs(dot(n, l - p)) / length(l - p); }, "absolute value");
  named([](V, V n, V l) { return max(dot(n, l) / length(l), 0.0); }, "subtract the point");
  named([](V p, V n, V l) { return std::acos(dot(n, l - p) / length(l - p)); }, "the angle");
  named([](V p, V n, V l) { return std::min(dot(n, normalize(l - p)), 0.0); }, "std::min");
  named([](V p, V, V l) { return max(dot(p, normalize(l - p)), 0.0); }, "point is a position");
  named([](V, V n, V l) { return max(dot(n, l), 0.0); }, "lamp is a position");
  named([](V p, V n, V l) { return max(dot(n, normalize(p + l)), 0.0); }, "not their sum");
  named([](V, V n, V l) { return max(dot(n, normalize(l - n)), 0.0); }, "subtract point");
  named([](V p, V n, V l) { return max(dot(n, normalize(l) - p), 0.0); }, "as a whole");
  named([](V p, V n, V l) { return max(dot(n, l - p) / dot(l - p, l - p), 0.0); },
        "not by its square");
  named([](V p, V n,
           V l) { return max(dot(n, normalize(l - p)) / (length(l - p) * length(l - p)), 0.0); },
        "does not matter");
  named([](V p, V n, V l) { return std::cos(dot(n, normalize(l - p))); }, "no std::cos");
  named([](V p, V n, V l) { return length(cross(normalize(l - p), n)); }, "cross product");
  named([](V p, V n, V l) { return 0.2 + 0.8 * max(dot(n, normalize(l - p)), 0.0); },
        "0.2 and 0.8");
  named([](V p, V n, V l) { return dot(n, l - p) > 0 ? 1.0 : 0.0; }, "only whether");
  check_unknown(
      "01.2", +[](V, V, V) { return 0.5; });
}

TEST_CASE("01.3: is the lamp hidden") {
  check_start("01.3", start_3::in_shadow);
  check_solution("01.3", solution_3::in_shadow);

  using Hit = const FirstHit&;
  const auto named = [](bool (*mistaken)(V p, V n, V l, Hit hit), const char* text) {
    check_mistake("01.3", mistaken, text);
  };
  named([](V p, V, V l, Hit hit) { return hit(p, (l - p) / length(l - p)) < length(l - p); },
        "start 0.001 above");
  named([](V p, V n, V l,
           Hit hit) { return hit(p - 0.001 * n, (l - p) / length(l - p)) < length(l - p); },
        "below the surface");
  named([](V p, V n, V l, Hit hit) { return hit(p + 0.001 * n, normalize(l - p)) != infinity; },
        "behind the lamp");
  named([](V p, V n, V l, Hit hit) { return hit(p + 0.001 * n, n) < length(l - p); },
        "along the normal");
  named([](V p, V n, V l, Hit hit) { return hit(normalize(l - p), p + 0.001 * n) < length(l - p); },
        "start first");
  named([](V p, V n, V l, Hit hit) { return hit(p + n, normalize(l - p - n)) < length(l - p - n); },
        "too far above");
  named([](V p, V, V l, Hit hit) { return hit(l, normalize(p - l)) < length(l - p); },
        "a ray from the lamp");
  named([](V p, V n, V l, Hit hit) { return hit(p + 0.001 * n, normalize(l - p)) > 0; },
        "true everywhere");
  named([](V p, V n, V l, Hit) { return dot(n, normalize(l - p)) <= 0; }, "behind the surface");
  named(start_3::in_shadow, "never true");

  // The ray starts at s, where it has to.
  const auto started = [](bool (*mistaken)(V s, V l, Hit hit), const char* text) {
    static bool (*from)(V, V, Hit);
    from = mistaken;
    check_mistake(
        "01.3", +[](V p, V n, V l, Hit hit) { return from(p + 0.001 * n, l, hit); }, text);
  };
  started([](V s, V l, Hit hit) { return hit(s, l - s) < sqrt(dot(l - s, l - s)); },
          "lengths of the direction");
  started([](V s, V l, Hit hit) { return hit(s, (s - l) / length(l - s)) < length(l - s); },
          "away from the lamp");
  started([](V s, V l, Hit hit) { return hit(s, (l - s) / length(l - s)) >= length(l - s); },
          "exchanged");
  started([](V s, V l, Hit hit) { return hit(s, l) < length(l - s); }, "lamp is a position");
  started([](V s, V l, Hit hit) { return hit(s, normalize(l)) < length(l); }, "lamp is a position");
  started([](V s, V l, Hit hit) { return hit(s, normalize(l - s)) < 1; }, "not with 1");
  started([](V s, V l, Hit hit) { return hit(s, normalize(l - s)) < length(l); }, "from (0, 0, 0)");
  started([](V s, V l, Hit hit) { return hit(s, normalize(s + l)) < length(l - s); },
          "not their sum");
}

TEST_CASE("the questions of chapter 01 have the answers of its page") {
  check_answer("01.a", 40);
  check_answer("01.b", std::acos(0.375) * 180 / pi);
}
