// A wooden crate for flat surfaces.
#pragma once
#include "texture/image.hpp"

namespace texmap {

/// One side of a wooden crate, 512 x 512 pixels, with the words "THIS SIDE UP" and an arrow.
[[nodiscard]] Image make_crate();

}  // namespace texmap
