// An exhibit of any type: its name, and how the sheet and the program draw it.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "engine/render/settings.hpp"
#include "math/color.hpp"
#include "number/kinds/judge.hpp"
#include "texture/image.hpp"
#include "texture/uv.hpp"

namespace texmap::chapter_14 {

/// Drawn where a formula gives a place outside the texture, or no number at all.
inline constexpr Rgb no_texel{1, 0, 1};
/// Drawn where a ray misses the object on show.
inline constexpr Rgb background{0.1, 0.1, 0.15};
inline constexpr Rgb sky{0.6, 0.75, 1};

/// Which formulas draw: the source documents' or the course's.
enum class Formulas {
  published,  ///< the source documents'; spheres by b^2 - ac, without their fixed t > 0.001
  robust,     ///< the course's, of the form that the scene needs
};

/// What one ray sees, and where on the texture it looks.
template <class Real>
struct SurfacePoint {
  Color<Real> color{};
  Uv<Real> uv{};  ///< of a hit on a textured object
  bool hit = false;
  bool mapped = false;   ///< true if `uv` means anything
  Real round = Real(1);  ///< length of the circle at this v over the equator's: weighs errors of u
};

/// One picture of an exhibit, and what each of its pixels sees.
struct Panel {
  Image image;
  std::vector<SurfacePoint<Judge>> points;  ///< without their colors

  Panel(int width, int height) : image(width, height), points(image.pixels.size()) {}
};

/// The pictures of an exhibit: four to compare, and the reference.
enum Variant {
  published_float,
  robust_float,
  published_double,
  robust_double,
  reference,  ///< robust, in Judge
  variants
};

struct Exhibit {
  std::string name;
  std::string caption;
  /// Draws one row of a panel.
  std::function<void(Panel& panel, Variant variant, int row)> draw_row;
  /// The whole picture, with the number that the user chose.
  std::function<Image(Formulas formulas, NumberKind number, int width, int height,
                      const RenderSettings& settings)>
      draw;
};

/// All exhibits, in the order of the sheet.
///
/// @param earth   on the globes
/// @param labels  on the needle
[[nodiscard]] std::vector<Exhibit> all_exhibits(const Image& earth, const Image& labels);

}  // namespace texmap::chapter_14
