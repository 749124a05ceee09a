// The files that a run writes with its picture: six plots, and one that programs can read.
#pragma once
#include <filesystem>

#include "table.hpp"

namespace texmap::chapter_13 {

/// The names of the plots and the file: out/x.png gives out/x_speed_error.svg. Empty where the
/// picture goes to a device.
[[nodiscard]] std::vector<std::filesystem::path> names_of_report(const std::filesystem::path& out);

/// Checks, before anything long begins, that all of them can be written.
/// Errors: FileError `cannot write 'F': why`.
void check_report(const std::filesystem::path& out);

/// Writes them.
/// Errors: FileError `cannot write 'F': why`.
void write_report(const std::filesystem::path& out, const Measurements& all);

}  // namespace texmap::chapter_13
