// The exercises of chapter 04, and what strangers write for them.
#include "solutions/04.hpp"

const std::vector<double> texmap::test::answers{0.25, 0.65};

TEST_CASE("04: strangers' answers get their words") {
  using solution_1::uv_in;
  ::uv_in("subtract the seam's longitude", [](V p, V, bool east, bool north) {
    return uv_in(p, {1, 0, 0}, east, north);
  });
  ::uv_in("whole turns", [](V p, V seam, bool east, bool north) {
    const D turns = (atan2(p.z, p.x) - atan2(seam.z, seam.x)) / (2 * pi);
    return Uv{east ? -turns : turns, uv_in(p, seam, east, north).v};
  });
  ::uv_in("turn the longitudes around", [](V p, V seam, bool east, bool north) {
    const Uv uv = uv_in(p, seam, true, true);
    return Uv{east ? uv.u : 1 - uv.u, north ? uv.v : 1 - uv.v};
  });
  ::uv_in.right([](V p, V seam, bool east, bool north) {  // by the angle from the seam
    const D across = east ? cross(seam, p).y : cross(p, seam).y;
    const D turns = atan2(across, seam.x * p.x + seam.z * p.z) / (2 * pi);
    const D v = atan2(std::hypot(p.x, p.z), north ? -p.y : p.y) / pi;
    return Uv{turns < 0 ? turns + 1 : turns, v};
  });

  old_column("one too far right", [](int c, int w) { return (2 * w - c - w / 4) % w; });
  old_column("add width there", [](int c, int w) { return w - 1 - c - w / 4; });
  old_column("turned around", [](int c, int w) { return (c + w / 4) % w; });
  using solution_3::is_mirrored;
  ::is_mirrored("grow downward", [](V a, V b, V c, Uv p, Uv q, Uv r, bool) {
    return is_mirrored(a, b, c, p, q, r, true);
  });
  ::is_mirrored("run clockwise", [](V a, V b, V c, Uv p, Uv q, Uv r, bool up) {
    return is_mirrored({}, {1, 0, 0}, {0, 1, 0}, p, q, r, up);
  });
  ::is_mirrored("these are places", [](V a, V b, V c, Uv p, Uv q, Uv r, bool up) {
    return is_mirrored({}, b, c, {}, q, r, up);
  });
}
