// The sheet: what some of the ways change in the picture. No clock has a part in it, so that it is the same on every machine.
#pragma once
#include "difference_map.hpp"
#include "lettering.hpp"
#include "paste.hpp"
#include "table.hpp"

namespace texmap::chapter_13 {

/// Four pictures beside each other, four rows of them, with three lines of text below each and a line above all.
struct SheetLayout {
  int scale, line, gap, panel_width, panel_height;

  SheetLayout(int width, int height)
      : scale(std::max(1, width / 1640)),
        line(11 * scale),
        gap(std::max(1, width / 120)),
        panel_width(std::max(1, width / 4 - gap)),
        panel_height(std::max(1, (height - 2 * line) / 4 - 3 * line - gap)) {}
  [[nodiscard]] int left(int panel) const { return gap / 2 + panel % 4 * (panel_width + gap); }
  [[nodiscard]] int top(int panel) const { return 2 * line + gap / 2 + panel / 4 * (panel_height + 3 * line + gap); }
};

/// Where two pictures differ, in the colors of `compare`'s maps.
///
/// @param reach  each pixel is drawn as far to all sides, so that a lone one is seen; where two meet, the larger difference
/// shows
[[nodiscard]] inline Image differences(const Image& a, const Image& b, int reach) {
  std::vector<int> levels(a.pixels.size());
  for (int row = 0; row < a.height; ++row) {
    for (int column = 0; column < a.width; ++column) {
      const int apart = channel_difference(a.at(column, row), b.at(column, row));
      for (int y = std::max(row - reach, 0); apart > 0 && y <= std::min(row + reach, a.height - 1); ++y) {
        for (int x = std::max(column - reach, 0); x <= std::min(column + reach, a.width - 1); ++x) {
          int& largest = levels[static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x)];
          largest = std::max(largest, apart);
        }
      }
    }
  }
  Image map(a.width, a.height);
  for (std::size_t i = 0; i < levels.size(); ++i) map.pixels[i] = difference_color(levels[i]);
  return map;
}

/// Draws the sheet.
///
/// @param threads  as RenderSettings has them
[[nodiscard]] inline Image draw_sheet(const Globe& globe, int width, int height, int threads, const Tick& tick) {
  const SheetLayout layout(width, height);
  const View view = globe.view(layout.panel_width, layout.panel_height);
  Image sheet(width, height, {255, 255, 255});
  int panel = 0;
  const auto show = [&](const Image& picture, const std::string& name, const std::string& figures, const std::string& bound) {
    const int top = layout.top(panel) + layout.panel_height + 2 * layout.scale;
    const int left = layout.left(panel++);
    paste(sheet, picture, left, layout.top(panel - 1));
    draw_text(sheet, left, top, name, {0, 0, 0}, layout.scale);
    draw_text(sheet, left, top + layout.line, figures, {70, 70, 70}, layout.scale);
    draw_text(sheet, left, top + 2 * layout.line, bound, {70, 70, 70}, layout.scale);
    tick();
  };
  const auto off = [](const Errors& errors) {
    if (errors.changed == 0) return std::string("no pixel differs");
    const char* levels = errors.levels == 1 ? "level" : "levels";
    if (errors.changed == 1) return printed("1 pixel differs, by %d %s", errors.levels, levels);
    return printed("%ld pixels differ, by up to %d %s", errors.changed, errors.levels, levels);
  };

  // Places: the picture, and what numbers and kernels change in it.
  const auto sights = sights_of(globe, view);
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    const Image judge = picture_of(globe, view, {.number = Number::extended, .filter = filter}, threads);
    show(judge, filter == Filter::nearest ? "nearest texel, extended" : "bilinear filter, extended",
         printed("the picture, %d x %d pixels", judge.width, judge.height),
         printed("of a texture of %d x %d", globe.nearest.image.width, globe.nearest.image.height));
    const std::array<Way, 3> ways = {
        {{Number::float_, {}, filter == Filter::nearest ? 0 : 5, filter},
         {Number::float_, {}, filter == Filter::nearest ? 5 : 9, filter},
         {filter == Filter::nearest ? Number::float_ : Number::double_, {}, filter == Filter::nearest ? 9 : 23, filter}}};
    for (const Way& way : ways) {
      const Errors errors = errors_of_places(globe, view, way, sights, judge);
      show(differences(picture_of(globe, view, way, threads), judge, 1),
           std::string(name_of(way.number)) + (way.degree == 0 ? ", reference formula" : ", " + name_of_kernel(way.degree)),
           off(errors), printed("%.1e texels off, at most %.1e", errors.worst_texels, errors.texels_bound));
    }
  }

  // Light: the picture under the sky, and what shorter curves change in it.
  const Image lit = picture_of(globe, view, {.curve = Curve::exact}, threads);
  show(lit, "under the sky's light, sRGB exact", "one ray a pixel", "");
  for (const Curve curve : {Curve::four, Curve::three}) {
    const Image image = picture_of(globe, view, {.curve = curve}, threads);
    Errors errors;
    compare_bytes(image, lit, errors);
    const int bound = rounded_bound(unrounded_bound<double>(curve, Texels::bytes));
    show(differences(image, lit, 0), std::string("sRGB by ") + name_of(curve), off(errors),
         printed("at most %d level%s", bound, bound > 1 ? "s" : ""));
  }

  // Samples: the picture that all samplers go to, and how far off 16 samples are.
#ifdef TEXMAP_HAVE_PACKS
  const Way way{.number = Number::double_pack};
#else
  const Way way{};
#endif
  const Film converged = sampled(globe, view, way, Sampler(SamplerKind::sobol, 256, 1), threads);
  const Image smooth = develop(converged, Transfer::srgb);
  show(smooth, "sobol, 256 rays a pixel", "what all samplers go to", "");
  for (const SamplerKind kind : sampler_kinds) {
    const Film film = sampled(globe, view, way, Sampler(kind, 16), threads);
    show(differences(develop(film, Transfer::srgb), smooth, 0), std::string(name_of(kind)) + ", 16 rays a pixel",
         printed("%.2f levels off, root mean square", rms_apart(levels_of(film), levels_of(converged))), "");
  }

  // What the colors mean.
  int left = layout.gap / 2;
  const int top = layout.line / 2;
  const std::string words = "Differences in levels of 255; in the upper two rows a changed pixel is drawn three wide:";
  draw_text(sheet, left, top, words, {0, 0, 0}, layout.scale);
  left += text_width(words, layout.scale) + layout.line;
  for (const int levels : {0, 1, 2, 4, 8, 16, 32, 64, 128, 255}) {
    paste(sheet, Image(layout.line, 7 * layout.scale, difference_color(levels)), left, top);
    left += layout.line + 2 * layout.scale;
    draw_text(sheet, left, top, std::to_string(levels), {0, 0, 0}, layout.scale);
    left += text_width(std::to_string(levels), layout.scale) + layout.line;
  }
  return sheet;
}

}  // namespace texmap::chapter_13
