// From the bytes of a Radiance .hdr file to light. Each texel is three mantissas and an exponent.
#include "engine/files/read_hdr.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/files/color_profile.hpp"
#include "engine/files/file_error.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/pixel_order.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

constexpr std::size_t max_header_bytes = std::size_t{1} << 16;
constexpr std::size_t max_shown = 60;  // bytes of the file in a message

using Rgbe = std::array<std::uint8_t, 4>;

[[noreturn]] void damaged(const std::string& how) {
  throw FileError("the Radiance file is damaged: " + how);
}

// The file, read from the front.
class Reader {
 public:
  explicit Reader(Bytes file) : rest_(file) {}

  std::string note;

  LightImage read(std::uint64_t most_texels) {
    const std::array<double, 3> exposure = header();
    const auto [size, order] = resolution();
    check_image_size(size);
    check_sky_size(size, most_texels);
    const int columns = static_cast<int>(size.width), rows = static_cast<int>(size.height);
    std::vector<Rgbe> texels(size.width);  // of a row
    return order.picture(columns, rows, [&](int column, int row) {
      if (column == 0) scanline(texels, row);
      return light_of(texels[static_cast<std::size_t>(column)], exposure);
    });
  }

 private:
  std::string_view take_line() {
    const auto end = std::find(rest_.begin(), rest_.end(), std::uint8_t{'\n'});
    const auto length = static_cast<std::size_t>(end - rest_.begin());
    header_bytes_ += length + 1;
    if (end == rest_.end() || header_bytes_ > max_header_bytes) damaged("its header does not end");
    const std::string_view line(reinterpret_cast<const char*>(rest_.data()), length);
    rest_ = rest_.subspan(length + 1);
    return line.substr(0, line.find_last_not_of(" \t\r") + 1);
  }

  // The lines before the first empty one. Returns by what each color's light was multiplied.
  std::array<double, 3> header() {
    std::array<double, 3> exposure = {1, 1, 1};
    bool has_format = false;
    take_line();  // the signature
    for (std::string_view line = take_line(); !line.empty(); line = take_line()) {
      const auto value_of = [line](std::string_view name) {
        if (line.substr(0, name.size()) != name) return std::string_view{};
        return line.substr(std::min(line.find_first_not_of(" \t", name.size()), line.size()));
      };
      if (const std::string_view format = value_of("FORMAT="); !format.empty()) {
        has_format = true;
        if (format != "32-bit_rle_rgbe") {
          throw FileError("its format is " + quoted(format, max_shown) +
                          ", and only 32-bit_rle_rgbe can be read; try: ra_xyze -r FILE out.hdr");
        }
      }
      if (const std::string_view typed = value_of("EXPOSURE="); !typed.empty()) {
        for (double& product : exposure) multiply(product, typed, line);
      }
      if (std::string_view typed = value_of("COLORCORR="); !typed.empty()) {
        for (double& product : exposure) multiply(product, take_word(typed), line);
      }
      if (std::string_view typed = value_of("PRIMARIES="); !typed.empty()) {
        // Radiance's own are those of sRGB, around a white of 1/3 and 1/3. Some programs write 0.
        for (const double usual : {0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329}) {
          const double stated = read_decimal(take_word(typed)).value_or(0);
          if (stated != 0 && std::abs(stated - usual) > 0.025)
            note = not_in_srgb("a space with primaries of its own (PRIMARIES)");
        }
      }
    }
    if (!has_format) damaged("it states no format");
    return exposure;
  }

