// The files that a run writes with its picture: six plots, and one that programs can read.
#include "report.hpp"

#include <array>

#include "engine/picture/save_png.hpp"
#include "engine/system/system.hpp"
#include "plots.hpp"

namespace texmap::chapter_13 {

std::vector<std::filesystem::path> names_of_report(const std::filesystem::path& out) {
  std::error_code error;
  if (std::filesystem::exists(out, error) && !std::filesystem::is_regular_file(out, error))
    return {};
  std::vector<std::filesystem::path> names;
  for (const char* const ending :
       {"_speed_error.svg", "_speed_levels.svg", "_error_samples.svg", "_error_seconds.svg",
        "_filter_error.svg", "_sky_error.svg", ".json"}) {
    names.push_back(std::filesystem::path(out).replace_extension() += ending);
  }
  return names;
}

void check_report(const std::filesystem::path& out) {
  for (const std::filesystem::path& file : names_of_report(out)) check_output(file);
}

void write_report(const std::filesystem::path& out, const Measurements& all) {
  const std::array texts = {svg_of(plot_speed_error(all)),
                            svg_of(plot_speed_levels(all)),
                            svg_of(plot_error_samples(all)),
                            svg_of(plot_error_seconds(all)),
                            svg_of(plot_filter_error(all.fronts)),
                            svg_of(plot_sky_error(all.fronts)),
                            json_of(all)};
  std::size_t i = 0;
  for (const std::filesystem::path& file : names_of_report(out)) {
    const std::string& content = texts[i++];
    with_name("cannot write", file, [&] { write_text_atomically(file, content); });
  }
}

}  // namespace texmap::chapter_13
