// The sheet of conventions. For each source document: a globe, a labelled map, u, v, and the two
// ways to round to a texel.
#include "sheet.hpp"

#include <algorithm>
#include <cmath>

#include "conventions_compared.hpp"
#include "engine/draw/render.hpp"
#include "engine/files/sheet.hpp"
#include "engine/files/system.hpp"
#include "engine/run/texture_file.hpp"

namespace texmap::chapter_04 {
namespace {

/// A coordinate as a shade from dark blue (0) to yellow (1), with a dark line at every eighth.
Rgb shade_of(double coordinate) {
  const double within = coordinate * 8 - std::floor(coordinate * 8);
  const double dim = within < 0.06 ? 0.45 : 1;
  return {coordinate * dim, coordinate * dim, (0.45 - 0.45 * coordinate) * dim};
}

/// An 8 x 4 texture with a different color in each texel, so that a lost or shifted texel is seen.
Image few_texels() {
  return image_of(8, 4, [](int column, int row) {
    const bool light = (row + column) % 2 == 0;
    const auto ramp = static_cast<std::uint8_t>(column * 255 / 7);
    return light ? Rgb8{255, ramp, 60} : Rgb8{30, static_cast<std::uint8_t>(60 + row * 40), 160};
  });
}

/// A flat map of the sphere, half as high as wide, north up; `color_at(direction)` at each center.
Image flat_map(int width, const std::function<Rgb(const Vec3<double>&)>& color_at) {
  const int columns = std::max(width, 1), rows = std::max(width / 2, 1);
  return image_of(columns, rows, [&](int column, int row) {
    const Rgb c = color_at(direction_at((column + 0.5) / columns, 1 - (row + 0.5) / rows));
    return Rgb8{byte_of(c.r), byte_of(c.g), byte_of(c.b)};
  });
}

}  // namespace

SheetImage sheet_of_conventions(const Session& session, const DrawGlobe& draw_globe) {
  const int width = session.settings.width;
  const int height = session.settings.height;
  SheetImage sheet(width, height, {255, 255, 255});
  const Image labels = TextureFile{"uv_map.png"}.load();
  const int scale = std::max(1, width / 800);
  const int line = 12 * scale;
  const int gap = std::max(1, width / 200);
  const int panel = std::max(1, std::min(width / 4, (height - 4 * line) * 4 / 7) - gap);
  const int half = std::max(1, (panel - gap) / 2);

  int left = gap / 2;
  for (const PublishedMapping& mapping : published_mappings) {
    const VAxis axis = v_axis_of(mapping.convention);
    SheetColumn column{sheet, left, 0, scale};
    const auto map_of = [&](int map_width, const auto& color_at) {
      return flat_map(map_width,
                      [&](const Vec3<double>& p) { return color_at(mapping.formula(p)); });
    };
    const auto pair_of = [&](const char* caption, const auto& color_at, const char* other_caption,
                             const auto& other_color_at) {
      SheetColumn other = column;
      other.left += half + gap;
      column.write(caption);
      column.lay(map_of(half, color_at));
      other.write(other_caption);
      other.lay(map_of(half, other_color_at));
    };

    column.write(mapping.title);
    column.lay(draw_globe(mapping.convention, panel, std::max(1, panel * 3 / 4)));
    column.write("flat: east right, north up");
    column.lay(map_of(panel, ImageTexture{labels, axis}));
    pair_of(
        "u", [](const Uv<double>& uv) { return shade_of(uv.u); }, "v",
        [](const Uv<double>& uv) { return shade_of(uv.v); });
    pair_of("floor(u n)", ImageTexture{few_texels(), axis}, "(n-1) u cut off",
            ImageTexture{few_texels(), axis, TexelRounding::lecture});
    left += panel + gap;
  }
  return sheet;
}

void save_sheet(Session& session, const Image& sheet) {
  if (!session.settings.quiet) print(table_of_relations());
  session.save(sheet);
}

}  // namespace texmap::chapter_04
