// The exercises of chapter 12, and what strangers write for them.
#include "solutions/12.hpp"

const std::vector<double> texmap::test::answers{600, 122};

TEST_CASE("12: strangers' answers get their words") {
  const auto by_normal = [](const char* text, auto normal) {  // of x and y from -1 to 1
    mirrored_sky(text, [=](Uv at) {
      const V n = normal(2 * at.u - 1, 2 * at.v - 1), d{0, 0, -1};
      return d - 2 * dot(n, d) * n;
    });
  };
  by_normal("z is sqrt", [](D x, D y) { return V{x, y, 1 - x * x - y * y}; });
  by_normal("painted", [](D x, D y) { return normalize(V{x, y, sqrt(1 - x * x - y * y) + 1}); });

  using Rows = const std::vector<D>&;
  const auto by_row = [](const char* text, auto counts) {  // of the upper half
    light_of_ground(text, [=](Rows rows) {
      D sum = 0;
      const D step = pi / rows.size();
      for (std::size_t i = 0; i < rows.size(); ++i)
        sum += rows[i] * counts(min(i * step, pi / 2), min((i + 1) * step, pi / 2));
      return sum;
    });
  };
  by_row("cosine is missing", [](D a, D b) { return cos(a) - cos(b); });
  by_row("divide by it", [](D a, D b) { return pi * (pow(sin(b), 2) - pow(sin(a), 2)); });
  by_row("yours is half of it", [](D a, D b) { return (cos(2 * a) - cos(2 * b)) / 4; });

  weight_of("return 0", [](D c, D q, int m, int k) { return c / pi / (m * c / pi + k * q); });
  weight_of("as they are", [](D c, D q, int m, int k) { return c > 0 ? c / (m * c + k * q) : 0; });
}
