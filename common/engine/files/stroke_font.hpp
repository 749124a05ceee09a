// Writing on pictures, with a small font of our own.
#pragma once
#include <string_view>

#include "texture/image.hpp"

namespace texmap {

/// Writes one line of text, and returns its width in pixels, from its first ink to its last. What
/// falls outside the picture is left out.
///
/// @param column, row  upper left corner of the first letter; may lie outside the picture
/// @param text         UTF-8: printable ASCII, degree sign, times sign, arrows; the rest as boxes
/// @param size         8/11 of it are above the baseline, 2/11 below; at 11 small letters are sharp
int draw_text(Image& image, int column, int row, std::string_view text, Rgb8 color, int size = 11);

[[nodiscard]] int text_width(std::string_view text, int size = 11);

}  // namespace texmap
