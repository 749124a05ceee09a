// Chapter 07's symptoms: many samples, linear light and scattered directions, with the word.
#include <vector>

#include "math/srgb.hpp"
#include "sampling/directions.hpp"
#include "scene/path.hpp"
#include "scene/sky.hpp"
#include "support/symptoms.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// Numbers on a regular grid of n x n, one after another.
struct GridOfSamples {
  int n;
  int next = 0;

  Point2<double> next_2d() {
    const int i = next++ % (n * n);
    return {(i % n + 0.5) / n, (i / n + 0.5) / n};
  }
};

}  // namespace

TEST_CASE("bytes are light on a curve: decode before averaging, encode before writing") {
  expect_number("the light of the byte 188 / 255", srgb_decode(188 / 255.0), 0.5028864580,
                {{188 / 255.0, "the curve of image files is missing"},
                 {srgb_encode(188 / 255.0), "encoded in place of decoded"},
                 {std::pow(188 / 255.0, 2.2), "a power of 2.2 is near the curve, but not it"}});
  expect_number("the channel that shows half of the light", srgb_encode(0.5), 0.7353569831,
                {{0.5, "the curve of image files is missing: the picture is too dark"},
                 {srgb_decode(0.5), "decoded in place of encoded: the picture is too dark"},
                 {std::sqrt(0.5), "a square root is near the curve, but not it"}});
}

TEST_CASE("light is scattered above the surface, more of it along the normal") {
  const Vec3d normal = normalize(Vec3d{1, 2, -2});
  GridOfSamples random{64};
  double sum = 0, least = 1;
  for (int i = 0; i < 64 * 64; ++i) {
    const double cosine = dot(normal, cosine_direction(normal, random.next_2d()));
    sum += cosine;
    least = min(cosine, least);
  }
  expect_that(least > 0, "scattered directions lie above the surface",
              "some point into the sphere");
  expect_number("the mean cosine of scattered directions", sum / (64 * 64), 2 / 3.0, {},
                "1/2 is the mean of directions that are all equally likely: Lambert's is 2/3",
                0.01);
}

TEST_CASE("a white sphere under a white sky is white: no light is lost and none is made") {
  struct White {
    Sphere<> shape{{0, 0, 0}, 1};
    Rgb paint(const Hit<double>&) const { return {1, 1, 1}; }
  };
  const std::vector<White> objects(1);
  const GradientSky sky{{1, 1, 1}, {1, 1, 1}};
  GridOfSamples random{8};
  const Ray<double> ray{{0, 0, 5}, {0, 0, -1}};
  expect_number("the light of a white sphere under a white sky",
                light_along(objects, ray, sky, 50, random).r, 1,
                {{0, "paths end at the sphere: the first bounce is missing"},
                 {0.5, "half of the light is lost at each bounce"}});
}
