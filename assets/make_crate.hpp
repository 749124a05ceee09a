// A wooden crate, for surfaces that are flat.
#pragma once
#include "image.hpp"

namespace texmap {

/// One side of a wooden crate, 512 x 512 pixels: planks, a frame, a brace, nails, and "THIS SIDE UP" with an arrow.
[[nodiscard]] Image make_crate();

}  // namespace texmap
