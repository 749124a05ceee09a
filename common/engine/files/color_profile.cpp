// What an ICC profile says about a picture's colors.
#include "engine/files/color_profile.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace texmap {
namespace {

/// The data of a tag with at least `least` bytes; empty if there is none.
Bytes tag_of(Bytes profile, std::string_view name, std::size_t least) {
  constexpr std::size_t table = 128;
  if (profile.size() < table + 4) return {};
  const std::size_t tags = big_endian_32(profile, table);
  for (std::size_t i = 0, at = table + 4; i < tags && at + 12 <= profile.size(); ++i, at += 12) {
    const std::size_t begin = big_endian_32(profile, at + 4), size = big_endian_32(profile, at + 8);
    if (!std::equal(name.begin(), name.end(), profile.begin() + static_cast<std::ptrdiff_t>(at)) ||
        size < least || begin > profile.size() || size > profile.size() - begin)
      continue;
    return profile.subspan(begin, size);
  }
  return {};
}

/// The description: ASCII, or the first of several languages in UTF-16, of which ASCII is kept.
std::string name_of_profile(Bytes profile) {
  Bytes text = tag_of(profile, "desc", 28);
  std::string name;
  if (!text.empty()) {
    const bool is_wide = text[0] == 'm';  // mluc
    const std::size_t begin = is_wide ? big_endian_32(text, 24) : 12;
    const std::size_t size = big_endian_32(text, is_wide ? 20 : 8), step = is_wide ? 2 : 1;
    text = text.subspan(std::min(begin, text.size()));
    text = text.first(std::min({size, text.size(), std::size_t{80}}));
    for (std::size_t i = 0; i + step <= text.size(); i += step) {
      const std::uint8_t c = text[i + step - 1];
      if ((!is_wide || text[i] == 0) && c >= ' ' && c <= '~') name += static_cast<char>(c);
    }
  }
  name.erase(name.find_last_not_of(' ') + 1);
  return name.empty() ? "another color space" : name;
}

/// True if the bytes are light itself by the curve of a tag: it has no table, or the exponent 1,
/// also as the parameter of a formula, "para".
bool is_linear(Bytes profile, std::string_view name) {
  const Bytes curve = tag_of(profile, name, 12);
  if (curve.size() >= 16 && curve[0] == 'p')
    return big_endian_16(curve, 8) == 0 && big_endian_32(curve, 12) == 0x10000;
  if (curve.empty() || curve[0] != 'c') return false;
  const std::uint32_t entries = big_endian_32(curve, 8);
  return entries == 0 || (entries == 1 && curve.size() >= 14 && big_endian_16(curve, 12) == 0x0100);
}

}  // namespace

std::string not_in_srgb(const std::string& space) {
  return "has its colors in " + space +
         ", not in sRGB, and they are drawn as if they were sRGB; convert it to sRGB for the right "
         "ones";
}

std::string note_on_profile(Bytes profile) {
  const Bytes red = tag_of(profile, "rXYZ", 20), green = tag_of(profile, "gXYZ", 20);
  const auto is = [](Bytes xyz, double x) {
    return std::abs(static_cast<std::int32_t>(big_endian_32(xyz, 8)) / 65536.0 - x) < 0.01;
  };
  const bool is_srgb = red.empty() || green.empty()
                           ? !is_linear(profile, "kTRC")  // of grays
                           : is(red, 0.4361) && is(green, 0.3851) && !is_linear(profile, "rTRC");
  return is_srgb ? "" : not_in_srgb(name_of_profile(profile));
}

}  // namespace texmap
