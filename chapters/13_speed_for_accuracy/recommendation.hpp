// The recommendation: for a budget, the fastest variant with a stated bound within it, and the
// command that uses it.
#pragma once
#include "engine/kernels/budget.hpp"
#include "table.hpp"

namespace texmap::chapter_13 {

/// True if a variant keeps to a budget by its bounds, whatever was measured.
///
/// `exact` is what plain double draws with the reference formula; others draw the same if no
/// rounding can change a byte. Texels are those of texels_bound; levels are the most that any pixel
/// can change, outline and edges of texels included.
[[nodiscard]] bool keeps_to(const Budget& budget, const Trial& trial);

/// Of the places with a filter that keep to the budget the fastest, and of those that could be as
/// fast, as far as the times' spread tells, the most exact; nullptr if none does.
[[nodiscard]] const Trial* fastest(const std::vector<Trial>& places, Filter filter,
                                   const Budget& budget);
/// The same of the variants from texels to bytes, for a budget in levels: only of numbers that find
/// every texel, since a wrong one may be any number of levels off.
[[nodiscard]] const Trial* fastest_light(const Measurements& all, const Budget& budget);
/// The fastest sampler with noise within a number of levels, root mean square; nullptr if none
/// does.
[[nodiscard]] const Noise* fastest(const std::vector<Noise>& all, double levels);

/// The filter that keeps to a number of levels of light with the fastest look-up, and of those as
/// fast the most exact; nullptr if none does.
[[nodiscard]] const FilterCost* cheapest(const std::vector<FilterCost>& all, double levels);
/// The same of the ways and samples under a sky.
[[nodiscard]] const SkyCost* cheapest(const std::vector<SkyCost>& all, const std::string& sky,
                                      double levels);

/// The shortest budget in texels for which choose_uv_kernel takes the kernel of this degree;
/// `exact` for the reference formula.
[[nodiscard]] std::string budget_for(int degree, const Image& texture);

/// What to take for a budget, in a few lines of at most 110 columns.
[[nodiscard]] std::string recommendation(const Measurements& all, const Budget& budget,
                                         const Image& texture);

}  // namespace texmap::chapter_13
