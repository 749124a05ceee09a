// UTF-8, character by character.
#pragma once
#include <string>
#include <string_view>

namespace texmap {

/// Replaces a byte that is not UTF-8.
inline constexpr char32_t replacement_character = 0xFFFD;

/// Takes a character off the front of a text that is not empty; of what is no UTF-8, one byte, as
/// the replacement character.
/// Source: RFC 3629, section 3.
[[nodiscard]] char32_t take_character(std::string_view& text);

/// Appends a character.
void append_utf8(std::string& text, char32_t character);

/// False for control characters and for marks that turn the direction of writing, which make one
/// text look like another. Source: Unicode, annex 9.
[[nodiscard]] bool is_harmless(char32_t character);

}  // namespace texmap
