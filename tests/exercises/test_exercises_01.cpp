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
  by_roots("cut away", [](D t, D u, auto left) { return t > 0 ? t : u > 0 ? u : infinity; });
  by_roots("behind the origin", [](D t, D u, auto left) { return std::isnan(t) ? infinity : t; });

  cosine_of("", [](V p, V n, V l) { return 0.4; });
  cosine_of("lamp is a position", [](V p, V n, V l) { return max(dot(n, l), 0.0); });
  cosine_of("cross product", [](V p, V n, V l) { return length(cross(normalize(l - p), n)); });

  using Hit = const FirstHit&;
  in_shadow("behind the surface", [](V p, V n, V l, Hit) { return dot(n, normalize(l - p)) <= 0; });
  const auto from = [](const char* text, auto hidden) {  // the ray starts where it has to
    in_shadow(text, [=](V p, V n, V l, Hit hit) { return hidden(p + 0.001 * n, l, hit); });
  };
  from("direction and distance do not fit",
       [](V s, V l, Hit hit) { return hit(s, l - s) < length(l - s); });
  from("true everywhere", [](V s, V l, Hit hit) { return hit(s, normalize(l - s)) > 0; });
}
