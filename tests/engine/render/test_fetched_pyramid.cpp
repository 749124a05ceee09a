// Filters that fetch texels with the instructions that this file is compiled for return what plain
// numbers return. Not a doctest program: main() must run on machines that lack the instructions.
#include <cstdio>
#include <cstring>

#include "engine/kernels/fetched_pyramid.hpp"
#include "engine/render/instructions.hpp"
#include "texture/filters.hpp"

namespace texmap::test {
namespace {

int wrong = 0;
int compared = 0;

/// Filters a grid of places with packs and with single numbers.
template <class Real>
void compare(const FilteredTexture& texture, const char* what) {
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
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      const Color<Single> one =
          texture.filtered(at.template operator()<Single>([i](const auto& f) { return f(i); }));
      ++compared;
      if (lane(many.r, i) == one.r && lane(many.g, i) == one.g && lane(many.b, i) == one.b)
        continue;
      if (++wrong <= 10) std::printf("%s: another color at step %d, lane %zu\n", what, step, i);
    }
  }
}

int run() {
  for (const auto& size :
       {std::array{1, 1}, std::array{2, 1}, std::array{1, 5}, std::array{37, 20}}) {
    LightImage image(size[0], size[1]);
    float light = 0.3F;
    for (Color<float>& texel : image.texels) {
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
        compare<Pack<float>>(texture, "float");
        compare<Pack2<Pack<float>>>(texture, "pairs of float");
        compare<Pack2<Pack<double>>>(texture, "pairs of double");
      }
    }
  }
  std::printf("%d wrong colors of %d\n", wrong, compared);
  return wrong == 0 && can_fetch<Pack<float>> ? 0 : 1;
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
