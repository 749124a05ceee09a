// The figures of chapter 04's page.
#include <algorithm>
#include <vector>

#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/conventions_compared.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"

namespace texmap::test {
namespace {

/// On how many pixels of the globe the lecture's rounding reads another texel.
long long other_texels(const chapter_03::Lesson& lesson) {
  const auto& globe = lesson.objects[chapter_03::middle];
  const Image& map = std::get<chapter_03::Textured>(globe.paint).texture.image;
  const View<> view = view_of(lesson.stage.camera, 800, 600);
  const std::vector<int> seen = objects_seen(lesson);
  long long count = 0;
  for (int i = 0; i < 800 * 600; ++i) {
    if (seen[static_cast<std::size_t>(i)] != static_cast<int>(chapter_03::middle)) continue;
    const auto ray = ray_through<double>(view, i % 800, i / 800);
    const Uv<double> uv = uv_rtiow(normal_at(globe.shape, ray, distance_to(globe.shape, ray)));
    const auto by = [&](TexelRounding rounding) {
      return texel_place(uv, map.width, map.height, VAxis::up, rounding);
    };
    const auto a = by(TexelRounding::floor), b = by(TexelRounding::lecture);
    count += a.column != b.column || a.row != b.row ? 1 : 0;
  }
  return count;
}

}  // namespace

void figures_of_04(Figures& figures) {
  double largest = 0;
  for (const chapter_04::Relation& relation : chapter_04::measure_relations())
    largest = std::max(largest, relation.residual);
  figures.emplace_back("04.largest_error", digits(largest, 2));

  const Image by_floor = picture(prepared<chapter_03::Lesson>());
  const Image as_lecture = picture(prepared<chapter_04::Lesson>({"--rounding", "lecture"}));
  figures.emplace_back("04.pixels_other_by_rounding", whole(count_different(by_floor, as_lecture)));
  figures.emplace_back("04.pixels_other_texel",
                       whole(other_texels(prepared<chapter_03::Lesson>())));
}

}  // namespace texmap::test
