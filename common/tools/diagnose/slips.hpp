// Which slips drew a picture: small mistakes at known places of the path from a ray to a byte, one
// or a few of them at once, found by computing what each would draw.
#pragma once
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/compare/known_mistakes.hpp"
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

/// The words of slips, joined.
[[nodiscard]] std::string all_of(const std::vector<Slip>& slips);

/// True if the stage draws the chapter's right picture: a reader may have changed its lesson.
[[nodiscard]] bool draws(const StageView& stage, const Image& right);

/// What explains a picture as one of some stages, at most one explanation a stage, in the order of
/// chapters: those by the fewest slips, or by one more.
///
/// @param stages  the most probable first
[[nodiscard]] std::vector<std::pair<const StageView*, Explanation>> explain_by_any(
    const Image& drawn, std::span<const StageView> stages);

/// The fewest slips, at most `most`, that explain a picture: of each object's pixels all but 2 % to
/// two levels, and nine in ten of those that are not the right picture's. Else no slips.
[[nodiscard]] Explanation explain(const Image& drawn, const StageView& stage, int most);

/// The best explanation by a mistake before the surface, and so many slips more.
[[nodiscard]] Explanation explain_by_view(const Image& drawn, const StageView& right, int more);

/// True if only the texture's colors are wrong, and the texture hardly has them: at least a tenth
/// of those in the lamp's light are near fewer than 0.1 % of its texels.
[[nodiscard]] bool has_other_colors(const Image& drawn, const StageView& stage);

/// True if what is wrong lies where the stage has a highlight.
[[nodiscard]] bool is_in_highlight(const Image& drawn, const StageView& stage);

/// The mistake of a picture in which only shadows are wrong; without words if it is another one.
[[nodiscard]] Slip wrong_shadows(const Image& drawn, const StageView& stage);

/// Names what is wrong with pictures of chapters; keeps what was computed for them.
class Words {
 public:
  /// The words of the slips that explain a picture, or of a mistake in the whole picture; "A; or B"
  /// where both draw the same. Empty if nothing is sure.
  ///
  /// @param right  the chapter's picture with its folder's name
  [[nodiscard]] std::string of(const Image& drawn, const WrongPicture& right);

 private:
  std::map<std::string, StageView> stages_;
};

}  // namespace texmap::slips
