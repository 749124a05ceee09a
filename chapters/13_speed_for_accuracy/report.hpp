// What is said of the ways: a table, JSON, plots, and the recommendations.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "engine/compare/plot.hpp"
#include "engine/fast/budget.hpp"
#include "ways.hpp"

namespace texmap::chapter_13 {

inline const char* name_of(SamplerKind kind) {
  return std::array{"random", "stratified", "multi-jitter",
                    "sobol"}[static_cast<std::size_t>(kind)];
}
inline const char* name_of(Filter filter) {
  return filter == Filter::nearest ? "nearest" : "bilinear";
}
inline const char* name_of(Curve curve) {
  return std::array{"none", "power", "exact", "4 terms",
                    "3 terms"}[static_cast<std::size_t>(curve)];
}
inline std::string name_of_kernel(int degree) {
  return degree == 0 ? "reference" : "degree " + std::to_string(degree);
}
/// What a row calculates with, such as: float-pack of avx2.
[[nodiscard]] std::string number_of(const Row& row);
/// What else makes it: a kernel, a curve, or a sampler and its samples.
[[nodiscard]] std::string choice_of(const Row& row);

/// The machine as it is now, how this chapter was compiled, and the packs up to `widest`.
[[nodiscard]] Machine measuring_machine(Instructions widest);

/// Of a row's line in the table the names at its left, and the errors at its right.
[[nodiscard]] std::string names_text(const Row& row);
[[nodiscard]] std::string errors_text(const Row& row);
/// What to know of the times if the machine was busy; empty if it was not.
[[nodiscard]] std::string busy_text(const Measurements& all);
[[nodiscard]] std::string table_of(const Measurements& all);
/// The same as JSON: an object with a list for each part. A place by the nearest texel has the
/// command of chapter 07 that draws with its number and kernel.
///
/// @param texture  the globe's
[[nodiscard]] std::string json_of(const Measurements& all, const Image& texture);
/// A plot of each part.
[[nodiscard]] std::vector<Plot> plots_of(const Measurements& all);

/// The shortest budget in texels for which choose_uv_kernel takes the kernel of this degree;
/// `exact` for the reference formula.
[[nodiscard]] std::string budget_for(int degree, const Image& texture);
/// What to take for a budget, in a few lines of at most 110 columns.
[[nodiscard]] std::string recommendation(const Measurements& all, const Budget& budget,
                                         const Image& texture);

}  // namespace texmap::chapter_13
