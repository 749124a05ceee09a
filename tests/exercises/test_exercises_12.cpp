// The exercises of chapter 12, and what strangers write for them.
#include "solutions/12.hpp"

const std::vector<double> texmap::test::answers{600, 122};

TEST_CASE("12: strangers' answers get their words") {
  const auto by_channel = [](const char* text, auto light) {  // the same line three times
    light_of_texel(text, [=](int r, int g, int b, int k) {
      return Color{light(r, k), light(g, k), light(b, k)};
    });
  };
  by_channel("must not be added", [](int m, int k) { return (m + 0.5) * exp2(k - 136); });
  by_channel("no power", [](int m, int k) { return m == 0 ? 0 : (m + 0.5) * (2 ^ (k - 136)); });
  by_channel("PNG", [](int m, int) { return m > 0 ? (m + 0.5) / 256 : 0; });
  by_channel("base first", [](int m, int k) { return m > 0 ? (m + 0.5) * pow(k - 136., 2.) : 0; });

  solid_angle("not on the sphere", [](int, int w, int h) { return 4 * pi / (w * h); });
  const auto by_edges = [](const char* text, auto edge) {  // the row's own and the next one's
    solid_angle(text, [=](int i, int w, int h) {
      return 2 * pi / w * (cos(edge(i, h)) - cos(edge(i + 1, h)));
    });
  };
  by_edges("whole numbers", [](int i, int h) { return i / h * pi; });
  by_edges("leave the half out", [](int i, int h) { return pi * (i - 0.5) / h; });
  by_edges("not by height - 1", [](int i, int h) { return pi * i / (h - 1); });

  using Sums = const std::vector<D>&;
  drawn_thing("not used", [](Sums sums, D r) { return round(r * (sums.size() - 1)); });
  drawn_thing("limit the index", [](Sums sums, D r) {
    return std::upper_bound(sums.begin(), sums.end(), r) - sums.begin();
  });
  drawn_thing("you count the sums", [](Sums sums, D r) {
    return sums.end() - std::upper_bound(sums.begin(), sums.end(), r);
  });
}
