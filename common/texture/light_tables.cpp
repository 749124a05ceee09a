// The tables of what a texel's bytes mean, computed at compile time.
#include "number/compiler.hpp"
#include "texture/light_texture.hpp"

namespace texmap {
namespace {

/// x^(1/5) for x in (0, 1], by Newton's iteration, which falls until rounding stops it.
TEXMAP_TABLE_CONSTEXPR long double fifth_root(long double x) {
  long double root = 1;
  for (;;) {
    const long double fourth = root * root * root * root;
    const long double next = root - (root * fourth - x) / (5 * fourth);
    if (!(next < root)) return root;
    root = next;
  }
}

/// srgb_decode (math/srgb.hpp) of a byte. Compilers cannot evaluate its power 2.4: take the square
/// times the square of the fifth root.
TEXMAP_TABLE_CONSTEXPR long double linear_light(int byte) {
  const long double encoded = static_cast<long double>(byte) / 255;
  if (encoded <= 0.04045L) return encoded / 12.92L;
  const long double base = (encoded + 0.055L) / 1.055L;
  const long double root = fifth_root(base);
  return base * base * (root * root);
}

/// The byte that stb_image makes from its HDR float: 256 x^2.2, cut off; 2.2 is 2 and a fifth.
TEXMAP_TABLE_CONSTEXPR long double stb_light(int byte) {
  if (byte == 0) return 0;
  const long double encoded = static_cast<long double>(byte) / 255;
  const int level = static_cast<int>(256 * (encoded * encoded * fifth_root(encoded)));
  return static_cast<long double>(level < 255 ? level : 255) / 255;
}

template <class Number>
TEXMAP_TABLE_CONSTEXPR LightTables<Number> make_light_tables() {
  LightTables<Number> tables{};
  for (std::size_t i = 0; i < 256; ++i) {
    const int byte = static_cast<int>(i);
    tables[0][i] = static_cast<Number>(byte) / Number(255);
    tables[1][i] = static_cast<Number>(linear_light(byte));
    tables[2][i] = static_cast<Number>(stb_light(byte));
  }
  return tables;
}

}  // namespace

TEXMAP_TABLE_CONSTINIT const
    std::tuple<LightTables<float>, LightTables<double>, LightTables<long double>>
        light_tables = {make_light_tables<float>(), make_light_tables<double>(),
                        make_light_tables<long double>()};

}  // namespace texmap
