// The figures of a comparison for other programs.
#pragma once
#include <string>

#include "difference.hpp"

namespace texmap {

/// A number as the shortest of 15, 16 or 17 digits that reads back as the same number, with a point, whatever the locale says.
///
/// @param value  finite; JSON has no word for other numbers
[[nodiscard]] std::string round_trip(double value);

/// The figures as a JSON object of several lines, ended by a newline.
///
/// `box` and `largest_difference` are null when the pictures are equal. The PSNR of equal pictures is infinite, which JSON
/// cannot say: `psnr_db` is then null, and `psnr` is "infinite" instead of "finite".
///
/// Source: RFC 8259.
[[nodiscard]] std::string figures_json(const Figures& figures);

}  // namespace texmap
