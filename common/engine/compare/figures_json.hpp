// The figures of a comparison for other programs.
#pragma once
#include <string>

#include "engine/compare/difference.hpp"
#include "engine/measure/json.hpp"

namespace texmap {

/// The figures as a JSON object of several lines.
///
/// If the pictures are equal, `box` and `largest_difference` are null. JSON has no infinity: `psnr`
/// is then "infinite" instead of "finite", and `psnr_db` is null.
[[nodiscard]] Json json_of(const Figures& figures);
/// Its text, ended by a newline.
[[nodiscard]] std::string figures_json(const Figures& figures);

}  // namespace texmap
