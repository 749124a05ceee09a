// Texels fetched with the instructions that this file is compiled for equal those that plain
// numbers read, on the texture and beyond its edges. Not a doctest program: main() must run on
// machines that lack the instructions.
#include <cstdio>
#include <cstring>

#include "engine/kernels/fetched_texels.hpp"
#include "engine/kernels/root_texture.hpp"
#include "engine/render/instructions.hpp"

namespace texmap::test {
namespace {

int wrong = 0;

/// Looks up a grid of places, some outside of the texture, with packs and with single numbers.
template <class Real, class Texture>
void compare(const Texture& texture, int width, int height, const char* what) {
  using Single = Scalar<Real>;
  const int columns = 4 * width;
  const int rows = 4 * height;
  for (int row = -2; row <= rows + 2; ++row) {
    for (int first = -2; first <= columns + 2; ++first) {
      const auto u = [&](std::size_t i) {
        return static_cast<Single>(first + static_cast<int>(i)) / static_cast<Single>(columns);
      };
      const auto v = static_cast<Single>(row) / static_cast<Single>(rows);
      const Color<Real> many = texture(Uv<Real>{from_lanes<Real>(u), Real(v)});
      for (std::size_t i = 0; i < lanes<Real>; ++i) {
        const Color<Single> one = texture(Uv<Single>{u(i), v});
        if (lane(many.r, i) == one.r && lane(many.g, i) == one.g && lane(many.b, i) == one.b)
          continue;
        if (++wrong <= 10)
          std::printf("%s %dx%d: another texel at (%g, %g)\n", what, width, height,
                      static_cast<double>(u(i)), static_cast<double>(v));
      }
    }
  }
}

/// The same with every kind of pack.
template <class Texture>
void compare_all(const Texture& texture, int width, int height) {
  compare<Pack<float>>(texture, width, height, "float");
  compare<Pack<double>>(texture, width, height, "double");
  compare<Pack2<Pack<float>>>(texture, width, height, "pairs of float");
  compare<Pack2<Pack<double>>>(texture, width, height, "pairs of double");
}

int run() {
  for (const auto& size : {std::array{1, 1}, std::array{2, 1}, std::array{1, 2}, std::array{3, 5},
                           std::array{17, 4}}) {
    Image image(size[0], size[1]);
    std::uint8_t byte = 1;
    for (Rgb8& pixel : image.pixels) {
      for (std::uint8_t* channel : {&pixel.r, &pixel.g, &pixel.b})
        *channel = byte = static_cast<std::uint8_t>(byte * 5 + 17);
    }
    for (const TexelLight light : {TexelLight::encoded, TexelLight::linear, TexelLight::stb}) {
      for (const VAxis axis : {VAxis::up, VAxis::down}) {
        const ImageTexture texture{.image = image, .v_axis = axis, .light = light};
        compare_all(texture, image.width, image.height);
        compare_all(RootTexture(texture), image.width, image.height);
      }
    }
  }
  std::printf("%d wrong texels\n", wrong);
  return wrong == 0 && can_fetch<Pack<float>> && can_fetch<Pack2<Pack<double>>> ? 0 : 1;
}

}  // namespace
}  // namespace texmap::test

int main(int argc, char** argv) {
  const auto needed = argc > 1 && std::strcmp(argv[1], "avx512") == 0 ? texmap::Instructions::avx512
                                                                      : texmap::Instructions::avx2;
  if (!texmap::machine_has(needed)) {
    std::puts("skipped: this machine does not have the instructions");
    return 77;
  }
  return texmap::test::run();
}
