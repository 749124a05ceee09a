// The changes that docs/how_to_change_things.md tells its reader to make: what they change in the
// picture, and what they do not. TEXMAP_COLLECT=1 writes the page's pictures.
#include <doctest.h>

#include <cstdlib>
#include <set>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "changes/can.hpp"
#include "changes/fifth_sphere.hpp"
#include "changes/float_mapping.hpp"
#include "changes/int_stripes.hpp"
#include "changes/marble.hpp"
#include "changes/moved.hpp"
#include "changes/own_mapping.hpp"
#include "changes/own_texture.hpp"
#include "changes/plain.hpp"
#include "changes/plane.hpp"
#include "changes/second_picture.hpp"
#include "changes/stripes.hpp"
#include "changes/tiles.hpp"
#include "engine/draw/wide_packs.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "number/kinds/pack.hpp"
#include "support/pictures.hpp"

using namespace texmap;
using namespace texmap::test;

// Each program has files of wide packs, also one whose lesson says that it does not run on packs.
template Image texmap::run_in_wide_packs<Instructions::avx2>(
    const WorkOf<change_float_mapping::Lesson>&, NumberKind);

namespace {

constexpr int width = 320;
constexpr int height = 240;

template <class Lesson>
Image small(const Lesson& lesson) {
  return picture(lesson, width, height);
}

/// Checks that the page shows the picture of a change, and that only some objects have changed.
///
/// @tparam Number  must draw the same picture: double for a lesson that is no template
/// @param may_change  indices of objects after the change; -1 is the background
template <class Number = Pack<double>, class Before, class After>
void check_change(const Before& before, const After& after, const std::string& name,
                  const std::set<int>& may_change) {
  CAPTURE(name);
  const Image was = small(before), is = small(after);
  const std::string file = TEXMAP_TESTS_DIR "/lessons/changes/" + name + ".png";
  if (std::getenv("TEXMAP_COLLECT") != nullptr) save_png(is, file);
  CHECK(load_image(file) == is);
  CHECK(picture<Number>(after, width, height) == is);
  const std::vector<int> seen = objects_seen(after, width, height);
  long changed = 0, elsewhere = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (was.pixels[i] == is.pixels[i]) continue;
    ++(may_change.count(seen[i]) == 1 ? changed : elsewhere);
  }
  CHECK(changed > 300);
  CHECK(elsewhere == 0);
}

}  // namespace

TEST_CASE("each change draws the page's picture, also in packs, and changes what the page says") {
  const chapter_01::Lesson first;
  const chapter_02::Lesson second;
  check_change(first, change_fifth_sphere::Lesson{}, "fifth_sphere",
               {0, 1, 2, 3, 4});  // shadows, too
  check_change(second, change_stripes::Lesson{}, "stripes", {change_stripes::right});
  using namespace change_own_mapping;
  check_change(second, change_own_mapping::Lesson{}, "own_mapping", {middle, right, ground});
  check_change(second, change_tiles::Lesson{}, "tiles", {change_tiles::ground});
  check_change<double>(second, change_int_stripes::Lesson{}, "int_stripes",
                       {middle, right, ground});
  change_marble::Lesson plain;
  plain.objects[change_marble::left].paint = Solid{red};
  check_change(plain, change_marble::Lesson{}, "marble", {change_marble::left});
  check_change(first, change_plane::Lesson{}, "plane", {-1, 0, 1, 2});  // the ground is no object
  const auto own_texture = prepared<change_own_texture::Lesson>();
  check_change(prepared<chapter_03::Lesson>(), own_texture, "own_texture",
               {change_own_texture::middle});
  check_change(prepared<chapter_03::Lesson>(), prepared<change_can::Lesson>(), "can",
               {-1, change_can::middle, change_can::left, change_can::right,
                change_can::ground});  // shadows, too
  const auto two = prepared<change_second_picture::Lesson>();
  check_change(prepared<chapter_03::Lesson>(), two, "second_picture",
               {change_second_picture::right});
  CHECK(small(prepared<change_second_picture::Lesson>({"--second", "earth.png"})) != small(two));
  check_change(prepared<chapter_03::Lesson>(), prepared<change_moved::Lesson>(), "moved",
               {change_moved::middle});
  CHECK(small(own_texture) == small(prepared<chapter_03::Lesson>({"--texture", "uv_map.png"})));
}

TEST_CASE("(u, v) in float changes pixels at edges of squares alone") {
  CHECK(change_float_mapping::Lesson::about.numbers == Numbers::single);
  const chapter_02::Lesson before;
  const Image first = picture(before);
  const long changed = count_different(picture(change_float_mapping::Lesson{}), first);
  // The page states both.
  CHECK(changed == 0);
  CHECK(count_different(picture<float>(before), first) == 77);
}

TEST_CASE("a lesson in plain double and if draws the picture of the template, byte for byte") {
  CHECK(picture(change_plain::Lesson{}) == picture(chapter_01::Lesson{}));
  CHECK(change_plain::Lesson::about.numbers == Numbers::only_double);
}
