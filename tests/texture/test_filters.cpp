// Tests of common/texture/filters.hpp: the mean light of a footprint, from few texels.
#include "texture/filters.hpp"

#include <doctest.h>

#include <cmath>

#include "support/made_pictures.hpp"

namespace texmap::test {
namespace {

constexpr std::array filters = {Filter::nearest,     Filter::bilinear, Filter::trilinear,
                                Filter::anisotropic, Filter::ewa,      Filter::stochastic};
constexpr std::array wraps = {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border,
                              Wrap::spherical};

template <class Real>
Uv<Dual<Real>> place(Real u, Real v, Real u_by_x, Real u_by_y, Real v_by_x, Real v_by_y) {
  return {{u, u_by_x, u_by_y}, {v, v_by_x, v_by_y}};
}
/// A place with an axis-aligned footprint of a x b texels of an image.
Uv<Dual<double>> place_of(double u, double v, double a, double b, int width, int height) {
  return place(u, v, a / width, 0.0, 0.0, b / height);
}

TEST_CASE("between two levels the mean square of the widths is the footprint's") {
  for (int i = 0; i <= 4000; ++i) {
    const double width = 1 + i / 64.0;
    const LevelPlace<double> level = level_place(width, 20);
    const double square = std::pow(4.0, level.number) * (1 + 3 * level.fraction);
    REQUIRE(std::abs(square - width * width) < 1e-12 * square);
    REQUIRE((level.fraction >= 0 && level.fraction <= 1));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double width : {0.0, -3.0, 1e-20, 0.99, nan, 16384.0, 1e20, infinity<double>()}) {
    CHECK(level_place(width, 14).number == (width > 1 ? 14 : 0));
    CHECK(level_place(width, 14).fraction == 0);
  }
}

TEST_CASE("constant in, constant out, whatever the filter, the wrap, the size and the footprint") {
  Dice dice(7);
  const Color<float> color{0.25F, 0.7F, 0.001F};
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(1, 7), std::pair(5, 3), std::pair(16, 16), std::pair(40, 2)}) {
    for (const Filter filter : filters) {
      for (const Wrap wrap : wraps) {
        const FilteredTexture texture{.pyramid = pyramid_of(LightImage(width, height, color)),
                                      .filter = filter,
                                      .wrap = wrap,
                                      .border = {color.r, color.g, color.b}};
        for (int i = 0; i < 40; ++i) {
          const double size = std::exp(dice.between(-8, 3));
          const auto any = [&] { return size * dice.between(-1, 1); };
          const Color<double> found = texture.filtered(
              place(dice.between(-2, 3), dice.between(-2, 3), any(), any(), any(), any()));
          REQUIRE(std::abs(found.r - color.r) < 1e-14);
          REQUIRE(std::abs(found.g - color.g) < 1e-14);
          REQUIRE(std::abs(found.b - color.b) < 1e-16);
        }
      }
    }
  }
}

TEST_CASE("drawn one to one at its texels' centers, a picture comes back to the last bit") {
  const LightImage image = light_noise(16, 8);
  for (const Filter filter :  // the others mix neighbors in, or take them by chance
       {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic}) {
    for (const Wrap wrap : wraps) {
      for (const VAxis axis : {VAxis::up, VAxis::down}) {
        const FilteredTexture texture{
            .pyramid = pyramid_of(image), .filter = filter, .wrap = wrap, .v_axis = axis};
        for (int row = 0; row < 8; ++row) {
          for (int column = 0; column < 16; ++column) {
            const double v = ((axis == VAxis::down ? row : 7 - row) + 0.5) / 8;
            const auto found = texture.filtered(place_of((column + 0.5) / 16, v, 1, 1, 16, 8));
            const Color<float>& texel = image.at(column, row);
            REQUIRE((found.r == texel.r && found.g == texel.g && found.b == texel.b));
          }
        }
      }
    }
  }
}

