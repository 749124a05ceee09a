// The exercises of chapter 08, and what strangers write for them.
#include "solutions/08.hpp"

const std::vector<double> texmap::test::answers{0.2, 0.3};

TEST_CASE("08: strangers' answers get their words") {
  using Window = std::vector<V>;
  const auto by_edges = [](const char* text, auto of, std::size_t left_out = 0) {
    is_hit(text, [=](const Window& corners) {
      D lowest = infinity, highest = -infinity;
      for (std::size_t i = 0; i + left_out < corners.size(); ++i) {
        const V a = corners[i], b = corners[(i + 1) % corners.size()];
        lowest = min(lowest, a.x * b.y - a.y * b.x);
        highest = max(highest, a.x * b.y - a.y * b.x);
      }
      return of(lowest, highest);
    });
  };
  by_edges("clockwise corners are missed", [](D low, D high) { return low > 0; });
  by_edges("without an area", [](D low, D high) { return low >= 0 || high <= 0; });
  by_edges("an edge hits nothing", [](D low, D high) { return low * high > 0; });
  by_edges(
      "last corner to the first", [](D low, D high) { return (low >= 0) != (high <= 0); }, 1);
  is_hit.right([](const Window& corners) {  // in triangles from the first corner
    const auto side = [](V a, V b) { return a.x * b.y - a.y * b.x; };
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const D ab = side(corners[0], corners[i - 1]), bc = side(corners[i - 1], corners[i]);
      const D ca = side(corners[i], corners[0]);
      if (ab == 0 && bc == 0 && ca == 0) continue;
      if (min({ab, bc, ca}) >= 0 || max({ab, bc, ca}) <= 0) return true;
    }
    return false;
  });

  const auto by_weights = [](const char* text, auto mix) {  // of those in the texture
    point_of(text, [=](Uv at, V a, V b, V c, Uv p, Uv q, Uv r) {
      const V w = solution_2::point_of(at, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, p, q, r);
      return mix(a, b, c, w);
    });
  };
  by_weights("opposite a", [](V a, V b, V c, V w) { return w.x * b + w.y * c + w.z * a; });
  by_weights("do not limit", [](V a, V b, V c, V w) {
    return max(w.x, 0.0) * a + max(w.y, 0.0) * b + max(w.z, 0.0) * c;
  });
  point_of("subtract it", [](Uv at, V a, V b, V c, Uv p, Uv q, Uv r) {
    return solution_2::point_of({0, 0}, a, b, c, p, q, r);
  });
  point_of.right([](Uv at, V a, V b, V c, Uv p, Uv q, Uv r) {  // along u, then along v
    const auto step = [=](D u, D v) { return solution_2::point_of({u, v}, a, b, c, p, q, r); };
    return step(0, 0) + at.u * (step(1, 0) - step(0, 0)) + at.v * (step(0, 1) - step(0, 0));
  });
}
