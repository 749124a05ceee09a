// The exercises of chapter 06, and what strangers write for them.
#include "solutions/06.hpp"

const std::vector<double> texmap::test::answers{698.0 / 75, 60};

TEST_CASE("06: strangers' answers get their words") {
  mirrored("points into the surface", [](V l, V n) { return l - n * (2 * dot(n, l)); });
  mirrored("counts once", [](V l, V n) { return normalize(n * dot(n, l) - l); });
  mirrored("other side of n", [](V l, V n) { return normalize((l + n) / 2); });
  mirrored("no std::max", [](V l, V n) { return 2 * max(0., dot(n, l)) * n - l; });
  mirrored("n = +y at most", [](V l, V n) { return V{-l.x, l.y, l.z}; });
  mirrored("shorter than n", [](V l, V n) { return 2 * dot(n, n) * n - l; });

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
