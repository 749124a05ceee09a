// Writing on pictures, with a small bitmap font of our own.
#pragma once
#include <string_view>

#include "texture/image.hpp"

namespace texmap {

/// A letter's cell at scale 1: 5 columns and a space, 7 rows above the baseline and 1 below.
inline constexpr int letter_columns = 6;
inline constexpr int letter_rows = 8;

/// Width of a text in pixels, without the space after its last letter; 0 for an empty text.
///
/// @param text   UTF-8
/// @param scale  pixels to a dot of the font, 1 or more
[[nodiscard]] int text_width(std::string_view text, int scale = 1);

/// Writes one line of text; what falls outside the picture is left out.
///
/// @param column, row  upper left corner of the first letter; may lie outside the picture
/// @param text         UTF-8: printable ASCII, degree sign, times sign, arrows; the rest as boxes
/// @param scale        pixels to a dot of the font, 1 or more
void draw_text(Image& image, int column, int row, std::string_view text, Rgb8 color, int scale = 1);

}  // namespace texmap
