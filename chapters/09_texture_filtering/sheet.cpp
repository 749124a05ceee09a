// The sheet of filters: the same scene by each of them.
#include "sheet.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/compare/plot.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/sheet.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"

namespace texmap::chapter_09 {
namespace {

/// The filters of the sheet, by the names that their figures have.
constexpr std::array shown = {std::pair(Filter::nearest, "nearest"),
                              std::pair(Filter::bilinear, "bilinear"),
                              std::pair(Filter::trilinear, "trilinear"),
                              std::pair(Filter::anisotropic, "anisotropic"),
                              std::pair(Filter::ewa, "ewa"),
                              std::pair(Filter::stochastic, "stochastic")};

}  // namespace

SheetImage sheet_of_filters(const Session& session, const std::vector<FilterFigures>& all,
                            const DrawFiltered& draw) {
  const int width = session.settings.width, height = session.settings.height;
  SheetImage sheet(width, height, {255, 255, 255});
  constexpr int columns = 3, rows = 2;
  const int scale = std::max(1, width / 600);
  const int line = 12 * scale, gap = std::max(1, width / 200);
  const int panel_width = std::max(1, (width - (columns - 1) * gap) / columns);
  const int panel_height = std::max(1, (height - (rows - 1) * gap) / rows - line);
  int panel = 0;
  for (const auto& [filter, name] : shown) {
    const auto figures = std::find_if(all.begin(), all.end(),
                                      [&want = name](const auto& one) { return one.name == want; });
    std::string label = name;
    if (figures != all.end()) {
      label += text(": %.0f read%s, %.1f %% off", figures->reads, figures->reads > 1 ? "s" : "",
                    100 * figures->error);
    }
    const int left = panel % columns * (panel_width + gap);
    const int top = panel / columns * (panel_height + line + gap);
    SheetColumn column{sheet, left, top, scale};
    column.indent = scale;
    column.write(label);
    column.lay(draw(filter, panel_width, panel_height));
    ++panel;
  }
  return sheet;
}

void show_sheet(Session& session, const std::optional<FloorView>& floor, const std::string& plot,
                const DrawFiltered& draw) {
  const std::filesystem::path plotted = path_of(plot);
  if (!plot.empty()) check_output(plotted);
  std::vector<FilterFigures> all;
  if (floor) all = compare_filters(*floor, session.settings.threads, !session.settings.quiet);
  usage_error_if(all.empty() && !plot.empty(),
                 "--plot shows errors on the floor: leave it out, or --scene globe");
  // They are those of the course's checkers, read up to 16 times: not of any picture.
  bool hold = true;
  for (const char* option : {"--taps", "--floor", "--wrap", "--zoom"})
    hold = hold && !session.chosen.was_given(option);
  const Image sheet = sheet_of_filters(session, hold ? all : std::vector<FilterFigures>(), draw);
  if (!all.empty() && !session.settings.quiet) print(table_of_filters(all));
  if (!plot.empty()) {
    with_name("cannot write", plotted,
              [&] { write_text_atomically(plotted, svg_of(plot_of_filters(all))); });
  }
  session.save(sheet);
}

}  // namespace texmap::chapter_09
