// The exercises of chapter 08, and what strangers write for them.
#include "solutions/08.hpp"

const std::vector<double> texmap::test::answers{0.2, 0.3};

static D edge(V a, V b) { return a.x * b.y - a.y * b.x; }

TEST_CASE("08: strangers' answers get their words") {
  const auto by_edges = [](const char* text, auto of) {
    is_hit(text, [=](V a, V b, V c) { return of(edge(a, b), edge(b, c), edge(c, a)); });
  };
  by_edges("clockwise corners are missed", [](D ab, D bc, D ca) { return min({ab, bc, ca}) > 0; });
  by_edges("on the line through", [](D ab, D bc, D ca) { return ab * bc >= 0 && bc * ca >= 0; });
  by_edges("the sum says", [](D ab, D bc, D ca) { return ab + bc + ca < 0; });

  using W = std::array<D, 3>;
  weights("areas", [](V a, V b, V c) { return W{edge(b, c), edge(c, a), edge(a, b)}; });

  const auto by_mix = [](const char* text, auto of) {  // the same line for u and for v
    mixed(text, [=](Uv a, Uv b, Uv c, W w) {
      return Uv{of(a.u, b.u, c.u, w), of(a.v, b.v, c.v, w)};
    });
  };
  mixed("next corners", [](Uv a, Uv b, Uv c, W w) { return w[2] * a + b * w[0] + w[1] * c; });
  by_mix("count the same", [](D a, D b, D c, W w) { return (a + b + c) / 3; });
  by_mix("weights are added", [](D a, D b, D c, W w) { return w[0] + a + w[1] + b + w[2] + c; });
}
