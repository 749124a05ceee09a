// Tests of texture/light_tables.cpp, texture/encoded.hpp and math/srgb.hpp: the light of each byte,
// and back. How near the standard's curve they are, tests/extremes searches.
#include <doctest.h>

#include <algorithm>

#include "math/srgb.hpp"
#include "texture/light_texture.hpp"

namespace texmap::test {

TEST_CASE_TEMPLATE("stb_image's light is kept in bytes, of which 184 remain and 21 are black", T,
                   float, double, long double) {
  const auto& kept = light_of_bytes<T>(TexelLight::stb);
  long levels = 1;
  for (std::size_t byte = 0; byte < 256; ++byte) {
    CAPTURE(byte);
    const long double share = static_cast<long double>(byte) / 255;
    const auto level = static_cast<T>(std::min(std::floor(256 * std::pow(share, 2.2L)), 255.0L));
    CHECK(kept[byte] == level / T(255));
    CHECK(light_of_bytes<T>(TexelLight::encoded)[byte] == static_cast<T>(byte) / T(255));
    levels += byte > 0 && kept[byte] != kept[byte - 1] ? 1 : 0;
  }
  CHECK(std::count(kept.begin(), kept.end(), T(0)) == 21);
  CHECK(levels == 184);
}

TEST_CASE("NaN stays NaN in both curves") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(srgb_decode(nan)));
  CHECK(std::isnan(srgb_encode(nan)));
}

}  // namespace texmap::test
