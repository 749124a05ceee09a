// What changed between two steps, and whether only that changed which the chapters declare.
#pragma once
#include <string>
#include <vector>

#include "drawn_step.hpp"
#include "engine/compare/difference.hpp"

namespace texmap::steps {

/// Two steps compared.
struct Comparison {
  DrawnStep before, after;
  std::vector<int> may_change;  ///< indices of the objects that the steps in between declare
  Figures figures;
  std::size_t changed_inside =
      0;  ///< changed pixels that show, before or after, an object that may change
  std::size_t changed_elsewhere = 0;
  int stray_column = -1;  ///< the first pixel that changed elsewhere, -1 if there is none
  int stray_row = -1;
  std::size_t pixels_with_uv = 0;  ///< where both steps have texture coordinates
  double largest_du = 0;           ///< turns, the short way round, 0 to 1/2
  double largest_dv = 0;           ///< 0 to 1
};

/// Names of the stage's objects by index; the sky is -1.
[[nodiscard]] std::string object_name(int index);

/// Errors: DifferenceError if the sizes differ.
[[nodiscard]] Comparison compare(DrawnStep before, DrawnStep after, std::vector<int> may_change);

/// |du| and |dv| side by side, as difference maps with 255 for half a turn and for the whole
/// height; gray where a step has no texture coordinates.
[[nodiscard]] Image uv_difference_map(const Comparison& comparison);

/// The pixels around a place, each enlarged to a square, with a frame round the one in the middle.
[[nodiscard]] Image zoom(const Image& picture, int column, int row);

/// All figures as JSON.
[[nodiscard]] std::string report_json(const Comparison& comparison);

/// The page: one HTML file with everything in it, readable without a network.
/// @param before_code, after_code  the two lessons
[[nodiscard]] std::string report_page(const Comparison& comparison, const std::string& before_code,
                                      const std::string& after_code);

/// The page of two steps with different scenes: both pictures and the code.
[[nodiscard]] std::string scenes_page(const DrawnStep& before, const DrawnStep& after,
                                      const std::string& before_code,
                                      const std::string& after_code);

/// Five lines for the terminal.
[[nodiscard]] std::string summary(const Comparison& comparison, const std::string& page);

}  // namespace texmap::steps
