// The sheet of conventions: for each seed a globe, a labelled map, u, v, and the two ways to round to a texel.
#pragma once
#include <algorithm>
#include <string>
#include <string_view>

#include "lettering.hpp"
#include "paste.hpp"
#include "seeds.hpp"
#include "standard_streams.hpp"
#include "studio.hpp"
#include "texture_file.hpp"

namespace texmap::chapter_04 {

/// A flat map of the whole sphere, half as high as wide: `color_at(direction)` at each pixel's center, north up.
template <class ColorAt>
[[nodiscard]] Image flat_map(int width, ColorAt color_at) {
  Image map(std::max(width, 1), std::max(width / 2, 1));
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Rgb c = color_at(direction_at((column + 0.5) / map.width, 1 - (row + 0.5) / map.height));
      map.at(column, row) = {byte_of(c.r), byte_of(c.g), byte_of(c.b)};
    }
  }
  return map;
}

/// A coordinate as a shade from black (0) to yellow (1), with a dark line at every eighth.
[[nodiscard]] inline Rgb shade_of(double coordinate) {
  const double within = coordinate * 8 - std::floor(coordinate * 8);
  const double dim = within < 0.06 ? 0.45 : 1;
  return {coordinate * dim, coordinate * dim, (0.45 - 0.45 * coordinate) * dim};
}

/// An 8 x 4 texture in which every texel has a color of its own: what is lost or shifted by a texel is seen.
[[nodiscard]] inline Image few_texels() {
  Image image(8, 4);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const bool light = (row + column) % 2 == 0;
      const auto ramp = static_cast<std::uint8_t>(column * 255 / 7);
      image.at(column, row) = light ? Rgb8{255, ramp, 60} : Rgb8{30, static_cast<std::uint8_t>(60 + row * 40), 160};
    }
  }
  return image;
}

/// The sheet, as large as the studio's picture.
/// The stage stays as it is in every panel, and only the globe's mapping changes. The flat maps use the seeds' own formulas.
template <class Lesson>
[[nodiscard]] Image sheet_of_conventions(const Lesson& lesson, Studio& studio) {
  Image sheet(studio.width, studio.height, {255, 255, 255});
  const Image labels = TextureFile{"uv_map.png"}.load();
  const Image earth = lesson.texture.load();
  const int scale = std::max(1, studio.width / 800);
  const int line = 12 * scale;
  const int gap = std::max(1, studio.width / 200);
  const int panel = std::max(1, std::min(studio.width / 4, (studio.height - 4 * line) * 4 / 7) - gap);
  const int half = std::max(1, (panel - gap) / 2);

  for (std::size_t i = 0; i < seeds_compared.size(); ++i) {
    const Seed& seed = seeds_compared[i];
    const VAxis axis = v_axis_of(seed.convention);
    const int left = gap / 2 + static_cast<int>(i) * (panel + gap);
    int top = 0;
    const auto caption = [&](std::string_view text, int column) {
      draw_text(sheet, column, top + 2 * scale, text, {20, 20, 20}, scale);
    };
    const auto place = [&](const Image& picture, int column) { paste(sheet, picture, column, top); };

    caption(seed.title, left);
    top += line;
    Lesson globe = lesson;
    globe.stage.camera.fov_y_degrees = 20;  // a closer look at the same stage
    globe.objects[0].paint = Mapped<ConventionMapping, ImageTexture>{{seed.convention}, {earth, axis}};
    place(studio.draw(globe, panel, std::max(1, panel * 3 / 4)), left);
    top += panel * 3 / 4;

    caption("flat: east right, north up", left);
    top += line;
    const ImageTexture labelled{labels, axis};
    place(flat_map(panel, [&](const Point& p) { return labelled(seed.formula(p)); }), left);
    top += panel / 2;

    caption("u", left);
    caption("v", left + half + gap);
    top += line;
    place(flat_map(half, [&](const Point& p) { return shade_of(seed.formula(p).u); }), left);
    place(flat_map(half, [&](const Point& p) { return shade_of(seed.formula(p).v); }), left + half + gap);
    top += half / 2;

    caption("floor(u n)", left);
    caption("(n-1) u cut off", left + half + gap);
    top += line;
    const ImageTexture floored{few_texels(), axis};
    const ImageTexture cut_off{few_texels(), axis, TexelRounding::lecture};
    place(flat_map(half, [&](const Point& p) { return floored(seed.formula(p)); }), left);
    place(flat_map(half, [&](const Point& p) { return cut_off(seed.formula(p)); }), left + half + gap);
  }
  return sheet;
}

/// Draws and saves the sheet, and prints the table of exact relations.
template <class Lesson>
void show_conventions(const Lesson& lesson, Studio& studio) {
  studio.prefer_size(1600, 796);
  const Image sheet = sheet_of_conventions(lesson, studio);
  if (!studio.quiet) print(table_of_relations());
  studio.save(sheet);
}

}  // namespace texmap::chapter_04
