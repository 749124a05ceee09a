// The exercises of chapter 12, and what strangers write for them.
#include "solutions/12.hpp"

const std::vector<double> texmap::test::answers{600, 122};

TEST_CASE("12: strangers' answers get their words") {
  mirrored_sky("painted on the ball", [](Uv at) {
    const D x = at.u * 2 - 1, y = at.v * 2 - 1;
    return V{x, y, sqrt(1 - x * x - y * y)};
  });
  const auto by_normal = [](const char* text, auto normal) {  // of x and y from -1 to 1
    mirrored_sky(text, [=](Uv at) {
      const V n = normal(2 * at.u - 1, 2 * at.v - 1), d{0, 0, -1};
      return d - 2 * dot(n, d) * n;
    });
  };
  by_normal("z is sqrt", [](D x, D y) { return V{x, y, 1 - x * x - y * y}; });
  by_normal("take 2 u - 1", [](D x, D y) {
    const D u = (x + 1) / 2, v = (y + 1) / 2;
    return V{u, v, sqrt(1 - u * u - v * v)};
  });
  mirrored_sky("back to the camera", [](Uv at) {
    const V n{2 * at.u - 1, 2 * at.v - 1, 0}, e{0, 0, -1};
    const V up = n + V{0, 0, sqrt(1 - dot(n, n))};
    return 2 * dot(up, e) * up - e;
  });

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
  by_row("in its middle",
         [](D a, D b) { return 2 * cos((a + b) / 2) * sin((a + b) / 2) * (b - a); });
  by_row("yours is half of it", [](D a, D b) { return (cos(2 * a) - cos(2 * b)) / 4; });

  weight_of("for one direction by each way",
            [](D c, D q, int, int) { return max(c, 0.) / (max(c, 0.) + pi * q); });
  weight_of("return 0", [](D c, D q, int m, int k) { return c / pi / (m * c / pi + k * q); });
  weight_of("as they are", [](D c, D q, int m, int k) { return c > 0 ? c / (m * c + k * q) : 0; });
  weight_of("not divided by m + k", [](D c, D q, int m, int k) {
    return c < 0 ? 0 : c / (c * m / (m + k) + pi * q * k / (m + k));
  });
}
