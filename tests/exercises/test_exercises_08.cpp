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
    for (std::size_t i = 2; i < corners.size(); ++i)
      if (solution_1::is_hit({corners[0], corners[i - 1], corners[i]})) return true;
    return false;
  });

  point_of("opposite a", [](Uv at, V a, V b, V c, Uv p, Uv q, Uv r) {
    return solution_2::point_of(at, b, c, a, p, q, r);
  });
  point_of("subtract it", [](Uv at, V a, V b, V c, Uv p, Uv q, Uv r) {
    return solution_2::point_of({0, 0}, a, b, c, p, q, r);
  });
  point_of.right([](Uv at, V a, V b, V c, Uv p, Uv q, Uv r) {  // along u, then along v
    const auto step = [=](D u, D v) { return solution_2::point_of({u, v}, a, b, c, p, q, r); };
    return step(0, 0) + at.u * (step(1, 0) - step(0, 0)) + at.v * (step(0, 1) - step(0, 0));
  });
}
