// Chapter 10's symptoms: seven maps of the sphere and their inverses, with the word.
#include "support/symptoms.hpp"
#include "texture/projections.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

constexpr Projection all_projections[] = {
    Projection::equirect,     Projection::plane,      Projection::cylinder,  Projection::cube,
    Projection::equi_angular, Projection::octahedral, Projection::equal_area};
const char* const names[] = {"equirect",     "plane",      "cylinder",  "cube",
                             "equi_angular", "octahedral", "equal_area"};

const Vec3d above = normalize(Vec3d{0.3, 0.8, 0.4});

}  // namespace

TEST_CASE("the maps that look from above have the north pole in the middle and +x on the right") {
  for (const std::size_t i : {1U, 5U, 6U}) {
    const Uv<double> pole = project(all_projections[i], Vec3d{0, 1, 0});
    expect_number(std::string("u of the north pole on ") + names[i], pole.u, 0.5, {},
                  "the square from -1 to 1 must become 0 to 1");
    const Uv<double> right = project(all_projections[i], normalize(Vec3d{0.6, 0.8, 0}));
    expect_that(right.u > 0.5, std::string("+x lies on the right of ") + names[i],
                "u runs the other way (mirrored)");
    const Uv<double> back = project(all_projections[i], normalize(Vec3d{0, 0.8, -0.6}));
    expect_that(back.v > 0.5, std::string("-z lies in the upper half of ") + names[i],
                "v runs the other way (flipped)");
  }
}

TEST_CASE("the cylinder keeps heights, the globe's map keeps angles") {
  const Vec3d half_way{0, 0.5, std::sqrt(0.75)};  // 30 degrees north
  expect_number("v at 30 degrees north on the cylinder", project(Projection::cylinder, half_way).v,
                0.75, {{2 / 3.0, "this is the angle; the cylinder takes the height"}});
  expect_number("v at 30 degrees north on the equirectangular map",
                project(Projection::equirect, half_way).v, 2 / 3.0,
                {{0.75, "this is the height; the map of latitudes takes the angle"}});
}

TEST_CASE("the inverse leads back to where a direction was") {
  for (std::size_t i = 0; i < std::size(all_projections); ++i) {
    const Vec3d back = unproject(all_projections[i], project(all_projections[i], above));
    const std::string name = names[i];
    expect_number(
        "x after " + name + " and back", back.x, above.x,
        {{-above.x, "u runs the other way (mirrored)"}, {above.z, "x and z are exchanged"}},
        "the inverse belongs to another map");
    expect_number("y after " + name + " and back", back.y, above.y,
                  {{-above.y, "the lower and the upper half are exchanged"}},
                  "the inverse belongs to another map");
    expect_number("z after " + name + " and back", back.z, above.z,
                  {{-above.z, "v runs the other way (flipped)"}},
                  "the inverse belongs to another map");
  }
}
