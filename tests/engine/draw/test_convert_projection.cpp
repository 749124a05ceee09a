// Tests of common/engine/draw/convert_projection.hpp.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/compare/difference.hpp"
#include "engine/draw/convert_projection.hpp"
#include "support/made_pictures.hpp"
#include "support/shown_values.hpp"

namespace texmap::test {
namespace {

/// A smooth picture of the sphere: each channel a polynomial of the direction.
Image smooth(Projection projection, const PictureSize& size) {
  return image_of(size.width, size.height, [&](int column, int row) {
    const Vec3<double> p = unproject(
        projection, Uv<double>{(column + 0.5) / size.width, 1 - (row + 0.5) / size.height});
    const auto level = [](double x) { return static_cast<std::uint8_t>(128 + 100 * x); };
    return Rgb8{level(p.x * p.y), level(p.z), level(p.x * p.z + p.y * 0.4)};
  });
}

int largest_difference(const Image& a, const Image& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    most = std::max(most, channel_difference(a.pixels[i], b.pixels[i]));
  return most;
}

}  // namespace

TEST_CASE("a smooth picture in each layout is the equirectangular one converted, within 3 levels") {
  const Image source = smooth(Projection::equirect, {512, 256});
  for (const ProjectionFacts& facts : projections) {
    if (facts.projection == Projection::plane) continue;
    CAPTURE(std::string(facts.word));
    const PictureSize size = converted_size(source, Projection::equirect, facts.projection);
    const Image made = smooth(facts.projection, size);
    const Image converted =
        convert_projection(source, Projection::equirect, facts.projection, size);
    CHECK(largest_difference(made, converted) <= 3);
    const Image back = convert_projection(converted, facts.projection, Projection::equirect,
                                          {source.width, source.height});
    CHECK(largest_difference(source, back) <= 5);
    // Read in another layout it would not be the same.
    const Projection other =
        facts.projection == Projection::cube ? Projection::equi_angular : Projection::cube;
    const Image wrong =
        convert_projection(converted, other, Projection::equirect, {source.width, source.height});
    CHECK(largest_difference(source, wrong) > 5);
  }
}

TEST_CASE("light is the same on both sides of every seam, even of noise") {
  const auto apart_at = [](const SharedLight& image, Projection projection, const Vec3<double>& p,
                           const Vec3<double>& across) {
    const double step = 1e-9;
    const Color<double> a = light_at(image, projection, project(projection, p + across * step));
    const Color<double> b = light_at(image, projection, project(projection, p + across * -step));
    REQUIRE(a.r + a.g + a.b + b.r + b.g + b.b >= 0);  // no NaN, which a maximum would lose
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
  };
  double worst = 0;
  const SharedLight cube(noise(48, 32, 2), TexelLight::linear);
  const SharedLight square_image(noise(32, 32, 3), TexelLight::linear);
  const SharedLight wide(noise(64, 32, 4), TexelLight::linear);
  for (int i = 0; i < 2000; ++i) {
    const double t = -1 + 2 * (i + 0.5) / 2000;
    for (const double one : {-1.0, 1.0}) {
      for (const double two : {-1.0, 1.0}) {
        for (const Projection projection : {Projection::cube, Projection::equi_angular}) {
          worst = std::max({worst, apart_at(cube, projection, {one, t, two}, {1, 0, 0}),
                            apart_at(cube, projection, {t, one, two}, {0, 1, 0}),
                            apart_at(cube, projection, {one, two, t}, {1, 0, 0})});
        }
      }
      for (const Projection projection : {Projection::octahedral, Projection::equal_area}) {
        worst = std::max({worst, apart_at(square_image, projection, {one, -t - 1, 0}, {0, 0, 1}),
                          apart_at(square_image, projection, {0, -t - 1, one}, {1, 0, 0})});
      }
    }
    for (const Projection projection : {Projection::equirect, Projection::cylinder})
      worst = std::max(worst, apart_at(wide, projection, {-1, t, 0}, {0, 0, 1}));
  }
  MESSAGE("largest jump across a seam: " << worst);
  CHECK(worst <= 1e-6);
  // Clamped at the edge, as for a picture without neighbors, noise would jump.
  const Color<double> left = light_at(wide, Projection::plane, {0.0, 0.5});
  const Color<double> right = light_at(wide, Projection::plane, {1 - 1e-9, 0.5});
  CHECK(std::abs(left.r - right.r) > 0.01);
}

TEST_CASE("where a plane's disk ends, none of the black around it is mixed in") {
  const Image white(64, 32, {255, 255, 255});
  const SharedLight disk(
      convert_projection(white, Projection::equirect, Projection::plane, {256, 256}),
      TexelLight::linear);
  double darkest = 1;
  for (int i = 0; i < 5000; ++i) {
    const double turn = 2 * static_cast<double>(pi_digits) * i / 5000;
    const Vec3<double> level{std::cos(turn), 0, std::sin(turn)};
    const Uv<double> rim = project(Projection::plane, level);
    darkest = std::min(darkest, light_at(disk, Projection::plane, rim).g);
  }
  CHECK(darkest == 1);
}

TEST_CASE("converted pictures have as many texels for the sphere, and a cube whole faces") {
  const Image source(2048, 1024);
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(std::string(facts.word));
    const PictureSize size = converted_size(source, Projection::equirect, facts.projection);
    const double texels = static_cast<double>(size.width) * size.height;
    const double for_the_sphere = texels * 4 * static_cast<double>(pi_digits) / facts.mean_texel;
    CHECK(for_the_sphere / (2048.0 * 1024) == doctest::Approx(1).epsilon(0.003));
    CHECK(static_cast<double>(size.width) / size.height ==
          doctest::Approx(facts.aspect).epsilon(0.002));
    if (facts.aspect == 1.5) CHECK((size.width % 3 == 0 && size.height % 2 == 0));
  }
  CHECK(converted_size(Image(1, 1), Projection::equirect, Projection::cube) == PictureSize{3, 2});
}

TEST_CASE("a picture that shrinks keeps its mean light, and threads change nothing") {
  // Stripes of one column: a sample sees black or white, their mean is half the light.
  const Image stripes = image_of(1024, 512, [](int column, int) {
    return column % 2 == 0 ? Rgb8{255, 255, 255} : Rgb8{};
  });
  const auto small = [&stripes](int threads) {
    return convert_projection(stripes, Projection::equirect, Projection::cylinder, {201, 64},
                              threads);
  };
  int off = 0;
  for (const Rgb8& p : small(1).pixels)
    off += std::abs(p.r - 188) > 20 ? 1 : 0;  // 188: half the light
  CHECK(off <= 201 * 64 / 20);
  CHECK(small(1) == small(3));
  for (const ProjectionFacts& facts : projections)
    CHECK(convert_projection(stripes, facts.projection, facts.projection, {1024, 512}) == stripes);
}

}  // namespace texmap::test
