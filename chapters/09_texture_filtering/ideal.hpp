// What each filter would show of checkers if it needed no pyramid: its own ideal.
#pragma once
#include "texture/filters.hpp"

namespace texmap::chapter_09 {

/// The share of white in a box on endless checkers with squares of 1; white from (0, 0) to (1, 1).
/// Exact but for rounding. Source: Quilez, "filtering of checkers".
///
/// @param x, y           the middle of the box
/// @param width, height  above 0
[[nodiscard]] double white_in_box(double x, double y, double width, double height);

/// The light of a filter with its own reads and weights, each read the exact mean of the checkers
/// over the square or the ellipse that it stands for. Of `stochastic` the mean of all its choices.
///
/// @param texture  checkers, `squares` in each direction; Wrap::repeat
[[nodiscard]] double ideal_light(const FilteredTexture& texture, int squares,
                                 const Uv<Dual<double>>& uv);

}  // namespace texmap::chapter_09
