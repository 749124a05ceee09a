// The diagrams of chapter 03: from (u, v) to a texel, a frayed coast, and half a texel.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "diagrams.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"
#include "texture/image_texture.hpp"
#include "texture/uv.hpp"

namespace texmap::diagrams {
namespace {

/// A picture of 8 x 4 texels on the unit square; v goes up, rows go down.
Drawing texel_grid() {
  Drawing d("texel_grid", 640, 340, "From (u, v) to a texel",
            "A grid of 8 by 4 texels. Columns are numbered 0 to 7 from the left, rows 0 to 3 from "
            "the top. u goes to the right, v goes up from the lower edge. The point (0.4, 0.8) is "
            "in column 3. It is in the topmost row, which is 3 counted by v from below and 0 "
            "counted from the top.");
  const int columns = 8, rows = 4;
  const double left = 80, top = 60, size = 52;
  const auto place = [&](Uv<double> uv) {
    return Spot{left + uv.u * columns * size, top + (1 - uv.v) * rows * size};
  };
  const Uv<double> uv{0.4, 0.8};
  const TexelPlace<double> texel = texel_place(uv, columns, rows, VAxis::up, TexelRounding::floor);
  const Spot corner{left + texel.column * size, top + texel.row * size};
  const double right = left + columns * size, bottom = top + rows * size;
  d.area({corner, corner + Spot{size, 0}, corner + Spot{size, size}, corner + Spot{0, size}},
         "fill-blue");
  for (int i = 0; i <= columns; ++i)
    d.line({left + i * size, top}, {left + i * size, bottom}, "soft");
  for (int i = 0; i <= rows; ++i) d.line({left, top + i * size}, {right, top + i * size}, "soft");
  for (int i = 0; i < columns; ++i) {
    d.text({left + (i + 0.5) * size, top - 12}, std::to_string(i), Anchor::middle,
           i == texel.column ? "blue strong" : "small");
  }
  for (int i = 0; i < rows; ++i) {
    const double y = top + (i + 0.5) * size + 5;
    d.text({right + 38, y}, std::to_string(rows - 1 - i), Anchor::middle,
           i == texel.row ? "red strong" : "small");
    d.text({right + 100, y}, std::to_string(i), Anchor::middle,
           i == texel.row ? "blue strong" : "small");
  }
  d.text({left + columns * size / 2, top - 36}, "column = floor(8 u)", Anchor::middle, "small");
  d.text({right + 38, top - 12}, "floor(4 v)", Anchor::middle, "red small");
  d.text({right + 100, top - 12}, "row", Anchor::middle, "small");
  d.arrow({right + 62, bottom}, {right + 62, top}, "red");
  d.arrow({right + 124, top}, {right + 124, bottom}, "ink");
  d.arrow({left, bottom + 22}, {right, bottom + 22}, "ink");
  d.arrow({left - 22, bottom}, {left - 22, top}, "ink");
  d.text(place({0.5, 0}) + Spot{0, 44}, "u");
  d.text(place({0, 0.5}) + Spot{-36, 5}, "v", Anchor::end);
  d.text({left, bottom + 42}, "0", Anchor::middle, "small");
  d.text({right, bottom + 42}, "1", Anchor::middle, "small");
  d.text({left - 32, bottom + 4}, "0", Anchor::end, "small");
  d.text({left - 32, top + 8}, "1", Anchor::end, "small");
  d.text(place({uv.u, 0}) + Spot{0, 42}, "0.4", Anchor::middle, "red small");
  d.text(place({0, uv.v}) + Spot{-32, 5}, "0.8", Anchor::end, "red small");
  d.line(place({uv.u, 0}), place(uv), "red dashed");
  d.line(place({0, uv.v}), place(uv), "red dashed");
  d.dot(place(uv), "fill-red");
  d.mark("point", place(uv));
  d.mark("texel", corner);
  return d;
}

/// Where the ray through a place of chapter 03's picture meets the globe, in texels from the
/// texture's upper left corner. Whole numbers are the pixels' centers.
Spot in_texels(const View<>& view, const Image& map, double column, double row) {
  const Ray<double> ray{view.eye, direction_through(view, column, row)};
  const double distance = distance_to(Sphere<>{{0, 0, 0}, 1}, ray);
  const Uv<double> uv = uv_rtiow(ray.origin + ray.direction * distance);
  return {uv.u * map.width, (1 - uv.v) * map.height};
}

/// Florida in the picture of chapter 03, and the texels of nine of its pixels.
Drawing frayed_coast() {
  Drawing d("frayed_coast", 640, 340, "One ray reads one of many texels",
            "Left: ten by ten pixels of the picture, land and sea, with a jagged coast; nine "
            "pixels are framed. Right: the map's texels under these nine pixels. Each pixel "
            "covers some 25 texels, some of land and some of sea, and a dot marks the only one "
            "that its ray reads.");
  const Image map = load_image(find_texture("earth.png"));
  const View<> view = view_of({.eye = {0, 2, 8}, .target = {0, 0, 0}}, 800, 600);
  // The texture's own rule for land and sea.
  const auto color_of = [&](int column, int row) {
    const Rgb8& texel = map.at(column, row);
    return texel.b > texel.r + 20 ? "fill-blue" : "fill-green";
  };
  const int left = 404, top = 278, framed_left = 408, framed_top = 282;

  // The pixels, each in the color of its one texel.
  const Spot origin{30, 50};
  const double pixel = 24;
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) {
      const Spot at = in_texels(view, map, left + column, top + row);
      d.rectangle(origin + Spot{column * pixel, row * pixel}, pixel, pixel,
                  color_of(static_cast<int>(at.x), static_cast<int>(at.y)));
    }
  }
  d.rectangle(origin + Spot{(framed_left - left) * pixel, (framed_top - top) * pixel}, 3 * pixel,
              3 * pixel, "ink");
  d.text(origin + Spot{5 * pixel, 10 * pixel + 26}, "10 x 10 pixels of the picture", Anchor::middle,
         "small");

