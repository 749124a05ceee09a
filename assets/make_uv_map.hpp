// A labelled map that shows how a picture is mapped to a surface.
#pragma once
#include "texture/image.hpp"

namespace texmap {

/// The labelled map of (u, v), 1024 x 512 pixels. It has no symmetry, so mirroring it shows.
///
/// u grows from 0 at the left edge to 1 at the right, v from 0 at the bottom to 1 at the top.
/// Longitude grows from -180 to 180 degrees with u, latitude from -90 to 90 degrees with v.
[[nodiscard]] Image make_uv_map();

}  // namespace texmap
