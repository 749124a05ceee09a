// Chapter 10's symptoms: seven maps of the sphere and their inverses, with the word.
#include "support/symptoms.hpp"
#include "texture/projection_facts.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("the maps that look from above have the north pole in the middle and +x on the right") {
  for (const Projection map : {Projection::plane, Projection::octahedral, Projection::equal_area}) {
    const std::string name = facts_of(map).word;
    const auto place = [map](const Vec3d& p) { return project(map, normalize(p)); };
    expect_number("u of the north pole on " + name, place({0, 1, 0}).u, 0.5, {},
                  "the square from -1 to 1 must become 0 to 1");
    expect_that(place({0.6, 0.8, 0}).u > 0.5, "+x lies on the right of " + name,
                "u runs the other way (mirrored)");
    expect_that(place({0, 0.8, -0.6}).v > 0.5, "-z lies in the upper half of " + name,
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
  const Vec3d above = normalize(Vec3d{0.3, 0.8, 0.4});
  for (const ProjectionFacts& facts : projections) {
    const Vec3d back = unproject(facts.projection, project(facts.projection, above));
    const std::string name = facts.word;
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
