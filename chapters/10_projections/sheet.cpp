// The sheet of projections, the globe in one of them, and the conversion of a file.
#include "sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/draw/convert_projection.hpp"
#include "engine/draw/render.hpp"
#include "engine/draw/threads.hpp"
#include "engine/files/sheet.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"
#include "figures.hpp"
#include "probable_layout.hpp"

namespace texmap::chapter_10 {
namespace {

constexpr Rgb8 paper{255, 255, 255};
constexpr Rgb dot_color{0.15, 0.15, 0.15};

/// The color of the solid angle of a texel / that of the mean: in steps of a quarter of an octave.
Rgb area_color(double area) {
  const double octaves = std::floor(clamp(4 * (log1p(area - 1) / log1p(1.0)), -8.0, 8.0) + 0.5) / 8;
  if (octaves > 0) return {1, 1 - 0.7 * octaves, 1 - 0.8 * octaves};
  return {1 + 0.8 * octaves, 1 + 0.5 * octaves, 1};
}

/// The color in steps of 8 levels: a PNG file of the sheet is then half as long.
Rgb8 in_steps(Rgb8 c) {
  const auto step = [](std::uint8_t level) {
    return static_cast<std::uint8_t>(std::min(255, (level + 4) / 8 * 8));
  };
  return {step(c.r), step(c.g), step(c.b)};
}

/// Above 0 within 6 degrees of a center: the cosine of the angle from it, less that of 6 degrees.
/// The centers are on circles of latitude, every 22.5 degrees; -1 far from these.
double in_small_circle(const Vec3<double>& n) {
  constexpr double degree = std::numbers::pi / 180;
  const double latitude = asin(clamp(n.y, -1.0, 1.0)) / degree;
  const double ring = std::round(latitude / 22.5) * 22.5;
  if (std::abs(latitude - ring) > 6.5) return -1;
  const double radius = cos(ring * degree);
  const double step = 2 * std::numbers::pi / std::max(1.0, std::round(16 * radius));
  const double longitude = atan2(n.z, n.x);
  const double from_center = longitude - step * std::round(longitude / step);
  return sin(ring * degree) * n.y + radius * std::sqrt(n.x * n.x + n.z * n.z) * cos(from_center) -
         cos(6 * degree);
}

std::string bound_of(double value) { return std::isinf(value) ? "no bound" : shown(value, 4); }

/// How a layout distorts: small circles of the globe, equal there, over a color for the solid angle
/// of the texels: blue where they are small, white for the mean, red where they are large.
///
/// @param plain   white everywhere
/// @param wanted  see convert_projection
Image distortion_picture(Projection projection, int width, int height, int threads,
                         bool plain = false, const PixelChoice& wanted = {}) {
  Image image(width, height, paper);
  const auto color_at = [&](double column, double row) {
    const Uv<double> uv{column / width, 1 - row / height};
    if (!shows(projection, uv)) return Rgb{1, 1, 1};
    const Vec3<double> n = unproject(projection, uv);
    if (in_small_circle(n) > 0) return dot_color;
    return plain ? Rgb{1, 1, 1} : area_color(distortion(projection, n).area);
  };
  for_each_row(height, threads, {}, [&](int row) {
    for (int column = 0; column < width; ++column) {
      if (wanted && !wanted(column, row)) continue;
      // Away from the edges of circles the whole texel has one color, and one place is enough.
      const Uv<double> middle{(column + 0.5) / width, 1 - (row + 0.5) / height};
      const double inside = plain ? in_small_circle(unproject(projection, middle)) : 0;
      const int places = std::abs(inside) > 0.5 / width ? 1 : 9;
      Rgb sum{};
      for (int k = 0; k < places; ++k)
        sum = sum + color_at(column + (k % 3 + 0.5) / 3, row + (k - k % 3 + 1.5) / 9);
      image.at(column, row) = {byte_of(sum.r / places), byte_of(sum.g / places),
                               byte_of(sum.b / places)};
    }
  });
  return image;
}

}  // namespace

SheetImage sheet_of_projections(const Session& session, const SharedImage& picture, Projection from,
                                const DrawGlobe& draw_globe) {
  const int width = session.settings.width;
  const int height = session.settings.height;
  SheetImage sheet(width, height, paper);
  const int scale = std::max(1, width / 600);
  const int line = 10 * scale;
  const int cell = std::max(1, width / 4);
  const int second_row = height * 47 / 100;  // its pictures are higher
  const int cell_height = std::max(1, height - second_row);
  const int gap = std::max(1, width / 160);
  // Every picture has as many texels for the sphere as an equirectangular one of this width.
  const int wide =
      std::max(8, std::min((cell - 2 * gap) * 4 / 5, (cell_height - 4 * line - 3 * gap) * 7 / 10));
  const Image model(wide, wide / 2);

  static_assert(projections.size() < 8, "the sheet has eight places, and the globe has the last");
  for (std::size_t i = 0; i < projections.size(); ++i) {
    const ProjectionFacts& facts = projections[i];
    const ClosedForms forms = closed_forms(facts.projection);
    const int left = static_cast<int>(i % 4) * cell + gap;
    SheetColumn panel{sheet, left, (i < 4 ? 0 : second_row) + gap, scale, line, 0};
    panel.write(facts.word);
    panel.write("largest texel " + bound_of(forms.largest_texel));
    panel.write("stretch " + bound_of(forms.worst_stretch));
    panel.write("seams " + text("%.0f\u00b0", seam_degrees(facts.projection)));
    const PictureSize size = converted_size(model, Projection::equirect, facts.projection);
    const auto wanted = [&](int column, int row) {
      return session.needs(panel.left + column, panel.top + row);
    };
    Image unfolded =
        convert_projection(picture, from, facts.projection, size, session.settings.threads, wanted);
    for (Rgb8& pixel : unfolded.pixels) pixel = in_steps(pixel);
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        const Uv<double> center{(column + 0.5) / size.width, (row + 0.5) / size.height};
        if (!shows(facts.projection, center)) unfolded.at(column, row) = paper;
      }
    }
    panel.lay(unfolded);
    panel.top += gap;
    panel.lay(distortion_picture(facts.projection, size.width, size.height,
                                 session.settings.threads, false, wanted));
  }

  SheetColumn panel{sheet, 3 * cell + gap, second_row + gap, scale, line, 0};
  for (const char* words : {"circles on the globe", "blue: small texels", "red: large texels", ""})
    panel.write(words);
  const int side = std::max(1, cell - 2 * gap);
  static const Image circles = distortion_picture(Projection::equirect, 1024, 512, 0, true);
  panel.lay(draw_globe(circles, side, side));
  return sheet;
}

void save_sheet(Session& session, const Image& sheet) {
  if (!session.settings.quiet) print(table_of_figures());
  session.save(sheet);
}

void save_converted(Session& session, TextureFile& file, const ProjectionOptions& layout) {
  usage_error_if(layout.projection.has_value(),
                 "--to saves a file, and --projection draws the globe: leave one of them out");
  SharedImage image = file.load();
  const Projection to = layout.to.value_or(layout.from);
  const PictureSize size = converted_size(image, layout.from, to);
  session.chosen.default_size(size.width, size.height);
  if (!session.settings.quiet) print(about_layout(file.name, image));
  const PictureSize wanted{session.settings.width, session.settings.height};
  const Image converted = session.timed(
      static_cast<double>(wanted.width) * wanted.height, [&](const RenderSettings& settings) {
        return convert_projection(image, layout.from, to, wanted, settings.threads);
      });
  image = file.kept = {};  // saving needs the memory
  session.save(converted);
}

}  // namespace texmap::chapter_10
