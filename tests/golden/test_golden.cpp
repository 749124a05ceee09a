// The golden picture that no program draws: chapter 13's sheet, without the times that it measures.
// All others: programs.sh. TEXMAP_COLLECT=1 writes a new one. Look at it before you commit it.
#include <doctest.h>

#include <cstdlib>

#include "13_speed_for_accuracy/lesson.hpp"
#include "13_speed_for_accuracy/show.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "support/pictures.hpp"
#include "support/same_picture.hpp"

using namespace texmap;

TEST_CASE("chapter 13 draws its golden sheet") {
  const chapter_13::Globe globe(chapter_13::Lesson{}.texture.load());
  const Image drawn = chapter_13::draw_sheet(globe, 1312, 1090, 0, [](int, int) {});
  const std::string file = TEXMAP_TESTS_DIR "/golden/13_speed_for_accuracy.png";
  if (std::getenv("TEXMAP_COLLECT") != nullptr) save_png(drawn, file);
  const Image golden = load_image(file);
  test::expect_same_picture(drawn, golden);
}
