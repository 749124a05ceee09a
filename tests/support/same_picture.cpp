// Whether two pictures are the same.
#include "support/same_picture.hpp"

#include <doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "engine/compare/difference.hpp"
#include "engine/compare/difference_map.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/save_png.hpp"

namespace texmap::test {
namespace {

/// Where two pictures of one size differ by more than the allowed levels.
struct Differences {
  long count = 0;
  int left = 0, right = -1, top = 0, bottom = -1;
  int first_column = 0, first_row = 0;
};

Differences differences_of(const Image& a, const Image& b, int levels) {
  Differences found;
  for (int row = 0; row < a.height; ++row) {
    for (int column = 0; column < a.width; ++column) {
      if (channel_difference(a.at(column, row), b.at(column, row)) <= levels) continue;
      if (found.count == 0) {
        found = {0, column, column, row, row, column, row};
      }
      found.left = std::min(found.left, column);
      found.right = std::max(found.right, column);
      found.bottom = row;
      ++found.count;
    }
  }
  return found;
}

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
  const Differences found = differences_of(is, should, allowed.levels);
  if (found.count <= allowed.pixels) return "";
  std::vector<WrongPicture> known = mistakes_of_the_whole(should);
  if (wrong) {
    const std::vector<WrongPicture> more = wrong();
    known.insert(known.end(), more.begin(), more.end());
  }
  const std::string word = name_mistake(is, should, known);
  std::string report =
      text("%ld of %zu pixels differ, in columns %d to %d, rows %d to %d", found.count,
           is.pixels.size(), found.left, found.right, found.top, found.bottom);
  report +=
      text("\n  the first, in column %d and row %d, is ", found.first_column, found.first_row);
  report += text_of(is.at(found.first_column, found.first_row));
  report += " and should be ";
  report += text_of(should.at(found.first_column, found.first_row));
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
