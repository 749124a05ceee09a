// Which slips drew a picture.
#include "slips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/compare/difference.hpp"
#include "engine/files/text.hpp"
#include "math/srgb.hpp"

namespace texmap::slips {
namespace {

constexpr double pi = std::numbers::pi;

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
constexpr int places = flip + 1;

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
constexpr const char* about_y = "turned about a horizontal axis: y must stay as it is";
constexpr const char* keep_y = "`{x * cos + z * sin, y, z * cos - x * sin}`";
constexpr const char* light_turned =
    "light and shade turned with the globe: the normal was rotated for the light, too";
constexpr const char* own_normal = "the light takes the normal as it is";
constexpr const char* overwritten =
    "skewed: a coordinate was overwritten before the other was computed from it";
constexpr Named of_turned[] = {
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
constexpr Named of_pole[] = {
    {},
    {"the poles lie on the x axis: x and y are exchanged", "y is the axis: `v = acos(-y) / pi`"},
    {"the poles lie on the z axis: z and y are exchanged", "y is the axis: `v = acos(-y) / pi`"},
};
constexpr Named of_mirrored[] = {{}, {"mirrored: u runs the other way", ""}};
constexpr Named of_upside[] = {{}, {"upside down: v runs the other way", ""}};

constexpr const char* right_u = "`atan2(-z, x) / (2 * pi) + 0.5`";
constexpr UForm of_u[] = {
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

constexpr const char* right_v = "`v = acos(-y) / pi`";
constexpr const char* right_asin = "`asin(y) / pi + 0.5`";
constexpr VForm of_v[] = {
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
Uv<double> texel_at(const Uv<double>& uv, double columns, double rows) {
  return {std::floor(uv.u * columns), std::floor(uv.v * rows)};
}
constexpr const char* squeezed = "squeezed: (int)((n - 1) u) in place of floor(n u)";
constexpr Texel of_texel[] = {
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

Rgb color_of(const Rgb8& p) { return {p.r / 255.0, p.g / 255.0, p.b / 255.0}; }
Rgb texel_color(const Image& image, const Spot& at) {
  return color_of(image.at(at.column, at.row));
}

/// The color of three bytes of the file in memory; not a number where one lies beyond its end.
Rgb bytes_at(const Image& image, std::size_t red, std::size_t green, std::size_t blue) {
  const auto channel = [&](std::size_t at) {
    if (at >= 3 * image.pixels.size()) return std::numeric_limits<double>::quiet_NaN();
    const Rgb8& p = image.pixels[at / 3];
    return (at % 3 == 0 ? p.r : at % 3 == 1 ? p.g : p.b) / 255.0;
  };
  return {channel(red), channel(green), channel(blue)};
}
/// The number of a texel where rows are so wide.
std::size_t number_of(const Spot& at, int width) {
  return static_cast<std::size_t>(at.row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(at.column);
}
template <class Change>
Rgb each(const Rgb& c, const Change& change) {
  return {change(c.r), change(c.g), change(c.b)};
}

constexpr const char* in_order = "red, green, blue";
constexpr const char* in_three = "`(row * width + column) * channels`";
constexpr Reading of_reading[] = {
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
     [](const Image& image, const Spot& at) {
       const Rgb c = texel_color(image, at);
       return Rgb{c.b, c.g, c.r};
     }},
    {{"the channels of the texture are in the wrong order: green, blue, red", in_order},
     [](const Image& image, const Spot& at) {
       const Rgb c = texel_color(image, at);
       return Rgb{c.g, c.b, c.r};
     }},
    {{"the channels of the texture are in the wrong order: blue, red, green", in_order},
     [](const Image& image, const Spot& at) {
       const Rgb c = texel_color(image, at);
       return Rgb{c.b, c.r, c.g};
     }},
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

bool is_odd(double x) { return x - 2 * std::floor(x / 2) != 0; }
bool is_odd_square(double u, double v) { return is_odd(std::floor(u) + std::floor(v)); }
constexpr const char* ten = "`floor(10 * u)`";
constexpr const char* both_floors = "`floor(10 u) + floor(10 v)`";
constexpr IsOdd of_squares[] = {
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

constexpr Named of_shadows[] = {{}, {"without shadows: no ray goes to the lamp", ""}};

constexpr const char* right_sky = "`(y + 1) / 2` of the ray's direction of length 1";
constexpr SkyForm of_sky[] = {
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

Rgb8 bytes_of_color(const Rgb& c) { return {byte_of(c.r), byte_of(c.g), byte_of(c.b)}; }
double limited(double x) { return std::clamp(x, 0.0, 1.0); }
/// Channels outside of 0 to 1 as bytes that begin again.
Rgb8 wrapped(const Rgb& c) {
  const auto byte = [](double x) {
    return static_cast<std::uint8_t>(static_cast<long>(std::abs(x) < 1e6 ? 255 * x : 0));
  };
  return {byte(c.r), byte(c.g), byte(c.b)};
}
constexpr Bytes of_bytes[] = {
    {{}, bytes_of_color},
    {{"too dark: light was written without the curve of image files", ""},
     [](const Rgb& c) {
       return bytes_of_color(each(c, [](double x) { return srgb_decode(limited(x)); }));
     }},
    {{"too pale: the curve of image files was applied once too often", ""},
     [](const Rgb& c) {
       return bytes_of_color(each(c, [](double x) { return srgb_encode(limited(x)); }));
     }},
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
     [](const Rgb& c) {
       return bytes_of_color({c.b, c.g, c.r});
     }},
    {{"the channels of the whole picture are in the wrong order: green, blue, red", in_order},
     [](const Rgb& c) {
       return bytes_of_color({c.g, c.b, c.r});
     }},
    {{"the channels of the whole picture are in the wrong order: blue, red, green", in_order},
     [](const Rgb& c) {
       return bytes_of_color({c.b, c.r, c.g});
     }},
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

constexpr Named of_flip[] = {
    {},
    {"the whole picture is mirrored: columns run the other way", "columns from the left"},
    {"the whole picture is upside down: rows run the other way", "rows from the top"},
    {"the whole picture is turned by half: columns and rows run the other way",
     "from the top left"},
};

constexpr const char* without_highlight =
    "without a highlight: its factor is 0, the direction to the eye or the reflected light has the "
    "wrong sign, or the 2 is missing";

/// All light slips of a stage; the first stands for none.
std::vector<const mistakes::LightMistake*> light_slips(const StageView& stage) {
  std::vector<const mistakes::LightMistake*> all{nullptr};
  for (const auto& one : mistakes::of_light) all.push_back(&one);
  const bool shines = std::ranges::any_of(
      stage.pixels, [](const Seen& seen) { return seen.lit && seen.lit->material.specular > 0; });
  if (shines) {
    for (const auto& one : mistakes::of_highlight) all.push_back(&one);
  }
  return all;
}

enum class Fit { nothing, factors, exponent, blend };  // of the light, to the picture

/// Which row of each table, 0 for right; `degrees` is an angle, and `light` a row of light_slips.
struct Way {
  std::array<int, places> row{};
  bool on_squares = true;                   ///< whether the slips of (u, v) reach the checkerboards
  std::optional<PhongMaterial> material{};  ///< in place of the lesson's, as the picture has it
  std::optional<double> blend{};            ///< of the globe's texture with its light
};

Vec3d axes_of(const Way& way, const Vec3d& d) {
  Vec3d p = way.row[pole] == 1   ? Vec3d{d.z, d.x, d.y}
            : way.row[pole] == 2 ? Vec3d{d.y, d.z, d.x}
                                 : d;
  if (way.row[degrees] != 0) p = rotation_y(way.row[degrees])(p);
  if (way.row[mirrored] != 0) p.z = -p.z;
  if (way.row[upside] != 0) p.y = -p.y;
  return p;
}

template <class Table>
std::vector<Named> names_of(const Table& table) {
  return {std::begin(table), std::end(table)};
}

bool alike(const Rgb8& a, const Rgb8& b, int tolerance = of_rounding) {
  return channel_difference(a, b) <= tolerance;
}

/// A direction with its coordinates exchanged in a ring: y is then another axis.
constexpr Vec3d next_axes(const Vec3d& d) { return {d.y, d.z, d.x}; }
/// The direction on the globe, turned as a wrong program does.
///
/// @param turned  as it should be
Vec3d turned_by(int way, const RotationY& turn, const Vec3d& turned) {
  const RotationY back{turn.cosine, -turn.sine};
  const Vec3d own = back(turned);
  switch (way) {
    case not_turned:
      return own;
    case other_way:
      return back(own);
    case twice:
      return turn(turned);
    case about_x:
    case about_x_back:
      return next_axes((way == about_x ? turn : back)(next_axes(next_axes(own))));
    case about_z:
    case about_z_back:
      return next_axes(next_axes((way == about_z ? turn : back)(next_axes(own))));
    case x_overwritten: {
      const double x = turn(own).x;
      return {x, own.y, turn(Vec3d{x, own.y, own.z}).z};
    }
    case z_overwritten: {
      const double z = turn(own).z;
      return {turn(Vec3d{own.x, own.y, z}).x, own.y, z};
    }
    default:
      return turned;
  }
}

/// The search for a picture's slips.
class Search {
 public:
  /// @param right  the stage as it should be, if `stage` is another
  Search(const Image& drawn, const StageView& stage, const StageView& right)
      : drawn_(drawn), stage_(stage), lights_(light_slips(stage)) {
    names_[degrees].resize(4);
    for (const auto* one : lights_) names_[light].push_back({one == nullptr ? "" : one->words, ""});
    const auto leave_out = [&](int first, int end) {
      for (int place = first; place < end; ++place)
        names_[static_cast<std::size_t>(place)].resize(1);
    };
    if (stage.picture.pixels.empty()) leave_out(texel, squares);
    if (std::ranges::none_of(stage.pixels, [](const Seen& seen) { return seen.lit.has_value(); }))
      leave_out(0, bytes);
    for (const Seen& seen : right.pixels) {
      right_.push_back(bytes_of_color(seen.color));
      if (seen.lit && shining_.specular == 0) shining_ = seen.lit->material;
    }
    // What tells slips apart best is what is not right.
    std::vector<std::size_t> wrong, all;
    std::size_t shining = 0;
    for (std::size_t i = 0; i < stage.pixels.size(); ++i) {
      if (stage.pixels[i].shines && shining++ % 8 == 0) probes_of_highlight_.push_back(i);
      all.push_back(i);
      ++seen_of_[number_of_object(stage.pixels[i])];
      if (!fits(right_[i], at(Way{}, stage.pixels[i]))) wrong.push_back(i);
    }
    different_ = static_cast<long>(wrong.size());
    for (const std::vector<std::size_t>* from : {&wrong, &all}) {
      for (std::size_t k = 0; k < 100 && !from->empty(); ++k)
        probes_.push_back((*from)[(k * 7919) % from->size()]);
    }
    // So that a wrong way is given up soon, both kinds take turns.
    for (std::size_t k = 0; k + 100 < probes_.size() && k < 100; k += 2)
      std::swap(probes_[k], probes_[k + 100]);
  }

  /// All ways with so many slips that explain the picture.
  [[nodiscard]] std::vector<Way> ways(int slips) const {
    std::vector<Way> found;
    const long limit = colors_ + (slips < 3 ? 20'000'000 : 3'000'000);  // about a second
    Fit fit = Fit::nothing;
    const std::function<void(Way&, int, int)> choose = [&](Way& way, int place, int left) {
      if (left == 0 || place == places || colors_ > limit) {
        if (left == 0) try_way(way, found, fit);
        return;
      }
      for (int row = 0; row < rows(place); ++row) {
        const bool is_turn = place == turned && row >= not_turned && row < from_origin;
        if (is_turn && stage_.turn.sine == 0) continue;  // nothing is turned
        way.row[static_cast<std::size_t>(place)] = place == degrees ? 90 * row : row;
        choose(way, place + 1, left - (row == 0 ? 0 : 1));
      }
      way.row[static_cast<std::size_t>(place)] = 0;
    };
    Way way;
    choose(way, 0, slips);
    const auto explains_all = [&](const Way& one) {
      return explained(one) * 1000 >= different_ * 999;
    };
    if (slips == 0 || std::ranges::any_of(found, explains_all)) return found;
    for (const Fit each : {Fit::factors, Fit::exponent, Fit::blend}) {
      fit = each;
      if (each == Fit::factors || shining_.specular > 0) choose(way, 0, slips - 1);
    }
    return found;
  }

  /// How far a way is from the picture, at few pixels.
  [[nodiscard]] int distance(const Way& way) const {
    int sum = 0;
    for (const auto* probes : {&probes_, &probes_of_highlight_}) {
      for (const std::size_t i : *probes)
        sum += channel_difference(color(way, stage_.pixels[i]), at(way, stage_.pixels[i]));
    }
    return sum;
  }
  /// The twentieths of texture in a blend with which a way is nearest to the picture.
  [[nodiscard]] double with_blend(Way way) const {
    const auto distance_at = [&](int twentieths) {
      way.blend = twentieths / 20.0;
      return distance(way);
    };
    std::array<int, 21> blends{};
    std::iota(blends.begin(), blends.end(), 0);
    return *std::ranges::min_element(blends, {}, distance_at) / 20.0;
  }

  /// The whole exponent of the highlight with which a way is nearest to the picture.
  [[nodiscard]] PhongMaterial with_exponent(Way way) const {
    PhongMaterial material = shining_;
    const auto distance_at = [&](double exponent) {
      material.shininess = exponent;
      way.material = material;
      return distance(way);
    };
    std::vector<double> exponents{128, 150, 200, 256, 300, 500, 1000};
    for (int i = 1; i <= 100; ++i) exponents.push_back(i);
    material.shininess = *std::ranges::min_element(exponents, {}, distance_at);
    return material;
  }

  /// The ambient, diffuse and specular, in hundredths, with which a way is nearest to the picture:
  /// least squares over what is neither black nor white.
  [[nodiscard]] PhongMaterial fitted(Way way) const {
    std::array<std::array<double, 4>, 3> sums{};  // the normal equations
    for (std::size_t k = 0; k < probes_.size() + stage_.pixels.size() / 97; ++k) {
      const Seen& seen = stage_.pixels[k < probes_.size() ? probes_[k] : (k - probes_.size()) * 97];
      if (!seen.lit) continue;
      std::array<Rgb, 3> part;
      for (const std::size_t j : {0U, 1U, 2U}) {
        way.material = {{j == 0 ? 1.0 : 0, j == 1 ? 1.0 : 0}, j == 2 ? 1.0 : 0, shining_.shininess};
        part[j] = light_of(way, seen);
      }
      if (std::isnan(part[0].r + part[1].r)) continue;
      const Rgb8 is = at(way, seen);
      const auto add = [&](double Rgb::*channel, int byte) {
        if (byte < 2 || byte > 253) return;
        for (std::size_t j = 0; j < 3; ++j) {
          for (std::size_t l = 0; l < 3; ++l) sums[j][l] += part[j].*channel * (part[l].*channel);
          sums[j][3] += part[j].*channel * (byte + 0.5) / 255;
        }
      };
      add(&Rgb::r, is.r), add(&Rgb::g, is.g), add(&Rgb::b, is.b);
    }
    std::array<double, 3> best{};
    for (std::size_t round = 0; round < 600; ++round) {  // Gauss and Seidel
      const std::size_t j = round % 3, k = (j + 1) % 3, l = (j + 2) % 3;
      best[j] = (sums[j][3] - sums[j][k] * best[k] - sums[j][l] * best[l]) / (sums[j][j] + 1e-6);
    }
    const auto rounded = [](double x) { return std::round(100 * x) / 100; };
    return {{rounded(best[0]), rounded(best[1])}, rounded(best[2]), shining_.shininess};
  }

  /// Bytes of 255 hide a part of the light: the factors may then be off by some hundredths.
  static PhongMaterial in_tenths(PhongMaterial material) {
    for (double* factor :
         {&material.lambertian.ambient, &material.lambertian.diffuse, &material.specular})
      *factor = std::round(10 * *factor) / 10;
    return material;
  }

  /// What a fitted material has otherwise than the lesson.
  [[nodiscard]] Slip slip(const PhongMaterial& is) const {
    if (is.lambertian.diffuse < 0.005) {
      return {"no light of the lamp arrives: its factor is 0, or the lamp lies below the ground",
              "`lamp = (5, 5, 5)`, with y upward"};
    }
    if (shining_.specular > 0 && is.specular < 0.005) {
      return {without_highlight, "from the point to the eye"};
    }
    std::string words;
    const auto say = [&](const char* what, double now, double should) {
      if (std::abs(now - should) < 0.005) return;
      words += (words.empty() ? "" : ", ") + text("%s is %.4g and not %.4g", what, now, should);
    };
    say("the ambient light", is.lambertian.ambient, shining_.lambertian.ambient);
    say("the factor of the lamp's light", is.lambertian.diffuse, shining_.lambertian.diffuse);
    say("the factor of the highlight", is.specular, shining_.specular);
    if (shining_.specular > 0) say("the highlight's exponent", is.shininess, shining_.shininess);
    return {words, ""};
  }

  /// The same for a globe that is turned by any whole number of degrees.
  [[nodiscard]] std::vector<Way> turned_ways() const {
    std::vector<Way> found;
    Way way;
    for (way.row[upside] = 0; way.row[upside] < 2; ++way.row[upside]) {
      for (way.row[mirrored] = 0; way.row[mirrored] < 2; ++way.row[mirrored]) {
        for (way.row[degrees] = 1; way.row[degrees] < 360; ++way.row[degrees]) try_way(way, found);
      }
    }
    return found;
  }

  /// Pixels that are not the right picture's.
  [[nodiscard]] long different() const { return different_; }
  /// How many of these a way explains. It is -1 if more than 2 % of an object stay unexplained, or
  /// if more than 40 % of these pixels are unknown.
  [[nodiscard]] long explained(const Way& way) const {
    long sum = 0, unknown = 0;
    auto left = seen_of_;
    for (std::size_t k = 0; k < right_.size(); ++k) {
      const std::size_t i = k * 7919 % right_.size();  // all, the objects mixed
      const Seen& seen = stage_.pixels[i];
      const Fits fits_here = fits_at(way, seen);
      if (fits_here == Fits::no && (left[number_of_object(seen)] -= 50) < 0) return -1;
      if (fits(right_[i], at({}, seen))) continue;
      sum += fits_here == Fits::no ? 0 : 1;
      unknown += fits_here == Fits::unknown ? 1 : 0;
    }
    return unknown * 10 > different_ * 4 ? -1 : sum;
  }

  [[nodiscard]] Rgb8 color(const Way& way, const Seen& seen) const {
    return of_bytes[way.row[bytes]].calculate(light_of(way, seen));
  }
  [[nodiscard]] Rgb light_of(const Way& way, const Seen& seen) const {
    ++colors_;
    const auto& row = way.row;
    if (!seen.lit && row[sky] == 0) return seen.color;
    if (!seen.lit)
      return mix(stage_.sky.below, stage_.sky.above,
                 of_sky[row[sky]].calculate(seen.height, seen.row / (stage_.height - 1.0)));
    mistakes::Lit lit = *seen.lit;
    if (way.material) {
      const bool shines = lit.material.specular > 0;
      lit.material = *way.material;
      if (!shines) lit.material.specular = 0;
    }
    if (row[turned] == inward) {  // the far side is then in the shadow of its own sphere
      lit.normal = -lit.normal;
      lit.light.cosine = 0;
    }
    const bool with_shadow = row[turned] == with_light_and_shadow;  // of its own sphere, too
    if ((row[turned] == with_light || with_shadow) && seen.mapped && !seen.on_checkers) {
      const bool is_hidden = lit.light.cosine == 0 && (with_shadow || lit.cosine() > 0);
      lit.normal = stage_.turn(lit.normal);
      lit.light.cosine = is_hidden ? 0 : std::max(lit.cosine(), 0.0);
    }
    if (row[turned] == undivided) {
      lit.normal = lit.normal * seen.radius;
      lit.light.cosine *= seen.radius;
    }
    if (row[shadows] != 0) lit.light.cosine = std::max(lit.cosine(), 0.0);
    if (seen.mapped) {
      Vec3d d = seen.direction;
      const bool reached = !seen.on_checkers || way.on_squares;
      if (!seen.on_checkers) d = turned_by(row[turned], stage_.turn, d);
      if (reached && row[turned] == from_origin) d = normalize(lit.lamp - lit.to_lamp);
      if (reached && row[turned] == from_point) d = lit.lamp - lit.to_lamp;
      if (reached && row[turned] == inward) d = -d;
      if (reached && row[turned] >= undivided) d.y *= seen.radius;
      if (reached) d = axes_of(way, d);
      const double angle = std::atan2(-d.z, d.x);
      const double v = std::acos(std::clamp(-d.y, -1.0, 1.0)) / pi;
      const Uv<double> uv{of_u[reached ? row[u_form] : 0].calculate(angle, d),
                          of_v[reached ? row[v_form] : 0].calculate(v, d.y)};
      lit.color = seen.on_checkers ? square(row[squares], uv) : in_picture(way, uv);
    }
    if (way.blend && lit.on_globe) {
      return mix(gray(clamp(lit.diffuse() + lit.specular(), 0.0, 1.0)), lit.color, *way.blend);
    }
    const auto* slip = lights_[static_cast<std::size_t>(row[light])];
    return slip == nullptr ? lit.right() : slip->shade(lit);
  }

  [[nodiscard]] Slip slip(int place, int row) const {
    if (place == degrees) {
      const std::string end = ": u begins at another place, or the globe is turned";
      if (row == 180) {
        return {"half a turn off: u begins on the other side, or the globe is turned",
                "`u + 0.5`, minus 1 from 1 on"};
      }
      if (row % 90 == 0) {  // what is drawn has another u by so much
        const double more = uv_rtiow(rotation_y(row)(Vec3d{1, 0, 0})).u - 0.5;
        return {"a quarter turn off" + end,
                more > 0 ? "`u = u - 0.25`, plus 1 below 0" : "`u = u + 0.25`, minus 1 from 1 on"};
      }
      return {text("turned by %d degrees", row) + end, ""};
    }
    const Named& named = names_[static_cast<std::size_t>(place)][static_cast<std::size_t>(row)];
    return {named.words, named.change};
  }

 private:
  [[nodiscard]] int rows(int place) const {
    return static_cast<int>(names_[static_cast<std::size_t>(place)].size());
  }
  /// Whether a way explains a pixel. Nobody knows what it draws by bytes beyond the texture's end.
  enum class Fits { no, yes, unknown };
  [[nodiscard]] Fits fits_at(const Way& way, const Seen& seen) const {
    const Rgb c = light_of(way, seen);
    const Rgb8 is = at(way, seen);
    if (std::isnan(c.r + c.g + c.b)) return Fits::unknown;
    if (fits(of_bytes[way.row[bytes]].calculate(c), is)) return Fits::yes;
    // Channels below 0 wrap around in a byte where they are not limited.
    const bool wraps = way.row[bytes] == 0 && std::min({c.r, c.g, c.b}) < 0;
    const auto at_most_1 = [](double x) { return std::min(x, 1.0); };
    return wraps && fits(wrapped(each(c, at_most_1)), is) ? Fits::yes : Fits::no;
  }
  [[nodiscard]] bool fits(const Rgb8& a, const Rgb8& b) const {
    return alike(a, b, stage_.tolerance);
  }
  [[nodiscard]] Rgb square(int row, const Uv<double>& uv) const {
    const Checkerboard& board = stage_.checkers;
    const bool odd = of_squares[row].calculate(uv.u * board.squares, uv.v * board.squares);
    return odd ? board.odd : board.even;
  }
  [[nodiscard]] Rgb in_picture(const Way& way, const Uv<double>& uv) const {
    const Image& image = stage_.picture;
    const Uv<double> from = of_texel[way.row[texel]].calculate(uv, image.width, image.height);
    const auto inside = [](double x, int n) {  // NaN gives 0
      return x > 0 ? static_cast<int>(std::min(x, n - 1.0)) : 0;
    };
    const Spot at{inside(from.u, image.width), image.height - 1 - inside(from.v, image.height), uv};
    return of_reading[way.row[reading]].calculate(image, at);
  }
  [[nodiscard]] Rgb8 at(const Way& way, const Seen& seen) const {
    const int form = way.row[flip];
    return drawn_.at(form % 2 == 1 ? drawn_.width - 1 - seen.column : seen.column,
                     form >= 2 ? drawn_.height - 1 - seen.row : seen.row);
  }
  /// Keeps a way that explains the probes and then the picture.
  void try_way(const Way& chosen, std::vector<Way>& found, Fit fit = Fit::nothing) const {
    if (fit != Fit::nothing && chosen.row[bytes] != 0) return;
    for (const bool on_squares : {true, false}) {
      Way way = chosen;
      way.on_squares = on_squares;
      const bool moves =
          std::any_of(way.row.begin(), way.row.begin() + texel, [](int r) { return r != 0; });
      if (!on_squares && (!moves || stage_.picture.pixels.empty())) return;
      if (fit == Fit::factors) {
        way.material = fitted(way);
        if (explains(way)) return found.push_back(way);
        way.material = in_tenths(*way.material);
      }
      if (fit == Fit::exponent) way.material = with_exponent(way);
      if (fit == Fit::blend) way.blend = with_blend(way);
      if (explains(way)) return found.push_back(way);
    }
  }
  [[nodiscard]] bool explains(const Way& way) const {
    double missed = 0, limit = 4;
    for (const std::size_t i : probes_) {
      missed += fits_at(way, stage_.pixels[i]) == Fits::no ? 1 : 0;
      limit += 0.12;
      if (missed > limit) return false;
    }
    return explained(way) * 10 >= different_ * 9;
  }

  static std::size_t number_of_object(const Seen& seen) {
    return seen.shines ? 7 : static_cast<std::size_t>(std::clamp(seen.object + 1, 0, 6));
  }

  const Image& drawn_;
  const StageView& stage_;
  std::vector<const mistakes::LightMistake*> lights_;
  PhongMaterial shining_;  ///< the lesson's, with a highlight if there is one
  std::array<std::vector<Named>, places> names_{
      // of each place's rows
      names_of(of_turned),  names_of(of_pole),    names_of(of_mirrored), {},
      names_of(of_upside),  names_of(of_u),       names_of(of_v),        names_of(of_texel),
      names_of(of_reading), names_of(of_squares), names_of(of_shadows),  {},
      names_of(of_sky),     names_of(of_bytes),   names_of(of_flip)};
  std::vector<Rgb8> right_;
  std::vector<std::size_t> probes_, probes_of_highlight_;
  std::array<long, 8> seen_of_{};  ///< pixels of each object, the sky's first, the highlight's last
  long different_ = 0;
  mutable long colors_ = 0;  ///< computed so far
};

/// By at least `least` slips, at most `most`, where `changed` was seen in place of the right one.
Explanation explain_changed(const Image& drawn, const StageView& right, const StageView& changed,
                            int least, int most) {
  Explanation result;
  const Search search(drawn, changed, right);
  result.different = search.different();
  // Too few tell no mistake from a damage.
  if (result.different * 3600 < static_cast<long>(right.pixels.size())) return result;
  std::vector<Way> ways;
  for (int slips = least; slips <= most && ways.empty(); ++slips) ways = search.ways(slips);
  if (ways.empty() && least == 1 && most == 2) ways = search.turned_ways();
  if (ways.empty()) return result;
  const auto explained = [&](const Way& way) { return search.explained(way); };
  // Of ways that explain as much, first those by the turn that the chapter adds.
  std::ranges::stable_sort(ways, std::greater<>(), [&](const Way& way) {
    return std::pair(explained(way), way.row[turned] != 0);
  });
  result.explained = explained(ways.front());
  const auto slips_of = [&](const Way& way) {
    std::vector<Slip> slips;
    for (int place = 0; place < places; ++place) {
      const int row = way.row[static_cast<std::size_t>(place)];
      if (place == upside && row != 0 && way.row[mirrored] != 0 && way.row[degrees] == 0) {
        slips.back() = {"turned by half: u and v run the other way", ""};
      } else if (row != 0) {
        slips.push_back(search.slip(place, row));
      }
      if (place == light && way.material) slips.push_back(search.slip(*way.material));
      if (place == light && way.blend) {
        slips.push_back({*way.blend == 0 ? "the globe's texture is missing: its light alone"
                         : *way.blend == 1
                             ? "the globe's light is missing: its texture alone"
                             : text("the globe's texture is blended with its light, %g parts of "
                                    "texture, though nobody asked for a blend",
                                    *way.blend),
                         ""});
      }
    }
    return slips;
  };
  result.slips = slips_of(ways.front());
  for (std::size_t i = 1; i < ways.size(); ++i) {
    if (explained(ways[i]) * 1000 < result.explained * 998) break;
    const std::string words = all_of(slips_of(ways[i]));
    const bool is_new = words != all_of(result.slips) &&
                        std::ranges::find(result.instead, words) == result.instead.end();
    if (is_new) result.instead.push_back(words);
  }
  return result;
}

}  // namespace

Explanation explain(const Image& drawn, const StageView& stage, int most) {
  return explain_changed(drawn, stage, stage, 1, most);
}

Explanation explain_by_view(const Image& drawn, const StageView& right, int more) {
  Explanation best;
  StageView few = right;
  std::erase_if(few.pixels, [](const Seen& seen) {
    return (seen.column - 1) % (10 * lattice) != 0 || (seen.row - 1) % (10 * lattice) != 0;
  });
  const auto try_one = [&](const Slip& slip, const auto& view) {
    // Drawing takes long here, so the search ends with the first that explains all.
    if (right.drawn_before && best.explained > 0 && best.explained * 1000 >= best.different * 999)
      return;
    if (explain_changed(drawn, few, view(10 * lattice), more, more).explained == 0) return;
    Explanation why = explain_changed(drawn, right, view(lattice), more, more);
    if (why.explained == 0) return;
    why.slips.insert(why.slips.begin(), slip);
    if (why.explained <= best.explained) return best.instead.push_back(slip.words);
    best = why;
  };
  right.visit_changed(right, try_one);
  return best;
}

std::vector<std::pair<const StageView*, Explanation>> explain_by_any(
    const Image& drawn, std::span<const StageView* const> stages) {
  std::vector<std::pair<const StageView*, Explanation>> found;
  std::size_t least = 99;
  const auto keep = [&](const StageView* stage, Explanation why) {
    if (why.slips.empty()) return;
    least = std::min(least, why.slips.size());
    found.emplace_back(stage, std::move(why));
  };
  const auto by_slips = [&](std::span<const StageView* const> some, int most) {
    for (const StageView* stage : some) {
      // With more slips than another's, only an earlier chapter may be meant.
      const auto before = [&](const auto& row) { return row.first->chapter <= stage->chapter; };
      if (least >= static_cast<std::size_t>(most) || std::ranges::none_of(found, before))
        keep(stage, explain(drawn, *stage, most));
    }
  };
  const auto by_views = [&](int more) {
    if (!found.empty()) return;
    for (const StageView* stage : stages) keep(stage, explain_by_view(drawn, *stage, more));
  };
  // Where light is gathered, the same random numbers are tried first.
  for (const StageView* stage : stages) {
    if (stage->tolerance == of_rounding) continue;
    StageView exact = *stage;
    exact.tolerance = of_rounding;
    keep(stage, explain(drawn, exact, 1));
    if (found.empty()) keep(stage, explain_by_view(drawn, exact, 0));
    if (!found.empty()) return found;
  }
  by_slips(stages, 1);
  by_views(0);
  by_slips(stages, 2);
  by_views(1);
  // Three slips take longer: of the nearest alone.
  if (found.empty()) by_slips(stages.first(std::min<std::size_t>(stages.size(), 1)), 3);
  std::erase_if(found, [&](const auto& row) { return row.second.slips.size() > least + 1; });
  std::ranges::stable_sort(found, {}, [](const auto& row) { return row.first->chapter; });
  return found;
}

bool has_other_colors(const Image& drawn, const StageView& stage) {
  // How often the texture has a color, in 16 steps a channel.
  constexpr int steps = 16;
  std::vector<std::size_t> times(std::size_t{steps} * steps * steps);
  const auto step_of = [](double channel, int more) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(channel * steps) + more, 0, 15));
  };
  const auto place_of = [&](const Rgb& c, int r, int g, int b) {
    return (step_of(c.r, r) * steps + step_of(c.g, g)) * steps + step_of(c.b, b);
  };
  if (stage.picture.pixels.empty()) return false;
  for (const Rgb8& texel : stage.picture.pixels) ++times[place_of(color_of(texel), 0, 0, 0)];
  const auto is_rare = [&](const Rgb& c) {
    std::size_t near = 0;
    for (int i = 0; i < 27; ++i) near += times[place_of(c, i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)];
    return near * 1000 < stage.picture.pixels.size();
  };
  long around = 0, around_wrong = 0, lit = 0, unlike = 0, impossible = 0;
  for (const Seen& seen : stage.pixels) {
    const Rgb8 is = drawn.at(seen.column, seen.row);
    if (!seen.mapped || seen.on_checkers) {
      ++around;
      around_wrong += alike(is, bytes_of_color(seen.color)) ? 0 : 1;
      continue;
    }
    const double diffuse = seen.lit->diffuse();
    if (diffuse < 0.4) continue;
    ++lit;
    const Rgb color = (color_of(is) + gray(-seen.lit->specular())) * (1 / diffuse);
    unlike += is_rare(color) ? 1 : 0;
    impossible += std::max({color.r, color.g, color.b}) > 1.02 ? 1 : 0;
  }
  return lit > 500 && around_wrong * 100 <= around && impossible * 50 <= lit && unlike * 10 >= lit;
}

bool is_in_highlight(const Image& drawn, const StageView& stage) {
  long wrong = 0, shining = 0;
  for (const Seen& seen : stage.pixels) {
    if (alike(drawn.at(seen.column, seen.row), bytes_of_color(seen.color))) continue;
    ++wrong;
    shining += seen.lit && seen.lit->specular() > 0.004 ? 1 : 0;
  }
  return shining > 4 && shining * 10 >= wrong * 9;
}

Slip wrong_shadows(const Image& drawn, const StageView& stage) {
  long dark = 0, bright = 0, other = 0, lit = 0, borders = 0;
  bool last_dark = false;
  for (const Seen& seen : stage.pixels) {
    const Rgb8 is = drawn.at(seen.column, seen.row);
    const bool right = alike(is, bytes_of_color(seen.color));
    const auto is_with = [&](double cosine) {
      return seen.lit && alike(is, bytes_of_color(mistakes::Lit(*seen.lit).with_cosine(cosine)));
    };
    lit += seen.lit && seen.lit->light.cosine > 0 ? 1 : 0;
    const bool is_dark = !right && is_with(0);
    borders += is_dark != last_dark ? 1 : 0;
    last_dark = is_dark;
    if (is_dark) {
      ++dark;
    } else if (!right) {
      ++(seen.lit && is_with(std::max(seen.lit->cosine(), 0.0)) ? bright : other);
    }
  }
  const auto some = [&](long count) { return count * 200 > lit && other * 50 < count; };
  if (some(dark) && bright * 50 < dark && borders * 5 > dark) {
    return {"full of dark dots: shadow acne, since the shadow ray meets the surface that it leaves",
            "start a little above the surface, or leave out the object that was hit"};
  }
  if (some(bright) && dark * 50 < bright) {
    return {"some shadows are missing: not every object is asked",
            "ask all objects, or all but the own"};
  }
  return {};
}

std::string all_of(const std::vector<Slip>& slips) {
  std::string words;
  for (const Slip& slip : slips) words += (words.empty() ? "" : "; and ") + slip.words;
  return words;
}

bool draws(const StageView& stage, const Image& right) {
  std::size_t off = 0;
  for (const Seen& seen : stage.pixels) {
    const Rgb8 is = {byte_of(seen.color.r), byte_of(seen.color.g), byte_of(seen.color.b)};
    off += channel_difference(is, right.at(seen.column, seen.row)) > 1 ? 1U : 0U;
  }
  return off * 1000 <= stage.pixels.size();
}

std::string Words::of(const Image& drawn, const WrongPicture& right) {
  for (const auto* known : {&stages(), &variants()}) {
    for (const OnStage& on_stage : *known) {
      if (on_stage.name != right.name) continue;
      const auto [place, is_new] = stages_.try_emplace(right.name);
      if (is_new) place->second = on_stage.view(on_stage.name, "");
    }
  }
  const auto known = stages_.find(right.name);
  if (known != stages_.end()) {
    const StageView& stage = known->second;
    const bool is_as_large = stage.width == drawn.width && stage.height == drawn.height;
    if (is_as_large && draws(stage, right.picture)) {
      const std::array<const StageView*, 1> alone{&stage};
      const auto whys = explain_by_any(drawn, alone);
      if (whys.empty()) {
        const std::string shadows = wrong_shadows(drawn, stage).words;
        if (!shadows.empty()) return shadows;
      } else {
        std::string words = all_of(whys.front().second.slips);
        for (const std::string& other : whys.front().second.instead) words += "; or " + other;
        return words;
      }
    }
  }
  return name_mistake(drawn, right.picture, mistakes_of_the_whole(right.picture));
}

}  // namespace texmap::slips
