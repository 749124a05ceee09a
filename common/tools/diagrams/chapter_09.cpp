// The diagrams of chapter 09: a pixel's footprint, the levels of a pyramid, the reads of filters,
// and the slope of u at the seam.
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "diagrams.hpp"
#include "engine/measure/text.hpp"
#include "scene/camera.hpp"
#include "scene/floor.hpp"
#include "texture/filters.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/rotated.hpp"
#include "texture/uv.hpp"

namespace texmap::diagrams {
namespace {

/// A footprint's rectangle around a place; `size` units of the drawing for a texel, v up.
std::vector<Spot> rectangle_of(const Footprint<double>& f, Spot center, double size) {
  const Spot along = Spot{f.along_u, -f.along_v} * size;
  const Spot across = Spot{along.y, -along.x} * (f.shorter / f.longer);
  return {center + (along + across) * 0.5, center + (along - across) * 0.5,
          center - (along + across) * 0.5, center - (along - across) * 0.5};
}

void outline(Drawing& d, const std::vector<Spot>& corners, const std::string& style) {
  std::vector<Spot> closed = corners;
  closed.push_back(corners.front());
  d.curve(closed, style);
}

/// Lines between texels, `size` apart.
void texel_lines(Drawing& d, Spot corner, int columns, int rows, double size) {
  const double right = corner.x + columns * size, bottom = corner.y + rows * size;
  for (int i = 0; i <= columns; ++i) {
    const double x = corner.x + i * size;
    d.line({x, corner.y}, {x, bottom}, "soft");
  }
  for (int i = 0; i <= rows; ++i) {
    const double y = corner.y + i * size;
    d.line({corner.x, y}, {right, y}, "soft");
  }
}

/// A pixel seen through the screen, and what it covers on the texture.
Drawing pixel_footprint() {
  Drawing d("pixel_footprint", 640, 340, "The footprint of a pixel",
            "Left: four rays from the eye go through the corners of a pixel of the screen and meet "
            "the floor in the corners of a long four-sided area. Right: this area on the texels, "
            "as a parallelogram with the sides p and q; a rectangle with the same area and the "
            "same spread stands for it; the ellipse of the filter ewa is around both.");
  constexpr int width = 6, height = 4, column = 3, row = 2;
  const Camera camera{.eye = {0, 1.5, 0}, .target = {0, 0.55, -1.7}, .fov_y_degrees = 48};
  const View<> view = view_of(camera, width, height);
  const Floor floor{.height = 0};
  const SpaceView space({1.9, 0.9, 1.0}, {34, 250}, 98);

  const auto on_screen = [&](double x, double y) {
    return space(camera.eye + direction_through(view, x, y) * 0.85);
  };
  const auto on_floor = [&](double x, double y) {
    const Ray<double> ray = ray_through(view, x, y);
    return space(point_on(floor, ray, distance_to(floor, ray)));
  };
  const std::array<Spot, 4> offsets{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
  std::vector<Spot> pixel, covered;
  for (const Spot o : offsets) {
    pixel.push_back(on_screen(column + o.x, row + o.y));
    covered.push_back(on_floor(column + o.x, row + o.y));
  }
  // The floor, as far as the drawing goes.
  for (int i = -1; i <= 2; ++i) {
    const double x = 0.6 * i;
    d.line(space({x, 0, -0.4}), space({x, 0, -3.4}), "soft");
  }
  for (int i = 0; i <= 5; ++i) {
    const double z = -0.4 - 0.6 * i;
    d.line(space({-0.6, 0, z}), space({1.2, 0, z}), "soft");
  }
  d.area(covered, "fill-blue");
  outline(d, covered, "blue");
  const Spot eye = space(camera.eye);
  for (std::size_t i = 0; i < 4; ++i) {
    d.line(eye, pixel[i], "blue");
    d.line(pixel[i], covered[i], "blue dashed");
    d.mark("pixel " + std::to_string(i), pixel[i]);
    d.mark("floor " + std::to_string(i), covered[i]);
  }
  for (int i = 0; i <= width; ++i)
    d.line(on_screen(i - 0.5, -0.5), on_screen(i - 0.5, height - 0.5), "soft");
  for (int i = 0; i <= height; ++i)
    d.line(on_screen(-0.5, i - 0.5), on_screen(width - 0.5, i - 0.5), "soft");
  d.area(pixel, "fill-blue");
  outline(d, pixel, "blue");
  d.dot(eye);
  d.mark("eye", eye);
  d.text(eye + Spot{-4, -12}, "eye", Anchor::middle);
  d.text(on_screen(1.5, -0.5) + Spot{20, -22}, "the screen", Anchor::middle, "small");
  d.text({215, 318}, "the footprint on the floor", Anchor::middle, "blue small");

  // The same on the texels.
  const Rotated<FloorMapping> mapping{rotation_y(23), {.size = 1}};
  const auto ray = ray_through(view, Dual<double>{column, 1, 0}, Dual<double>{row, 0, 1});
  const auto uv = mapping(point_on(floor, ray, distance_to(floor, ray)));
  constexpr double texels = 7, size = 24;
  const Footprint<double> footprint = footprint_of(uv, texels, texels);
  const Spot center{510, 146};
  texel_lines(d, {center.x - 5 * size, center.y - 5.5 * size}, 10, 12, size);
  const Spot p = Spot{uv.u.dx, -uv.v.dx} * (texels * size);
  const Spot q = Spot{uv.u.dy, -uv.v.dy} * (texels * size);
  std::vector<Spot> sides;
  sides.reserve(4);
  for (const Spot o : offsets) sides.push_back(center + p * o.x + q * o.y);
  const std::vector<Spot> box = rectangle_of(footprint, center, size);
  std::vector<Spot> ellipse;
  const Spot half_long =
      (box[0] + box[1] - center * 2.0) * std::sqrt(FilteredTexture::squared_axis_per_side);
  const Spot half_short = (box[0] - box[1]) * std::sqrt(FilteredTexture::squared_axis_per_side);
  for (int i = 0; i <= 96; ++i) {
    const double angle = 2 * std::numbers::pi * i / 96;
    ellipse.push_back(center + half_long * std::cos(angle) + half_short * std::sin(angle));
  }
  d.area(sides, "fill-blue");
  outline(d, sides, "blue");
  outline(d, box, "red");
  d.curve(ellipse, "green dashed");
  d.dot(center);
  d.text(center - q * 0.4 + Spot{0, 5}, "p", Anchor::middle, "blue strong");
  d.text(center + p * 0.36 + Spot{0, 5}, "q", Anchor::middle, "blue strong");
  d.text({390, 322}, "parallelogram", Anchor::start, "blue small");
  d.text({527, 322}, "rectangle", Anchor::middle, "red small");
  d.text({632, 322}, "ellipse", Anchor::end, "green small");
  for (std::size_t i = 0; i < 4; ++i) {
    d.mark("parallelogram " + std::to_string(i), sides[i]);
    d.mark("rectangle " + std::to_string(i), box[i]);
  }
  d.mark("center", center);
  d.mark("end of the ellipse", ellipse.front());
  return d;
}

/// The levels of a pyramid.
Drawing mip_pyramid() {
  Drawing d("mip_pyramid", 640, 190, "The levels of a MIP pyramid",
            "A picture of 8 by 8 texels, and its levels of 4 by 4, 2 by 2 and 1 texel, all drawn "
            "in the same size. Each texel of a level holds the mean of four texels of the level "
            "before.");
  constexpr int texels = 8;
  LightImage image(texels, texels);
  const std::array<std::string, texels> picture{"........", ".#####..", ".#......", ".####...",
                                                ".....##.", ".....##.", ".####...", "........"};
  for (int row = 0; row < texels; ++row) {
    for (int column = 0; column < texels; ++column) {
      const char sign = picture.at(static_cast<std::size_t>(row))[static_cast<std::size_t>(column)];
      image.at(column, row) = gray(sign == '#' ? 1.0F : 0.0F);
    }
  }
  const Pyramid pyramid = pyramid_of(image);
  constexpr double side = 128, between = 26, left = 26, top = 40;
  for (int number = 0; number <= pyramid.last_level(); ++number) {
    const PyramidLevel<int>& level = pyramid.levels[static_cast<std::size_t>(number)];
    const Spot corner{left + number * (side + between), top};
    const double size = side / level.width;
    texel_lines(d, corner, level.width, level.height, size);
    const auto at = level_of(pyramid, double(number));
    for (int row = 0; row < level.height; ++row) {
      for (int column = 0; column < level.width; ++column) {
        const double light = texel_light(pyramid, at, double(column), double(row)).g;
        const Spot texel = corner + Spot{column * size, row * size};
        if (number == 0) {
          if (light > 0) d.rectangle(texel, size, size, "fill-ink");
        } else {
          d.text(texel + Spot{size / 2, size / 2 + 5}, text("%.2g", light), Anchor::middle,
                 "small");
          d.mark("mean " + std::to_string(number) + " " + std::to_string(column) + " " +
                     std::to_string(row) + " is " + text("%.2g", light),
                 texel);
        }
      }
    }
    d.text(corner + Spot{side / 2, -12}, "level " + std::to_string(number), Anchor::middle,
           "strong");
  }
  return d;
}

/// The level of a read with a width between those of two levels.
Drawing level_of_width() {
  constexpr int last = 3;
  Drawing d("level_of_width", 640, 130, "The level of a read 3 texels wide",
            "An axis with the levels 0, 1, 2 and 3 at equal distances. The texels of level 0 are 1 "
            "texel wide, those of level 1 are 2 wide, of level 2 are 4 wide, of level 3 are 8 "
            "wide. A read 3 texels wide lies between level 1 and level 2, at 0.42 of the way.");
  constexpr double axis = 68, width = 3;
  const LevelPlace<double> place = level_place(width, last);
  const auto middle = [](double number) { return 90 + number * 154; };
  d.line({middle(0), axis}, {middle(last), axis});
  for (int number = 0; number <= last; ++number) {
    const Spot tick{middle(number), axis};
    d.line(tick - Spot{0, 5}, tick + Spot{0, 5});
    d.text(tick + Spot{0, 26}, "level " + std::to_string(number), Anchor::middle);
    d.text(tick + Spot{0, 46}, text(number == 0 ? "%d texel wide" : "%d texels wide", 1 << number),
           Anchor::middle, "small");
    d.mark("level " + std::to_string(number), tick);
  }
  const Spot chosen{middle(place.number + place.fraction), axis};
  d.arrow(chosen + Spot{0, -38}, chosen, "blue thick");
  d.text(chosen + Spot{0, -46},
         text("a read 3 texels wide: level %.2f", place.number + place.fraction), Anchor::middle,
         "blue small");
  d.mark("width 3", chosen);
  return d;
}

/// A long footprint, read by one square or by a row of squares.
Drawing square_or_row() {
  Drawing d("square_or_row", 640, 270, "A long footprint and three ways to read it",
            "A long, narrow and slanted rectangle, three times. Left: a square as wide as the "
            "rectangle is long covers much more than the rectangle. Middle: a square as wide as "
            "the rectangle is narrow covers only its middle. Right: a row of six such squares "
            "covers the rectangle.");
  constexpr double size = 17, panel = 11;
  LightImage blank(64, 64);
  const FilteredTexture texture{.pyramid = pyramid_of(blank)};
  const Uv<Dual<double>> uv{{0.5, 1.3 / 64, 7.0 / 64}, {0.5, -0.9 / 64, 4.0 / 64}};
  const Footprint<double> footprint = footprint_of(uv, 64.0, 64.0);
  const auto reads = texture.taps_of(Uv<double>{0.5, 0.5}, footprint);
  const std::array words{"trilinear: too much", "narrow: too little", "anisotropic: a row"};
  for (int i = 0; i < 3; ++i) {
    const Spot corner{20 + 206.0 * i, 20}, center = corner + Spot{panel, panel} * (size / 2);
    texel_lines(d, corner, static_cast<int>(panel), static_cast<int>(panel), size);
    const std::vector<Spot> box = rectangle_of(footprint, center, size);
    d.area(box, "fill-blue");
    outline(d, box, "blue");
    const double width = i == 0 ? footprint.longer : reads.width;
    const int count = i == 2 ? static_cast<int>(reads.count) : 1;
    for (int read = 0; read < count; ++read) {
      const Uv<double> at = reads.at(read);
      const Spot middle = i == 2 ? center + Spot{at.u - 0.5, 0.5 - at.v} * (64 * size) : center;
      d.rectangle(middle - Spot{width, width} * (size / 2), width * size, width * size, "red");
      if (i == 2) d.mark("read " + std::to_string(read), middle);
    }
    d.text(corner + Spot{panel * size / 2, panel * size + 30},
           words.at(static_cast<std::size_t>(i)));
    if (i == 2) {
      d.mark("one end", (box[2] + box[3]) * 0.5);
      d.mark("other end", (box[0] + box[1]) * 0.5);
    }
  }
  return d;
}

/// u from pixel to pixel across the seam: its slope, and the difference of neighbors.
Drawing slope_at_seam() {
  Drawing d("slope_at_seam", 640, 290, "The slope of u at the seam",
            "Dots show u of eight neighboring pixels: 0.65, 0.75, 0.85, 0.95, then 0.05, 0.15, "
            "0.25, 0.35. A short line through each dot shows its slope, 0.1 a pixel everywhere. "
            "The difference between the two dots at the seam is minus 0.9.");
  const Spot origin{110, 236};
  const double across = 60, up = 190;
  const auto place = [&](double pixel, double u) { return origin + Spot{pixel * across, -u * up}; };
  d.line(place(-0.5, 0), place(7.7, 0));
  d.line(place(-0.5, 0), place(-0.5, 1));
  d.line(place(-0.5, 1), place(7.7, 1), "soft");
  d.line(place(3.5, 0), place(3.5, 1.12), "soft");
  d.text(place(3.5, 1.12) + Spot{0, -6}, "the seam", Anchor::middle, "small");
  d.text(place(-0.5, 0) + Spot{-10, 5}, "u = 0", Anchor::end, "small");
  d.text(place(-0.5, 1) + Spot{-10, 5}, "u = 1", Anchor::end, "small");
  for (int i = 0; i < 8; ++i) {
    // Pixel by pixel eastward, a tenth of a turn each.
    const Dual<double> turn{0.1 * (i - 3.5), 0.1, 0};
    const Dual<double> angle = Dual<double>(std::numbers::pi) * (Dual<double>(1) - turn - turn);
    const Vec3<Dual<double>> point{cos(angle), Dual<double>(0), sin(angle)};
    const Dual<double> u = uv_rtiow(point).u;
    const Spot dot = place(i, u.value), slope{across, -u.dx * up};
    d.line(dot - slope * 0.36, dot + slope * 0.36, "blue thick");
    d.dot(dot);
    d.mark("dot " + std::to_string(i), dot);
    d.mark("slope " + std::to_string(i), slope);
    d.text(place(i, 0) + Spot{0, 22}, std::to_string(i), Anchor::middle, "small");
  }
  d.arrow(d.marked("dot 3") + Spot{1, 7}, d.marked("dot 4") + Spot{-2, -7}, "red");
  d.text(place(3.95, 0.55), "difference -0.9", Anchor::start, "red");
  d.text(place(0.1, 0.5), "slope 0.1", Anchor::start, "blue");
  d.text(place(3.5, 0) + Spot{0, 44}, "pixels", Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_09() {
  return {pixel_footprint(), mip_pyramid(), level_of_width(), square_or_row(), slope_at_seam()};
}

}  // namespace texmap::diagrams
