// The figures of chapter 04's page.
#include <algorithm>

#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/conventions_compared.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"

namespace texmap::test {

void figures_of_04(Figures& figures) {
  double largest = 0;
  for (const chapter_04::Relation& relation : chapter_04::measure_relations())
    largest = std::max(largest, relation.residual);
  figures.emplace_back("04.largest_error", digits(largest, 2));

  const Image by_floor = picture(prepared<chapter_03::Lesson>());
  const Image as_lecture = picture(prepared<chapter_04::Lesson>({"--rounding", "lecture"}));
  figures.emplace_back("04.pixels_other_by_rounding", whole(count_different(by_floor, as_lecture)));
}

}  // namespace texmap::test
