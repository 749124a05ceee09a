// The exercises of chapter 12: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/12_1.hpp"
}
namespace solution_1 {
#include "exercises/12_1.hpp"
}
namespace start_2 {
#include "starts/12_2.hpp"
}
namespace solution_2 {
#include "exercises/12_2.hpp"
}
namespace start_3 {
#include "starts/12_3.hpp"
}
namespace solution_3 {
#include "exercises/12_3.hpp"
}

using namespace texmap::test;

using D = double;
using std::cos;
using std::exp2;
using std::pow;
using std::sin;

TEST_CASE("12.1: light from four bytes") {
  check_start("12.1", start_1::light_of_texel);
  check_solution("12.1", solution_1::light_of_texel);

  const auto named = [](Color (*mistaken)(int r, int g, int b, int k), const char* text) {
    check_mistake("12.1", mistaken, text);
  };
  static constexpr auto right = solution_1::light_of_texel;
  static constexpr auto color = [](D r, D g, D b) { return Color{r, g, b}; };
  static constexpr auto half = [](int r, int g, int b) { return Color{r + 0.5, g + 0.5, b + 0.5}; };
  named([](int r, int g, int b, int k) { return right(r, g, b, k + 8); }, "256 times");
  named([](int r, int g, int b, int k) { return color(r, g, b) * exp2(k - 128); }, "256 times");
  named([](int r, int g, int b,
           int k) { return color(r / 256., g / 256., b / 256.) * pow(2, k - 128); },
        "half is missing");
  named([](int r, int g, int b,
           int k) { return color(1 / 2 + 1. * r, 1 / 2 + 1. * g, 1 / 2 + 1. * b) * exp2(k - 136); },
        "half is missing");
  named([](int r, int g, int b, int k) { return half(r, g, b) * pow(2, k - 136); },
        "must not be added");
  named(
      [](int r, int g, int b, int k) { return (k == 0 ? Color{} : half(r, g, b)) * exp2(k - 136); },
      "must not be added");
  static constexpr auto no_0 = [](int m, int k) { return (m + 0.5) * exp2(k - 136); };
  static constexpr auto with_0 = [](int m, int k) { return m == 0 ? 0 : no_0(m, k); };
  named([](int r, int g, int b, int k) { return color(with_0(r, k), no_0(g, k), no_0(b, k)); },
        "must not be added");
  named([](int r, int g, int b, int k) { return color(no_0(r, k), with_0(g, k), with_0(b, k)); },
        "must not be added");
  static constexpr auto unless = [](bool black, Color light) { return black ? Color{} : light; };
  named([](int r, int g, int b,
           int k) { return unless(r == 0 && g == 0 && b == 0, half(r, g, b) * exp2(k - 136)); },
        "must not be added");
  named([](int r, int g, int b,
           int k) { return unless(r * g * b == 0, half(r, g, b) * exp2(k - 136)); },
        "its own byte");
  named([](int r, int g, int b, int k) { return unless(r == 0, half(r, g, b) * exp2(k - 136)); },
        "its own byte");
  named([](int r, int g, int b, int k) { return unless(r == 0, right(r, g, b, k)); },
        "its own byte");
  named([](int r, int g, int b, int k) { return right(b, g, r, k); }, "BGR");
  named([](int r, int g, int, int k) { return right(r, g, g, k); }, "line that was copied");
  named([](int r, int, int b, int k) { return right(r, r, b, k); }, "line that was copied");
  named([](int r, int g, int, int k) { return right(r, g, r, k); }, "line that was copied");
  named([](int r, int, int, int k) { return right(r, r, r, k); }, "the texel is gray");
  named([](int r, int g, int b, int) { return color(r, g, b) * (1 / 255.); }, "PNG");
  named([](int r, int g, int b, int) { return color(r / 255., g / 255., b / 255.); }, "PNG");
  check_unknown(
      "12.1", +[](int, int, int, int) { return color(1, 1, 1); });

  // A student writes the same line three times.
  const auto same = [&](D (*channel)(int m, int k), const char* text) {
    static D (*line)(int, int);
    line = channel;
    named([](int r, int g, int b, int k) { return color(line(r, k), line(g, k), line(b, k)); },
          text);
  };
  same([](int m, int) { return srgb_decode(m / 255.); }, "and the bytes of this file are light");
  same([](int m, int k) { return m == 0 ? 0 : (m + 0.5) * (2 ^ (k - 136)); }, "no power");
  same([](int m, int k) { return m == 0 ? 0 : (m + 0.5) * (k - 136); }, "multiply by it");
  same([](int m, int k) { return m > 0 ? (m + 0.5) / 255 * pow(2., k - 128) : 0; }, "not 1 / 255");
  same([](int m, int k) { return m / 255. * pow(2., k - 128); }, "not 1 / 255");
  same([](int m, int k) { return m > 0 ? (m + 0.5) / 256 * exp2(k - 127) : 0; }, "twice as bright");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * exp2(k - 137) : 0; }, "half as bright");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * exp2(136 - k) : 0; }, "wrong sign");
  same([](int m, int k) { return m > 0 ? (m + 0.5) / exp2(k - 136) : 0; }, "wrong sign");
  same([](int m, int k) { return m * exp2(136 - k); }, "wrong sign");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * std::exp(k - 136) : 0; }, "power of e");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * pow(10., k - 136) : 0; }, "power of 10");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * pow(k - 136., 2.) : 0; }, "base first");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * 2 * (k - 136) : 0; }, "2 * x is no power");
  same([](int m, int k) { return (m + 0.5) * (2 ^ (k - 136)); }, "compares bits");
  same([](int m, int k) { return (m + 0.5) * (1 << ((k - 136) & 31)); }, "1 << x");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * (exp2(k) - 136) : 0; }, "before the power");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * exp2(k) - 136 : 0; }, "before the power");
  same([](int m, int k) { return m > 0 ? (m + 0.5) * static_cast<int>(exp2(k - 136)) : 0; },
       "0 as an int");
  same([](int m, int k) { return m > 0 ? (m + 0.5) / 256 * exp2(k - 136) : 0; },
       "8 bits of m in it already");
  same([](int m, int k) { return m / 255. * exp2(k - 136); }, "8 bits of m in it already");
  same([](int m, int k) { return m > 0 ? pow(m + 0.5, k - 136) : 0; }, "base of the power");
  same([](int m, int k) { return pow(m + 0.5, k - 136); }, "base of the power");
  same([](int m, int) { return m > 0 ? m + 0.5 : 0; }, "2 to the power");
  same([](int m, int) { return m > 0 ? (m + 0.5) / 256 : 0; }, "PNG");
  same([](int m, int k) { return m > 0 ? m * exp2(k - 136) + 0.5 : 0; }, "comes before +");
  same([](int m, int k) { return m + 0.5 * exp2(k - 136); }, "comes before +");
  same([](int m, int k) { return m > 0 ? m + 0.5 * exp2(k - 136) : 0; }, "comes before +");
  same([](int m, int k) { return m > 0 ? (m - 0.5) * exp2(k - 136) : 0; }, "it is m + 1/2");
  same([](int m, int k) { return m > 0 ? (m + 1) * exp2(k - 136) : 0; }, "it is m + 1/2");
  same([](int m, int k) { return std::fmin(1, m > 0 ? (m + 0.5) * exp2(k - 136) : 0); },
       "do not limit");
  same([](int m, int k) { return std::clamp(m * exp2(k - 136), 0., 1.); }, "do not limit");
  same([](int m, int k) { return 1. * static_cast<int>((m > 0 ? m + 0.5 : 0) * exp2(k - 136)); },
       "no whole number");
  same([](int m, int k) { return srgb_decode(m > 0 ? (m + 0.5) * exp2(k - 136) : 0); },
       "leave srgb_decode out");
  same([](int m, int k) { return srgb_encode(m > 0 ? (m + 0.5) * exp2(k - 136) : 0); },
       "leave srgb_encode out");
}

