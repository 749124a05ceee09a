// The mistakes that a chapter's own options draw.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace texmap::slips {

/// A mistake that a chapter's own option draws.
struct OptionSlip {
  const char *chapters, *option, *value;
  const char *words, *change;           ///< as of a Slip
  const char *right = "", *wrong = "";  ///< as of a PageSlip

  [[nodiscard]] std::vector<std::string> typed() const {
    std::vector<std::string> all{option};
    if (*value != 0) all.emplace_back(value);
    return all;
  }
};
inline constexpr OptionSlip of_options[] = {
    {"05", "--degrees", "5156.6201561774", "turned by degrees taken for radians",
     "`angle * pi / 180`", "c = cos(angle * pi / 180)", "c = cos(angle)"},
    {"05", "--degrees", "1.5707963", "turned by radians taken for degrees", "`angle * pi / 180`",
     "c = cos(angle)", "c = cos(angle * pi / 180)"},
    {"05", "--degrees", "45", "turned by half the angle", "the whole angle",
     "turn = rotation_y(angle)", "turn = rotation_y(angle / 2)"},
    {"06", "--degrees", "1145.9155902616", "turned by degrees taken for radians",
     "`angle * pi / 180`", "c = cos(angle * pi / 180)", "c = cos(angle)"},
    {"06", "--highlight", "lecture", "shining on its night side: the highlight has the wrong sign",
     "", "reflected = 2 * dot(normal, to_lamp) * normal - to_lamp",
     "reflected = to_lamp - 2 * dot(normal, to_lamp) * normal"},
    {"07", "--rounding", "lecture", "squeezed: (int)((n - 1) u) in place of floor(n u)",
     "`floor(u * n)`, at most n - 1", "column = floor(u * width)",
     "column = (int)(u * (width - 1))"},
    {"07", "--decode", "raw",
     "the texture is too pale: its bytes were taken for light and not decoded",
     "the curve from bytes to light before the mean", "light = srgb_decode(byte / 255.0)",
     "light = byte / 255.0"},
    {"07 12", "--gamma", "sqrt", "the square root was taken in place of the curve of image files",
     "the sRGB curve", "byte_of(srgb_encode(light))", "byte_of(sqrt(light))"},
    {"07 12", "--gamma", "2.2", "the power 1/2.2 was taken in place of the curve of image files",
     "the sRGB curve", "byte_of(srgb_encode(light))", "byte_of(pow(light, 1 / 2.2))"},
    {"07", "--degrees", "90", "a quarter turn off: u begins at another place", "",
     "u = atan2(-z, x) / (2 * pi) + 0.5", "u = atan2(-z, x) / (2 * pi) + 0.75"},
    {"07 12", "--bounces", "1", "one bounce: paths end at the first surface", "more bounces",
     "for (int bounce = 0; bounce < 50; ++bounce)", "for (int bounce = 0; bounce < 1; ++bounce)"},
    {"08", "--wrap", "repeat", "the texture is repeated and not mirrored",
     "mirror a coordinate beyond 0 and 1", "u = mirror(u)", "u = u - floor(u)"},
    {"08", "--wrap", "clamp", "the texture's edge is repeated: coordinates were limited to 0 and 1",
     "mirror a coordinate beyond 0 and 1", "u = mirror(u)", "u = clamp(u, 0, 1)"},
    {"08", "--degrees", "25", "turned the other way: the sign of the sine",
     "the other sign of the sine, or of the angle", "{x * c + z * s, y, z * c - x * s}",
     "{x * c - z * s, y, z * c + x * s}"},
    {"08", "--degrees", "0", "not turned at all", "rotate the points before the rays",
     "point = turn(point)", ""},
    {"08", "--weights", "picture", "(u, v) is mixed evenly in the picture, and not in space",
     "weights from the hit point in space", "b = area(a, hit, c) / area(a, b, c), in space",
     "b = area(a, hit, c) / area(a, b, c), in the picture"},
    {"11", "--relief", "-0.06", "dents and not bumps: the height has the wrong sign", "",
     "height = relief * gray", "height = -relief * gray"},
    {"11", "--relief", "0.03", "the bumps are half as high", "a relief of 0.06", "relief = 0.06",
     "relief = 0.03"},
    {"11", "--relief", "0.12", "the bumps are twice as high", "a relief of 0.06", "relief = 0.06",
     "relief = 0.12"},
    {"11", "--bump", "off", "without bumps: the globe's own normal", "the leaning normal",
     "dot(leaning, to_lamp)", "dot(normal, to_lamp)"},
    {"11", "--bump", "blinn", "Blinn's normal of 1978, which leaves out the term h dn",
     "the exact normal"},
    {"12", "--degrees", "180", "the sky is turned by half", "u + 0.5",
     "u = atan2(-z, x) / (2 * pi) + 0.5", "u = atan2(-z, x) / (2 * pi)"},
    {"12", "--degrees", "90", "the sky is turned by a quarter", "u - 0.25",
     "u = atan2(-z, x) / (2 * pi) + 0.5", "u = atan2(-z, x) / (2 * pi) + 0.75"},
    {"12", "--degrees", "-90", "the sky is turned by a quarter", "u + 0.25",
     "u = atan2(-z, x) / (2 * pi) + 0.5", "u = atan2(-z, x) / (2 * pi) + 0.25"},
    {"12", "--sky-mirrored", "", "the sky is mirrored: what should be left is right", "1 - u",
     "u = atan2(-z, x) / (2 * pi) + 0.5", "u = atan2(z, x) / (2 * pi) + 0.5"},
    {"12", "--exposure", "1", "the sky is twice as bright", "the picture's own light",
     "light = sky(u, v)", "light = 2 * sky(u, v)"},
    {"12", "--exposure", "-1", "the sky is half as bright", "the picture's own light",
     "light = sky(u, v)", "light = sky(u, v) / 2"},
    {"12", "--filter", "nearest", "the sky has edges: one texel was read, and not four mixed",
     "bilinear"},
};

