// The exercise of chapter 11, and what strangers write for it.
#include "solutions/11.hpp"

const std::vector<double> texmap::test::answers{14, 0.32};

TEST_CASE("11: strangers' answers get their words") {
  scratched("Add slopes, not normals", [](V b, V s) { return normalize(b + s); });
  scratched("divide by z first", [](V b, V s) { return normalize(V{b.x + s.x, b.y + s.y, b.z}); });
  scratched("half as high", [](V b, V s) { return normalize(b / b.z + s / s.z); });
  scratched.right([](V b, V s) {
    return normalize(V{b.x * s.z + s.x * b.z, b.y * s.z + s.y * b.z, b.z * s.z});
  });
}
