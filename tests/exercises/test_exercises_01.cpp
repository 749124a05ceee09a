// The exercises of chapter 01, and what strangers write for them.
#include "starts/01.hpp"

const std::vector<double> texmap::test::answers{40, acos(0.375) * 180 / ::pi};

TEST_CASE("01: strangers' answers get their words") {
  distance_to_sphere("", [](V o, V d, V s, D r) { return o.z; });
  const auto by_root = [](const char* text, auto t_of) {  // of a, b and the root are right
    distance_to_sphere(text, [=](V o, V d, V s, D r) {
      const D a = dot(d, d), b = dot(s - o, d);
      return t_of(a, b, sqrt(b * b - a * (dot(o - s, o - s) - r * r)));
    });
  };
  distance_to_sphere.right([](V o, V d, V s, D r) {  // its result is rounded to a float
    const D a = dot(d, d), b = dot(s - o, d), inside = b * b - a * (dot(o - s, o - s) - r * r);
    const float t = float((b - sqrt(inside)) / a), far = float((b + sqrt(inside)) / a);
    return D(t > 0 ? t : far > 0 ? far : infinity);
  });
  by_root("ray leaves the", [](D a, D b, D q) { return b + q > 0 ? (b + q) / a : infinity; });
  by_root("only t > 0 counts", [](D a, D b, D q) { return q >= 0 ? (b - q) / a : infinity; });
  by_root("starts inside", [](D a, D b, D q) { return b - q > 0 ? (b - q) / a : infinity; });
  by_root("parentheses", [](D a, D b, D q) { return q >= 0 ? 2 * b - 2 * q / (2 * a) : infinity; });
  by_root("std::abs", [](D a, D b, D q) { return q >= 0 ? abs((b - q) / a) : infinity; });

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
