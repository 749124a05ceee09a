// The files that a run writes with its picture: four plots, and one that programs can read.
#include "report.hpp"

#include <filesystem>
#include <span>

#include "engine/picture/files/file_error.hpp"
#include "engine/picture/files/write_file.hpp"
#include "engine/picture/save_png.hpp"
#include "plots.hpp"

namespace texmap::chapter_13 {

std::vector<std::string> names_of_report(const std::string& out) {
  std::error_code error;
  if (std::filesystem::exists(out, error) && !std::filesystem::is_regular_file(out, error))
    return {};
  const std::string stem = std::filesystem::path(out).replace_extension().string();
  return {stem + "_speed_error.svg", stem + "_speed_levels.svg", stem + "_error_samples.svg",
          stem + "_error_seconds.svg", stem + ".json"};
}

void check_report(const std::string& out) {
  for (const std::string& file : names_of_report(out)) check_output(file);
}

void write_report(const std::string& out, const Measurements& all) {
  const std::array texts = {svg_of(plot_speed_error(all)), svg_of(plot_speed_levels(all)),
                            svg_of(plot_error_samples(all)), svg_of(plot_error_seconds(all)),
                            json_of(all)};
  std::size_t i = 0;
  for (const std::string& file : names_of_report(out)) {
    const std::string& content = texts[i++];
    try {
      write_file_atomically(
          file, std::span(reinterpret_cast<const std::uint8_t*>(content.data()), content.size()));
    } catch (const FileError& error) {
      throw FileError("cannot write '" + file + "': " + error.what());
    }
  }
}

}  // namespace texmap::chapter_13
