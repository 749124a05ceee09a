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

  const auto by_height = [](const char* text, auto height) {
    through_window(text, [=](D a, D b, D edge) {
      const D z = height(a, edge);
      return above(sqrt(1 - z * z), 2 * pi * b, z);
    });
  };
  by_height("over a disk", [](D a, D edge) { return 1 - sqrt(a) * (1 - edge); });
  by_height("not the angle", [](D a, D edge) { return cos(acos(edge) * a); });
  by_height("a = 0 is straight up", [](D a, D edge) { return a + edge - a * edge; });
  by_height("a = 1 the height edge", [](D a, D edge) { return (1 - a) * edge; });
  by_height("ends at the height edge", [](D a, D edge) { return 1 - a; });
  through_window("half of the window", [](D a, D b, D edge) {
    const D z = a * edge + (1 - a);
    return above(sin(acos(z)), pi * b, z);
  });
  through_window.right([](D a, D b, D edge) {  // in float, with a sine
    const float z = (1 - a) + a * edge, w = b * 2 * pi;
    return above(std::sin(std::acos(z)), w, z);
  });

  const auto by_radius = [](const char* text, auto radius) {  // of the sample's share of the lens
    place_on_lens(text, [=](int i, int n, D a, D b, D inner) {
      const D r = radius((i + a) / n, inner);
      return Uv{r * cos(2 * pi * b), r * sin(2 * pi * b)};
    });
  };
  by_radius("steps of the area", [](D s, D inner) { return inner + (1 - inner) * s; });
  by_radius("area, inner * inner, comes first", [](D s, D) { return sqrt(s); });
  by_radius("in units of pi", [](D s, D in) { return sqrt(in * in + s * pow(1 - in, 2)); });
  by_radius("the root is missing", [](D s, D in) { return s + in * in * (1 - s); });
}