/// For the book's live pictures alone: ./course diagnose computes these.
inline constexpr OptionSlip of_pages[] = {
    {"04", "--uv-scale", "-1x1", "mirrored: u runs the other way", "`1 - u`",
     "u = atan2(-z, x) / (2 * pi) + 0.5", "u = atan2(z, x) / (2 * pi) + 0.5"},
    {"04", "--uv-offset", "0.25,0", "a quarter turn off: u begins at another place", "`u - 0.25`",
     "u = atan2(-z, x) / (2 * pi) + 0.5", "u = atan2(-z, x) / (2 * pi) + 0.75"},
    {"04", "--uv-offset", "0.5,0", "half a turn off: the picture begins at Greenwich", "`u - 0.5`",
     "u = atan2(-z, x) / (2 * pi) + 0.5", "u = atan2(-z, x) / (2 * pi), plus 1 below 0"},
    {"04", "--uv-scale", "2x1",
     "twice around: u covers 0 to 2, or it was divided by pi and not by 2 pi",
     "`atan2(-z, x) / (2 * pi) + 0.5`", "u = atan2(-z, x) / (2 * pi) + 0.5",
     "u = atan2(-z, x) / pi + 1"},
    {"04", "--uv-scale", "0.5x1", "half of the map is spread over the globe: u only reaches 1/2",
     "`atan2(-z, x) / (2 * pi) + 0.5`", "u = atan2(-z, x) / (2 * pi) + 0.5",
     "u = atan2(-z, x) / (4 * pi) + 0.25"},
    {"04", "--rounding", "lecture", "squeezed: (int)((n - 1) u) in place of floor(n u)",
     "`floor(u * n)`, at most n - 1", "column = floor(u * width)",
     "column = (int)(u * (width - 1))"},
    // The pages' modules draw these, ./course diagnose does not; the lines are those of the pages.
    {"09", "--mistake", "twice", "blurred far away: the footprint is twice as wide as the pixel",
     "",
     "const Dual<Real> across{column, spacing, Real(0)};\n"
     "const Dual<Real> down{row, Real(0), spacing};",
     "const Dual<Real> across{column, 2 * spacing, Real(0)};\n"
     "const Dual<Real> down{row, Real(0), 2 * spacing};"},
    {"09", "--mistake", "half", "rough far away: the footprint is half as wide as the pixel",
     "the whole pixel",
     "const Dual<Real> across{column, spacing, Real(0)};\n"
     "const Dual<Real> down{row, Real(0), spacing};",
     "const Dual<Real> across{column, spacing / 2, Real(0)};\n"
     "const Dual<Real> down{row, Real(0), spacing / 2};"},
    {"09", "--mistake", "right-alone",
     "noise at the horizon: the footprint knows the step to the right alone", "the step down, too",
     "const Dual<Real> down{row, Real(0), spacing};",
     "const Dual<Real> down{row, Real(0), Real(0)};"},
    {"09", "--mistake", "no-texels", "noise far away: the footprint is in (u, v) and not in texels",
     "multiply by the width and the height",
     "p = (du/dx · width, dv/dx · height)          q = (du/dy · width, dv/dy · height)",
     "p = (du/dx, dv/dx)          q = (du/dy, dv/dy)"},
    {"09", "--mistake", "bytes",
     "too dark far away: the levels are means of bytes and not of light",
     "decode the bytes before the mean"},
    {"09", "--taps", "1", "blurred far away: there is one tap, as wide as the footprint is long",
     "", "const Real most = clamp(-floor(-footprint.longer / least), Real(1), Real(taps));",
     "const Real most = Real(1);"},
    {"09", "--wrap", "clamp", "the texture's edge is repeated: coordinates were limited to 0 and 1",
     "`u - floor(u)`, `v - floor(v)`"},
    {"10", "--mistake", "inside", "each face of the cube is mirrored: it is the face from inside",
     "`1 + right`", "u = (c + (1 + right)/2) / 3", "u = (c + (1 - right)/2) / 3"},
    {"10", "--mistake", "columns",
     "the cube's faces -x and +x are exchanged: columns were counted from the right",
     "c from the left", "u = (c + (1 + right)/2) / 3", "u = (2 - c + (1 + right)/2) / 3"},
    {"10", "--mistake", "rows",
     "the cube's rows of faces are exchanged: they were counted from above", "k from below",
     "v = (k + (1 + up)/2) / 2", "v = (1 - k + (1 + up)/2) / 2"},
    {"10", "--mistake", "angles",
     "bent on each face: the cube's texels were taken for the equi-angular ones",
     "`x / z`, `y / z`", "x / z, y / z", "atan(x / z) · 4/π, atan(y / z) · 4/π"},
    {"10", "--mistake", "height",
     "squeezed at the poles: v was taken from the height, without the angle", "",
     "objects[middle].paint = Textured{{layout.on_globe()}, layout.load(texture)};",
     "objects[middle].paint = Textured{{Projection::cylinder}, layout.load(texture)};"},
    {"10", "--mistake", "mirrored", "mirrored: u runs the other way", "",
     "return {clamp_u(Real(0.5) - turn / (Real(2) * pi<Real>())),",
     "return {clamp_u(Real(0.5) + turn / (Real(2) * pi<Real>())),"},
    {"10", "--mistake", "upside-down", "upside down: v runs the other way", "",
     "clamp(Real(0.5) + Real(0.5) * p.y, Real(0), Real(1))};",
     "clamp(Real(0.5) - Real(0.5) * p.y, Real(0), Real(1))};"},
    {"10", "--mistake", "unfolded",
     "the south shows the north: the octahedron's lower faces were not folded out",
     "fold where y is below 0", "(a, b)  →  (sign(a) (1 - |b|), sign(b) (1 - |a|))",
     "(a, b)  →  (a, b)"},
    {"10", "--mistake", "exchanged",
     "each lower face of the octahedron is mirrored: the fold exchanged |a| and |b|",
     "1 - |b| for a, 1 - |a| for b", "(a, b)  →  (sign(a) (1 - |b|), sign(b) (1 - |a|))",
     "(a, b)  →  (sign(a) (1 - |a|), sign(b) (1 - |b|))"},
    {"10", "--mistake", "signs",
     "the south is four times the same face: the octahedron's fold forgot the signs",
     "the signs of a and b", "(a, b)  →  (sign(a) (1 - |b|), sign(b) (1 - |a|))",
     "(a, b)  →  (1 - |b|, 1 - |a|)"},
};

/// The rows of a chapter, by its folder's name.
template <class Row, std::size_t n>
[[nodiscard]] std::vector<const Row*> of_chapter(std::string_view chapter, const Row (&all)[n]) {
  std::vector<const Row*> found;
  for (const Row& row : all) {
    if (std::string_view(row.chapters).find(chapter.substr(0, 2)) != std::string_view::npos)
      found.push_back(&row);
  }
  return found;
}

}  // namespace texmap::slips
