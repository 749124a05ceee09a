// Which slips drew a picture: small mistakes at known places of the path from a ray to a byte, one
// or a few of them at once, found by computing what each would draw.
#pragma once
#include <string>
#include <vector>

#include "stage.hpp"
#include "texture/image.hpp"

namespace texmap::slips {

/// The slips that explain a picture together.
struct Explanation {
  std::vector<Slip> slips;           ///< empty: the picture is right, but for what is unexplained
  std::vector<std::string> instead;  ///< words of others that would draw the same
  long different = 0;                ///< pixels of the lattice that are not the right picture's
  long explained = 0;                ///< of these
};

/// The fewest slips, at most `most`, that explain a picture: of each object's pixels all but 2 % to
/// two levels, and nine in ten of those that are not the right picture's. Else no slips.
[[nodiscard]] Explanation explain(const Image& drawn, const StageView& stage, int most);

/// The best explanation by a mistake before the surface, and so many slips more.
[[nodiscard]] Explanation explain_by_view(const Image& drawn, const StageView& right, int more);

/// True if only the texture's colors are wrong, and the texture hardly has them: at least a tenth
/// of those in the lamp's light are near fewer than 0.1 % of its texels.
[[nodiscard]] bool has_other_colors(const Image& drawn, const StageView& stage);

/// The mistake of a picture in which only shadows are wrong; without words if it is another one.
[[nodiscard]] Slip wrong_shadows(const Image& drawn, const StageView& stage);

}  // namespace texmap::slips