  static std::string_view take_word(std::string_view& line) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(" \t", end), line.size()));
    return word;
  }

  static void multiply(double& product, std::string_view typed, std::string_view line) {
    const double factor = read_decimal(typed).value_or(-1);
    product *= factor == 0 ? 1 : factor;  // many programs write 0 for "not known"
    if (!(product >= 1e-30 && product <= 1e30)) {
      damaged("its line " + quoted(line, max_shown) +
              " has what is not a number from 1e-30 to 1e30");
    }
  }

  // The line of the size, usually -Y height +X width: how many rows the file has, and how many
  // texels each. -Y runs down, +X to the right. In files that begin with X they are columns.
  std::pair<ImageSize, PixelOrder> resolution() {
    const std::string_view line = take_line();
    std::string_view left = line;
    std::uint32_t sizes[2] = {};
    bool minus[2] = {}, is_x[2] = {};
    bool whole = true;
    for (int i = 0; i < 2; ++i) {
      left.remove_prefix(std::min(left.find_first_not_of(" \t"), left.size()));
      whole = whole && left.size() > 3 && (left[0] == '+' || left[0] == '-') &&
              (left[1] == 'X' || left[1] == 'Y') && left[2] == ' ';
      if (!whole) break;
      minus[i] = left[0] == '-';
      is_x[i] = left[1] == 'X';
      const auto [end, error] =
          std::from_chars(left.data() + 3, left.data() + left.size(), sizes[i]);
      whole = error == std::errc();
      left.remove_prefix(static_cast<std::size_t>(end - left.data()));
    }
    if (!whole || !left.empty() || is_x[0] == is_x[1])
      damaged("its size " + quoted(line, max_shown) + " is not of the form -Y height +X width");
    // The first of the two counts the file's rows.
    return {{sizes[1], sizes[0]},
            {.from_right = minus[1] == is_x[1],
             .from_below = minus[0] == is_x[0],
             .columns_first = is_x[0]}};
  }

  std::uint8_t take_byte(int row) {
    if (rest_.empty()) ends_in(row);
    const std::uint8_t byte = rest_[0];
    rest_ = rest_.subspan(1);
    return byte;
  }
  [[noreturn]] static void ends_in(int row) { damaged("it ends in row " + std::to_string(row)); }
  [[noreturn]] static void too_long(std::size_t run, int row) {
    damaged("a run of " + std::to_string(run) + " texels does not fit into row " +
            std::to_string(row));
  }

  void scanline(std::vector<Rgbe>& texels, int row) {
    const std::size_t width = texels.size();
    const bool may_be_new = width >= 8 && width <= 32767;
    if (may_be_new && rest_.size() >= 4 && rest_[0] == 2 && rest_[1] == 2 && rest_[2] < 128) {
      const std::size_t stated = big_endian_16(rest_, 2);
      if (stated != width) {
        damaged("row " + std::to_string(row) + " has " + std::to_string(stated) + " texels, not " +
                std::to_string(width));
      }
      rest_ = rest_.subspan(4);
      for (std::size_t channel = 0; channel < 4; ++channel) new_runs(texels, channel, row);
    } else {
      old_runs(texels, row);
    }
  }

  // One channel of a row: a count up to 128 and so many bytes, or 128 more than a count and the
  // byte that is repeated.
  void new_runs(std::vector<Rgbe>& texels, std::size_t channel, int row) {
    std::size_t x = 0;
    while (x < texels.size()) {
      const std::size_t code = take_byte(row);
      const std::size_t count = code > 128 ? code - 128 : code;
      if (count == 0 || count > texels.size() - x) too_long(count, row);
      if (code > 128) {
        const std::uint8_t value = take_byte(row);
        for (std::size_t i = 0; i < count; ++i) texels[x++][channel] = value;
      } else {
        for (std::size_t i = 0; i < count; ++i) texels[x++][channel] = take_byte(row);
      }
    }
  }

  // Texels one by one. Mantissas 1, 1, 1 mean: the texel before, as often as the fourth byte says;
  // several in a row are the bytes of one count, the lowest first.
  void old_runs(std::vector<Rgbe>& texels, int row) {
    std::size_t x = 0;
    std::size_t shift = 0;
    while (x < texels.size()) {
      if (rest_.size() < 4) ends_in(row);
      const Rgbe texel = {rest_[0], rest_[1], rest_[2], rest_[3]};
      rest_ = rest_.subspan(4);
      if (texel[0] != 1 || texel[1] != 1 || texel[2] != 1) {
        texels[x++] = texel;
        shift = 0;
        continue;
      }
      const std::size_t count = std::size_t{texel[3]} << shift;
      if (x == 0 || count > texels.size() - x || shift > 16) too_long(count, row);
      std::fill_n(texels.begin() + static_cast<std::ptrdiff_t>(x), count, texels[x - 1]);
      x += count;
      shift += 8;
    }
  }

  // A writer cuts mantissas off; the middle of what was cut off has no bias.
  static Color<float> light_of(const Rgbe& texel, const std::array<double, 3>& exposure) {
    if (texel[3] == 0) return {};
    const double step = std::ldexp(1.0, texel[3] - 136);
    const auto channel = [&](std::size_t i) {
      const double light = texel[i] == 0 ? 0 : (texel[i] + 0.5) * (step / exposure[i]);
      if (light > brightest_texel) {
        throw FileError("a texel has " + shown(light, 3) + " of light, more than " +
                        shown(brightest_texel, 3) + "; its EXPOSURE line may be wrong");
      }
      return static_cast<float>(light);
    };
    return {channel(0), channel(1), channel(2)};
  }

  Bytes rest_;
  std::size_t header_bytes_ = 0;
};

}  // namespace

bool looks_like_hdr(Bytes file) {
  return file.size() > 2 && file[0] == '#' && file[1] == '?';  // then RADIANCE, RGBE or a program
}

LightImage read_hdr(Bytes file, std::uint64_t most_texels, std::string* note) {
  Reader reader(file);
  LightImage light = reader.read(most_texels);
  if (note != nullptr) *note = reader.note;
  return light;
}

}  // namespace texmap
