// What a program on the stage computes otherwise when something slips: for each place of the path
// from a ray to a byte a table of slips.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "engine/draw/render.hpp"
#include "math/color.hpp"
#include "math/srgb.hpp"
#include "math/vec3.hpp"
#include "texture/image.hpp"
#include "texture/uv.hpp"

namespace texmap::slips {

inline constexpr double pi = std::numbers::pi;

/// What is wrong, and what to write instead; empty where a card says that.
struct Named {
  const char *words, *change;
};
/// The same with its calculation, one for each place of the path.
template <class Calculation>
struct Calculated : Named {
  Calculation calculate;
};
/// A texel, and the (u, v) that it is read for.
struct Spot {
  int column, row;
  Uv<double> uv;
};
using UForm = Calculated<double (*)(double angle, const Vec3d& d)>;  // angle = atan2(-z, x)
using VForm = Calculated<double (*)(double v, double y)>;            // v: the right one
using Texel = Calculated<Uv<double> (*)(const Uv<double>& uv, double columns, double rows)>;
using Reading = Calculated<Rgb (*)(const Image& image, const Spot& at)>;
using IsOdd = Calculated<bool (*)(double u, double v)>;  // u and v times the number of squares
using SkyForm = Calculated<double (*)(double y, double down)>;  // of the ray; of the picture
using Bytes = Calculated<Rgb8 (*)(const Rgb& color)>;

/// The places of the path where something can slip, in their order.
enum Place {
  turned,
  pole,
  mirrored,
  degrees,
  upside,
  u_form,
  v_form,
  texel,
  reading,
  squares,
  shadows,
  light,
  sky,
  bytes,
  flip
};
inline constexpr int places = flip + 1;

// Row 0 of each table is right.

enum Turned {
  not_turned = 1,
  other_way,
  twice,
  about_x,
  about_x_back,
  about_z,
  about_z_back,
  with_light,
  with_light_and_shadow,
  x_overwritten,
  z_overwritten,
  from_origin,
  from_point,
  inward,
  undivided,
  undivided_uv
};
inline constexpr const char* about_y = "turned about a horizontal axis: y must stay as it is";
inline constexpr const char* keep_y = "`{x * cos + z * sin, y, z * cos - x * sin}`";
inline constexpr const char* light_turned =
    "light and shade turned with the globe: the normal was rotated for the light, too";
inline constexpr const char* own_normal = "the light takes the normal as it is";
inline constexpr const char* overwritten =
    "skewed: a coordinate was overwritten before the other was computed from it";
inline constexpr Named of_turned[] = {
    {},
    {"not turned at all", "rotate the normal before the mapping"},
    {"turned the other way: the sign of the sine", "the other sign of the sine, or of the angle"},
    {"turned by twice the angle", "rotate once"},
    {about_y, keep_y},
    {about_y, keep_y},
    {about_y, keep_y},
    {about_y, keep_y},
    {light_turned, own_normal},
    {light_turned, own_normal},
    {overwritten, keep_y},
    {overwritten, keep_y},
    {"the center was not subtracted: (u, v) were taken from the point in the world",
     "`(point - center) / radius` for the mapping"},
    {"(u, v) were taken from the point itself: it has no center and no radius",
     "`(point - center) / radius` for the mapping"},
    {"the normal points inward", "`(point - center) / radius`, not `center - point`"},
    {"the normal was not divided by the radius", "`(point - center) / radius`"},
    {"the direction for (u, v) was not divided by the radius", "`(point - center) / radius`"},
};
inline constexpr Named of_pole[] = {
    {},
    {"the poles lie on the x axis: x and y are exchanged", "y is the axis: `v = acos(-y) / pi`"},
    {"the poles lie on the z axis: z and y are exchanged", "y is the axis: `v = acos(-y) / pi`"},
};
inline constexpr Named of_mirrored[] = {{}, {"mirrored: u runs the other way", ""}};
inline constexpr Named of_upside[] = {{}, {"upside down: v runs the other way", ""}};

inline constexpr const char* right_u = "`atan2(-z, x) / (2 * pi) + 0.5`";
inline constexpr UForm of_u[] = {
    {{}, [](double angle, const Vec3d&) { return angle / (2 * pi) + 0.5; }},
    {{"striped: u is negative on one half and was limited to 0; the 1/2 is missing", ""},
     [](double angle, const Vec3d&) { return angle / (2 * pi); }},
    {{"twice around: u covers 0 to 2, or it was divided by pi and not by 2 pi", right_u},
     [](double angle, const Vec3d&) { return angle / pi + 0.5; }},
    {{"folded: atan knows half of the directions; atan2 knows all",
      "`atan2(-z, x)`, not `atan(-z / x)`"},
     [](double, const Vec3d& d) { return std::atan(-d.z / d.x) / (2 * pi) + 0.5; }},
    {{"folded: atan over pi covers the map twice; atan2 over 2 pi once", right_u},
     [](double, const Vec3d& d) { return std::atan(-d.z / d.x) / pi + 0.5; }},
    {{"folded: acos gives east and west the same u", "`atan2(-z, x)`, not `acos(x)`"},
     [](double, const Vec3d& d) { return std::acos(d.x / std::hypot(d.x, d.z)) / (2 * pi); }},
    {{"folded: acos gives east and west the same u", "`atan2(-z, x)`, not `acos(x)`"},
     [](double, const Vec3d& d) { return std::acos(d.x) / (2 * pi); }},
    {{"one column: u was cut to a whole number", "divide and multiply floating-point numbers"},
     [](double angle, const Vec3d&) { return std::trunc(angle / (2 * pi) + 0.5); }},
    {{"u is the angle in radians: it was not divided by 2 pi", right_u},
     [](double angle, const Vec3d&) { return angle; }},
    {{"u is the angle in degrees", right_u},
     [](double angle, const Vec3d&) { return angle * 180 / pi; }},
    {{"u is too large: the angle was divided by 2 and multiplied by pi", right_u},
     [](double angle, const Vec3d&) { return angle / 2 * pi + 0.5; }},
    {{"u is an angle about another axis: atan2 took y", right_u},
     [](double, const Vec3d& d) { return std::atan2(-d.y, d.x) / (2 * pi) + 0.5; }},
    {{"the map is projected flat: u was taken from x, without the angle", right_u},
     [](double, const Vec3d& d) { return (d.x + 1) / 2; }},
    {{"u is negative on one half: the 1/2 is missing", right_u},
     [](double angle, const Vec3d&) { return std::abs(angle) / (2 * pi); }},
};

inline constexpr const char* right_v = "`v = acos(-y) / pi`";
inline constexpr const char* right_asin = "`asin(y) / pi + 0.5`";
inline constexpr VForm of_v[] = {
    {{}, [](double v, double) { return v; }},
    {{"squeezed at the poles: v was taken from the height, without the angle", ""},
     [](double, double y) { return (y + 1) / 2; }},
    {{"v covers half of the map: it was divided by 2 pi and not by pi", right_v},
     [](double v, double) { return v / 2; }},
    {{"v reaches 2: it was divided by pi / 2 and not by pi", right_v},
     [](double v, double) { return v * 2; }},
    {{"the south is one row: asin is negative there, and the 1/2 is missing", right_asin},
     [](double v, double) { return v - 0.5; }},
    {{"v covers the middle of the map: asin was divided by 2 pi", right_asin},
     [](double v, double) { return v / 2 + 0.25; }},
    {{"v is the angle in radians: it was not divided by pi", right_v},
     [](double v, double) { return v * pi; }},
    {{"v is the angle in degrees", right_v}, [](double v, double) { return v * 180; }},
    {{"one row: v was cut to a whole number", "divide and multiply floating-point numbers"},
     [](double, double) { return 0.0; }},
};

/// The column and the row from the bottom, before they are limited to the image.
inline Uv<double> texel_at(const Uv<double>& uv, double columns, double rows) {
  return {std::floor(uv.u * columns), std::floor(uv.v * rows)};
}
inline constexpr const char* squeezed = "squeezed: (int)((n - 1) u) in place of floor(n u)";
inline constexpr Texel of_texel[] = {
    {{}, texel_at},
    {{"half a texel off: u n was rounded and not cut off", ""},
     [](const Uv<double>& uv, double columns, double rows) -> Uv<double> {
       return {std::round(uv.u * columns), std::round(uv.v * rows)};
     }},
    {{"half a texel off: u n was rounded and not cut off, v n was", ""},
     [](const Uv<double>& uv, double columns, double rows) -> Uv<double> {
       return {std::round(uv.u * columns), std::floor(uv.v * rows)};
     }},
    {{"half a texel off: v n was rounded and not cut off, u n was", ""},
     [](const Uv<double>& uv, double columns, double rows) -> Uv<double> {
       return {std::floor(uv.u * columns), std::round(uv.v * rows)};
     }},
    {{squeezed, "`floor(u * n)`, at most n - 1"},
     [](const Uv<double>& uv, double columns, double rows) {
       return texel_at(uv, columns - 1, rows - 1);
     }},
    {{squeezed, "`floor(u * n)`, at most n - 1"},  // with rows from the top
     [](const Uv<double>& uv, double columns, double rows) -> Uv<double> {
       return {uv.u * (columns - 1), rows - 1 - std::floor((1 - uv.v) * (rows - 1))};
     }},
    {{"u and v are exchanged", "columns by u, rows by v"},
     [](const Uv<double>& uv, double columns, double rows) {
       return texel_at({uv.v, uv.u}, columns, rows);
     }},
    {{"columns were counted by the height, and rows by the width", "`u * width`, `v * height`"},
     [](const Uv<double>& uv, double columns, double rows) -> Uv<double> {
       return {std::floor(uv.u * rows), std::floor(uv.v * columns)};
     }},
    {{"half of the map is spread over the globe: u only reaches 1/2", right_u},
     [](const Uv<double>& uv, double columns, double rows) {
       return texel_at({uv.u / 2, uv.v}, columns, rows);
     }},
    {{"tiled: u and v are multiplied, or divided by too little", "u and v from 0 to 1"},
     [](const Uv<double>& uv, double columns, double rows) {
       const auto part = [](double x) { return 2 * x - std::floor(2 * x); };
       return texel_at({part(uv.u), part(uv.v)}, columns, rows);
     }},
};

inline Rgb color_of(const Rgb8& p) { return {p.r / 255.0, p.g / 255.0, p.b / 255.0}; }
inline Rgb texel_color(const Image& image, const Spot& at) {
  return color_of(image.at(at.column, at.row));
}

/// The color of three bytes of the file in memory; not a number where one lies beyond its end.
inline Rgb bytes_at(const Image& image, std::size_t red, std::size_t green, std::size_t blue) {
  const auto channel = [&](std::size_t at) {
    if (at >= 3 * image.pixels.size()) return std::numeric_limits<double>::quiet_NaN();
    const Rgb8& p = image.pixels[at / 3];
    return (at % 3 == 0 ? p.r : at % 3 == 1 ? p.g : p.b) / 255.0;
  };
  return {channel(red), channel(green), channel(blue)};
}
/// The number of a texel where rows are so wide.
inline std::size_t number_of(const Spot& at, int width) {
  return static_cast<std::size_t>(at.row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(at.column);
}
template <class Change>
Rgb each(const Rgb& c, const Change& change) {
  return {change(c.r), change(c.g), change(c.b)};
}
inline Rgb bgr(const Rgb& c) { return {c.b, c.g, c.r}; }
inline Rgb gbr(const Rgb& c) { return {c.g, c.b, c.r}; }
inline Rgb brg(const Rgb& c) { return {c.b, c.r, c.g}; }

inline constexpr const char* in_order = "red, green, blue";
inline constexpr const char* in_three = "`(row * width + column) * channels`";
inline constexpr Reading of_reading[] = {
    {{}, texel_color},
    {{"four channels were read as three: each texel has an alpha, too",
      "the number of channels that the file has, or ask stbi_load for 3"},
     [](const Image& image, const Spot& at) {
       const std::size_t first = 3 * number_of(at, image.width);
       const auto of_four = [&](std::size_t i) {
         return i % 4 == 3 ? 1.0 : bytes_at(image, i / 4 * 3 + i % 4, first, first).r;
       };
       return Rgb{of_four(first), of_four(first + 1), of_four(first + 2)};
     }},
    {{"each texel begins a byte after the last: the index was not multiplied by 3", in_three},
     [](const Image& image, const Spot& at) {
       const std::size_t first = number_of(at, image.width);
       return bytes_at(image, first, first + 1, first + 2);
     }},
    {{"three channels were read as four", "the number of channels that stbi_load was asked for"},
     [](const Image& image, const Spot& at) {
       const std::size_t first = 4 * number_of(at, image.width);
       return bytes_at(image, first, first + 1, first + 2);
     }},
    {{"a row begins after the picture's height of texels, not after its width", in_three},
     [](const Image& image, const Spot& at) {
       const std::size_t first = 3 * number_of(at, image.height);
       return bytes_at(image, first, first + 1, first + 2);
     }},
    {{"red and blue are exchanged in the texture", "red is the first byte"},
     [](const Image& image, const Spot& at) { return bgr(texel_color(image, at)); }},
    {{"the channels of the texture are in the wrong order: green, blue, red", in_order},
     [](const Image& image, const Spot& at) { return gbr(texel_color(image, at)); }},
    {{"the channels of the texture are in the wrong order: blue, red, green", in_order},
     [](const Image& image, const Spot& at) { return brg(texel_color(image, at)); }},
    {{"gray: one channel of the texture was taken for all three", "each channel its own byte"},
     [](const Image& image, const Spot& at) { return gray(texel_color(image, at).r); }},
    {{"bytes from 128 on are negative: they were read as signed", "`unsigned char`"},
     [](const Image& image, const Spot& at) {
       return each(texel_color(image, at),
                   [](double x) { return x > 127.5 / 255 ? x - 256 / 255.0 : x; });
     }},
    {{"the texture is too dark: its bytes were decoded and never encoded again", ""},
     [](const Image& image, const Spot& at) {
       return each(texel_color(image, at), srgb_decode<double>);
     }},
    {{"the texture is too pale: its bytes were encoded twice", ""},
     [](const Image& image, const Spot& at) {
       return each(texel_color(image, at), srgb_encode<double>);
     }},
    {{"black texture: the file was not loaded, and the program did not check", ""},
     [](const Image&, const Spot&) { return Rgb{}; }},
    {{"the texture is twice as bright: bytes were divided by 128", "`byte / 255.0`"},
     [](const Image& image, const Spot& at) { return texel_color(image, at) * (255.0 / 128); }},
    {{"bytes were divided as whole numbers: only 255 is not 0", "`byte / 255.0`"},
     [](const Image& image, const Spot& at) {
       return each(texel_color(image, at), [](double x) { return std::floor(x); });
     }},
    {{"white texture: it is missing", "the texel in place of white"},
     [](const Image&, const Spot&) {
       return Rgb{1, 1, 1};
     }},
    {{"(u, v) as colors: the picture of an earlier step", "the texel at (u, v)"},
     [](const Image&, const Spot& at) {
       return Rgb{at.uv.u, at.uv.v, 0};
     }},
};

inline bool is_odd(double x) { return x - 2 * std::floor(x / 2) != 0; }
inline bool is_odd_square(double u, double v) { return is_odd(std::floor(u) + std::floor(v)); }
inline constexpr const char* ten = "`floor(10 * u)`";
inline constexpr const char* both_floors = "`floor(10 u) + floor(10 v)`";
inline constexpr IsOdd of_squares[] = {
    {{}, is_odd_square},
    {{"every square has the other color: the two colors, or an odd number in the sum",
      "`(floor(10 u) + floor(10 v)) % 2 == 0` is the first color"},
     [](double u, double v) { return !is_odd_square(u, v); }},
    {{"half as many squares: 5 for 10, or u and v only reach 1/2", "`floor(10 * u)`"},
     [](double u, double v) { return is_odd_square(u / 2, v / 2); }},
    {{"twice as many squares: 20 for 10, or u and v reach 2", "`floor(10 * u)`"},
     [](double u, double v) { return is_odd_square(u * 2, v * 2); }},
    {{"stripes from pole to pole: v is not used", both_floors},
     [](double u, double) { return is_odd(std::floor(u)); }},
    {{"stripes around: u is not used", both_floors},
     [](double, double v) { return is_odd(std::floor(v)); }},
    {{"slanted stripes: the sum was cut off, and not u and v", both_floors},
     [](double u, double v) { return is_odd(std::floor(u + v)); }},
    {{"three of four squares are alike: the product of column and row, and not their sum",
      both_floors},
     [](double u, double v) { return is_odd(std::floor(u) * std::floor(v)); }},
    {{"half as many squares in v", "10 in u and in v"},
     [](double u, double v) { return is_odd_square(u, v / 2); }},
    {{"half as many squares in u", "10 in u and in v"},
     [](double u, double v) { return is_odd_square(u / 2, v); }},
    {{"one color: the sum is always even, as of a column with itself", both_floors},
     [](double, double) { return false; }},
    {{"4 squares and not 10", ten},
     [](double u, double v) { return is_odd_square(u * 0.4, v * 0.4); }},
    {{"6 squares and not 10", ten},
     [](double u, double v) { return is_odd_square(u * 0.6, v * 0.6); }},
    {{"8 squares and not 10", ten},
     [](double u, double v) { return is_odd_square(u * 0.8, v * 0.8); }},
    {{"12 squares and not 10", ten},
     [](double u, double v) { return is_odd_square(u * 1.2, v * 1.2); }},
    {{"16 squares and not 10", ten},
     [](double u, double v) { return is_odd_square(u * 1.6, v * 1.6); }},
    {{"squares by sine: it changes its sign at each pi, and not at each 1", "`sin(pi * 10 * u)`"},
     [](double u, double v) { return std::sin(u) * std::sin(v) < 0; }},
    {{"squares are moved by half: their numbers were rounded", "`floor`, not `round`"},
     [](double u, double v) { return is_odd(std::round(u) + std::round(v)); }},
};

inline constexpr Named of_shadows[] = {{}, {"without shadows: no ray goes to the lamp", ""}};

inline constexpr const char* right_sky = "`(y + 1) / 2` of the ray's direction of length 1";
inline constexpr SkyForm of_sky[] = {
    {{}, [](double y, double) { return (y + 1) / 2; }},
    {{"the sky's colors lie too high: y was taken for (y + 1) / 2", right_sky},
     [](double y, double) { return std::max(y, 0.0); }},
    {{"the sky is blue above and below: y lost its sign", right_sky},
     [](double y, double) { return std::abs(y); }},
    {{"the sky is mixed by the picture's row, and not by the ray", right_sky},
     [](double, double down) { return 1 - down; }},
    {{"the sky is mixed by the picture's row, and not by the ray", right_sky},
     [](double, double down) { return down; }},
};

inline Rgb8 bytes_of_color(const Rgb& c) { return {byte_of(c.r), byte_of(c.g), byte_of(c.b)}; }
inline double limited(double x) { return std::clamp(x, 0.0, 1.0); }
/// Channels outside of 0 to 1 as bytes that begin again.
inline Rgb8 wrapped(const Rgb& c) {
  const auto byte = [](double x) {
    return static_cast<std::uint8_t>(static_cast<long>(std::abs(x) < 1e6 ? 255 * x : 0));
  };
  return {byte(c.r), byte(c.g), byte(c.b)};
}
inline constexpr Bytes of_bytes[] = {
    {{}, bytes_of_color},
    {{"too dark: light was written without the curve of image files", ""},
     [](const Rgb& c) { return bytes_of_color(each(each(c, limited), srgb_decode<double>)); }},
    {{"too pale: the curve of image files was applied once too often", ""},
     [](const Rgb& c) { return bytes_of_color(each(each(c, limited), srgb_encode<double>)); }},
    {{"too pale: the power 1/2.2 of image files was applied once too often", ""},
     [](const Rgb& c) {
       return bytes_of_color(each(c, [](double x) { return std::pow(limited(x), 1 / 2.2); }));
     }},
    {{"too pale: the square root was applied once too often", ""},
     [](const Rgb& c) {
       return bytes_of_color(each(c, [](double x) { return std::sqrt(limited(x)); }));
     }},
    {{"too dark: light was written without the curve of image files, or its power 2.2 was taken",
      ""},
     [](const Rgb& c) {
       return bytes_of_color(each(c, [](double x) { return std::pow(limited(x), 2.2); }));
     }},
    {{"stained: channels above 1 begin at 0 again, since a byte overflows",
      "`clamp(channel, 0, 1)` before it becomes a byte"},
     wrapped},
    {{"stained: 256 times a channel of 1 is a byte of 0", "`255 * channel`"},
     [](const Rgb& c) {
       const auto byte = [](double x) { return static_cast<std::uint8_t>(long(256 * limited(x))); };
       return Rgb8{byte(c.r), byte(c.g), byte(c.b)};
     }},
    {{"red and blue are exchanged in the whole picture", "red is the first byte"},
     [](const Rgb& c) { return bytes_of_color(bgr(c)); }},
    {{"the channels of the whole picture are in the wrong order: green, blue, red", in_order},
     [](const Rgb& c) { return bytes_of_color(gbr(c)); }},
    {{"the channels of the whole picture are in the wrong order: blue, red, green", in_order},
     [](const Rgb& c) { return bytes_of_color(brg(c)); }},
    {{"black: nothing was drawn", "the color of each ray in its pixel"},
     [](const Rgb&) { return Rgb8{}; }},
    {{"white: every channel of every pixel is 255", "`byte / 255.0` or `255 * channel`, once"},
     [](const Rgb&) {
       return Rgb8{255, 255, 255};
     }},
    {{"inverted: each channel is 255 minus what it should be", "`255 * channel`"},
     [](const Rgb& c) {
       const auto inverse = [](double x) { return static_cast<std::uint8_t>(255 - byte_of(x)); };
       return Rgb8{inverse(c.r), inverse(c.g), inverse(c.b)};
     }},
};

inline constexpr Named of_flip[] = {
    {},
    {"the whole picture is mirrored: columns run the other way", "columns from the left"},
    {"the whole picture is upside down: rows run the other way", "rows from the top"},
    {"the whole picture is turned by half: columns and rows run the other way",
     "from the top left"},
};

}  // namespace texmap::slips
