// The exercises of chapter 10, and what strangers write for them.
#include "solutions/10.hpp"

const std::vector<double> texmap::test::answers{1816 * 908, 30};

TEST_CASE("10: strangers' answers get their words") {
  const auto at = [](const char* text, auto radius) {  // of the height
    on_round_map(text, [=](V p) {
      const D w = atan2(-p.z, p.x), r = radius(p.y);
      return Uv{0.5 + r * cos(w), 0.5 + r * sin(w)};
    });
  };
  at("equal steps of the angle", [](D y) { return acos(y) / (2 * pi); });
  at("the root is missing", [](D y) { return (1 - y) / 4; });
  at("does not fit the square", [](D y) { return sqrt((1 - y) / 2); });
  on_round_map("0 / 0", [](V p) {
    const V out = normalize(V{p.x, 0, -p.z});
    return Uv{0.5, 0.5} + Uv{out.x, out.z} * sqrt((1 - p.y) / 8);
  });

  const auto turned = [](const char* text, auto turn) {  // of the place on the octahedron
    on_half_octahedron(text, [=](V p) {
      const D s = abs(p.x) + p.y + abs(p.z);
      const Uv square = turn(p.x / s, -p.z / s);
      return Uv{(square.u + 1) / 2, (square.v + 1) / 2};
    });
  };
  turned("on its corner still", [](D a, D b) { return Uv{a, b}; });
  turned("too small", [](D a, D b) { return Uv{(a + b) * sqrt(0.5), (b - a) * sqrt(0.5)}; });

  const auto back = [](const char* text, auto direction) {  // of the right angle and height
    direction_of(text, [=](Uv uv) { return direction((0.5 - uv.u) * 2 * pi, 2 * uv.v - 1); });
  };
  back("not on the sphere", [](D w, D y) { return V{cos(w), y, sin(w)}; });
  back("do not normalize", [](D w, D y) { return normalize(V{cos(w), y, sin(w)}); });
  back("multiply both", [](D w, D y) { return V{cos(w), y, sqrt(1 - y * y) * sin(w)}; });
  back("length of the result", [](D w, D y) { return V{y * cos(w), y, y * sin(w)}; });
}
