// The sheet: what some of the variants change in the picture. It shows no times: it is the same on
// every machine.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/files/sheet_image.hpp"
#include "ways.hpp"

namespace texmap::chapter_13 {

/// The plots' files in the order of plots_of, then the JSON file: x_speed_error.svg and so on,
/// beside x.png. Empty if the picture goes to a device.
[[nodiscard]] std::vector<std::filesystem::path> names_of_report(const std::filesystem::path& out);

/// The view of one picture of a sheet of this size.
[[nodiscard]] View<> view_of_sheet(const Globe& globe, int width, int height);
/// @param threads  as RenderSettings has them
[[nodiscard]] SheetImage draw_sheet(const Globe& globe, int width, int height, int threads,
                                    const Tick& tick);

}  // namespace texmap::chapter_13
