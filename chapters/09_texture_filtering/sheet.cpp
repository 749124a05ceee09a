// The sheet of filters: the same scene by each of them.
#include "sheet.hpp"

#include <algorithm>

#include "engine/measure/plot.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/bitmap_font.hpp"
#include "engine/picture/blit.hpp"
#include "engine/system/system.hpp"

namespace texmap::chapter_09 {

Image sheet_of_filters(const Session& session, const std::vector<FilterFigures>& all,
                       const DrawFiltered& draw) {
  const int width = session.settings.width, height = session.settings.height;
  Image sheet(width, height, {255, 255, 255});
  constexpr int columns = 3, rows = 2;
  const int scale = std::max(1, width / 600);
  const int line = 12 * scale, gap = std::max(1, width / 200);
  const int panel_width = std::max(1, (width - (columns - 1) * gap) / columns);
  const int panel_height = std::max(1, (height - (rows - 1) * gap) / rows - line);
  int panel = 0;
  for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear,
                              Filter::anisotropic, Filter::ewa, Filter::stochastic}) {
    const FilterFigures& figures = *std::find_if(all.begin(), all.end(), [&](const auto& one) {
      return one.filter == filter && (filter != Filter::anisotropic || one.taps == 16);
    });
    const int left = panel % columns * (panel_width + gap);
    const int top = panel / columns * (panel_height + line + gap);
    draw_text(sheet, left + scale, top + 2 * scale,
              text("%s: %.0f read%s, %.3f off", figures.name.c_str(), figures.reads,
                   figures.reads > 1 ? "s" : "", figures.error),
              {20, 20, 20}, scale);
    blit(sheet, draw(filter, panel_width, panel_height), left, top + line);
    ++panel;
  }
  return sheet;
}

void show_sheet(Session& session, const FloorView& floor, const std::string& plot,
                const DrawFiltered& draw) {
  const std::vector<FilterFigures> all =
      compare_filters(floor, session.settings.threads, !session.settings.quiet);
  const Image sheet = sheet_of_filters(session, all, draw);
  if (!session.settings.quiet) print(table_of_filters(all));
  if (!plot.empty()) write_text_atomically(plot, svg_of(plot_of_filters(all)));
  session.save(sheet);
}

}  // namespace texmap::chapter_09
