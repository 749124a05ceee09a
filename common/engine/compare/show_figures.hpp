// The figures of a comparison for readers and for other programs.
#pragma once
#include <string>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/measure/json.hpp"

namespace texmap {

/// How many pixels differ, by the rule of golden pictures: such as "2907 of 480000 pixels by more
/// than one level (0.61 %), 1037 by one".
[[nodiscard]] std::string differing_pixels(const Figures& figures);

/// The figures in words: for each its name and its value; SSIM if it was computed.
[[nodiscard]] std::vector<std::vector<std::string>> figure_rows(const Figures& figures);

/// The figures as a JSON object of several lines.
///
/// If the pictures are equal, `box` and `largest_difference` are null. JSON has no infinity: `psnr`
/// is then "infinite" instead of "finite", and `psnr_db` is null.
[[nodiscard]] Json json_of(const Figures& figures);

}  // namespace texmap
