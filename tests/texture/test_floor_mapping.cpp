// Tests of common/texture/floor_mapping.hpp: a picture laid on the floor.
#include "texture/floor_mapping.hpp"

#include <doctest.h>

namespace texmap::test {
namespace {

TEST_CASE("a copy begins at the origin and is as large as it says; it reads from above") {
  const FloorMapping mapping{.size = 8};
  struct Row {
    Vec3d point;
    double u, v;
  };
  for (const Row& row : {Row{{0, 0, 0}, 0.5, 0}, Row{{-4, 0, 0}, 0, 0}, Row{{4, 0, -8}, 1, 1},
                         Row{{2, 0, -2}, 0.75, 0.25}, Row{{0, -7, 4}, 0.5, -0.5}}) {
    const Uv<double> uv = mapping(row.point);
    CHECK(uv.u == row.u);
    CHECK(uv.v == row.v);
  }
  // Looking to -z, +x is on the right and farther is up: u then v turn as x then y do.
  const Uv<double> origin = mapping(Vec3d{0, 0, 0});
  CHECK(mapping(Vec3d{1, 0, 0}).u > origin.u);
  CHECK(mapping(Vec3d{0, 0, -1}).v > origin.v);
}

}  // namespace
}  // namespace texmap::test
