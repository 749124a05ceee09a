// The exercises of chapter 10, and what strangers write for them.
#include "solutions/10.hpp"

const std::vector<double> texmap::test::answers{1816 * 908, 30};

static Uv halved(D a, D b) { return {(1 + a) / 2, (1 + b) / 2}; }
static D sum(V p) { return abs(p.x) + abs(p.y) + abs(p.z); }

TEST_CASE("10: strangers' answers get their words") {
  const auto at = [](const char* text, auto place) {  // of the right u
    on_cylinder(text, [=](V p) { return place(0.5 - atan2(p.z, p.x) / (2 * pi), p); });
  };
  at("equirectangular", [](D u, V p) { return Uv{u, 0.5 + asin(p.y) / pi}; });
  at("mirrored", [](D u, V p) { return Uv{1 - u, (1 + p.y) / 2}; });
  at("1/2 is missing", [](D u, V p) { return Uv{0.5 - u, (1 + p.y) / 2}; });
  at("1/2 is missing", [](D u, V p) { return Uv{u - 0.5, p.y}; });

  on_octahedron("nothing is folded", [](V p) { return halved(p.x / sum(p), -p.z / sum(p)); });
  const auto folded = [](const char* text, auto fold) {
    on_octahedron(text, [=](V p) {
      return p.y < 0 ? fold(p.x / sum(p), -p.z / sum(p)) : halved(p.x / sum(p), -p.z / sum(p));
    });
  };
  folded("b is not folded", [](D a, D b) { return halved(copysign(1 - abs(b), a), b); });
  folded("size first", [](D a, D b) { return halved(copysign(a, 1 - b), copysign(b, 1 - a)); });
  folded("counts twice", [](D a, D b) { return halved(a * (1 - abs(b)), b * (1 - abs(a))); });

  const auto back = [](const char* text, auto direction) {  // of the right angle and height
    direction_of(text, [=](Uv uv) { return direction((0.5 - uv.u) * 2 * pi, 2 * uv.v - 1); });
  };
  back("not on the sphere", [](D w, D y) { return V{cos(w), y, sin(w)}; });
  back("do not normalize", [](D w, D y) { return normalize(V{cos(w), y, sin(w)}); });
  back("multiply both", [](D w, D y) { return V{cos(w), y, sqrt(1 - y * y) * sin(w)}; });
  back("length of the result", [](D w, D y) { return V{y * cos(w), y, y * sin(w)}; });
}