TEST_CASE("12.2: how much of the sphere is a texel") {
  check_start("12.2", start_2::solid_angle);
  check_solution("12.2", solution_2::solid_angle);

  // i is the row, w the width and h the height.
  const auto named = [](D (*mistaken)(int i, int w, int h), const char* text) {
    check_mistake("12.2", mistaken, text);
  };
  named([](int, int w, int h) { return (2 * pi / w) * (pi / h); }, "sine is missing");
  named([](int, int w, int h) { return 4 * pi / (w * h); }, "not on the sphere");
  named(
      [](int i, int w, int h) { return sin((2 * i + 1) * pi / (2 * h)) * (2 * pi / w) * (pi / h); },
      "in the middle");
  named([](int i, int w, int h) { return sin(pi * (i + 0.5) / h) * 4 * pi / (w * h); },
        "in the middle");
  named([](int i, int w, int h) { return sin(i * pi / h) * (2 * pi / w) * (pi / h); },
        "upper edge");
  named([](int i, int w, int h) { return sin(pi * (i + 1 / 2) / h) * 2 * pi / w * pi / h; },
        "upper edge");
  named([](int i, int w, int h) { return sin(pi * (i + 1) / h) * 2 * pi / w * pi / h; },
        "the row's lower edge");
  named([](int i, int w,
           int h) { return (cos(i * 180. / h) - cos((i + 1) * 180. / h)) * 2 * pi / w; },
        "radians");
  check_unknown(
      "12.2", +[](int, int, int) { return 1.0; });

  // The right integral between other edges: of this row and of the next one.
  static constexpr auto between = [](D a, D b, int w) { return 2 * pi / w * (cos(a) - cos(b)); };
  const auto edges = [&](D (*edge)(int i, int h), const char* text) {
    static D (*edge_of)(int, int);
    edge_of = edge;
    named([](int i, int w, int h) { return between(edge_of(i, h), edge_of(i + 1, h), w); }, text);
  };
  edges([](int i, int h) { return 1. * (180 * i / h); }, "radians");
  edges([](int i, int h) { return 2 * pi * i / h; }, "2 pi for both");
  edges([](int i, int h) { return pi / 2 * i / h; }, "ends at the equator");
  edges([](int i, int h) { return i / h * pi; }, "whole numbers");
  edges([](int i, int h) { return 1. * (i / h); }, "whole numbers");
  edges([](int i, int h) { return 1. * i / h; }, "pi is missing");
  edges([](int i, int) { return 1. * i; }, "not row alone");
  edges([](int i, int h) { return pi * (i + 1) / h; }, "too far down");
  edges([](int i, int h) { return pi * (i - 1) / h; }, "too far up");
  edges([](int i, int h) { return pi * (i - 0.5) / h; }, "leave the half out");
  edges([](int i, int h) { return pi * (i + 0.5) / h; }, "leave the half out");
  edges([](int i, int h) { return pi * i / (h - 1); }, "not by height - 1");

  // The upper edge is right.
  const auto lower = [&](D (*edge)(int row, int height), const char* text) {
    static D (*lower_of)(int, int);
    lower_of = edge;
    named([](int i, int w, int h) { return between(pi * i / h, lower_of(i, h), w); }, text);
  };
  lower([](int row, int height) { return pi * row / height; }, "both edges are the same");
  lower([](int row, int height) { return pi * (row - 1) / height; }, "that of row - 1");
  lower([](int row, int height) { return pi * row + 1 / height; }, "brackets");
  lower([](int row, int height) { return pi * row + 1. / height; }, "brackets");
  lower([](int row, int) { return pi * row + 1; }, "brackets");
  lower([](int row, int height) { return (pi * row + 1) / height; }, "brackets");
  lower([](int row, int height) { return pi * row / height + 1; }, "brackets");
  lower([](int row, int height) { return (1. * row / height + 1) * pi; }, "brackets");
  lower([](int row, int height) { return pi * (row + 1. / height); }, "brackets");
  lower([](int row, int height) { return row + 1 * pi / height; }, "brackets");

  // Both edges are right: a and b.
  const auto of_edges = [&](D (*angle)(D a, D b, int w, int h), const char* text) {
    static D (*angle_of)(D, D, int, int);
    angle_of = angle;
    named([](int i, int w, int h) { return angle_of(pi * i / h, pi * (i + 1) / h, w, h); }, text);
  };
  of_edges([](D a, D b, int w, int) { return (cos(b) - cos(a)) * 2 * pi / w; }, "above 0");
  of_edges([](D a, D b, int, int) { return (cos(a) - cos(b)) * 2 * pi; }, "whole row");
  of_edges([](D a, D b, int w, int h) { return 2 * pi / w * pi / h * 0.5 * (sin(a) + sin(b)); },
           "mean of two sines");
  of_edges([](D a, D, int w, int) { return 2 * pi / w * (cos(a) + 1); }, "south pole");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * (cos(a) + cos(b)); }, "not added");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * cos(a) * cos(b); }, "not multiplied");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * cos(b - a); }, "cosine of a - b");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * (1 - cos(b - a)); }, "cosine of a - b");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * (sin(a) - sin(b)); }, "yours are sines");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * (sin(b) - sin(a)); }, "yours are sines");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * (cos(pi / 2 - a) - cos(pi / 2 - b)); },
           "yours are sines");
  of_edges([](D, D b, int w, int) { return 2 * pi / w * (1 - cos(b)); }, "down to b");
  of_edges([](D a, D, int w, int) { return 2 * pi / w * (1 - cos(a)); }, "down to a");
  of_edges([](D a, D, int w, int) { return 2 * pi / w * cos(a); }, "cos b is missing");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * cos(a) - cos(b); }, "comes before -");
  of_edges([](D a, D b, int w, int) { return 2 * pi / w * (b - a); }, "sine is missing");
  of_edges([](D a, D b, int, int) { return 2 * pi * (cos(b) - cos(a)); }, "whole row");
  of_edges([](D a, D b, int w, int) { return pi / w * (cos(a) - cos(b)); }, "not pi:");
  of_edges([](D a, D b, int w, int) { return 4 * pi / w * (cos(a) - cos(b)); }, "not 4 pi");
  of_edges([](D a, D b, int w, int) { return (cos(a) - cos(b)) / w; }, "2 pi is missing");
  of_edges([](D a, D b, int, int) { return cos(a) - cos(b); }, "multiply by 2 pi / width");
  of_edges([](D a, D b, int w, int) { return 360. / w * (cos(a) - cos(b)); }, "not 360");
  of_edges([](D a, D b, int w, int h) { return 2 * pi / w * pi / h * (cos(a) - cos(b)); },
           "the other height");
  of_edges([](D a, D b, int w, int h) { return 2 * pi / (w * h) * (cos(a) - cos(b)); },
           "the other height");
  of_edges([](D a, D b, int w, int h) { return 4 * pi / (w * h) * (cos(a) - cos(b)); },
           "the other height");
  of_edges([](D a, D b, int w, int) { return 2 * pi * w * (cos(a) - cos(b)); }, "you multiply");
  of_edges([](D a, D b, int, int h) { return 2 * pi / h * (cos(a) - cos(b)); },
           "divide by the height here");
  of_edges([](D a, D b, int w, int h) { return 2 * pi / h * (cos(a * h / w) - cos(b * h / w)); },
           "width and height are exchanged");
  of_edges([](D a, D b, int w, int h) { return 2 * pi / w * (cos(a * h / w) - cos(b * h / w)); },
           "you divide it by the width");
}

