// The exercises of chapter 02, and what strangers write for them.
#include "solutions/02.hpp"

const std::vector<double> texmap::test::answers{60, 80};

TEST_CASE("02: strangers' answers get their words") {
  uv_of("radians", [](V p) { return Uv{atan2(-p.z, p.x), acos(-p.y)}; });
  const auto by_u = [](const char* text, auto u_of) {  // v is one that the judge's tables have not
    uv_of(text, [=](V p) { return Uv{u_of(p), asin(p.y) / pi + 0.5}; });
  };
  by_u("as the page's:", [](V p) { return 0.5 - atan2(p.z, p.x) / (2 * pi); });
  by_u("(2 * pi)", [](V p) { return (atan2(-p.z, p.x) + pi) / 2 * pi; });
  by_u("below 0: add 1", [](V p) { return fmod(atan2(-p.z, p.x) / (2 * pi), 1); });
  by_u("exchanged", [](V p) { return 0.5 - atan2(p.x, p.z) / (2 * pi); });
  const auto by_v = [](const char* text, auto v_of) {
    uv_of(text, [=](V p) { return Uv{fmod(1 - atan2(p.z, p.x) / (2 * pi), 1), v_of(p)}; });
  };
  by_v("at the pole", [](V p) { return acos(-p.y) / pi; });
  by_v("add 0.5", [](V p) { return atan2(p.y, std::hypot(p.x, p.z)) / pi; });
  by_v("square root", [](V p) { return atan2(p.x * p.x + p.z * p.z, -p.y) / pi; });
  // Both are wrong, each in its own way.
  uv_of("by 2 pi; and v is", [](V p) { return Uv{atan2(-p.z, p.x) / pi, acos(-p.y)}; });

  after_walk("subtract the center", [](V p, V, D radius, D du, D dv) {
    return solution_2::after_walk(p, {0, 0, 0}, radius, du, dv);
  });
  after_walk("in a whole turn, 2 pi", [](V p, V center, D radius, D du, D dv) {
    return solution_2::after_walk(p, center, radius, du / 2, dv);
  });
  after_walk.right([](V p, V center, D radius, D du, D dv) {  // by turns, without the map
    const V d = p - center;
    const D wide = std::hypot(d.x, d.z), north = atan2(d.y, wide) + pi * dv;
    const D east = atan2(-d.z, d.x) + 2 * pi * du;
    return center + radius * V{cos(north) * cos(east), sin(north), -cos(north) * sin(east)};
  });

  const auto by_row = [](const char* text, auto row_of, auto shift) {
    as_bricks(text, [=](Uv uv, int n) {
      return Uv{uv.u + (row_of(uv.v * n) % 2 == 0 ? 0 : shift(n)), uv.v};
    });
  };
  const auto down = [](D row) { return int(row); };
  by_row("nothing is moved", down, [](int n) { return 1 / (2 * n); });
  by_row("further east", down, [](int n) { return -0.5 / n; });
  by_row("a whole brick", down, [](int n) { return 1. / n; });
  by_row(
      "no rounding", [](D row) { return int(row + 0.5); }, [](int n) { return 0.5 / n; });
  as_bricks("more than the one", [](Uv uv, int n) {
    return Uv{uv.u + int(uv.v * n) * 0.5 / n, uv.v};
  });
  as_bricks.right([](Uv uv, int n) {  // further by two squares in each row
    const int row = int(uv.v * n);
    return Uv{uv.u + row * 2.0 / n - (row % 2) * 1.5 / n, uv.v};
  });
  as_bricks.right([](Uv uv, int n) {  // within the map, and in float
    const float u = uv.u + std::lround(floor(uv.v * n)) % 2 / (2.F * n);
    return Uv{fmod(u, 1), uv.v};
  });
}
