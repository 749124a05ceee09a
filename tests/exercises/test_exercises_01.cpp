// The exercises of chapter 01, and what strangers write for them.
#include "solutions/01.hpp"

const std::vector<double> texmap::test::answers{40, acos(0.375) * 180 / ::pi};

TEST_CASE("01: strangers' answers get their words") {
  distance_to_bowl("", [](V o, V d, V s, D r, D rim) { return o.z; });
  const auto by_roots = [](const char* text, auto t_of) {  // of two right t, and of what is left
    distance_to_bowl(text, [=](V o, V d, V s, D r, D rim) {
      const D a = dot(d, d), b = dot(s - o, d), q = sqrt(b * b - a * (dot(o - s, o - s) - r * r));
      const auto left = [=](D t) { return t > 0 && o.y + t * d.y <= rim; };
      return t_of((b - q) / a, (b + q) / a, left);
    });
  };
  distance_to_bowl.right([](V o, V d, V s, D r, D rim) {  // its result is rounded to a float
    const D a = dot(d, d), b = dot(s - o, d), q = sqrt(b * b - a * (dot(o - s, o - s) - r * r));
    for (const float t : {float((b - q) / a), float((b + q) / a)})
      if (t > 0 && o.y + t * d.y <= rim) return D(t);
    return infinity;
  });
  by_roots("comes second", [](D t, D u, auto left) { return left(u) ? u : infinity; });
  by_roots("open top", [](D t, D u, auto left) { return left(t) ? t : infinity; });
  by_roots("from inside", [](D t, D u, auto left) { return t > 0 ? t : infinity; });
  by_roots("cut away", [](D t, D u, auto left) { return t > 0 ? t : u > 0 ? u : infinity; });
  by_roots("behind the origin", [](D t, D u, auto left) { return std::isnan(t) ? infinity : t; });

  light_on_paper("", [](V p, V n, V l, D s) { return 0.4; });
  light_on_paper("lamp is a position", [](V p, V n, V l, D s) { return max(dot(n, l), 0.0); });
  const auto by_cosine = [](const char* text, auto light) {
    light_on_paper(text, [=](V p, V n, V l, D s) { return light(dot(n, normalize(l - p)), s); });
  };
  light_on_paper.right([](V p, V n, V l, D s) {  // it asks first, and calculates in float
    const float c = dot(normalize(l - p), n);
    if (c < 0) return s * dot(-n, normalize(l - p));
    return D(c);
  });
  by_cosine("is dark", [](D c, D s) { return max(c, 0.0); });
  by_cosine("share is missing", [](D c, D s) { return abs(c); });
  by_cosine("slanted light", [](D c, D s) { return c < 0 ? s : c; });
  by_cosine("without 1 +", [](D c, D s) { return c > 0 ? c : s * (1 + c); });
  by_cosine("negative light", [](D c, D s) { return c < 0 ? s * c : c; });

  using Hit = const FirstHit&;
  using Row = const std::vector<V>&;
  const auto by_share = [](const char* text, auto seen, auto share) {  // of start, lamp, way
    visible(text, [=](V p, V n, Row lamps, Hit hit) {
      int count = 0;
      for (const V lamp : lamps) count += seen(p + 0.001 * n, lamp, hit);
      return share(count, int(lamps.size()));
    });
  };
  const auto right = [](V s, V l, Hit hit) { return hit(s, l - s) > 1; };
  const auto part = [](int seen, int all) { return 1. * seen / all; };
  visible.right([=](V p, V n, Row lamps, Hit hit) {
    float hidden = 0;
    for (V l : lamps) hidden += dot(n, l - p) > 0 && right(p + n / 1000, l, hit) ? 0 : 1;
    return 1 - hidden / lamps.size();
  });
  by_share("divide in double", right, [](int seen, int all) { return D(seen / all); });
  by_share("how many lamps", right, [](int seen, int all) { return D(seen); });
  by_share(
      "direction and distance do not fit",
      [](V s, V l, Hit hit) { return hit(s, l - s) > length(l - s); }, part);
  by_share(
      "behind the lamp", [](V s, V l, Hit hit) { return hit(s, l - s) == infinity; }, part);
}
