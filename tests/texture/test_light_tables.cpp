// Tests of texture/light_tables.cpp: the light of each byte, against more digits.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/srgb.hpp"
#include "support/many_digits.hpp"
#include "texture/image_texture.hpp"

namespace texmap::test {
namespace {

#ifdef TEXMAP_HAVE_DIGITS
using Exact = Digits50;
#else
using Exact = long double;
#endif

/// The sRGB curve at a byte. Its numbers are decimal: 0.055 is not the double nearest to it.
Exact linear_light(int byte) {
  const auto thousandths = [](int n) { return Exact(n) / 1000; };
  const Exact encoded = Exact(byte) / 255;
  if (encoded * 100000 <= 4045) return encoded / thousandths(12920);
  return pow((encoded + thousandths(55)) / thousandths(1055), Exact(12) / 5);
}

/// Calls `check` with the table's entry, and the exact one, of every byte.
template <class T, class Check>
void for_each_byte(TexelLight light, Exact (*exact)(int), const Check& check) {
  for (int byte = 0; byte < 256; ++byte) {
    CAPTURE(byte);
    check(light_of_bytes<T>(light)[static_cast<std::size_t>(byte)], exact(byte));
  }
}

TEST_CASE_TEMPLATE("an encoded byte is the nearest number to byte / 255", T, float, double,
                   long double) {
  for_each_byte<T>(
      TexelLight::encoded, [](int byte) { return Exact(byte) / 255; },
      [](T entry, const Exact& exact) { CHECK(entry == static_cast<T>(exact)); });
}

TEST_CASE_TEMPLATE(
    "a byte's light is the nearest number to the standard's curve, in long double within 8 ulp", T,
    float, double, long double) {
  // The table is computed in long double, on some machines no wider than double.
  constexpr bool as_wide =
      std::numeric_limits<T>::digits == std::numeric_limits<long double>::digits;
  for_each_byte<T>(TexelLight::linear, linear_light, [](T entry, const Exact& exact) {
    const Exact ulp = std::nextafter(entry, T(2)) - entry;
    CHECK((as_wide ? abs(Exact(entry) - exact) <= 8 * ulp : entry == static_cast<T>(exact)));
  });
}

TEST_CASE_TEMPLATE("stb_image's light is kept in bytes, of which 184 remain and 21 are black", T,
                   float, double, long double) {
  for_each_byte<T>(
      TexelLight::stb,
      [](int byte) {
        const Exact level = floor(256 * pow(Exact(byte) / 255, Exact(11) / 5));
        return (level < 255 ? level : Exact(255)) / 255;
      },
      [](T entry, const Exact& exact) { CHECK(entry == static_cast<T>(exact)); });
  const auto& kept = light_of_bytes<T>(TexelLight::stb);
  CHECK(std::count(kept.begin(), kept.end(), T(0)) == 21);
  long levels = 1;
  for (std::size_t i = 1; i < kept.size(); ++i) levels += kept[i] != kept[i - 1] ? 1 : 0;
  CHECK(levels == 184);
}

}  // namespace
}  // namespace texmap::test
