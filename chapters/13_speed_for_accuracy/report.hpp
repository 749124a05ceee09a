// What a run leaves behind beside its picture: three plots and a file for other programs.
#pragma once
#include <filesystem>
#include <span>

#include "fronts.hpp"
#include "image_error.hpp"
#include "studio.hpp"
#include "write_file.hpp"

namespace texmap::chapter_13 {

/// Writes a text beside the picture: out/x.png and _speed_error.svg give out/x_speed_error.svg.
/// Errors: ImageError `cannot write 'F': why`.
inline void write_beside(const Studio& studio, const std::string& ending, const std::string& text) {
  const std::string file = std::filesystem::path(studio.out).replace_extension().string() + ending;
  try {
    write_file_atomically(file, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  } catch (const Refusal& refusal) {
    throw ImageError("cannot write '" + file + "': " + refusal.what());
  }
}

inline void write_report(const Studio& studio, const Measurements& all) {
  write_beside(studio, "_speed_error.svg", svg_of(plot_speed_error(all)));
  write_beside(studio, "_error_samples.svg", svg_of(plot_error_samples(all)));
  write_beside(studio, "_error_seconds.svg", svg_of(plot_error_seconds(all)));
  write_beside(studio, ".json", json_of(all));
}

}  // namespace texmap::chapter_13
