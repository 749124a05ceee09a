// Chapter 05's symptoms: rotation about the vertical axis, with the word for a mistake.
#include <cmath>

#include "math/rotation.hpp"
#include "support/symptoms.hpp"
#include "texture/rotated.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("an angle is in degrees") {
  expect_number("the sine of 30 degrees", rotation_y(30).sine, 0.5,
                {{std::sin(30.0), "degrees were taken for radians"},
                 {-0.5, "it turns the other way"},
                 {std::sqrt(0.75), "sine and cosine are exchanged"}},
                "degrees were taken for radians, or converted twice");
}

TEST_CASE("a quarter turn carries +z to +x and leaves y alone") {
  const Vec3d turned = rotation_y(90)(Vec3d{0, 0.5, 1});
  expect_number("x of the turned +z", turned.x, 1,
                {{-1, "it turns the other way: the sign of the sine"},
                 {0, "the wrong axis, or no turn at all"},
                 {std::sin(90.0), "degrees were taken for radians"}});
  expect_number("y of the turned point", turned.y, 0.5, {}, "turn about y leaves y alone");
}

TEST_CASE("turning by an angle adds angle / 360 to u") {
  const Rotated<RtiowMapping> mapping{rotation_y(36), {}};
  const Vec3d front{0, 0, 1};
  expect_number(
      "u at +z, turned by 36 degrees", mapping(front).u, 0.35,
      {{0.15, "it turns the other way"},
       {0.25, "the mapping does not turn"},
       {uv_rtiow(Vec3d{std::sin(36.0), 0, std::cos(36.0)}).u, "degrees were taken for radians"}});
}
