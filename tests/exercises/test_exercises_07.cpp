// The exercises of chapter 07: each fails as shipped, its solution passes, each known mistake gets
// its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/07_1.hpp"
}
namespace solution_1 {
#include "exercises/07_1.hpp"
}
namespace start_2 {
#include "starts/07_2.hpp"
}
namespace solution_2 {
#include "exercises/07_2.hpp"
}
namespace start_3 {
#include "starts/07_3.hpp"
}
namespace solution_3 {
#include "exercises/07_3.hpp"
}

using namespace texmap::test;

using D = double;
using V = Vec3;
using std::cos;
using std::round;
using std::sin;
using std::sqrt;

TEST_CASE("07.1: average light, not bytes") {
  check_start("07.1", start_1::mean_byte);
  check_solution("07.1", solution_1::mean_byte);

  // A student adds a number for each byte, and makes a byte from the sum and the count.
  const auto named = [](D (*mean_byte)(D sum, D n), const char* text, D (*number)(int byte)) {
    static D (*added)(int);
    static D (*byte_of)(D, D);
    added = number;
    byte_of = mean_byte;
    check_mistake(
        "07.1",
        +[](const std::vector<int>& bytes) {
          D sum = 0;
          for (const int byte : bytes) sum += added(byte);
          return static_cast<int>(byte_of(sum, static_cast<D>(bytes.size())));
        },
        text);
  };
  const auto as_is = [](int byte) { return 1.0 * byte; };
  named([](D sum, D n) { return sum / n + 0.5; }, "mean of the bytes", as_is);
  named([](D sum, D n) { return 255 * srgb_encode(sum / 255 / n) + 0.5; }, "not decoded", as_is);
  named([](D sum, D) { return sum; }, "no mean", as_is);
  named([](D sum, D n) { return round(255 * srgb_decode(sum / 255 / n)); },
        "mean of the bytes is decoded", as_is);
  named([](D sum, D n) { return round(255 * srgb_encode(srgb_decode(sum / 255 / n))); },
        "mean of the bytes, not", as_is);

  const auto light = [](int byte) { return srgb_decode(byte / 255.0); };
  named([](D sum, D n) { return 255 * sum / n + 0.5; }, "encode it", light);
  named([](D sum, D n) { return sum / n * 255; }, "encode it", light);
  named([](D sum, D n) { return 255 * srgb_encode(sum / n); }, "cut off", light);
  named([](D sum, D n) { return 255.999 * srgb_encode(sum / n); }, "cut off", light);
  named([](D sum, D n) { return 256 * srgb_encode(sum / n); }, "cut off", light);
  named([](D sum, D n) { return round(256 * srgb_encode(sum / n)); }, "not 256", light);
  named([](D sum, D n) { return round(srgb_encode(sum / n)); }, "multiply it by 255", light);
  named([](D sum, D n) { return srgb_encode(sum / n); }, "multiply it by 255", light);
  named([](D sum, D n) { return round(sum / n); }, "multiply it by 255", light);
  named([](D sum, D) { return round(255 * srgb_encode(sum)); }, "no mean", light);
  named([](D sum, D n) { return round(255 * srgb_encode(sum) / n); }, "before it is divided",
        light);
  named([](D sum, D n) { return round(255 * srgb_decode(sum / n)); }, "mean again", light);

  const auto half_up = [](D sum, D n) { return 255 * srgb_encode(sum / n) + 0.5; };
  const auto rounded = [](D sum, D n) { return round(255 * srgb_encode(sum / n)); };
  named(half_up, "255.0", [](int byte) { return srgb_decode(1.0 * (byte / 255)); });
  named(rounded, "not 256", [](int byte) { return srgb_decode(byte / 256.0); });
  named(rounded, "from 0 to 1: give", [](int byte) { return srgb_decode(1.0 * byte); });
  named(rounded, "from 0 to 1: give", [](int byte) { return srgb_decode(byte); });
  named([](D sum, D n) { return round(srgb_encode(sum / n)); }, "from 0 to 1: give",
        [](int byte) { return srgb_decode(1.0 * byte); });
  named([](D sum, D n) { return 255 * srgb_decode(sum / n) + 0.5; }, "exchanged",
        [](int byte) { return srgb_encode(byte / 255.0); });
  named([](D sum, D n) { return round(255 * std::pow(sum / n, 1 / 2.2)); }, "power",
        [](int byte) { return std::pow(byte / 255.0, 2.2); });
  named([](D sum, D n) { return round(sqrt(sum / n)); }, "power",
        [](int byte) { return 1.0 * (byte * byte); });

  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        int sum = 0;
        for (const int byte : bytes) sum = static_cast<int>(sum + srgb_decode(byte / 255.0));
        const D mean = 1.0 * sum / static_cast<D>(bytes.size());
        return static_cast<int>(std::lround(255 * srgb_encode(mean)));
      },
      "add in a double");
  check_mistake(
      "07.1",
      +[](const std::vector<int>& bytes) {
        D sum = 0;
        for (std::size_t i = 1; i < bytes.size(); i++) sum += srgb_decode(bytes[i] / 255.0);
        return static_cast<int>(std::lround(255 * srgb_encode(sum / static_cast<D>(bytes.size()))));
      },
      "missing in the sum");
  check_unknown(
      "07.1", +[](const std::vector<int>& bytes) { return 255 - bytes.back(); });
}