TEST_CASE(
    "everywhere the bilinear filter mixes the four texels that the wrap mode shows around it") {
  constexpr int width = 6, height = 4;
  const LightImage image = light_noise(width, height);
  Dice dice(9);
  for (const Wrap wrap : wraps) {
    CAPTURE(static_cast<int>(wrap));
    const FilteredTexture texture{.pyramid = pyramid_of(image),
                                  .wrap = wrap,
                                  .v_axis = VAxis::down,
                                  .border = {0.25, 0.5, 0.75}};
    for (int i = 0; i < 2000; ++i) {
      const Uv<double> at{dice.between(-3, 4), dice.between(-3, 4)};
      double sum = 0;  // of texels weighted by a tent
      for (int row = -4 * height; row < 5 * height; ++row) {
        for (int column = -4 * width; column < 5 * width; ++column) {
          const auto texel = wrapped_texel<double>(wrap, column, row, width, height);
          const double light =
              texel.inside
                  ? static_cast<double>(
                        image.at(static_cast<int>(texel.column), static_cast<int>(texel.row)).g)
                  : 0.5;
          sum += light * std::max(0.0, 1 - std::abs(at.u * width - column - 0.5)) *
                 std::max(0.0, 1 - std::abs(at.v * height - row - 0.5));
        }
      }
      REQUIRE(std::abs(texture(at).g - sum) < 1e-12);
    }
  }
}

TEST_CASE(
    "the elliptical filter weighs texels by (1 - r^2)^2; its ellipse spreads as the footprint") {
  constexpr int size = 32;
  const LightImage image = light_noise(size, size);
  const FilteredTexture texture{
      .pyramid = pyramid_of(image), .filter = Filter::ewa, .v_axis = VAxis::down};
  Dice dice(14);
  for (int i = 0; i < 300; ++i) {
    // A side of 1.2 to 1.9 texels is read in the picture itself; the other is up to 12 long.
    const double angle = dice.between(0, 3), c = std::cos(angle), s = std::sin(angle);
    const double longer = dice.between(2, 12), shorter = dice.between(1.2, 1.9);
    const auto uv = place(dice.between(0, 1), dice.between(0, 1), longer * c / size,
                          -shorter * s / size, longer * s / size, shorter * c / size);
    const auto ellipse = texture.ellipse_of(footprint_of<double>(uv, size, size));
    REQUIRE(ellipse.level.width == size);
    // Its variance is that of the footprint, side^2 / 12, and 1/8 for the texel added.
    const double a = 8 * ((square(longer * c) + square(shorter * s)) / 12 + 0.125);
    const double b = 8 * (square(longer) - square(shorter)) * c * s / 12;
    const double d = 8 * ((square(longer * s) + square(shorter * c)) / 12 + 0.125);
    REQUIRE(ellipse.a == doctest::Approx(a));
    REQUIRE(ellipse.b == doctest::Approx(b));
    REQUIRE(ellipse.c == doctest::Approx(d));
    double sum = 0, weights = 0;
    for (int row = -size; row < 2 * size; ++row) {
      for (int column = -size; column < 2 * size; ++column) {
        const double x = column + 0.5 - uv.u.value * size, y = row + 0.5 - uv.v.value * size;
        const double radius = (d * x * x - 2 * b * x * y + a * y * y) / (a * d - b * b);
        const double weight = square(std::max(0.0, 1 - radius));
        sum += weight * image.at((column + size) % size, (row + size) % size).g;
        weights += weight;
      }
    }
    REQUIRE(texture.filtered(uv).g == doctest::Approx(sum / weights).epsilon(1e-9));
  }
}

TEST_CASE("the stochastic filter's mean is the anisotropic filter's") {
  const FilteredTexture full{.pyramid = pyramid_of(light_noise(32, 32)), .taps = 4};
  Dice dice(12);
  for (int i = 0; i < 8; ++i) {
    const double size = std::exp(dice.between(-4.5, -2));
    const auto any = [&] { return size * dice.between(-1, 1); };
    const Uv<double> at{dice.between(0, 1), dice.between(0, 1)};
    const auto footprint = footprint_of(place(at.u, at.v, any(), any(), any(), any()), 32.0, 32.0);
    Color<double> sum{};
    for (int k = 0; k < 65536; ++k) {  // 16 strata of each random number, at random in each
      const auto part = [&](int shift) { return ((k >> shift & 15) + dice.between(0, 1)) / 16; };
      const double tap = part(0), level = part(4), column = part(8), row = part(12);
      sum = sum + full.one_of_many(at, footprint, {tap, level, column, row});
    }
    const Color<double> off = sum * (1.0 / 65536) + full.filtered(at, footprint) * -1.0;
    CHECK(std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}) < 2e-3);
  }
}

