// The exercises of chapter 09, and what strangers write for them.
#include "solutions/09.hpp"

const std::vector<double> texmap::test::answers{188, 1398101};

TEST_CASE("09: strangers' answers get their words") {
  repeated_column("below 0", [](int c, int w) { return c - c / w * w; });
  repeated_column("clamp", [](int c, int w) { return min(max(0, c), w - 1); });
  repeated_column("one width is not enough", [](int c, int w) { return (c + w) % w; });

  using W = std::array<D, 2>;
  const auto by_right = [](const char* text, auto right) {
    weights_of(text, [=](D u, int width) { return W{1 - right(u, width), right(u, width)}; });
  };
  by_right("half a texel", [](D u, int width) { return fmod(u * width, 1.0); });
  by_right("multiply it by width", [](D u, int width) { return u; });
  by_right("nearest center", [](D u, int w) { return abs(u * w - 0.5 - round(u * w - 0.5)); });
  by_right("loses its sign", [](D u, int w) { return abs(u * w - 0.5 - int(u * w - 0.5)); });

  level_of_width("natural", [](D width) { return std::log(max(width, 1.0)); });
  const auto by_level = [](const char* text, auto level) {  // of the whole level and the rest
    level_of_width(text, [=](D width) {
      const D l = floor(log2(max(width, 1.0)));
      return level(l, max(width, 1.0) / exp2(l));
    });
  };
  by_level("divide by 3", [](D l, D rest) { return l + rest * rest - 1; });
  by_level("before -", [](D l, D rest) { return l + rest * rest - 1. / 3; });
}
