// The sheet of conventions. For each source document: a globe, a labelled map, u, v, and the two
// ways to round to a texel.
#include "sheet.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "conventions_compared.hpp"
#include "engine/app/texture_file.hpp"
#include "engine/picture/bitmap_font.hpp"
#include "engine/picture/blit.hpp"
#include "engine/render/render.hpp"
#include "engine/system/system.hpp"

namespace texmap::chapter_04 {
namespace {

/// A coordinate as a shade from black (0) to yellow (1), with a dark line at every eighth.
Rgb shade_of(double coordinate) {
  const double within = coordinate * 8 - std::floor(coordinate * 8);
  const double dim = within < 0.06 ? 0.45 : 1;
  return {coordinate * dim, coordinate * dim, (0.45 - 0.45 * coordinate) * dim};
}

/// An 8 x 4 texture with a different color in each texel, so that a lost or shifted texel is seen.
Image few_texels() {
  Image image(8, 4);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const bool light = (row + column) % 2 == 0;
      const auto ramp = static_cast<std::uint8_t>(column * 255 / 7);
      image.at(column, row) =
          light ? Rgb8{255, ramp, 60} : Rgb8{30, static_cast<std::uint8_t>(60 + row * 40), 160};
    }
  }
  return image;
}

}  // namespace

Image flat_map(int width, const std::function<Rgb(const Vec3<double>&)>& color_at) {
  Image map(std::max(width, 1), std::max(width / 2, 1));
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Rgb c =
          color_at(direction_at((column + 0.5) / map.width, 1 - (row + 0.5) / map.height));
      map.at(column, row) = {byte_of(c.r), byte_of(c.g), byte_of(c.b)};
    }
  }
  return map;
}

Image sheet_of_conventions(const Session& session, const Image& earth,
                           const DrawGlobe& draw_globe) {
  const int width = session.settings.width;
  const int height = session.settings.height;
  Image sheet(width, height, {255, 255, 255});
  const Image labels = TextureFile{"uv_map.png"}.load();
  const int scale = std::max(1, width / 800);
  const int line = 12 * scale;
  const int gap = std::max(1, width / 200);
  const int panel = std::max(1, std::min(width / 4, (height - 4 * line) * 4 / 7) - gap);
  const int half = std::max(1, (panel - gap) / 2);

  int left = gap / 2;
  for (const PublishedMapping& mapping : published_mappings) {
    const VAxis axis = v_axis_of(mapping.convention);
    const int right = left + half + gap;  // of two pictures side by side
    int top = 0;
    const auto caption = [&](std::string_view text, int column) {
      draw_text(sheet, column, top + 2 * scale, text, {20, 20, 20}, scale);
    };
    const auto map_of = [&](int column, int map_width, const auto& color_at) {
      const Image map =
          flat_map(map_width, [&](const Vec3<double>& p) { return color_at(mapping.formula(p)); });
      blit(sheet, map, column, top);
    };

    caption(mapping.title, left);
    top += line;
    const int globe_height = panel * 3 / 4;
    blit(sheet, draw_globe({{mapping.convention}, {earth, axis}}, panel, std::max(1, globe_height)),
         left, top);
    top += globe_height;

    caption("flat: east right, north up", left);
    top += line;
    map_of(left, panel, ImageTexture{labels, axis});
    top += panel / 2;

    caption("u", left);
    caption("v", right);
    top += line;
    map_of(left, half, [](const Uv<double>& uv) { return shade_of(uv.u); });
    map_of(right, half, [](const Uv<double>& uv) { return shade_of(uv.v); });
    top += half / 2;

    caption("floor(u n)", left);
    caption("(n-1) u cut off", right);
    top += line;
    map_of(left, half, ImageTexture{few_texels(), axis});
    map_of(right, half, ImageTexture{few_texels(), axis, TexelRounding::lecture});
    left += panel + gap;
  }
  return sheet;
}

void save_sheet(Session& session, const Image& sheet) {
  if (!session.settings.quiet) print(table_of_relations());
  session.save(sheet);
}

}  // namespace texmap::chapter_04
