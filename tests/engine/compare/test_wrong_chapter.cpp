// A chapter with a mistake, compared with the right one: each mistake shows in its own figure.
#include <doctest.h>

#include "03_image_texture/lesson.hpp"
#include "engine/compare/difference.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

constexpr Box globe = {337, 237, 126, 126};  // where the middle sphere is seen

Image chapter(const std::string& texture) {
  return picture(prepared<chapter_03::Lesson>({"--texture", texture}));
}

bool inside(const Box& box, const Box& outer) {
  return box.left >= outer.left && box.top >= outer.top &&
         box.left + box.width <= outer.left + outer.width &&
         box.top + box.height <= outer.top + outer.height;
}

/// The rule for golden pictures: at most 0.02 % of the pixels off by more than one level.
bool same_by_the_golden_rule(const Figures& f) {
  return pixels_off_by_more_than(f, 1) * 5000 <= f.pixels_compared;
}

/// Black everywhere but on the middle sphere, or the other way round.
Image mask_of_the_globe(bool globe_is_compared) {
  const std::vector<int> seen = objects_seen(prepared<chapter_03::Lesson>());
  Image mask(800, 600);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if ((seen[i] == chapter_03::middle) == globe_is_compared) mask.pixels[i] = {255, 255, 255};
  }
  return mask;
}

}  // namespace

TEST_CASE(
    "mirrored u: the globe and nothing else differs, and its structure is lost while its colors "
    "stay") {
  const TemporaryFolder folder;
  save_png(mirrored(load_image(find_texture("earth.png"))), folder / "mirrored.png");
  const Image right = chapter("earth.png");
  const Image wrong = chapter(folder / "mirrored.png");
  const Figures f = measure(right, wrong);
  CHECK_FALSE(same_by_the_golden_rule(f));
  CHECK(inside(f.box, globe));
  CHECK(f.pixels_different > 6000);  // half of the globe's
  CHECK(measure(right, wrong, mask_of_the_globe(false)).pixels_different == 0);

  const Figures on_globe = measure(right, wrong, mask_of_the_globe(true));
  CHECK(on_globe.share_different > 0.5);
  CHECK(on_globe.structural_similarity < 0.7);
  CHECK(on_globe.flip > 0.2);
}

TEST_CASE("half a texel: small where the map is smooth, but no golden picture") {
  // Each texel twice, so that one column is half a texel.
  const Image map = load_image(find_texture("earth.png"));
  Image twice(2 * map.width, map.height), shifted(2 * map.width, map.height);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < twice.width; ++column) {
      twice.at(column, row) = map.at(column / 2, row);
      shifted.at(column, row) = map.at((column + 1) % twice.width / 2, row);
    }
  }
  const TemporaryFolder folder;
  save_png(twice, folder / "twice.png");
  save_png(shifted, folder / "shifted.png");
  const Image right = chapter(folder / "twice.png");
  CHECK(measure(chapter("earth.png"), right).pixels_different == 0);
  const Figures f = measure(right, chapter(folder / "shifted.png"));
  CHECK_FALSE(same_by_the_golden_rule(f));
  CHECK(inside(f.box, globe));
  CHECK(f.pixels_different > 1000);
  CHECK(f.structural_similarity > 0.99);

  // Less than the mirrored globe by every figure of amount.
  save_png(mirrored(map), folder / "mirrored.png");
  const Figures mirrored = measure(right, chapter(folder / "mirrored.png"));
  CHECK(f.root_mean_square_error < mirrored.root_mean_square_error / 2);
  CHECK(f.flip < mirrored.flip / 2);
  CHECK(f.structural_similarity > mirrored.structural_similarity);
}

TEST_CASE(
    "one stray pixel outside the globe: too little for the golden rule and for every mean, found "
    "by the exact figures") {
  const Image right = chapter("earth.png");
  Image wrong = right;
  wrong.at(11, 580) = {255, 0, 255};
  const Figures f = measure(right, wrong);
  CHECK(same_by_the_golden_rule(f));
  CHECK(f.structural_similarity > 0.999);
  CHECK(f.pixels_different == 1);
  CHECK(f.box == Box{11, 580, 1, 1});
  CHECK(f.worst.column == 11);
  CHECK(f.worst.row == 580);
  CHECK_FALSE(inside(f.box, globe));
  CHECK(measure(right, wrong, mask_of_the_globe(false)).pixels_different == 1);
  CHECK(measure(right, wrong, mask_of_the_globe(true)).pixels_different == 0);
}
