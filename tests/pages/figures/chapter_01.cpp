// The figures of chapter 01's page.
#include "01_plain_spheres/lesson.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"

namespace texmap::test {

void figures_of_01(Figures& figures) {
  const chapter_01::Lesson lesson;
  const Image reference = picture(lesson);
  const long in_float = count_different(picture<float>(lesson), reference);
  figures.emplace_back("01.pixels", whole(static_cast<long long>(reference.pixels.size())));
  figures.emplace_back("01.pixels_other_in_float", whole(in_float));
}

}  // namespace texmap::test
