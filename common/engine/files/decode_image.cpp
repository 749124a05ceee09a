// From the bytes of a PNG or JPEG file to a picture, and the names of files that are neither.
#include "engine/files/decode_image.hpp"

#include <algorithm>
#include <string_view>

#include "engine/files/file_error.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/read_jpeg.hpp"
#include "engine/files/read_png.hpp"
#include "engine/files/system.hpp"

namespace texmap {
namespace {

using namespace std::string_view_literals;

// Programs of Debian's packages imagemagick, libheif-examples, libavif-bin, webp, libjxl-tools,
// libopenjp2-tools, pfstools, librsvg2-bin and poppler-utils.
constexpr std::string_view usual = "convert FILE out.png";
constexpr std::string_view first_picture = "convert FILE[0] out.png";
constexpr std::string_view heif = "heif-convert FILE out.png";

struct Kind {
  std::size_t place;  // of the signature
  std::string_view signature, name, remedy;
  std::string_view keeps_light{};  // for a sky, where the file may be brighter than white
};
constexpr Kind kinds[] = {
    {4, "ftypavi", "an AVIF picture", "avifdec FILE out.png"},
    {4, "ftyphei", "a HEIC picture", heif},
    {4, "ftypmif1", "a HEIF picture", heif},
    {8, "WEBP", "a WebP picture", "dwebp FILE -o out.png"},
    {0, "v/1\1", "an OpenEXR picture", usual, "pfsin FILE | pfsout out.hdr"},
    {0, "#?", "a Radiance .hdr file", usual},
    {0, "II*\0"sv, "a TIFF picture", first_picture},
    {0, "MM\0*"sv, "a TIFF picture", first_picture},
    {0, "8BPS", "a Photoshop picture (PSD)", first_picture},
    {0, "GIF8", "a GIF picture", first_picture},
    {0, "BM", "a BMP picture", usual},
    {0, "P5", "a PGM picture", usual},
    {0, "P6", "a PPM picture", usual},
    {0, "\xFF\x0A", "a JPEG XL picture", "djxl FILE out.png"},
    {4, "JXL ", "a JPEG XL picture", "djxl FILE out.png"},
    {4, "jP  ", "a JPEG 2000 picture", "opj_decompress -i FILE -o out.png"},
    {0, "%PDF", "a PDF page", "pdftoppm -png -singlefile FILE out"},
    {0, "<svg", "an SVG drawing", "rsvg-convert FILE -o out.png"},
    {0, "<?xml", "an SVG drawing (XML)", "rsvg-convert FILE -o out.png"},
    {0, "<!DOCTYPE html", "a web page", "save the picture that the page shows, not the page"},
    {0, "<html", "a web page", "save the picture that the page shows, not the page"},
    {0, "version https://git-lfs", "a Git LFS pointer to the picture", "git lfs pull"},
    {0, "PK\3\4", "a ZIP archive", "unzip FILE"},
    {0, "\x1F\x8B", "a gzip archive", "gunzip -c FILE > out"},
};

}  // namespace

void refuse_kind(Bytes file, bool is_sky) {
  // Texts may begin with a byte order mark and blanks, and be in capitals.
  std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const auto same = [](char a, char b) {
    return a == b || ((a ^ b) == ' ' && (a | ' ') >= 'a' && (a | ' ') <= 'z');
  };
  const std::string wanted = is_sky ? "a PNG, JPEG or Radiance .hdr file" : "a PNG or JPEG file";
  for (const Kind& kind : kinds) {
    const std::string_view there =
        text.substr(std::min(kind.place, text.size()), kind.signature.size());
    if (!std::equal(there.begin(), there.end(), kind.signature.begin(), kind.signature.end(), same))
      continue;
    const bool keep = is_sky && !kind.keeps_light.empty();
    throw FileError(
        "it is " + std::string(kind.name) + ", not " + wanted +
        ", whatever its name says; try: " + std::string(keep ? kind.keeps_light : kind.remedy));
  }
  throw FileError("it is not " + wanted + ", whatever its name says");
}

void check_memory(std::uint64_t decoding, std::uint64_t later) {
  constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
  const auto refuse = [](std::uint64_t bytes, const std::string& why) {
    throw FileError("it would take " + std::to_string(bytes / mebibyte + 1) + " MiB of memory" +
                    why);
  };
  if (decoding > max_decoding_bytes) {
    refuse(decoding, " to decode, more than " + std::to_string(max_decoding_bytes / mebibyte) +
                         "; save it smaller, or with 8 bits a channel, no alpha, not interlaced "
                         "and not progressive");
  }
  if (decoding + later < 16 * mebibyte) return;
  const std::uint64_t free = free_memory();
  if (decoding + later > free) {
    refuse(decoding + later, ", and " + std::to_string(free / mebibyte) +
                                 " MiB are free; half as wide and high it takes a quarter");
  }
}

Image decode_image(Bytes file, std::string* note, DeepImage* deep, int later_bytes) {
  if (file.size() > max_file_bytes) throw FileError("the file is too long");
  if (file.empty()) throw FileError("the file is empty");
  if (looks_like_png(file)) return read_png(file, note, deep, later_bytes);
  if (looks_like_jpeg(file)) return read_jpeg(file, note, later_bytes, deep == nullptr);
  refuse_kind(file, false);
}

}  // namespace texmap