TEST_CASE("its random numbers come from the place alone, and differ from place to place") {
  const FilteredTexture texture{.pyramid = pyramid_of(light_noise(64, 64)),
                                .filter = Filter::stochastic};
  const FilteredTexture full{.pyramid = texture.pyramid, .filter = Filter::anisotropic};
  double sum = 0, expected = 0, differences = 0;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const auto at = place_of(0.3 + i * 1e-9, 0.4 + i * 3e-9, 12, 3, 64, 64);  // nearly one place
    const double light = texture.filtered(at).r;
    REQUIRE(light == texture.filtered(at).r);
    sum += light;
    expected += full.filtered(at).r;
    differences += std::abs(light - full.filtered(at).r);
  }
  CHECK(std::abs(sum - expected) / count < 0.01);
  CHECK(differences / count > 0.02);  // of single texels
}

TEST_CASE_TEMPLATE("no place and no footprint leaves the image or a color's range", Real, float,
                   double) {
  Dice dice(15);
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 9), std::pair(16, 8)}) {
    for (const Filter filter : filters) {
      for (const Wrap wrap : wraps) {
        const FilteredTexture texture{.pyramid = pyramid_of(light_noise(width, height)),
                                      .filter = filter,
                                      .wrap = wrap,
                                      .taps = 4};
        for (int i = 0; i < 1000; ++i) {
          const auto any = [&] {
            return dice.once_in(2) ? dice.anything<Real>() : static_cast<Real>(dice.between(-3, 3));
          };
          const auto step = [&] { return dice.once_in(4) ? any() : any() * Real(0.01); };
          const auto found = texture.filtered(place(any(), any(), step(), step(), step(), step()));
          REQUIRE((found.r >= 0 && found.r <= Real(1.0001)));
        }
      }
    }
  }
  CHECK(FilteredTexture{}.filtered(place<Real>(0, 0, 1, 1, 1, 1)).r == 0);
}

TEST_CASE("a pixel on a globe's pole shows the land around it and not the whole globe's mean") {
  LightImage map(1024, 512);
  for (int row = 0; row < 64; ++row) {  // ice
    for (int column = 0; column < 1024; ++column) map.at(column, row).r = 1;
  }
  for (const double aside : {0.0, 1e-100, 1e-12, 1e-4, -1e-4}) {
    CAPTURE(aside);
    const Vec3<Dual<double>> direction{{aside, 0.01, 0.0}, {1.0}, {aside, 0.0, 0.01}};
    const auto light = [&](Wrap wrap) {
      const FilteredTexture texture{.pyramid = pyramid_of(map), .wrap = wrap};
      return texture.filtered(uv_rtiow(direction)).r;
    };
    CHECK(light(Wrap::spherical) > 0.75);
    if (aside > 0 && aside < 1e-3) CHECK(light(Wrap::clamp) < 0.3);  // without a limit to u
  }
  // In the pole itself, too, all meridians are seen, and not one of them.
  LightImage meridian(64, 32);
  for (int row = 0; row < 32; ++row) {
    for (int column = 30; column < 34; ++column) meridian.at(column, row).r = 1;
  }
  for (const Filter filter : {Filter::trilinear, Filter::anisotropic, Filter::ewa}) {
    const FilteredTexture globe{
        .pyramid = pyramid_of(meridian), .filter = filter, .wrap = Wrap::spherical};
    const Vec3<Dual<double>> pole{{0.0, 0.01, 0.0}, {1.0}, {0.0, 0.0, 0.01}};
    CHECK(globe.filtered(uv_rtiow(pole)).r < 0.1);  // 4 of 64 columns are white
  }
}

}  // namespace
}  // namespace texmap::test
