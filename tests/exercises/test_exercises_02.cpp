// The exercises of chapter 02, and what strangers write for them.
#include "starts/02.hpp"

const std::vector<double> texmap::test::answers{60, 80};

TEST_CASE("02: strangers' answers get their words") {
  uv_of("radians", [](V p) { return Uv{atan2(-p.z, p.x), acos(-p.y)}; });
  const auto by_u = [](const char* text, auto u_of) {  // v is one that the judge's tables have not
    uv_of(text, [=](V p) { return Uv{u_of(p), asin(p.y) / pi + 0.5}; });
  };
  by_u("write 0.5", [](V p) { return 1 / 2 - atan2(p.z, p.x) / (2 * pi); });
  by_u("(2 * pi)", [](V p) { return (atan2(-p.z, p.x) + pi) / 2 * pi; });
  by_u("half a turn", [](V p) { return fmod(atan2(-p.z, p.x) / (2 * pi) + 1, 1); });
  by_u("exchanged", [](V p) { return 0.5 - atan2(p.x, p.z) / (2 * pi); });
  const auto by_v = [](const char* text, auto v_of) {
    uv_of(text, [=](V p) { return Uv{(pi - atan2(p.z, p.x)) / (2 * pi), v_of(p)}; });
  };
  by_v("beyond 1 at the pole", [](V p) { return acos(-p.y) / pi; });
  by_v("add 0.5", [](V p) { return atan2(p.y, std::hypot(p.x, p.z)) / pi; });
  by_v("square root", [](V p) { return atan2(p.x * p.x + p.z * p.z, -p.y) / pi; });

  is_first_color("stripes", [](Uv uv, int n) { return int(uv.u * n) % 2 == 1; });
  is_first_color("slanted", [](Uv uv, int n) { return int(uv.u * n + uv.v * n) % 2 == 0; });

  twice_around("goes on there", [](Uv uv) { return Uv{min(1.0, 2 * uv.u), uv.v}; });
  twice_around.right([](Uv uv) { return Uv{fmod(2 * uv.u, 1), uv.v}; });
  twice_around("multiplies by its 10", [](Uv uv) { return Uv{fmod(10 * uv.u, 1), uv.v}; });
  twice_around("drops the decimals", [](Uv uv) { return Uv{D(int(2 * uv.u)), uv.v}; });
}
