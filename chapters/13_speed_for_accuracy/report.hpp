// What a run leaves behind beside its picture: four plots and a file for other programs.
#pragma once
#include <filesystem>
#include <span>

#include "fronts.hpp"
#include "image_error.hpp"
#include "save_png.hpp"
#include "write_file.hpp"

namespace texmap::chapter_13 {

/// What the plots and the file are called: out/x.png gives out/x_speed_error.svg. None where the picture goes to a device.
[[nodiscard]] inline std::vector<std::string> names_beside(const std::string& out) {
  std::error_code error;
  if (std::filesystem::exists(out, error) && !std::filesystem::is_regular_file(out, error)) return {};
  const std::string stem = std::filesystem::path(out).replace_extension().string();
  return {stem + "_speed_error.svg", stem + "_speed_levels.svg", stem + "_error_samples.svg", stem + "_error_seconds.svg",
          stem + ".json"};
}

/// Checks, before anything long begins, that all of them can be written.
/// Errors: ImageError `cannot write 'F': why`.
inline void check_report(const std::string& out) {
  for (const std::string& file : names_beside(out)) check_output(file);
}

/// Writes them.
/// Errors: ImageError `cannot write 'F': why`.
inline void write_report(const std::string& out, const Measurements& all) {
  const std::array<std::string, 5> texts = {svg_of(plot_speed_error(all)), svg_of(plot_speed_levels(all)),
                                            svg_of(plot_error_samples(all)), svg_of(plot_error_seconds(all)), json_of(all)};
  std::size_t i = 0;
  for (const std::string& file : names_beside(out)) {
    const std::string& text = texts[i++];
    try {
      write_file_atomically(file, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    } catch (const Refusal& refusal) {
      throw ImageError("cannot write '" + file + "': " + refusal.what());
    }
  }
}

}  // namespace texmap::chapter_13