TEST_CASE("12.3: draw one of many") {
  check_start("12.3", start_3::drawn_thing);
  check_solution("12.3", solution_3::drawn_thing);

  using Sums = const std::vector<D>&;
  const auto named = [](const char* text, int (*mistaken)(Sums sums, D r)) {
    check_mistake("12.3", mistaken, text);
  };
  static constexpr auto right = solution_3::drawn_thing;
  static constexpr auto size_of = [](Sums sums) { return static_cast<int>(sums.size()); };
  named("not used", [](Sums sums, D r) { return static_cast<int>(std::floor(r * size_of(sums))); });
  named("not used", [](Sums sums, D r) { return static_cast<int>(r * (size_of(sums) - 1)); });
  named("not used",
        [](Sums sums, D r) { return static_cast<int>(std::round(r * (size_of(sums) - 1))); });
  named("too large",
        [](Sums sums, D r) { return std::min(right(sums, r) + 1, size_of(sums) - 1); });
  named("too large", [](Sums sums, D r) { return right(sums, r) + 1; });
  named("too small", [](Sums sums, D r) { return std::max(0, right(sums, r) - 1); });
  named("too small", [](Sums sums, D r) { return right(sums, r) - 1; });
  named("always draw the first", [](Sums, D r) { return static_cast<int>(r); });
  named("limit the index", [](Sums sums, D r) {
    return static_cast<int>(std::upper_bound(sums.begin(), sums.end(), r) - sums.begin());
  });
  named("probability 0 is drawn", [](Sums sums, D r) {
    int i = 0;
    for (const D sum : sums)
      if (r > sum && i + 1 < size_of(sums)) ++i;
    return i;
  });
  named("too small", [](Sums sums, D r) {
    int i = size_of(sums) - 1;
    while (i > 0 && r < sums[i]) --i;
    return i;
  });
  named("the last thing is never drawn", [](Sums sums, D r) {
    int i = 0;
    while (i < size_of(sums) - 2 && r >= sums[i]) ++i;
    return i;
  });
  named("thing 0 is never drawn", [](Sums sums, D r) {
    int i = 1;
    while (i < size_of(sums) - 1 && r >= sums[i]) ++i;
    return i;
  });
  named("a sum already", [](Sums sums, D r) {
    D sum = 0;
    for (int i = 0; i < size_of(sums); ++i) {
      sum += sums[i];
      if (r < sum) return i;
    }
    return size_of(sums) - 1;
  });
  named("a sum already", [](Sums sums, D r) {
    for (int i = 0; i < size_of(sums); ++i) {
      if (r < sums[i]) return i;
      r -= sums[i];
    }
    return size_of(sums) - 1;
  });
  named("always draw the last", [](Sums sums, D r) {
    for (int i = size_of(sums) - 1; i >= 0; --i)
      if (r < sums[i]) return i;
    return size_of(sums) - 1;
  });
  named("your search goes on", [](Sums sums, D r) {
    for (int i = size_of(sums) - 1; i >= 0; --i)
      if (r < sums[i]) return i;
    return -1;
  });
  named("your search goes on", [](Sums sums, D r) {
    int found = 0;
    for (int i = 0; i < size_of(sums); ++i)
      if (r < sums[i]) found = i;
    return found;
  });
  named("nearest to r", [](Sums sums, D r) {
    int best = 0;
    for (int i = 1; i < size_of(sums); ++i)
      if (std::fabs(sums[i] - r) < std::fabs(sums[best] - r)) best = i;
    return best;
  });
  check_unknown(
      "12.3", +[](Sums, D) { return 1; });

  // A student counts sums, from this number on.
  const auto counted = [&](int from, bool (*counts)(D sum, D r), const char* text) {
    static int from_number;
    static bool (*counts_here)(D, D);
    from_number = from;
    counts_here = counts;
    named(text, [](Sums sums, D r) {
      int i = from_number;
      for (const D sum : sums)
        if (counts_here(sum, r)) ++i;
      return i;
    });
  };
  const auto reached = [](D sum, D r) { return r >= sum; };
  counted(0, reached, "limit the index");
  counted(1, reached, "too large");
  counted(-1, reached, "too small");
  const auto passed = [](D sum, D r) { return r > sum; };
  counted(0, passed, "and limit");
  const auto above = [](D sum, D r) { return sum > r; };
  counted(0, above, "you count the sums");

  // A student looks for the first thing like this; if there is none, it is the last or another one.
  constexpr int last = std::numeric_limits<int>::max();
  const auto found = [&](bool (*like)(Sums s, int i, D r), const char* text, int other) {
    static bool (*like_this)(Sums, int, D);
    static int else_this;
    like_this = like;
    else_this = other;
    named(text, [](Sums sums, D r) {
      for (int i = 0; i < size_of(sums); ++i)
        if (like_this(sums, i, r)) return i;
      return std::min(else_this, size_of(sums) - 1);
    });
  };
  found([](Sums s, int i, D r) { return r < s[i]; }, "not -1", -1);
  found([](Sums s, int i, D r) { return r < s[i]; }, "not the first", 0);
  found([](Sums s, int i, D r) { return s[i] >= r; }, "and return the last", -1);
  found([](Sums s, int i, D r) { return !(r < s[i]); }, "turned around", last);
  found([](Sums s, int i, D r) { return r > s[i]; }, "turned around", -1);
  found([](Sums s, int i, D r) { return r >= s[i]; }, "always draw the first", 0);
  found([](Sums s, int i, D r) { return r == s[i]; }, "hardly ever", last);
  found([](Sums s, int i, D r) { return i > 0 && s[i - 1] <= r && r < s[i]; },
        "thing 0 is left out", last);
  found([](Sums s, int i, D r) { return (i > 0 ? s[i - 1] : 0) < r && r < s[i]; }, "write >= there",
        last);
  found([](Sums s, int i, D r) { return r < s[i] - (i > 0 ? s[i - 1] : 0); },
        "the probability of thing i alone", last);
  found([](Sums s, int i, D r) { return 1 - r < s[i]; }, "1 - r", last);
}

TEST_CASE("the questions of chapter 12 have the answers of its page") {
  check_answer("12.a", 600);
  check_answer("12.b", 122);
}
