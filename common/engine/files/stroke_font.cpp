// The font, drawn with strokes of a pen, and the writing with it. How much of a pixel is ink
// follows from its center's distance to the nearest stroke, by sums, products, quotients and roots
// alone, which every computer rounds in the same way: a text has the same pixels everywhere.
#include "engine/files/stroke_font.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/utf8.hpp"

namespace texmap {
namespace {

// Drawn by hand: a character, the space before and after it, and its strokes as the path of an SVG
// picture. 10 is a pixel of letters of size 11, whose rows have their centers at 0, 10, 20 and so
// on: capitals reach from 0 down to 70, small letters from 20. The last one is for all others.
constexpr std::string_view table = R"(
    15 15   & 5 3 M52 70L13 26Q8 20 8 14 8 0 22 0T36 13Q36 23 16 33 0 42 0 53 0 70 21 70 46 70 49 38
  ! 8 8 M1 0V45M0 68H2V70H0   ? 5 5 M0 16Q3 0 18 0 35 0 35 17 35 27 25 34 17 39 17 49M16 68H18V70H16
  " 7 7 M0 0V18M20 0V18   = 7 7 M0 30H40M0 50H40   > 6 6 M0 16L42 40 0 64   ^ 5 5 M0 27L18 0 36 27
  # 5 5 M17 0L8 70M42 0L33 70M0 20H50M0 50H50   ~ 5 5 M0 47Q1 34 12 34 19 34 25 40T38 46Q49 46 50 33
  $ 6 6 M40 18Q35 8 20 8 2 8 2 22 2 34 20 37 40 40 40 51T20 63Q5 63 0 52M20 -5V75   ` 5 5 M0 -5L11 8
  % 5 5 M15 0Q30 0 30 17T15 34 0 17 15 0M55 36Q70 36 70 53T55 70 40 53 55 36M56 0L14 70
  ' 7 7 M0 0V18   / 3 3 M0 80L32 -5   \ 3 3 M0 -5L32 80   _ 3 3 M0 90H50   | 8 8 M0 -5V90
  ( 6 4 M16 -5Q0 12 0 39T16 83   ) 4 6 M0 -5Q16 12 16 39T0 83   × 6 6 M0 20L40 60M40 20L0 60
  * 5 5 M15 0V34M0 8L30 26M30 8L0 26   - 6 6 M0 40H20   ° 4 5 M12 0Q25 0 25 12T12 25 0 12Q0 0 12 0
  + 7 7 M20 20V60M0 40H40   ; 5 6 M5 30H7V32H5M6 69Q7 79 0 86   → 6 6 M0 40H60M40 20L60 40 40 60
  , 5 6 M6 69Q7 79 0 86   . 7 7 M0 68H2V70H0   [ 7 4 M16 -5H0V83H16   ] 4 7 M0 -5H16V83H0
  : 7 7 M0 30H2V32H0M0 68H2V70H0   { 4 4 M20 -5Q10 -5 10 8V26Q10 39 0 39 10 39 10 52V70Q10 83 20 83
  < 6 6 M42 16L0 40 42 64   ← 6 6 M60 40H0M20 20L0 40 20 60   ↓ 6 6 M20 0V67M0 47L20 67 40 47
  @ 5 5 M57 25V48Q57 59 66 59T80 37Q80 0 42 0T0 42 44 86H66M57 42Q57 24 41 24T24 42 41 60 57 42
  } 4 4 M0 -5Q10 -5 10 8V26Q10 39 20 39 10 39 10 52V70Q10 83 0 83   ↑ 6 6 M20 70V3M0 23L20 3 40 23
  0 6 6 M20 0Q40 0 40 35T20 70 0 35 20 0   5 6 6 M37 0H5L2 34Q9 26 20 26 40 26 40 48T20 70Q5 70 0 58
  1 6 6 M4 14L20 0V70M4 70H36   9 6 6 M4 60Q9 70 19 70 40 70 40 32 40 0 20 0T0 21 19 42 40 25
  2 6 6 M1 18Q3 0 20 0T38 19Q38 30 26 42L0 70H40
  3 6 6 M2 13Q7 0 20 0 37 0 37 17T20 33H15M20 33Q40 33 40 52T20 70Q4 70 0 56   7 6 6 M0 0H40L15 70
  4 6 6 M30 70V0L0 50H42   6 6 6 M36 10Q31 0 21 0 0 0 0 38 0 70 20 70T40 49 21 28 0 45
  8 6 6 M20 0Q37 0 37 16T20 33 3 16Q3 0 20 0M20 33Q40 33 40 52T20 70 0 52Q0 33 20 33
  A 3 3 M0 70L30 0 60 70M9 50H51   H 8 8 M0 0V70M50 0V70M0 30H50   Y 3 3 M0 0L30 37 60 0M30 37V70
  B 8 5 M0 30H26Q46 30 46 15T26 0H0V70H28Q50 70 50 50T28 30   O 5 5 M30 0Q60 0 60 35T30 70 0 35 30 0
  C 5 4 M55 15Q47 0 30 0 0 0 0 35T30 70Q47 70 55 55   K 8 3 M0 0V70M50 0L0 45M18 29L52 70
  D 8 5 M0 0H20Q50 0 50 35T20 70H0V0   R 8 3 M0 70V0H26Q48 0 48 20T26 40H0M28 40L52 70
  E 8 5 M40 0H0V70H40M0 30H36   U 8 8 M0 0V45Q0 70 25 70T50 45V0   W 3 3 M0 0L20 70 40 0 60 70 80 0
  F 8 3 M40 0H0V70M0 30H36   M 8 8 M0 70V0L30 55 60 0V70   X 3 3 M0 0L50 70M50 0L0 70
  G 5 7 M55 15Q47 0 30 0 0 0 0 35T30 70 60 45V40H34   P 8 4 M0 70V0H26Q48 0 48 20T26 40H0
  I 8 8 M0 0V70
  J 4 8 M30 0V50Q30 70 14 70 3 70 0 58   Q 5 5 M30 0Q60 0 60 35T30 70 0 35 30 0M36 50L62 78
  L 8 2 M0 0V70H40   S 5 5 M47 14Q41 0 25 0 3 0 3 18 3 32 25 35 50 38 50 52 50 70 25 70 5 70 0 55
  N 8 8 M0 70V0L50 70V0   T 3 3 M0 0H60M30 0V70   V 3 3 M0 0L30 70 60 0   Z 4 4 M2 0H50L0 70H50
  a 5 7 M4 28Q9 20 20 20 40 20 40 40V70M40 43H19Q0 43 0 57T17 70 40 57   l 7 4 M0 0V58Q0 70 11 70
  b 7 5 M0 0V70M0 45Q0 20 20 20T40 45 20 70 0 45   d 5 7 M40 0V70M40 45Q40 20 20 20T0 45 20 70 40 45
  c 5 4 M38 30Q33 20 21 20 0 20 0 45T21 70Q33 70 38 60   o 5 5 M20 20Q40 20 40 45T20 70 0 45 20 20
  e 5 5 M0 43H40Q40 20 20 20T0 45 21 70Q33 70 39 61   y 3 3 M0 20L22 70M44 20L19 78Q14 90 3 90
  f 3 2 M30 0H26Q10 0 10 16V70M0 20H29   i 7 7 M0 20V70M0 0V1   k 7 3 M0 0V70M37 20L0 52M14 40L39 70
  g 5 7 M40 20V70Q40 90 20 90 9 90 3 84M40 45Q40 20 20 20T0 45 20 70 40 45   v 3 3 M0 20L22 70 44 20
  h 7 7 M0 0V70M0 43Q2 20 21 20T40 42V70   t 3 4 M10 5V55Q10 70 24 70H29M0 20H29
  j 3 7 M10 20V78Q10 90 0 90M10 0
  m 7 7 M0 20V70M0 42Q1 20 16 20T30 42V70M30 42Q31 20 46 20T60 42V70   x 3 3 M0 20L40 70M40 20L0 70
  n 7 7 M0 20V70M0 43Q2 20 21 20T40 42V70   p 7 5 M0 20V90M0 45Q0 20 20 20T40 45 20 70 0 45
  q 5 7 M40 20V90M40 45Q40 20 20 20T0 45 20 70 40 45   u 7 7 M0 20V48Q0 70 19 70T40 47M40 20V70
  r 7 2 M0 20V70M0 43Q2 20 20 20H22   w 3 3 M0 20L16 70 32 20 48 70 64 20
  s 5 5 M36 29Q31 20 19 20 2 20 2 33 2 43 19 45 38 47 38 58T19 70Q5 70 0 60   z 4 4 M2 20H40L0 70H40
  other 7 7 M0 0H40V70H0V0
)";

constexpr double pen_width = 1.1;

struct Place {
  double x, y;
};

/// In pixels of letters of size 11.
struct Glyph {
  double before, after;                          ///< space to its neighbours
  double right = 0;                              ///< end of its ink, which begins at 0
  std::vector<std::pair<Place, Place>> lines{};  ///< a curve is eight
};

/// Takes a character off a text that is not empty.
Glyph take_glyph(std::string_view& text) {
  const std::string_view whole = text;
  static_cast<void>(take_character(text));
  std::string key = "  " + std::string(whole.substr(0, whole.size() - text.size())) + " ";
  if (table.find(key) == std::string_view::npos) key = "  other ";
  const char* at = table.data() + table.find(key) + key.size();

  const auto number = [&at] {
    char* end = nullptr;
    const long tenths = std::strtol(at, &end, 10);
    at = end;
    return static_cast<double>(tenths) / 10;
  };
  const auto place = [&number] {
    const double x = number();
    return Place{x, number()};
  };
  const double before = number();
  Glyph glyph{before, number()};
  Place pen{}, corner{};
  const auto draw_to = [&](Place to) {
    glyph.lines.emplace_back(pen, to);
    glyph.right = std::max(glyph.right, to.x + 1);
    pen = to;
  };
  for (char command = 0; *at != '\n' && (at[0] != ' ' || at[1] != ' ');) {
    if (*at == ' ') ++at;
    if (*at >= 'A') command = *at++;
    if (command == 'M') draw_to(pen = place());  // alone it is a dot
    if (command == 'L') draw_to(place());
    if (command == 'H') draw_to({number(), pen.y});
    if (command == 'V') draw_to({pen.x, number()});
    if (command != 'Q' && command != 'T') continue;
    corner = command == 'Q' ? place() : Place{2 * pen.x - corner.x, 2 * pen.y - corner.y};
    const Place from = pen, to = place();
    for (int eighth = 1; eighth <= 8; ++eighth) {
      const double t = eighth / 8.0, s = 1 - t;
      draw_to({s * s * from.x + 2 * s * t * corner.x + t * t * to.x,
               s * s * from.y + 2 * s * t * corner.y + t * t * to.y});
    }
  }
  return glyph;
}

/// The square of a place's distance from a line.
double squared_distance(Place p, Place from, Place to) {
  const double along_x = to.x - from.x, along_y = to.y - from.y;
  const double x = p.x - from.x, y = p.y - from.y;
  const double squared = along_x * along_x + along_y * along_y;
  const double t = squared > 0 ? std::clamp((x * along_x + y * along_y) / squared, 0.0, 1.0) : 0;
  const double off_x = x - t * along_x, off_y = y - t * along_y;
  return off_x * off_x + off_y * off_y;
}

int rounded(double x) { return static_cast<int>(std::floor(x + 0.5)); }

/// @param unit  pixels to one of letters of size 11
void draw_glyph(Image& image, int left, int baseline, const Glyph& glyph, Rgb8 color, double unit) {
  const int bottom = std::min(baseline + rounded(3 * unit), image.height);
  const int right = std::min(left + rounded(glyph.right * unit) + 1, image.width);
  for (int row = std::max(baseline - rounded(9 * unit), 0); row < bottom; ++row) {
    for (int column = std::max(left - 1, 0); column < right; ++column) {
      const Place p{(column - left + 0.5) / unit - 0.5, (row - baseline + 0.5) / unit + 7.5};
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& [from, to] : glyph.lines)
        nearest = std::min(nearest, squared_distance(p, from, to));
      const double inside = (pen_width / 2 - std::sqrt(nearest)) * unit;
      const int covered = rounded(255 * std::clamp(inside + 0.5, 0.0, 1.0));
      const auto mixed = [covered](int under, int over) {
        return static_cast<std::uint8_t>((under * (255 - covered) + over * covered + 127) / 255);
      };
      Rgb8& pixel = image.at(column, row);
      pixel = {mixed(pixel.r, color.r), mixed(pixel.g, color.g), mixed(pixel.b, color.b)};
    }
  }
}

}  // namespace

int draw_text(Image& image, int column, int row, std::string_view text, Rgb8 color, int size) {
  const double unit = size / 11.0;
  int right = column;
  double after = 0;
  for (bool first = true; !text.empty(); first = false) {
    const Glyph glyph = take_glyph(text);
    // Each begins on a whole pixel: an upright stroke at its left is sharp.
    const int left = first ? column : right + rounded((after + glyph.before) * unit);
    draw_glyph(image, left, row + rounded(8 * unit), glyph, color, unit);
    right = left + rounded(glyph.right * unit);
    after = glyph.after;
  }
  return right - column;
}

int text_width(std::string_view text, int size) {
  Image nowhere;
  return draw_text(nowhere, 0, 0, text, {}, size);
}

}  // namespace texmap
