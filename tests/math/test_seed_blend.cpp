// The lecture's byte blend against `mix`.
#include <doctest.h>

#include "color.hpp"
#include "seed_blend.hpp"

using namespace texmap;

TEST_CASE("at weight 0.3 the lecture's blend changes 41 of 256 bytes that are blended with themselves, and mix none") {
  int changed_by_lecture = 0;
  int changed_by_mix = 0;
  for (int byte = 0; byte < 256; ++byte) {
    changed_by_lecture += seeds::blend_lecture(byte, byte, 0.3) != byte ? 1 : 0;
    const Color<double> color{byte / 255.0, byte / 255.0, byte / 255.0};
    changed_by_mix += mix(color, color, 0.3).r != color.r ? 1 : 0;
  }
  CHECK(changed_by_lecture == 41);
  CHECK(changed_by_mix == 0);
}

TEST_CASE("at its ends the lecture's blend gives either byte") {
  CHECK(seeds::blend_lecture(200, 100, 1) == 200);
  CHECK(seeds::blend_lecture(200, 100, 0) == 100);
  CHECK(seeds::blend_lecture(200, 100, 0.5) == 150);
}
