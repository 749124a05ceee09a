// The computed diagram of chapter 12: the sky as a sphere and as a picture.
#include <array>
#include <string>

#include "diagrams.hpp"
#include "engine/measure/text.hpp"
#include "texture/sky_texels.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::diagrams {
namespace {

constexpr int sky_columns = 16, sky_rows = 8, sky_column = 2;
constexpr std::array sky_example_rows{0, 3};  // at a pole, at the equator

/// The sky as a sphere around the scene, and its picture.
Drawing sky_texels() {
  Drawing d("sky_texels", 640, 320, "Two texels of the sky",
            "Left: a sphere around the scene with a grid of 16 columns and 8 rows. A texel next "
            "to the equator is large, one next to the north pole is a narrow triangle. Right: the "
            "picture of the sky, where both texels have the same size.");
  const double radius = 130;
  const SpaceView view({0.25, 0.5, 1}, {160, 165}, radius);
  const auto at = [](double column, double row) {
    return direction_rtiow(Uv<double>{column / sky_columns, 1 - row / sky_rows});
  };
  d.circle({160, 165}, radius, "fill-soft");
  d.circle({160, 165}, radius, "ink");
  const std::array styles{"fill-red", "fill-blue"};
  const std::array lines{"red thick", "blue thick"};
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<Spot> outline;
    const double row = sky_example_rows[i];
    for (int k = 0; k <= 8; ++k) outline.push_back(view(at(sky_column + k / 8.0, row)));
    for (int k = 0; k <= 8; ++k) outline.push_back(view(at(sky_column + 1, row + k / 8.0)));
    for (int k = 8; k >= 0; --k) outline.push_back(view(at(sky_column + k / 8.0, row + 1)));
    for (int k = 8; k >= 0; --k) outline.push_back(view(at(sky_column, row + k / 8.0)));
    d.area(outline, styles[i]);
    d.curve(outline, lines[i]);
  }
  for (int row = 1; row < sky_rows; ++row) {
    view.draw(d, "soft", 0, sky_columns, [&](double x) { return at(x, row); });
  }
  for (int column = 0; column < sky_columns; ++column) {
    view.draw(d, "soft", 0, sky_rows, [&](double y) { return at(column, y); });
  }
  d.dot(view({0, 0, 0}));
  d.line(view({0, 0, 0}) + Spot{4, -4}, {286, 54}, "soft");
  d.text({290, 52}, "scene", Anchor::start, "small");
  d.text({160, 315}, "the sky as a sphere", Anchor::middle, "small");

  const Spot corner{330, 110};
  const double size = 13.5;
  d.rectangle(corner, sky_columns * size, sky_rows * size, "fill-soft");
  for (int i = 0; i <= sky_columns; ++i)
    d.line(corner + Spot{i * size, 0}, corner + Spot{i * size, sky_rows * size}, "soft");
  for (int i = 0; i <= sky_rows; ++i)
    d.line(corner + Spot{0, i * size}, corner + Spot{sky_columns * size, i * size}, "soft");
  const std::array names{"red small", "blue small"};
  for (std::size_t i = 0; i < 2; ++i) {
    const int row = sky_example_rows[i];
    const Spot texel = corner + Spot{sky_column * size, row * size};
    d.rectangle(texel, size, size, styles[i]);
    d.rectangle(texel, size, size, lines[i]);
    const double angle = SkyBand(row, sky_columns, sky_rows).solid_angle;
    d.text({corner.x + sky_columns * size + 8, texel.y + 11}, "ω = " + texmap::text("%.4f", angle),
           Anchor::start, names[i]);
  }
  d.text(corner + Spot{sky_columns * size / 2, -14}, "north pole: the whole edge", Anchor::middle,
         "small");
  d.text({corner.x + sky_columns * size / 2, 315}, "the sky as a picture", Anchor::middle, "small");
  d.text(corner + Spot{sky_columns * size / 2, sky_rows * size + 26},
         "equal on the picture, not on the sphere", Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_12() { return {sky_texels()}; }

}  // namespace texmap::diagrams