TEST_CASE("07.2: more light from above") {
  check_start("07.2", start_2::scattered);
  check_solution("07.2", solution_2::scattered);

  const auto named = [](V (*mistaken)(D a, D b), const char* text) {
    check_mistake("07.2", mistaken, text);
  };
  // A place on the disk and a height above it; the height of a hemisphere if there is no other.
  static constexpr auto v = [](D x, D y, D z) { return V{x, y, z}; };
  static constexpr auto above = [](D r, D w, D z) { return v(r * cos(w), r * sin(w), z); };
  static constexpr auto lifted = [](D r, D w) { return above(r, w, sqrt(1 - r * r)); };
  named([](D a, D b) { return lifted(a, 2 * pi * b); }, "radius is a");
  named([](D a, D b) { return above(a, 2 * pi * b, 1 - a); }, "radius is a:");
  named([](D a, D b) { return lifted(a * a, 2 * pi * b); }, "radius is a a");
  named([](D a, D b) { return lifted(sqrt(1 - a), 2 * pi * b); }, "radius is sqrt(1 - a)");
  named([](D a, D b) { return above(sqrt(a), pi * b, sqrt(1 - a)); }, "half of the disk");
  named([](D a, D b) { return above(sqrt(a), pi * b, 1 - sqrt(a) * sqrt(a)); }, "half of the disk");
  named([](D a, D b) { return above(sqrt(a), b, sqrt(1 - a)); }, "radians");
  named([](D a, D b) { return above(sqrt(a), 360 * b, sqrt(1 - a)); }, "degrees");
  named([](D a, D b) { return lifted(sqrt(a), 2 * pi * b * 180 / pi); }, "into degrees");
  named([](D a, D b) { return lifted(sqrt(a), 2 * pi * b * pi / 180); }, "in radians already");
  named([](D a, D b) { return lifted(sqrt(a), -2 * pi * b); }, "other way");
  named([](D a, D b) { return above(sqrt(a), 2 * pi * b, 1 - a); }, "needs a root");
  named([](D a, D b) { return above(sqrt(a), 2 * pi * b, sqrt(1 - a * a)); }, "length is not 1");
  named([](D a, D b) { return above(sqrt(1 - (1 - a) * (1 - a)), 2 * pi * b, 1 - a); },
        "equally likely");
  named([](D a, D b) { return above(sqrt(1 - (1 - 2 * a) * (1 - 2 * a)), 2 * pi * b, 1 - 2 * a); },
        "all sides");
  named([](D a, D b) { return lifted(sqrt(b), 2 * pi * a); }, "a and b are exchanged");
  named([](D a, D) { return lifted(sqrt(a), 2 * pi * a); }, "a makes the radius and the angle");
  named([](D, D b) { return lifted(sqrt(b), 2 * pi * b); }, "b makes the radius and the angle");
  named(
      [](D a, D b) { return v(sqrt(a) * cos(2 * pi * b), sqrt(1 - a), sqrt(a) * sin(2 * pi * b)); },
      "not y");

  // The radius and the angle are right.
  const auto placed = [](V (*mistaken)(D r, D w), const char* text) {
    static V (*direction)(D, D);
    direction = mistaken;
    check_mistake(
        "07.2", +[](D a, D b) { return direction(sqrt(a), 2 * pi * b); }, text);
  };
  placed([](D r, D w) { return above(r, w, 1 - r); }, "below the hemisphere");
  placed([](D r, D w) { return above(r, w, 0); }, "on the disk");
  placed([](D r, D w) { return v(r * cos(w), -r * sin(w), sqrt(1 - r * r)); }, "other way");
  placed([](D r, D w) { return v(cos(w), sin(w), sqrt(1 - r * r)); }, "edge of the disk");
  placed([](D r, D w) { return above(r, w, sqrt(1 - r)); }, "length is not 1");
  placed([](D r, D w) { return above(r, w, 1); }, "length is not 1");
  placed([](D r, D w) { return above(r, w, r); }, "length is not 1");
  placed([](D r, D w) { return above(r, w, sqrt(1 - r * cos(w) * (r * cos(w)))); },
         "length is not 1");
  placed([](D r, D w) { return normalize(above(r, w, 1)); }, "move x and y");
  placed([](D r, D w) { return above(r, w, -sqrt(1 - r * r)); }, "not negative");
  placed([](D r, D w) { return v(r * sin(w), r * cos(w), sqrt(1 - r * r)); },
         "cos and sin are exchanged");
  check_unknown(
      "07.2", +[](D a, D b) { return v(b, 0, a); });
}

