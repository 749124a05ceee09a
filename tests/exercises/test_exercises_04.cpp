// The exercises of chapter 04, and what strangers write for them.
#include "published/uv.hpp"
#include "solutions/04.hpp"

const std::vector<double> texmap::test::answers{0.25, 0.65};

TEST_CASE("04: strangers' answers get their words") {
  // The daily exercise's own formula normalizes its point first, so it is right at the pole.
  uv_of.right([](V p) { return texmap::published::uv_daily(p); });
  const auto by_u = [](const char* text, auto u_of) {  // v is one that the judge's tables have not
    uv_of(text, [=](V p) { return Uv{u_of(p), 0.5 - asin(p.y) / pi}; });
  };
  by_u("beyond 1", [](V p) { return 0.5 + atan2(p.z, p.x) / (2 * pi); });
  by_u("arguments of atan2", [](V p) { return 0.5 + atan2(-p.x, p.z) / (2 * pi); });
  by_u("between x and z", [](V p) { return 0.5 + atan2(p.z, p.y) / (2 * pi); });
  by_u("goes around twice", [](V p) { return 0.5 + atan2(p.z, p.x) / pi; });

  lecture_u.right([](D u) { return u + 0.75 - floor(u + 0.75); });
  lecture_u("1 / 4 is 0", [](D u) { return fmod(u + 3 / 4, 1.0); });
  lecture_u("not <=", [](D u) { return u > 0.25 ? u - 0.25 : u + 0.75; });
  lecture_u("turns the other way", [](D u) { return u > 0.75 ? u - 0.75 : u + 0.25; });
  lecture_u("runs the other way", [](D u) { return u > 0.25 ? 1.25 - u : 0.25 - u; });
  lecture_u("a quarter of a turn is 0.25", [](D u) { return u - pi / 2; });

  is_mirrored("north alone", [](Uv o, Uv e, Uv n) { return n.v < o.v; });
  is_mirrored("always true", [](Uv o, Uv e, Uv n) { return e.u != o.u || e.v != o.v; });
  is_mirrored("not added", [](Uv o, Uv e, Uv n) { return e.u - o.u + n.v - o.v < 0; });
}
