// Chapter 08's symptoms: weights of corners, their (u, v) and wrapping, with the word.
#include "scene/edge_function.hpp"
#include "support/symptoms.hpp"
#include "texture/mesh_mapping.hpp"
#include "texture/wrap.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// What a ray straight down at (x, y) crosses of a triangle.
Crossing<double> at(double x, double y) {
  const RaySpace<double> space(Ray<double>{{x, y, 1}, {0, 0, -1}});
  return crossing(space, seen_along(space, Point{0, 0, 0}), seen_along(space, Point{4, 0, 0}),
                  seen_along(space, Point{0, 4, 0}));
}

}  // namespace

TEST_CASE("each weight belongs to the opposite area") {
  const auto inside = at(1, 0.5);
  expect_number("the weight of b at (1, 0.5)", inside.b, 0.25,
                {{0.625, "the weights of the corners are exchanged"},
                 {0.125, "the weights of the corners are exchanged"},
                 {4, "an area was not divided by the whole one"},
                 {-4, "an area was not divided by the whole one"}});
  expect_number("the sum of the weights", inside.a + inside.b + inside.c, 1, {},
                "divide by the whole area");
  expect_that(!at(-1, 2).met, "a ray beside an edge meets nothing",
              "areas lost their sign: every point is inside");
}

TEST_CASE("(u, v) is the mean of the corners' by their weights") {
  const MeshMapping mapping{{{{{0, 0}, {1, 0}, {0, 1}}}}};
  MeshHit<double> hit;
  hit.triangle = 0;
  hit.a = 0.25;
  hit.b = 0.5;
  hit.c = 0.25;
  expect_number("u with the weights 1/4, 1/2, 1/4", mapping(hit).u, 0.5,
                {{0.25, "the weights of the corners are exchanged"}});
}

TEST_CASE("beyond its edges the texture goes on as was asked for") {
  expect_number("1.25 repeated", wrapped_coordinate(Wrap::repeat, 1.25), 0.25,
                {{1, "limited to 1 and not repeated (clamp)"}, {0.75, "mirrored, not repeated"}});
  expect_number("-0.25 repeated", wrapped_coordinate(Wrap::repeat, -0.25), 0.75,
                {{0.25, "the sign was lost: use floor, not a cut towards 0"},
                 {-0.25, "fmod of a negative number is negative: use floor"}});
  expect_number("1.25 mirrored", wrapped_coordinate(Wrap::mirror, 1.25), 0.75,
                {{0.25, "repeated, not mirrored"}});
  expect_number("-0.25 mirrored", wrapped_coordinate(Wrap::mirror, -0.25), 0.25,
                {{0.75, "repeated, not mirrored"}});
  expect_number("1.25 clamped", wrapped_coordinate(Wrap::clamp, 1.25), 1,
                {{0.25, "repeated, not limited to the edge"}, {1.25, "not limited to 1"}});
}
