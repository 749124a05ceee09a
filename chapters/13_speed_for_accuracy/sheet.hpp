// The sheet: what some of the variants change in the picture. It shows no times: it is the same on
// every machine.
#pragma once
#include <algorithm>

#include "trials.hpp"

namespace texmap::chapter_13 {

/// Four rows of four pictures, each above three lines of text, and a line above all.
struct SheetLayout {
  int scale, line, gap, panel_width, panel_height;

  SheetLayout(int width, int height)
      : scale(std::max(1, width / 1640)),
        line(11 * scale),
        gap(std::max(1, width / 120)),
        panel_width(std::max(1, width / 4 - gap)),
        panel_height(std::max(1, (height - 2 * line) / 4 - 3 * line - gap)) {}
  [[nodiscard]] int left(int panel) const { return gap / 2 + panel % 4 * (panel_width + gap); }
  [[nodiscard]] int top(int panel) const {
    return 2 * line + gap / 2 + panel / 4 * (panel_height + 3 * line + gap);
  }
};

/// @param threads  as RenderSettings has them
[[nodiscard]] Image draw_sheet(const Globe& globe, int width, int height, int threads,
                               const Tick& tick);

}  // namespace texmap::chapter_13
