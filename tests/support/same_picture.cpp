// Whether two pictures are the same.
#include "support/same_picture.hpp"

#include <doctest.h>

#include <algorithm>
#include <utility>

#include "engine/compare/difference.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/text.hpp"

namespace texmap::test {
namespace {

std::string text_of(Rgb8 color) { return text("(%d, %d, %d)", color.r, color.g, color.b); }

/// Writes a picture for the reader of a failure; what cannot be written is no failure of its own.
void leave(const Image& image, const std::filesystem::path& file) {
  try {
    save_png(image, file);
  } catch (const FileError&) {
    MESSAGE("could not write " << file.string());
  }
}

/// Writes both pictures and the map. Returns how their names begin.
std::string leave_pictures(const Image& is, const Image& should, const CallPlace& place) {
  const std::filesystem::path folder = std::filesystem::path(TEXMAP_DIFFERING_DIR);
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);
  const std::string stem =
      std::filesystem::path(place.file).stem().string() + "_line_" + std::to_string(place.line);
  leave(is, folder / (stem + "_is.png"));
  leave(should, folder / (stem + "_should.png"));
  leave(difference_map(is, should), folder / (stem + "_map.png"));
  return (folder / stem).string();
}

}  // namespace

std::string difference_report(const Image& is, const Image& should, const Allowed& allowed,
                              const WrongPictures& wrong) {
  if (is.width != should.width || is.height != should.height) {
    return text("the picture is %d x %d pixels, and should be %d x %d", is.width, is.height,
                should.width, should.height);
  }
  Image seen = is;  // what is allowed is no difference
  for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
    if (channel_difference(is.pixels[i], should.pixels[i]) <= allowed.levels)
      seen.pixels[i] = should.pixels[i];
  }
  const Figures found = measure(seen, should, {}, Detail::pixels);
  if (std::cmp_less_equal(found.pixels_different, allowed.pixels)) return "";
  std::vector<WrongPicture> known = mistakes_of_the_whole(should);
  if (wrong) {
    const std::vector<WrongPicture> more = wrong();
    known.insert(known.end(), more.begin(), more.end());
  }
  const std::string word = name_mistake(is, should, known);
  const auto [first, there] = std::ranges::mismatch(seen.pixels, should.pixels);
  const long place = first - seen.pixels.begin();
  std::string report =
      text("%zu of %zu pixels differ, in columns %d to %d, rows %d to %d", found.pixels_different,
           is.pixels.size(), found.box.left, found.box.left + found.box.width - 1, found.box.top,
           found.box.top + found.box.height - 1);
  report +=
      text("\n  the first, in column %ld and row %ld, is ", place % is.width, place / is.width);
  report += text_of(*first) + " and should be " + text_of(*there);
  if (!word.empty()) report += "\n  " + word;
  return report;
}

void expect_same_picture(const Image& is, const Image& should, const Allowed& allowed,
                         const WrongPictures& wrong, CallPlace place) {
  const std::string report = difference_report(is, should, allowed, wrong);
  if (report.empty()) {
    CHECK(report.empty());  // it counts as an assertion
    return;
  }
  std::string where;
  if (is.width == should.width && is.height == should.height) {
    where = "\n  look at ";
    where += leave_pictures(is, should, place) + "_is.png, ..._should.png and ..._map.png";
  }
  ADD_FAIL_CHECK_AT(place.file, place.line, report << where);
}

}  // namespace texmap::test
