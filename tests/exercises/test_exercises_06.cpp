// The exercises of chapter 06, and what strangers write for them.
#include "solutions/06.hpp"

const std::vector<double> texmap::test::answers{698.0 / 75, 60};

TEST_CASE("06: strangers' answers get their words") {
  mirrored("this mirrors l", [](V d, V n) { return n * (2 * dot(n, d)) - d; });
  mirrored("counts once", [](V d, V n) { return normalize(d - n * dot(n, d)); });
  mirrored("other side of n", [](V d, V n) { return normalize((n - d) / 2); });
  mirrored("no std::abs", [](V d, V n) { return d - 2 * min(0., dot(n, d)) * n; });
  mirrored("n = +y at most", [](V d, V n) { return V{d.x, -d.y, d.z}; });
  mirrored("not n", [](V d, V n) { return d - 2 * dot(n, n) * n; });

  const auto shine = [](const char* text, auto of) {  // of n, l, the eye
    highlight(text, [=](V n, V to_lamp, V d, D s) {
      const V l = to_lamp / length(to_lamp);
      return dot(n, l) > 0 ? of(n, l, -d, s) : 0;
    });
  };
  shine("does not have the length 1",
        [](V n, V l, V e, D s) { return pow(dot(n, (l + e) / 2), s); });
  shine("page's r . e",
        [](V n, V l, V e, D s) { return pow(max(0., dot(2 * dot(n, l) * n - l, e)), s); });
  shine("not between one of them and n",
        [](V n, V l, V e, D s) { return pow(dot(normalize(l + n), e), s); });
  shine("direction to the eye is -d",
        [](V n, V l, V e, D s) { return pow(max(0., dot(n, normalize(l - e))), s); });
  shine("is a sine", [](V n, V l, V e, D s) { return pow(length(cross(n, l + e)), s); });
  shine("at right angles", [](V n, V l, V e, D s) { return pow(dot(n, cross(l, e)), s); });
  shine("no half of an angle",
        [](V n, V l, V e, D s) { return pow(cos(acos(dot(n, normalize(l + e))) / 2), s); });
  highlight("test n . l first", [](V n, V to_lamp, V d, D s) {
    return pow(dot(n, normalize(normalize(to_lamp) - d)), s);
  });
  highlight.right([](V n, V to_lamp, V d, D s) {  // in float, and by half of the angle
    const V l = normalize(to_lamp), e = -d;
    const float c = dot(n, l + e) / sqrt(2 + 2 * dot(l, e));
    return dot(l, n) <= 0 ? 0 : D(std::pow(c, float(s)));
  });

  const auto mean = [](Color c) { return (c.r + c.g + c.b) / 3; };
  const auto print = [](const char* text, auto share) {
    printed(text, [=](Color c, D light, D t) {
      const D w = share(c, t), l = min(light, 1.0);
      return w * c + (1 - w) * Color{l, l, l};
    });
  };
  print("falls evenly", [](Color c, D t) { return t; });
  print("belong where it is white", [=](Color c, D t) { return t * mean(c); });
  print("the length of the color", [](Color c, D t) { return t * (1 - length(V{c.r, c.g, c.b})); });
  print("t is missing", [=](Color c, D t) { return 1 - mean(c); });
  print("divide the sum by 3", [](Color c, D t) { return t * (1 - (c.r + c.g + c.b)); });
  printed.right([=](Color c, D light, D t) {  // from the light toward the texture, in float
    const float w = t - t * mean(c), l = light > 1 ? 1 : light;
    return Color{l, l, l} + w * (c - Color{l, l, l});
  });
}
