// Tests of common/published/look_up.hpp: which texel a (u, v) anywhere shows; and of mip_map.hpp,
// where it is the course's trilinear filter (where it fails, chapter 14 shows). The bricks of the
// daily exercise (brick_normals.hpp), chapter 11's test sees pixel by pixel.
#include <doctest.h>

#include "published/look_up.hpp"
#include "published/mip_map.hpp"
#include "support/dice.hpp"

namespace texmap::test {
namespace {

using published::LookUpTexture;
using published::TexelFormula;

constexpr int columns = 8, rows = 4;

/// Red is the column, green the row.
Image numbered() {
  return image_of(columns, rows, [](int column, int row) {
    return Rgb8{static_cast<std::uint8_t>(column), static_cast<std::uint8_t>(row), 0};
  });
}

struct Place {
  int column, row;
  bool operator==(const Place&) const = default;
};

template <class Real>
Place shown(const LookUpTexture& texture, const Uv<Real>& uv) {
  const Color<Real> color = texture(uv);
  return {static_cast<int>(std::lround(color.r * 255)),
          static_cast<int>(std::lround(color.g * 255))};
}

/// One Weekend 2020's and the triangle article's texels, as their programs have them.
template <class Real>
Place one_weekend(Real u, Real v) {
  int i = int(u * columns);
  int j = int((1 - v) * rows - Real(0.001));
  if (i < 0) i = 0;
  if (j < 0) j = 0;
  if (i > columns - 1) i = columns - 1;
  if (j > rows - 1) j = rows - 1;
  return {i, j};
}
template <class Real>
Place article(Real u, Real v) {
  return {std::abs(int(u * columns)) % columns, std::abs(int(v * rows)) % rows};
}

TEST_CASE_TEMPLATE(
    "the documents' formulas find the texels that their programs find, far outside "
    "and on edges too",
    Real, float, double, long double) {
  const LookUpTexture weekend{{Wrap::repeat, {numbered()}}, TexelFormula::one_weekend_2020};
  const LookUpTexture triangle{{Wrap::repeat, {numbered(), VAxis::down}},
                               TexelFormula::triangle_article};
  Dice dice;
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&] {
      return i % 2 == 0 ? static_cast<Real>(dice.uniform(-9, 9))
                        : static_cast<Real>(dice.within(-300, 300)) / 32;
    };
    const Uv<Real> uv{any(), any()};
    CAPTURE(uv.u);
    CAPTURE(uv.v);
    REQUIRE(shown(weekend, uv) == one_weekend(uv.u, uv.v));
    REQUIRE(shown(triangle, uv) == article(uv.u, uv.v));
  }
}

TEST_CASE("0.001 of a row moves over to the next, and only with One Weekend 2020's formula") {
  const LookUpTexture weekend{{Wrap::clamp, {numbered()}}, TexelFormula::one_weekend_2020};
  const LookUpTexture course{{Wrap::clamp, {numbered()}}};
  for (const double rows_up : {0.0, 0.9985, 0.9995, 1.0, 3.9995, 4.0}) {
    CAPTURE(rows_up);
    const Uv<double> uv{0.5, rows_up / rows};
    const bool next = rows_up == 0.9995;
    CHECK(shown(weekend, uv).row == shown(course, uv).row - (next ? 1 : 0));
  }
}

TEST_CASE("v runs as in the image, an image without texels is black, and the course's way wraps") {
  for (const TexelFormula formula :
       {TexelFormula::course, TexelFormula::one_weekend_2020, TexelFormula::triangle_article}) {
    CHECK(shown(LookUpTexture{{Wrap::repeat, {numbered(), VAxis::up}}, formula},
                Uv<double>{0.4, 0.3}) == Place{3, 2});
    CHECK(shown(LookUpTexture{{Wrap::repeat, {numbered(), VAxis::down}}, formula},
                Uv<double>{0.4, 0.3}) == Place{3, 1});
    CHECK(LookUpTexture{{}, formula}(Uv<double>{0.4, 0.3}).r == 0);
  }
  CHECK(shown(LookUpTexture{{Wrap::repeat, {numbered()}}}, Uv<double>{-0.1, 1.3}) == Place{7, 2});
  CHECK(shown(LookUpTexture{{Wrap::mirror, {numbered()}}}, Uv<double>{-0.1, 1.3}) == Place{0, 1});
}

/// So many texels, the light of each its number.
FilteredTexture numbered(int width, int height) {
  LightImage image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = gray(static_cast<float>(i));
  return {.pyramid = pyramid_of(image), .filter = Filter::trilinear, .v_axis = VAxis::down};
}

/// A place with a pixel that covers so much of u and v.
Uv<Dual<double>> place(double u, double v, double along_u, double along_v) {
  return {{u, along_u, 0.0}, {v, 0.0, along_v}};
}

TEST_CASE("a square footprint of 2^k / 2 texels of a square picture reads level k") {
  const FilteredTexture texture = numbered(16, 16);
  const Uv<double> at{0.3, 0.6};
  for (int level = 0; level <= 4; ++level) {
    const double side = std::ldexp(0.5, level) / 16;
    const double found = published::trilinear(texture, place(at.u, at.v, side, side)).r;
    CHECK(std::abs(found - texture.bilinear(at, level_of(texture.pyramid, double(level))).r) <
          1e-9);
  }
  for (const double side : {0.0, 1e-30, 1e-4})
    CHECK(published::trilinear(texture, place(at.u, at.v, side, 0)).r == texture(at).r);
  for (const double side : {1.0, 1e30, infinity<double>()})
    CHECK(published::trilinear(texture, place(at.u, at.v, 0, side)).r == 127.5);
}

}  // namespace
}  // namespace texmap::test
