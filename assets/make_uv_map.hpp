// A labelled map that shows at once how it was laid on.
#pragma once
#include "image.hpp"

namespace texmap {

/// The labelled map of (u, v), 1024 x 512 pixels, without any symmetry: mirrored or turned, it looks wrong.
///
/// u grows from 0 at the left edge to 1 at the right edge, v from 0 at the bottom to 1 at the top; as an equirectangular map,
/// longitude grows from -180 to 180 degrees with u and latitude from -90 to 90 degrees with v.
[[nodiscard]] Image make_uv_map();

}  // namespace texmap
