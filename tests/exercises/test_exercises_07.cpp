// The exercises of chapter 07, and what strangers write for them.
#include "solutions/07.hpp"

const std::vector<double> texmap::test::answers{137, 0};

// A place on the disk, with a height above it.
static V above(D radius, D angle, D z) { return {radius * cos(angle), radius * sin(angle), z}; }

TEST_CASE("07: strangers' answers get their words") {
  const auto by_mean = [](const char* text, auto number, auto byte_of) {
    mean_byte(text, [=](const std::vector<int>& bytes) {
      D sum = 0;
      for (const int byte : bytes) sum += number(byte);
      return byte_of(sum / bytes.size());
    });
  };
  const auto same = [](int byte) { return byte; };
  const auto light = [](int byte) { return srgb_decode(byte / 255.0); };
  by_mean("mean of the bytes", same, [](D mean) { return mean + 0.5; });
  by_mean("not decoded", same, [](D mean) { return 255 * srgb_encode(mean / 255) + 0.5; });
  by_mean("cut off", light, [](D mean) { return 255.999 * srgb_encode(mean); });

  scattered("radius is a:", [](D a, D b) { return above(a, 2 * pi * b, 1 - a); });
  scattered("half of the disk", [](D a, D b) { return above(sqrt(a), pi * b, sqrt(1 - a)); });
  scattered("move x and y", [](D a, D b) { return normalize(above(sqrt(a), 2 * pi * b, 1)); });

  const auto by_cell = [](const char* text, auto of) {  // the same line for u and for v
    place_of_sample(text, [=](int i, int n, D a, D b) {
      return Uv{of(i % n, n, a), of(i / n, n, b)};
    });
  };
  by_cell("at its corner", [](int k, int n, D c) { return 1. * k / n; });
  by_cell("then divide", [](int k, int n, D c) { return 1. * (k / n); });
  by_cell("leave their cells", [](int k, int n, D c) { return 1. * k / n + c; });
}
