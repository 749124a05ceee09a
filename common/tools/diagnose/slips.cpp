// Which slips drew a picture.
#include "slips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <span>
#include <utility>

#include "engine/files/text.hpp"
#include "math/srgb.hpp"

namespace texmap::slips {
namespace {

constexpr double pi = std::numbers::pi;

struct Named {
  const char *words, *change;
};

/// The places of the path where something can slip.
enum Stage {
  turned,
  pole,
  mirrored,
  degrees,
  upside,
  u_form,
  v_form,
  look,
  squares,
  light,
  bytes,
  flip
};
constexpr int places = flip + 1;

// Row 0 of each table is right. The texture on the globe, in the order of the path.
constexpr Named of_turned[] = {
    {},
    {"not turned at all", "rotate the normal before the mapping"},
    {"turned the other way: the sign of the sine", "the other sign of the sine, or of the angle"},
    {"turned by twice the angle", "rotate once"},
    {"the center was not subtracted: (u, v) were taken from the point in the world",
     "`(point - center) / radius` for the mapping"},
    {"the normal points inward", "`(point - center) / radius`, not `center - point`"},
    {"the normal was not divided by the radius", "`(point - center) / radius`"},
};
constexpr Named of_pole[] = {
    {},
    {"the poles lie on the x axis: x and y are exchanged", "y is the axis: `v = acos(-y) / pi`"},
    {"the poles lie on the z axis: z and y are exchanged", "y is the axis: `v = acos(-y) / pi`"},
};
constexpr Named of_mirrored[] = {{}, {"mirrored: u runs the other way", ""}};
constexpr Named of_upside[] = {{}, {"upside down: v runs the other way", ""}};
constexpr Named of_u[] = {
    {},
    {"striped: u is negative on one half and was limited to 0; the 1/2 is missing", ""},
    {"twice around: u covers 0 to 2, or it was divided by pi and not by 2 pi",
     "`atan2(-z, x) / (2 * pi) + 0.5`"},
    {"folded: atan knows half of the directions; atan2 knows all",
     "`atan2(-z, x)`, not `atan(-z / x)`"},
    {"folded: atan over pi covers the map twice; atan2 over 2 pi once",
     "`atan2(-z, x) / (2 * pi) + 0.5`"},
    {"folded: acos gives east and west the same u", "`atan2(-z, x)`, not `acos(x)`"},
    {"one column: u was cut to a whole number", "divide and multiply floating-point numbers"},
    {"u is the angle in radians: it was not divided by 2 pi", "`atan2(-z, x) / (2 * pi) + 0.5`"},
    {"u is the angle in degrees", "`atan2(-z, x) / (2 * pi) + 0.5`"},
    {"the map is projected flat: u was taken from x, without the angle",
     "`atan2(-z, x) / (2 * pi) + 0.5`"},
    {"u is negative on one half: the 1/2 is missing", "`atan2(-z, x) / (2 * pi) + 0.5`"},
};
constexpr Named of_v[] = {
    {},
    {"squeezed at the poles: v was taken from the height, without the angle", ""},
    {"v covers half of the map: it was divided by 2 pi and not by pi", "`v = acos(-y) / pi`"},
    {"v reaches 2: it was divided by pi / 2 and not by pi", "`v = acos(-y) / pi`"},
    {"the south is one row: asin is negative there, and the 1/2 is missing",
     "`asin(y) / pi + 0.5`"},
    {"v covers the middle of the map: asin was divided by 2 pi", "`asin(y) / pi + 0.5`"},
    {"v is the angle in radians: it was not divided by pi", "`v = acos(-y) / pi`"},
    {"one row: v was cut to a whole number", "divide and multiply floating-point numbers"},
};
constexpr Named of_look[] = {
    {},
    {"half a texel off: u n was rounded and not cut off", ""},
    {"squeezed: (int)((n - 1) u) in place of floor(n u)", "`floor(u * n)`, at most n - 1"},
    {"u and v are exchanged", "columns by u, rows by v"},
    {"tiled: u and v are multiplied, or divided by too little", "u and v from 0 to 1"},
    {"four channels were read as three: each texel has an alpha, too",
     "the number of channels that the file has, or ask stbi_load for 3"},
    {"three channels were read as four", "the number of channels that stbi_load was asked for"},
    {"a row begins after the picture's height of texels, not after its width",
     "`(row * width + column) * channels`"},
    {"red and blue are exchanged in the texture", "red is the first byte"},
    {"the channels of the texture are in the wrong order: green, blue, red", "red, green, blue"},
    {"the channels of the texture are in the wrong order: blue, red, green", "red, green, blue"},
    {"gray: one channel of the texture was taken for all three", "each channel its own byte"},
    {"bytes from 128 on are negative: they were read as signed", "`unsigned char`"},
    {"the texture is too dark: its bytes were decoded and never encoded again", ""},
    {"the texture is too pale: its bytes were encoded twice", ""},
    {"black texture: the file was not loaded, and the program did not check", ""},
    {"bytes were divided as whole numbers: only 255 is not 0", "`byte / 255.0`"},
    {"white texture: it is missing", "the texel in place of white"},
    {"(u, v) as colors: the picture of an earlier step", "the texel at (u, v)"},
    {"half a texel off: u n was rounded and not cut off, v n was", ""},
    {"half a texel off: v n was rounded and not cut off, u n was", ""},
    {"squeezed: (int)((n - 1) u) in place of floor(n u)", "`floor(u * n)`, at most n - 1"},
};
constexpr Named of_squares[] = {
    {},
    {"every square has the other color: the two colors, or an odd number in the sum",
     "`(floor(10 u) + floor(10 v)) % 2 == 0` is the first color"},
    {"half as many squares: 5 for 10, or u and v only reach 1/2", "`floor(10 * u)`"},
    {"twice as many squares: 20 for 10, or u and v reach 2", "`floor(10 * u)`"},
    {"stripes from pole to pole: v is not used", "`floor(10 u) + floor(10 v)`"},
    {"stripes around: u is not used", "`floor(10 u) + floor(10 v)`"},
    {"slanted stripes: the sum was cut off, and not u and v", "`floor(10 u) + floor(10 v)`"},
    {"three of four squares are alike: the product of column and row, and not their sum",
     "`floor(10 u) + floor(10 v)`"},
    {"half as many squares in v", "10 in u and in v"},
    {"half as many squares in u", "10 in u and in v"},
    {"squares are moved by half: their numbers were rounded", "`floor`, not `round`"},
};
constexpr Named of_bytes[] = {
    {},
    {"too dark: light was written without the curve of image files", ""},
    {"too pale: the curve of image files was applied once too often", ""},
    {"stained: channels above 1 begin at 0 again, since a byte overflows",
     "`clamp(channel, 0, 1)` before it becomes a byte"},
    {"red and blue are exchanged in the whole picture", "red is the first byte"},
    {"the channels of the whole picture are in the wrong order: green, blue, red",
     "red, green, blue"},
    {"the channels of the whole picture are in the wrong order: blue, red, green",
     "red, green, blue"},
    {"too pale: the power 1/2.2 of image files was applied once too often", ""},
    {"too pale: the square root was applied once too often", ""},
    {"too dark: light was written without the curve of image files, or its power 2.2 was taken",
     ""},
    {"inverted: each channel is 255 minus what it should be", "`255 * channel`"},
};
constexpr Named of_flip[] = {
    {},
    {"the whole picture is mirrored: columns run the other way", "columns from the left"},
    {"the whole picture is upside down: rows run the other way", "rows from the top"},
    {"the whole picture is turned by half: columns and rows run the other way",
     "from the top left"},
};

/// Light slips beyond those that are drawn.
constexpr mistakes::LightMistake of_more_light[] = {
    {"no_limit_no_shadows",
     "too dark on the far side, and without shadows: cosines below 0 were not limited to 0",
     [](mistakes::Lit lit) { return lit.with_cosine(lit.cosine()); }},
    {"light_twice", "the light was multiplied twice",
     [](mistakes::Lit lit) {
       return lit.color * (lit.diffuse() * lit.diffuse()) + gray(lit.specular());
     }},
    {"both_sides", "lit on both sides: the cosine lost its sign, and no ray goes to the lamp",
     [](mistakes::Lit lit) { return lit.with_cosine(std::abs(lit.cosine())); }},
    {"inward", "dark where the lamp shines: the normal points inward for the light",
     [](mistakes::Lit lit) { return lit.with_cosine(std::max(-lit.cosine(), 0.0)); }},
    {"ambient_alone", "without the lamp's light: the ambient light alone",
     [](mistakes::Lit lit) { return lit.with_cosine(0); }},
    {"black_shadow", "black in the shadow alone: a point in the shadow lost its ambient light",
     [](mistakes::Lit lit) {
       return lit.light.cosine == 0 && lit.cosine() > 0 ? Rgb{} : lit.right();
     }},
    {"squared", "the light falls off too fast: the cosine was squared",
     [](mistakes::Lit lit) { return lit.with_cosine(lit.light.cosine * lit.light.cosine); }},
    {"distance_squared", "dark: the light was divided by the square of the lamp's distance",
     [](mistakes::Lit lit) {
       return lit.with_cosine(lit.light.cosine / dot(lit.to_lamp, lit.to_lamp));
     }},
};

/// All light slips of a stage; the first stands for none.
std::vector<const mistakes::LightMistake*> light_slips(const StageView& stage) {
  std::vector<const mistakes::LightMistake*> all{nullptr};
  for (const auto& one : mistakes::of_light) all.push_back(&one);
  for (const auto& one : of_more_light) all.push_back(&one);
  const bool shines = std::ranges::any_of(
      stage.pixels, [](const Seen& seen) { return seen.lit && seen.lit->material.specular > 0; });
  if (shines) {
    for (const auto& one : mistakes::of_highlight) all.push_back(&one);
  }
  return all;
}

/// Which row of each table, 0 for right; `degrees` is an angle.
struct Way {
  std::array<int, places> row{};
  bool on_squares = true;  ///< whether the slips of (u, v) reach the checkerboards
};

double whole(double x) { return std::trunc(x); }

Vec3d axes_of(const Way& way, const Vec3d& d) {
  Vec3d p = way.row[pole] == 1   ? Vec3d{d.z, d.x, d.y}
            : way.row[pole] == 2 ? Vec3d{d.y, d.z, d.x}
                                 : d;
  if (way.row[degrees] != 0) p = rotation_y(way.row[degrees])(p);
  if (way.row[mirrored] != 0) p.z = -p.z;
  if (way.row[upside] != 0) p.y = -p.y;
  return p;
}

double u_of(int form, const Vec3d& p) {
  const double angle = std::atan2(-p.z, p.x);
  switch (form) {
    case 1:
      return angle / (2 * pi);
    case 2:
      return angle / pi + 0.5;
    case 3:
      return std::atan(-p.z / p.x) / (2 * pi) + 0.5;
    case 4:
      return std::atan(-p.z / p.x) / pi + 0.5;
    case 5:
      return std::acos(p.x / std::hypot(p.x, p.z)) / (2 * pi);
    case 6:
      return whole(angle / (2 * pi) + 0.5);
    case 7:
      return angle;
    case 8:
      return angle * 180 / pi;
    case 9:
      return (p.x + 1) / 2;
    case 10:
      return std::abs(angle) / (2 * pi);
    default:
      return angle / (2 * pi) + 0.5;
  }
}

double v_of(int form, double y) {
  const double v = std::acos(std::clamp(-y, -1.0, 1.0)) / pi;
  switch (form) {
    case 1:
      return (y + 1) / 2;
    case 2:
      return v / 2;
    case 3:
      return v * 2;
    case 4:
      return v - 0.5;
    case 5:
      return v / 2 + 0.25;
    case 6:
      return v * pi;
    case 7:
      return 0;
    default:
      return v;
  }
}

Rgb color_of(const Rgb8& p) { return {p.r / 255.0, p.g / 255.0, p.b / 255.0}; }

/// The texel as a slip reads it.
Rgb texel_of(int form, const Image& image, Uv<double> uv) {
  if (form == 18) return {uv.u, uv.v, 0};
  if (form == 3) std::swap(uv.u, uv.v);
  if (form == 4) uv = {2 * uv.u - std::floor(2 * uv.u), 2 * uv.v - std::floor(2 * uv.v)};
  const auto number = [](double x) { return std::isnan(x) ? 0.0 : x; };
  const auto limited = [](double x, int n) {
    return static_cast<int>(std::clamp(x, 0.0, n - 1.0));
  };
  const bool less = form == 2 || form == 21;
  const double u = number(uv.u) * (image.width - (less ? 1 : 0));
  const double v = number(form == 21 ? 1 - uv.v : uv.v) * (image.height - (less ? 1 : 0));
  const int column = limited(form == 1 || form == 19 ? std::round(u) : std::floor(u), image.width);
  const int up = limited(form == 1 || form == 20 ? std::round(v) : std::floor(v), image.height);
  const int row = form == 21 ? up : image.height - 1 - up;
  const Rgb8& p = image.at(column, row);
  const auto byte = [&image](std::size_t i, std::size_t channels, std::size_t channel) {
    const std::size_t at = channels * i + channel;
    if (at >= 3 * image.pixels.size()) return std::uint8_t{0};
    const Rgb8& texel = image.pixels[at / 3];
    return at % 3 == 0 ? texel.r : at % 3 == 1 ? texel.g : texel.b;
  };
  const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                 static_cast<std::size_t>(column);
  switch (form) {
    case 5: {  // three bytes a texel, of four
      const auto of_four = [&](std::size_t at) {
        return at % 4 == 3 ? std::uint8_t{255} : byte(at / 4, 3, at % 4);
      };
      return color_of({of_four(3 * i), of_four(3 * i + 1), of_four(3 * i + 2)});
    }
    case 6:
      return color_of({byte(i, 4, 0), byte(i, 4, 1), byte(i, 4, 2)});
    case 7: {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(image.height) +
                      static_cast<std::size_t>(column);
      return color_of({byte(at, 3, 0), byte(at, 3, 1), byte(at, 3, 2)});
    }
    case 8:
      return color_of({p.b, p.g, p.r});
    case 9:
      return color_of({p.g, p.b, p.r});
    case 10:
      return color_of({p.b, p.r, p.g});
    case 11:
      return color_of({p.r, p.r, p.r});
    case 12: {
      const auto signed_byte = [](std::uint8_t b) { return (b < 128 ? b : b - 256) / 255.0; };
      return {signed_byte(p.r), signed_byte(p.g), signed_byte(p.b)};
    }
    case 13: {
      const Rgb c = color_of(p);
      return {srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b)};
    }
    case 14: {
      const Rgb c = color_of(p);
      return {srgb_encode(c.r), srgb_encode(c.g), srgb_encode(c.b)};
    }
    case 15:
      return {};
    case 16:
      return {p.r < 255 ? 0.0 : 1.0, p.g < 255 ? 0.0 : 1.0, p.b < 255 ? 0.0 : 1.0};
    case 17:
      return {1, 1, 1};
    default:
      return color_of(p);
  }
}

Rgb square_of(int form, const Checkerboard& board, const Uv<double>& uv) {
  const double n = board.squares * (form == 2 ? 0.5 : form == 3 ? 2 : 1);
  const double u = uv.u * n * (form == 9 ? 0.5 : 1), v = uv.v * n * (form == 8 ? 0.5 : 1);
  const auto parity = [](double x) { return x - 2 * std::floor(x / 2) != 0; };
  const double column = form == 10 ? std::round(u) : std::floor(u);
  const double row = form == 10 ? std::round(v) : std::floor(v);
  bool odd = parity(column + row);
  if (form == 1) odd = !odd;
  if (form == 4) odd = parity(column);
  if (form == 5) odd = parity(row);
  if (form == 6) odd = parity(std::floor(u + v));
  if (form == 7) odd = parity(column * row);
  return odd ? board.odd : board.even;
}

Rgb8 bytes_of(int form, const Rgb& c) {
  const auto byte = [form](double x) -> std::uint8_t {
    if (form == 1) x = srgb_decode(std::clamp(x, 0.0, 1.0));
    if (form == 2) x = srgb_encode(std::clamp(x, 0.0, 1.0));
    if (form == 3)
      return static_cast<std::uint8_t>(static_cast<long>(std::abs(x) < 1e6 ? 255 * x : 0));
    if (form == 7 || form == 8) x = std::pow(std::clamp(x, 0.0, 1.0), form == 7 ? 1 / 2.2 : 0.5);
    if (form == 9) x = std::pow(std::clamp(x, 0.0, 1.0), 2.2);
    const std::uint8_t b = byte_of(x);
    return form == 10 ? static_cast<std::uint8_t>(255 - b) : b;
  };
  const Rgb8 p{byte(c.r), byte(c.g), byte(c.b)};
  return form == 4   ? Rgb8{p.b, p.g, p.r}
         : form == 5 ? Rgb8{p.g, p.b, p.r}
         : form == 6 ? Rgb8{p.b, p.r, p.g}
                     : p;
}

/// The search for a picture's slips.
class Search {
 public:
  Search(const Image& drawn, const StageView& stage)
      : drawn_(drawn), stage_(stage), lights_(light_slips(stage)) {
    for (const Seen& seen : stage.pixels) right_.push_back(texmap::slips::bytes_of(0, seen.color));
    // What tells slips apart best is what is not right.
    std::vector<std::size_t> wrong, all;
    for (std::size_t i = 0; i < stage.pixels.size(); ++i) {
      all.push_back(i);
      if (!alike(right_[i], at(Way{}, stage.pixels[i]))) wrong.push_back(i);
    }
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
    const std::function<void(Way&, int, int)> choose = [&](Way& way, int place, int left) {
      if (left == 0 || place == places) {
        if (left == 0) try_way(way, found);
        return;
      }
      for (int row = 0; row < rows(place); ++row) {
        way.row[static_cast<std::size_t>(place)] = place == degrees ? 90 * row : row;
        choose(way, place + 1, left - (row == 0 ? 0 : 1));
      }
      way.row[static_cast<std::size_t>(place)] = 0;
    };
    Way way;
    choose(way, 0, slips);
    return found;
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

  struct Count {
    long different = 0, explained = 0;
    bool enough = true;
  };
  [[nodiscard]] Count count(const Way& way) const {
    Count result;
    std::array<long, 8> unexplained{}, seen_of{};
    for (std::size_t i = 0; i < stage_.pixels.size(); ++i) {
      const Seen& seen = stage_.pixels[i];
      const Rgb8 is = at(way, seen);
      const auto object = static_cast<std::size_t>(std::clamp(seen.object + 1, 0, 7));
      const bool fits = alike(color(way, seen), is);
      ++seen_of[object];
      unexplained[object] += fits ? 0 : 1;
      if (alike(right_[i], at({}, seen))) continue;
      ++result.different;
      result.explained += fits ? 1 : 0;
    }
    for (std::size_t i = 0; i < unexplained.size(); ++i)
      result.enough = result.enough && unexplained[i] * 50 <= seen_of[i];
    return result;
  }

  [[nodiscard]] Rgb8 color(const Way& way, const Seen& seen) const {
    const auto& row = way.row;
    if (!seen.lit) return texmap::slips::bytes_of(row[bytes], seen.color);
    mistakes::Lit lit = *seen.lit;
    if (row[turned] == 5) {  // the far side is then in the shadow of its own sphere
      lit.normal = -lit.normal;
      lit.light.cosine = 0;
    }
    if (row[turned] == 6) {
      lit.normal = lit.normal * seen.radius;
      lit.light.cosine *= seen.radius;
    }
    if (seen.mapped) {
      Vec3d d = seen.direction;
      const RotationY back{stage_.turn.cosine, -stage_.turn.sine};
      const bool reached = !seen.on_checkers || way.on_squares;
      if (reached && row[turned] != 0 && !seen.on_checkers) {
        if (row[turned] == 1) d = back(d);
        if (row[turned] == 2) d = back(back(d));
        if (row[turned] == 3) d = stage_.turn(d);
      }
      if (reached && row[turned] == 4) d = normalize(lit.lamp - lit.to_lamp);
      if (reached && row[turned] == 5) d = -d;
      if (reached && row[turned] == 6) d.y *= seen.radius;
      if (reached) d = axes_of(way, d);
      const Uv<double> uv{u_of(reached ? row[u_form] : 0, d), v_of(reached ? row[v_form] : 0, d.y)};
      lit.color = seen.on_checkers ? square_of(row[squares], stage_.checkers, uv)
                                   : texel_of(row[look], stage_.picture, uv);
    }
    const auto* light_slip = lights_[static_cast<std::size_t>(row[light])];
    return texmap::slips::bytes_of(row[bytes],
                                   light_slip == nullptr ? lit.right() : light_slip->shade(lit));
  }

  [[nodiscard]] Slip slip(int place, int row) const {
    if (place == light) return {lights_[static_cast<std::size_t>(row)]->words, ""};
    if (place == degrees) {
      const std::string end = ": u begins at another place, or the globe is turned";
      if (row == 180) {
        return {"half a turn off: u begins on the other side, or the globe is turned",
                "`u + 0.5`, minus 1 from 1 on"};
      }
      if (row % 90 == 0) return {"a quarter turn off" + end, ""};
      return {text("turned by %d degrees", row) + end, ""};
    }
    const Named& named = names(place)[static_cast<std::size_t>(row)];
    return {named.words, named.change};
  }

 private:
  static std::span<const Named> names(int place) {
    switch (place) {
      case turned:
        return of_turned;
      case pole:
        return of_pole;
      case mirrored:
        return of_mirrored;
      case upside:
        return of_upside;
      case u_form:
        return of_u;
      case v_form:
        return of_v;
      case look:
        return of_look;
      case squares:
        return of_squares;
      case bytes:
        return of_bytes;
      default:
        return of_flip;
    }
  }
  [[nodiscard]] int rows(int place) const {
    if (place == degrees) return 4;
    if (place == light) return static_cast<int>(lights_.size());
    if (place == look && stage_.picture.pixels.empty()) return 1;
    return static_cast<int>(names(place).size());
  }
  [[nodiscard]] Rgb8 at(const Way& way, const Seen& seen) const {
    const int form = way.row[flip];
    return drawn_.at(form % 2 == 1 ? drawn_.width - 1 - seen.column : seen.column,
                     form >= 2 ? drawn_.height - 1 - seen.row : seen.row);
  }
  static bool alike(const Rgb8& a, const Rgb8& b) {
    return std::abs(a.r - b.r) <= 2 && std::abs(a.g - b.g) <= 2 && std::abs(a.b - b.b) <= 2;
  }
  /// Keeps a way that explains the probes and then the picture.
  void try_way(const Way& chosen, std::vector<Way>& found) const {
    for (const bool on_squares : {true, false}) {
      Way way = chosen;
      way.on_squares = on_squares;
      const bool moves =
          std::any_of(way.row.begin(), way.row.begin() + look, [](int r) { return r != 0; });
      if (!on_squares && (!moves || stage_.picture.pixels.empty())) return;
      double missed = 0, limit = 4;
      for (const std::size_t i : probes_) {
        missed += alike(color(way, stage_.pixels[i]), at(way, stage_.pixels[i])) ? 0 : 1;
        limit += 0.12;
        if (missed > limit) break;
      }
      if (missed > limit) continue;
      const Count result = count(way);
      if (!result.enough || result.explained * 10 < result.different * 9) continue;
      found.push_back(way);
      return;
    }
  }

  const Image& drawn_;
  const StageView& stage_;
  std::vector<const mistakes::LightMistake*> lights_;
  std::vector<Rgb8> right_;
  std::vector<std::size_t> probes_;
};

}  // namespace

Explanation explain(const Image& drawn, const StageView& stage, int most) {
  Explanation result;
  const Search search(drawn, stage);
  result.different = search.count({}).different;
  if (result.different < 15) return result;  // too few to tell a mistake from a damage
  std::vector<Way> ways;
  for (int slips = 1; slips <= most && ways.empty(); ++slips) ways = search.ways(slips);
  if (ways.empty() && most < 3) ways = search.turned_ways();
  if (ways.empty()) return result;
  const auto explained = [&](const Way& way) { return search.count(way).explained; };
  std::ranges::stable_sort(ways, std::greater<>(), explained);
  result.explained = explained(ways.front());
  const auto slips_of = [&](const Way& way) {
    std::vector<Slip> slips;
    for (int place = 0; place < places; ++place) {
      const int row = way.row[static_cast<std::size_t>(place)];
      if (row != 0) slips.push_back(search.slip(place, row));
    }
    return slips;
  };
  result.slips = slips_of(ways.front());
  for (std::size_t i = 1; i < ways.size(); ++i) {
    if (explained(ways[i]) * 1000 < result.explained * 998) break;
    std::string words;
    for (const Slip& slip : slips_of(ways[i]))
      words += (words.empty() ? "" : "; and ") + slip.words;
    result.instead.push_back(words);
  }
  return result;
}

}  // namespace texmap::slips
