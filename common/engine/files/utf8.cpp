// UTF-8, character by character.
#include "engine/files/utf8.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace texmap {

char32_t take_character(std::string_view& text) {
  const auto byte = [text](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t size = first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  char32_t character = size == 1 ? first : first & (0x7FU >> size);
  bool good = size == 1 || (first >= 0xC2 && first <= 0xF4 && text.size() >= size);
  for (std::size_t i = 1; good && i < size; ++i) {
    good = (byte(i) & 0xC0U) == 0x80U;
    character = character << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
  good = good && character >= least[size] && character <= 0x10FFFF && !is_surrogate;
  text.remove_prefix(good ? size : 1);
  return good ? character : replacement_character;
}

void append_utf8(std::string& text, char32_t character) {
  // Each byte after the first has six bits. The first says how many bytes follow.
  constexpr std::array<char32_t, 4> first{0, 0xC0, 0xE0, 0xF0};
  unsigned left = character < 0x80 ? 0 : character < 0x800 ? 1 : character < 0x10000 ? 2 : 3;
  text += static_cast<char>(first[left] | character >> 6U * left);
  while (left-- > 0) text += static_cast<char>(0x80U | (character >> 6U * left & 0x3FU));
}

bool is_harmless(char32_t c) {
  const bool is_control = c < 0x20 || (c >= 0x7F && c < 0xA0);
  const bool turns = c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) ||
                     (c >= 0x2066 && c <= 0x2069);
  return !is_control && !turns;
}

}  // namespace texmap
