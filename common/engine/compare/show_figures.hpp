// The figures of a comparison for readers and for other programs.
#pragma once
#include <string>
#include <vector>

#include "engine/compare/difference.hpp"
#include "engine/measure/json.hpp"

namespace texmap {

/// The figures in words: for each its name and its value; SSIM if it was computed.
[[nodiscard]] std::vector<std::vector<std::string>> figure_rows(const Figures& figures);

/// The figures as a JSON object of several lines.
///
/// If the pictures are equal, `box` and `largest_difference` are null. JSON has no infinity: `psnr`
/// is then "infinite" instead of "finite", and `psnr_db` is null.
[[nodiscard]] Json json_of(const Figures& figures);

}  // namespace texmap
