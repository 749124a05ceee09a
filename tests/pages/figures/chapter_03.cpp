// The figures of chapter 03's page.
#include <algorithm>

#include "03_image_texture/lesson.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"

namespace texmap::test {

void figures_of_03(Figures& figures) {
  const auto lesson = prepared<chapter_03::Lesson>();
  const std::vector<int> seen = objects_seen(lesson);
  const auto pixels = std::count(seen.begin(), seen.end(), static_cast<int>(chapter_03::middle));
  const auto& globe = std::get<chapter_03::Textured>(lesson.objects[chapter_03::middle].paint);
  const Image& map = globe.texture.image;
  const long long texels = static_cast<long long>(map.width) * map.height;
  figures.emplace_back("03.pixels_of_the_globe", whole(pixels));
  figures.emplace_back("03.texels", whole(texels));
  // Half of them are on the side that is seen.
  figures.emplace_back("03.texels_a_pixel", whole((texels / 2 + pixels / 2) / pixels));
}

}  // namespace texmap::test
