// The diagrams of chapter 12: a mirrored ray, the sky as a sphere and as a picture, and the alias
// table.
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "diagrams.hpp"
#include "engine/measure/text.hpp"
#include "sampling/alias_table.hpp"
#include "scene/phong.hpp"
#include "texture/sky_texels.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::diagrams {
namespace {

/// A ray that meets a mirror and goes on into the sky.
Drawing mirrored_ray() {
  Drawing d("mirrored_ray", 640, 330, "A mirrored ray",
            "A ray comes from the eye on the left and meets a mirror at its top. The normal n "
            "points up, the direction e points back to the eye. The mirrored direction r leaves "
            "to the right at the same angle to n, and meets the sky, a large arc. The part of e "
            "along n is drawn: e and r are the same distance from n, on opposite sides.");
  const Spot foot{300, 250};
  const double size = 120;
  const Vec3d n{0, 1, 0}, e = normalize(Vec3d{-1, 0.8, 0}), r = mirror(e, n);
  const auto at = [&](const Vec3d& p) { return foot + Spot{p.x, -p.y} * size; };
  // The sky; where the mirrored ray meets it.
  const double far = 200;
  d.arc(foot, far, 12, 130, "blue thick");
  d.text(foot + Spot{0, -far - 12}, "sky", Anchor::middle, "blue strong");
  const Spot seen = foot + Spot{r.x, -r.y} * far;
  d.line(at(r), seen, "red");
  d.dot(seen, "fill-blue");
  d.text(seen + Spot{10, -10}, "this texel is read", Anchor::start, "blue small");
  // The mirror ball's top.
  d.arc(foot + Spot{0, 400}, 400, 64, 116, "ink");
  d.text(foot + Spot{-150, 66}, "mirror", Anchor::middle, "small");
  const Spot eye = foot + Spot{e.x, -e.y} * 270;
  d.line(eye, at(e), "soft");
  d.dot(eye);
  d.text(eye + Spot{-12, 2}, "eye", Anchor::end);
  const Vec3d along = n * dot(n, e);
  d.line(at(e), at(along), "green dashed");
  d.line(at(along), at(r), "green dashed");
  d.text(at(along) + Spot{8, 20}, "(n·e) n", Anchor::start, "green small");
  d.arrow(at({0, 0, 0}), at(n), "ink thick");
  d.arrow(at({0, 0, 0}), at(along), "green thick");
  d.arrow(at({0, 0, 0}), at(e), "red thick");
  d.arrow(at({0, 0, 0}), at(r), "red thick");
  d.text(at(n) + Spot{10, 4}, "n", Anchor::start);
  d.text(at(e * 0.62) + Spot{-6, 20}, "e", Anchor::end, "red");
  d.text(at(r * 0.62) + Spot{10, 18}, "r", Anchor::start, "red");
  d.mark("foot", foot);
  d.mark("e", at(e));
  d.mark("r", at(r));
  d.mark("n", at(n));
  d.mark("seen", seen);
  return d;
}

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
    view.draw(
        d, [&](double x) { return at(x, row); }, 0, sky_columns, "soft");
  }
  for (int column = 0; column < sky_columns; ++column) {
    view.draw(
        d, [&](double y) { return at(column, y); }, 0, sky_rows, "soft");
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
    d.mark("solid angle in row " + std::to_string(row), {angle, 0});
    d.mark("texel in row " + std::to_string(row), view(at(sky_column + 0.5, row + 0.5)));
  }
  d.text(corner + Spot{sky_columns * size / 2, -14}, "north pole: the whole edge", Anchor::middle,
         "small");
  d.text({corner.x + sky_columns * size / 2, 315}, "the sky as a picture", Anchor::middle, "small");
  d.text(corner + Spot{sky_columns * size / 2, sky_rows * size + 26},
         "equal on the picture, not on the sphere", Anchor::middle, "small");
  return d;
}

/// Four probabilities, and the boxes that draw by them.
Drawing alias_table() {
  Drawing d("alias_table", 640, 320, "The alias table",
            "Left: four columns, the probabilities of four texels times four; three are below 1, "
            "the sun's is 2.3. Right: four boxes of height 1. The boxes of the three dark texels "
            "are filled up with pieces of the sun's column; the fourth box holds the rest of it.");
  const std::vector<double> weights{0.10, 0.15, 0.575, 0.175};
  const std::array names{"0", "1", "sun", "3"};
  const std::array styles{"fill-blue", "fill-green", "fill-red", "fill-soft"};
  const AliasTable table(weights);
  const double wide = 52, gap = 12, high = 90, bottom = 270;
  const auto piece = [&](double left, double from, double to, std::size_t thing) {
    if (to - from < 1e-9) return;
    const Spot corner{left, bottom - to * high};
    d.rectangle(corner, wide, (to - from) * high, styles[thing]);
    d.rectangle(corner, wide, (to - from) * high, "ink");
    d.text({left + wide / 2, bottom - (from + to) / 2 * high + 5}, names[thing], Anchor::middle,
           "small");
  };
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const auto column = static_cast<double>(i);
    const double left = 50 + column * (wide + gap);
    piece(left, 0, 4 * weights[i], i);
    d.text({left + wide / 2, bottom + 20}, texmap::text("%.2f", 4 * weights[i]), Anchor::middle,
           "small");

    const AliasTable::Box& box = table.boxes()[i];
    const double right = 370 + column * (wide + gap);
    piece(right, 0, box.share, i);
    piece(right, box.share, 1, box.other);
    d.text({right + wide / 2, bottom + 20}, "box " + std::to_string(i), Anchor::middle, "small");
    d.mark("share " + std::to_string(i), {box.share, static_cast<double>(box.other)});
  }
  d.line({36, bottom - high}, {306, bottom - high}, "soft");
  d.text({32, bottom - high + 5}, "1", Anchor::end, "small");
  d.text({32, bottom + 5}, "0", Anchor::end, "small");
  d.text({172, 312}, "probability × 4", Anchor::middle, "small");
  d.text({492, 312}, "every box is drawn equally often", Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_12() { return {mirrored_ray(), sky_texels(), alias_table()}; }

}  // namespace texmap::diagrams
