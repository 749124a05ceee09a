// The figures of chapter 10's page.
#include <cmath>
#include <numbers>
#include <string>

#include "10_projections/lesson.hpp"
#include "engine/picture/load_image.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"
#include "texture/projection_facts.hpp"

namespace texmap::test {

void figures_of_10(Figures& figures) {
  // Land by the rule of assets/README.md, each texel counted once, and by the area of its row.
  const Image earth = load_image(std::string(TEXMAP_ASSETS_DIR) + "/earth.png");
  double counted = 0;
  double weighted = 0;
  double weights = 0;
  for (int row = 0; row < earth.height; ++row) {
    const double weight = std::sin((row + 0.5) / earth.height * std::numbers::pi);
    double land = 0;
    for (int column = 0; column < earth.width; ++column) {
      const Rgb8 pixel = earth.at(column, row);
      land += pixel.b > pixel.r + 20 ? 0 : 1;
    }
    counted += land;
    weighted += land * weight;
    weights += weight * earth.width;
  }
  const double texels = static_cast<double>(earth.width) * earth.height;
  figures.emplace_back("10.land_percent", decimals(100 * weighted / weights, 1));
  figures.emplace_back("10.land_percent_by_count", decimals(100 * counted / texels, 1));

  // The file read as if its rows were those of a cylinder.
  auto lesson = prepared<chapter_10::Lesson>();
  const Image right = picture(lesson);
  auto& globe = std::get<chapter_10::Textured>(lesson.objects[chapter_10::middle].paint);
  globe.mapping = {Projection::cylinder};
  figures.emplace_back("10.pixels_by_cylinder", whole(count_different(picture(lesson), right)));

  // How much wider than high small circles are in the equirectangular picture.
  for (const int latitude : {60, 80, 89}) {
    const double angle = latitude * std::numbers::pi / 180;
    const Vec3d n{std::cos(angle) * 0.8, std::sin(angle), std::cos(angle) * 0.6};
    figures.emplace_back("10.stretch_at_" + std::to_string(latitude),
                         decimals(distortion(Projection::equirect, n).stretch, 2));
  }
  const double largest = distortion(Projection::equirect, Vec3d{0.8, 0, 0.6}).area;
  figures.emplace_back("10.texels_needed", whole(std::lround(std::ceil(1024 * 1024 * largest))));
}

}  // namespace texmap::test
