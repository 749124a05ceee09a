// How an amount of light becomes a byte.
#pragma once

namespace texmap {

enum class Transfer {
  srgb,  ///< the sRGB curve of screens and files
  sqrt,  ///< the books' gamma 2
  stb,   ///< the power 1/2.2, the inverse of stb_image's
};

}  // namespace texmap
