// A sheet as data: its picture, and what was laid on it.
#pragma once
#include <string>
#include <vector>

#include "texture/image.hpp"

namespace texmap {

/// What a sheet holds: a picture, or a line of text, which has no size.
struct SheetPart {
  std::string words;
  int left, top, width = 0, height = 0;
};

/// A sheet's picture, with its parts in the order in which they were laid: the book shows a sheet's
/// pictures with their words as text.
struct SheetImage : Image {
  using Image::Image;
  std::vector<SheetPart> parts{};
};

}  // namespace texmap
