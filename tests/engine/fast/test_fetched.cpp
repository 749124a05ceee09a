// What fetches texels with the instructions that this file is compiled for returns what plain
// numbers return: textures, on them and beyond their edges, and filters of pyramids. Not a doctest
// program: main() must run on machines that lack the instructions.
#include <cstdio>
#include <cstring>

#include "engine/draw/settings.hpp"
#include "engine/fast/fetched_pyramid.hpp"
#include "engine/fast/fetched_texels.hpp"
#include "engine/fast/root_texture.hpp"
#include "texture/filters.hpp"

namespace texmap::test {
namespace {

int wrong = 0;

/// Holds each lane of `many` against what `one` makes of that lane.
template <class Real, class One>
void check_lanes(const Color<Real>& many, const One& one, const char* what, int step) {
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const Color<Scalar<Real>> alone = one(i);
    if (lane(many.r, i) == alone.r && lane(many.g, i) == alone.g && lane(many.b, i) == alone.b)
      continue;
    if (++wrong <= 10) std::printf("%s: another color at step %d, lane %zu\n", what, step, i);
  }
}

/// Looks up a grid of places, some outside of the texture.
template <class Real, class Texture>
void look_up(const Texture& texture, int width, int height, const char* what) {
  using Single = Scalar<Real>;
  const int columns = 4 * width, rows = 4 * height;
  for (int row = -2; row <= rows + 2; ++row) {
    for (int first = -2; first <= columns + 2; ++first) {
      const auto u = [&](std::size_t i) {
        return static_cast<Single>(first + static_cast<int>(i)) / static_cast<Single>(columns);
      };
      const auto v = static_cast<Single>(row) / static_cast<Single>(rows);
      check_lanes<Real>(
          texture(Uv<Real>{from_lanes<Real>(u), Real(v)}),
          [&](std::size_t i) {
            return texture(Uv<Single>{u(i), v});
          },
          what, first);
    }
  }
}

template <class Texture>
void look_up_in_all(const Texture& texture, int width, int height) {
  look_up<Pack<float>>(texture, width, height, "texels in float");
  look_up<Pack<double>>(texture, width, height, "texels in double");
  look_up<Pack2<Pack<float>>>(texture, width, height, "texels in pairs of float");
  look_up<Pack2<Pack<double>>>(texture, width, height, "texels in pairs of double");
}

void check_textures() {
  for (const auto& [width, height] :
       {std::pair{1, 1}, std::pair{2, 1}, std::pair{1, 2}, std::pair{3, 5},
        std::pair{17, 6}}) {  // the last has all bytes
    Image image(width, height);
    std::uint8_t byte = 1;
    for (Rgb8& pixel : image.pixels) {
      for (std::uint8_t* channel : {&pixel.r, &pixel.g, &pixel.b})
        *channel = byte = static_cast<std::uint8_t>(byte * 5 + 17);
    }
    for (const TexelLight light : {TexelLight::encoded, TexelLight::linear, TexelLight::stb}) {
      for (const VAxis axis : {VAxis::up, VAxis::down}) {
        const LightTexture texture{{.image = image, .v_axis = axis}, light};
        look_up_in_all(static_cast<const ImageTexture&>(texture), width, height);
        look_up_in_all(texture, width, height);
        look_up_in_all(RootTexture(texture), width, height);
      }
    }
  }
}

/// Filters a grid of places with packs and with single numbers.
template <class Real>
void look_up_filtered(const FilteredTexture& texture, const char* what) {
  using Single = Scalar<Real>;
  for (int step = -40; step < 120; ++step) {
    const auto u = [&](std::size_t i) {
      return static_cast<Single>(step * 7 + static_cast<int>(i) * 31) / Single(211);
    };
    const auto v = [&](std::size_t i) {
      return static_cast<Single>(step * 13 + static_cast<int>(i) * 5) / Single(196);
    };
    const auto slope = [&](int k) {
      return [k, step](std::size_t i) {
        const int size = (step * k + static_cast<int>(i) * 11) % 24 + 24;
        return static_cast<Single>(size * size * size) / Single(400000);
      };
    };
    const auto at = [&]<class Number>(auto value) {
      return Uv<Dual<Number>>{{value(u), value(slope(5)), value(slope(7))},
                              {value(v), value(slope(9)), Number(0) - value(slope(3))}};
    };
    const Color<Real> many = texture.filtered(
        at.template operator()<Real>([](const auto& f) { return from_lanes<Real>(f); }));
    check_lanes<Real>(
        many,
        [&](std::size_t i) {
          return texture.filtered(
              at.template operator()<Single>([i](const auto& f) { return f(i); }));
        },
        what, step);
  }
}

void check_filters() {
  for (const auto& size :
       {std::array{1, 1}, std::array{2, 1}, std::array{1, 5}, std::array{37, 20}}) {
    LightImage image(size[0], size[1]);
    float light = 0.3F;
    for (Color<float>& texel : image.pixels) {
      for (float* channel : {&texel.r, &texel.g, &texel.b})
        *channel = light = light * 7.3F - static_cast<float>(static_cast<int>(light * 7.3F));
    }
    FilteredTexture texture{.pyramid = pyramid_of(image)};
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear,
                                Filter::anisotropic, Filter::ewa, Filter::stochastic}) {
      for (const Wrap wrap :
           {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border, Wrap::spherical}) {
        texture.filter = filter;
        texture.wrap = wrap;
        look_up_filtered<Pack<float>>(texture, "filters in float");
        look_up_filtered<Pack2<Pack<float>>>(texture, "filters in pairs of float");
        look_up_filtered<Pack2<Pack<double>>>(texture, "filters in pairs of double");
      }
    }
  }
}

}  // namespace
}  // namespace texmap::test

int main(int argc, char** argv) {
  using namespace texmap;
  const bool wide = argc > 1 && std::strcmp(argv[1], "avx512") == 0;
  if (!machine_has(wide ? Instructions::avx512 : Instructions::avx2)) {
    std::puts("skipped: this machine does not have the instructions");
    return 77;
  }
  test::check_textures();
  test::check_filters();
  std::printf("%d wrong colors\n", test::wrong);
  return test::wrong == 0 && can_fetch<Pack<float>> && can_fetch<Pack2<Pack<double>>> ? 0 : 1;
}
