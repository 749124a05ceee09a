// The diagram of chapter 03: from (u, v) to a texel.
#include "diagrams.hpp"
#include "texture/image_texture.hpp"

namespace texmap::diagrams {
namespace {

/// A picture of 8 x 4 texels on the unit square; v goes up, rows go down.
Drawing texel_grid() {
  Drawing d("texel_grid", 640, 340, "From (u, v) to a texel",
            "A grid of 8 by 4 texels. Columns are numbered 0 to 7 from the left, rows 0 to 3 from "
            "the top. u goes to the right, v goes up from the lower edge. The point (0.4, 0.8) is "
            "in column 3 and row 0.");
  const int columns = 8, rows = 4;
  const double left = 110, top = 60, size = 52;
  const auto place = [&](Uv<double> uv) {
    return Spot{left + uv.u * columns * size, top + (1 - uv.v) * rows * size};
  };
  const Uv<double> uv{0.4, 0.8};
  const TexelPlace<double> texel = texel_place(uv, columns, rows, VAxis::up, TexelRounding::floor);
  const Spot corner{left + texel.column * size, top + texel.row * size};
  d.area({corner, corner + Spot{size, 0}, corner + Spot{size, size}, corner + Spot{0, size}},
         "fill-blue");
  for (int i = 0; i <= columns; ++i)
    d.line({left + i * size, top}, {left + i * size, top + rows * size}, "soft");
  for (int i = 0; i <= rows; ++i)
    d.line({left, top + i * size}, {left + columns * size, top + i * size}, "soft");
  for (int i = 0; i < columns; ++i)
    d.text({left + (i + 0.5) * size, top - 12}, std::to_string(i), Anchor::middle,
           i == texel.column ? "blue strong" : "small");
  for (int i = 0; i < rows; ++i)
    d.text({left + columns * size + 16, top + (i + 0.5) * size + 5}, std::to_string(i),
           Anchor::start, i == texel.row ? "blue strong" : "small");
  d.text({left + columns * size / 2, top - 36}, "column = floor(u w), from the left",
         Anchor::middle, "small");
  d.text({left + columns * size + 40, top + 1.8 * size}, "row, from", Anchor::start, "small");
  d.text({left + columns * size + 40, top + 1.8 * size + 18}, "the top", Anchor::start, "small");
  d.arrow(place({0, 0}) + Spot{0, 22}, place({1, 0}) + Spot{0, 22}, "ink");
  d.arrow(place({0, 0}) + Spot{-22, 0}, place({0, 1}) + Spot{-22, 0}, "ink");
  d.text(place({0.5, 0}) + Spot{0, 44}, "u");
  d.text(place({0, 0.5}) + Spot{-40, 5}, "v");
  d.text(place({0, 0}) + Spot{-10, 38}, "0", Anchor::middle, "small");
  d.text(place({1, 0}) + Spot{0, 42}, "1", Anchor::middle, "small");
  d.text(place({0, 1}) + Spot{-40, 8}, "1", Anchor::middle, "small");
  d.line(place({uv.u, 0}), place(uv), "blue dashed");
  d.line(place({0, uv.v}), place(uv), "blue dashed");
  d.dot(place(uv), "fill-red");
  d.text(place(uv) + Spot{10, 22}, "(0.4, 0.8)", Anchor::start, "red");
  d.mark("point", place(uv));
  d.mark("texel", corner);
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_03() { return {texel_grid()}; }

}  // namespace texmap::diagrams