TEST_CASE("07.3: one sample in each cell") {
  check_start("07.3", start_3::place_of_sample);
  check_solution("07.3", solution_3::place_of_sample);

  // A student writes the same line for u, with the column and a, and for v, with the row and b.
  const auto same = [](D (*line)(int k, int n, D c), const char* text) {
    static D (*both)(int, int, D);
    both = line;
    check_mistake(
        "07.3",
        +[](int i, int n, D a, D b) {
          return Uv{both(i % n, n, a), both(i / n, n, b)};
        },
        text);
  };
  same([](int k, int n, D) { return k * 1.0 / n; }, "at its corner");
  same([](int k, int n, D) { return 1.0 * k / n; }, "at its corner");
  same([](int k, int n, D) { return k * 1.0 / n + 0.5 / n; }, "stripes");
  same([](int, int, D c) { return c; }, "without cells");
  same([](int k, int n, D c) { return (k + c) / n / n; }, "n x n");
  same([](int k, int n, D c) { return 1.0 * k / n + c; }, "leave their cells");
  same([](int, int n, D c) { return c / n; }, "first cell");
  same([](int k, int n, D) { return 1.0 * (k / n); }, "then divide");
  same([](int k, int n, D c) { return (k + c) / (n - 1); }, "not by n - 1");
  same([](int k, int n, D c) { return (k + c) / (n + 1); }, "not by n + 1");
  same([](int k, int, D c) { return k + c; }, "these are cells");
  same([](int k, int n, D c) { return k + c / n; }, "before the sum");
  same([](int k, int n, D c) { return k * c / n; }, "are factors");
  same([](int k, int n, D c) { return (k + c - 0.5) / n; }, "1/2");
  same([](int k, int n, D c) { return (k + 0.5 + c) / n; }, "1/2");
  same([](int k, int n, D c) { return (k - 1 + c) / n; }, "without 1");

  static constexpr auto uv = [](D u, D v) { return Uv{u, v}; };
  const auto named = [](Uv (*mistaken)(int i, int n, D a, D b), const char* text) {
    check_mistake("07.3", mistaken, text);
  };
  named([](int i, int n, D a, D b) { return uv((i / n + a) / n, (i % n + b) / n); },
        "rows are exchanged");
  named([](int i, int n, D a, D b) { return uv((i % n + a) / n, (1.0 * i / n + b) / n); },
        "no whole number");
  named([](int i, int n, D a, D b) { return uv((i + a) / n, (i / n + b) / n); }, "remainder");
  named([](int i, int n, D a, D b) { return uv(i % n / n + a, i % n / n + b); }, "column / n is 0");
  named([](int i, int n, D a, D b) { return uv(i % n / n + a / n, i % n / n + b / n); },
        "first cell");
  named([](int i, int n, D a, D b) { return uv((i % n + b) / n, (i / n + a) / n); }, "a is across");
  named([](int i, int n, D a, D) { return uv((i % n + a) / n, (i / n + a) / n); }, "across and up");
  named([](int i, int n, D a, D b) { return uv((i / n + b) / n, (i % n + a) / n); },
        "u and v are exchanged");
  named([](int i, int n, D a, D b) { return uv((i % n + a) / n, 1 - (i / n + b) / n); },
        "upside down");
  named([](int i, int n, D a, D b) { return uv((i % n + a) / n, (n - 1 - i / n + b) / n); },
        "upside down");
  named([](int i, int n, D a, D b) { return uv(((i + 1) % n + a) / n, ((i + 1) / n + b) / n); },
        "without 1");
  named([](int i, int n, D a, D b) { return uv((i % n + a) / n, (i % n + b) / n); },
        "without the rest");
  named([](int i, int n, D a, D b) { return uv((i / n + a) / n, (i / n + b) / n); },
        "i / n is the row");
  named([](int i, int n, D a, D b) { return uv((i % n + a) / n, (i + b) / n); }, "not rows");
  named([](int i, int n, D a, D b) { return uv((i + a) / n, (i + b) / n); },
        "i counts samples: the column");
  named([](int i, int n, D a, D b) { return uv((i % n + a) / n, b); }, "v is random");
  named([](int i, int n, D a, D b) { return uv(a, (i / n + b) / n); }, "u is random");
  check_unknown(
      "07.3", +[](int i, int n, D a, D b) { return uv(b * n, a * i); });
}

TEST_CASE("the questions of chapter 07 have the answers of its page") {
  check_answer("07.a", 137);
  check_answer("07.b", 0);
}