  // The texels under the framed pixels, a run of one color at a time.
  std::array<std::array<Spot, 4>, 4> corners{};
  Spot low{1e9, 1e9}, high{0, 0};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const Spot at = in_texels(view, map, framed_left - 0.5 + static_cast<double>(column),
                                framed_top - 0.5 + static_cast<double>(row));
      corners[row][column] = at;
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
  }
  low = {std::floor(low.x), std::floor(low.y)};
  high = {std::ceil(high.x), std::ceil(high.y)};
  const double texel = std::min(300 / (high.x - low.x), 240 / (high.y - low.y));
  const Spot corner{320, 50};
  const auto place = [&](Spot at) { return corner + (at - low) * texel; };
  for (int row = static_cast<int>(low.y); row < static_cast<int>(high.y); ++row) {
    int begin = static_cast<int>(low.x);
    for (int column = begin; column < static_cast<int>(high.x); ++column) {
      const bool ends = column + 1 == static_cast<int>(high.x) ||
                        std::string(color_of(column + 1, row)) != color_of(column, row);
      if (!ends) continue;
      d.rectangle(place({begin + 0.0, row + 0.0}), (column + 1 - begin) * texel, texel,
                  color_of(column, row));
      begin = column + 1;
    }
  }
  for (int i = 0; low.x + i <= high.x; ++i)
    d.line(place({low.x + i, low.y}), place({low.x + i, high.y}), "soft");
  for (int i = 0; low.y + i <= high.y; ++i)
    d.line(place({low.x, low.y + i}), place({high.x, low.y + i}), "soft");
  for (std::size_t i = 0; i < 4; ++i) {
    d.curve(
        {place(corners[i][0]), place(corners[i][1]), place(corners[i][2]), place(corners[i][3])});
    d.curve(
        {place(corners[0][i]), place(corners[1][i]), place(corners[2][i]), place(corners[3][i])});
  }
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      d.dot(place(in_texels(view, map, framed_left + column, framed_top + row)), "fill-red");
  }
  d.text({corner.x + (high.x - low.x) * texel / 2, corner.y + (high.y - low.y) * texel + 26},
         "the texels under the nine framed pixels", Anchor::middle, "small");
  d.text({320, 28}, "sea is blue, land is green; a dot is what one ray reads", Anchor::middle,
         "small");
  d.mark("texel size", {texel, texel});
  d.mark("low", low);
  d.mark("corner", corner);
  d.mark("ray", place(in_texels(view, map, framed_left + 1, framed_top + 1)));
  d.mark("a", place(corners[1][1]));
  d.mark("b", place(corners[1][2]));
  d.mark("c", place(corners[2][2]));
  d.mark("d", place(corners[2][1]));
  return d;
}

/// Columns painted for u = i / (n - 1), and looked up from i / n to (i + 1) / n.
Drawing half_a_texel() {
  Drawing d("half_a_texel", 640, 200, "Half a texel",
            "A row of 8 texels from u = 0 to u = 1. A dot shows the u that each column was "
            "painted for: the left edge of the first texel, the right edge of the last, and in "
            "between ever farther right. An arrow goes from there to the middle of the texel, "
            "where the column is seen: to the right in the left half, to the left in the right "
            "half.");
  const int columns = 8;
  const double left = 80, top = 70, width = 480, height = 50;
  for (int i = 0; i < columns; ++i) {
    const double size = width / columns;
    d.rectangle({left + i * size, top}, size, height, i % 2 == 0 ? "fill-soft" : "soft");
    d.text({left + (i + 0.5) * size, top - 14}, std::to_string(i));
    const Spot painted{left + width * i / (columns - 1.0), top + height / 2};
    const Spot middle{left + (i + 0.5) * size, top + height / 2};
    if (std::abs(painted.x - middle.x) > 10) {
      d.arrow(painted, middle, "red");
    } else {
      d.line(painted, middle, "red");
    }
    d.dot(painted, "fill-red");
    d.mark("painted " + std::to_string(i), painted);
    d.mark("middle " + std::to_string(i), middle);
  }
  d.rectangle({left, top}, width, height, "ink");
  d.text({left + width / 2, top - 40}, "column that the look-up finds", Anchor::middle, "small");
  d.text({left + width / 2, top + height + 52},
         "dot: the u that the column was painted for; arrow: to the middle of where it is seen",
         Anchor::middle, "red small");
  d.text({left, top + height + 24}, "u = 0");
  d.text({left + width, top + height + 24}, "u = 1");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_03() { return {texel_grid(), frayed_coast(), half_a_texel()}; }

}  // namespace texmap::diagrams
