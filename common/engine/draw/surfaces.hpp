// Pictures of surfaces instead of their light: normals, (u, v), objects. They help to find errors.
#pragma once
#include <array>

#include "engine/draw/settings.hpp"
#include "texture/surface.hpp"

namespace texmap {

/// The colors of objects, in their order; after the last the first comes again.
inline constexpr std::array<Rgb, 16> object_colors = {{{0.9, 0.1, 0.1},
                                                       {0.1, 0.7, 0.2},
                                                       {0.15, 0.35, 0.95},
                                                       {1, 0.85, 0.1},
                                                       {0.6, 0.2, 0.8},
                                                       {0.1, 0.85, 0.85},
                                                       {0.95, 0.5, 0.1},
                                                       {0.95, 0.55, 0.8},
                                                       {0.5, 0.3, 0.1},
                                                       {0.65, 0.85, 0.3},
                                                       {0.05, 0.4, 0.4},
                                                       {0.75, 0.75, 0.75},
                                                       {0.55, 0, 0.2},
                                                       {1, 0.8, 0.6},
                                                       {0.1, 0.1, 0.5},
                                                       {0.4, 0.4, 0.45}}};

/// A surface as a color; the sky is black. Coordinates beyond 0 to 1 show their fractional part.
[[nodiscard]] inline Rgb color_of_surface(const Surface<double>& surface, Shown shown) {
  if (surface.object < 0) return gray(0.0);
  const auto on_picture = [](double x) { return x >= 0 && x <= 1 ? x : x - floor(x); };
  switch (shown) {
    case Shown::normal: {
      const Vec3d half = (surface.normal + Vec3d{1, 1, 1}) * 0.5;
      return {half.x, half.y, half.z};
    }
    case Shown::uv:
      if (!surface.has_uv()) return gray(0.5);
      return {on_picture(surface.uv.u), on_picture(surface.uv.v), 0};
    case Shown::object:
      return object_colors[static_cast<std::size_t>(surface.object) % object_colors.size()];
    case Shown::color:
      break;
  }
  return gray(0.0);
}

}  // namespace texmap
