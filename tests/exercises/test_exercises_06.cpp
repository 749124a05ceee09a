// The exercises of chapter 06, and what strangers write for them.
#include "solutions/06.hpp"

const std::vector<double> texmap::test::answers{698.0 / 75, 60};

TEST_CASE("06: strangers' answers get their words") {
  mirrored("this mirrors l", [](V d, V n) { return n * (2 * dot(n, d)) - d; });
  mirrored("counts once", [](V d, V n) { return normalize(d - n * dot(n, d)); });
  mirrored("other side of n", [](V d, V n) { return normalize((n - d) / 2); });
  mirrored("no std::abs", [](V d, V n) { return d - 2 * min(0., dot(n, d)) * n; });
  mirrored("n = +y at most", [](V d, V n) { return V{d.x, -d.y, d.z}; });
  mirrored("shorter than n", [](V d, V n) { return d - 2 * dot(n, n) * n; });

  const auto shine = [](const char* text, auto of) {  // of n, l, the mirrored l, the eye
    highlight(text, [=](V n, V to_lamp, V d, D s) {
      const V l = to_lamp / length(to_lamp);
      return dot(n, l) > 0 ? of(n, l, 2 * dot(n, l) * n - l, -d, s) : 0;
    });
  };
  shine("wrong sign", [](V n, V l, V r, V e, D s) { return pow(max(0., dot(r, -e)), s); });
  shine("not limited", [](V n, V l, V r, V e, D s) { return max(pow(dot(r, e), s), 0.); });
  shine("the angle", [](V n, V l, V r, V e, D s) { return pow(acos(max(dot(r, e), 0.)), s); });
  shine("added in r", [](V n, V l, V r, V e, D s) { return pow(max(dot(r + 2 * l, e), 0.), s); });

  blended("added whole", [](Color c, D light, D t) { return c + Color{light, light, light}; });
  blended("a blend is a sum", [](Color c, D light, D t) { return c * min(light, 1.0); });
}
