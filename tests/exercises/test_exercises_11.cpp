// The exercises of chapter 11, and what strangers write for them.
#include "solutions/11.hpp"

const std::vector<double> texmap::test::answers{14, 0.32};

TEST_CASE("11: strangers' answers get their words") {
  const auto by_slopes = [](const char* text, auto normal) {  // of the slopes to the right and up
    bump_normal(text, [=](D here, D right, D up, D step) {
      return normal((right - here) / step, (up - here) / step, step);
    });
  };
  by_slopes("uphill, and it is not", [](D x, D y, D step) { return V{x, y, 1}; });
  by_slopes("divide it by its length", [](D x, D y, D step) { return V{-x, -y, 1} * step; });
  by_slopes("nearly flat", [](D x, D y, D step) { return normalize(V{-x * step, -y * step, 1}); });
  by_slopes("has a sign", [](D x, D y, D step) { return normalize(V{-abs(x), -abs(y), 1}); });

  const auto by_channel = [](const char* text, auto of) {  // the same line three times
    normal_of_texel(text, [=](int r, int g, int b) { return V{of(r), of(g), of(b)}; });
  };
  by_channel("divide whole numbers", [](int c) -> D { return (c - 128) / 127; });
  by_channel("and 255 exactly 1", [](int c) { return 2 * ((c + 0.5) / 256) - 1; });
  by_channel("comes before -", [](int c) { return c * 2 - 1 / 255.; });
  by_channel("not colors", [](int c) { return srgb_decode(c / 255.) * 2 - 1; });

  bitangent_of("mirrored copy bumps", [](V n, V t, D sign) { return cross(n * sign, t * sign); });
  bitangent_of("right angle to both", [](V n, V t, D sign) { return normalize(n + t) * sign; });
  bitangent_of("without an axis", [](V n, V t, D sign) { return V{-t.y, t.x, 0} * sign; });
  bitangent_of("no direction", [](V n, V t, D sign) { return dot(n, t) * sign * n; });
}
