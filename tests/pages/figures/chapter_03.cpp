// The figures of chapter 03's page.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "03_image_texture/lesson.hpp"
#include "engine/picture/load_image.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::test {
namespace {

using chapter_03::Lesson;

const ImageTexture& map_of(const Lesson& lesson) {
  return std::get<chapter_03::Textured>(lesson.objects[chapter_03::middle].paint).texture;
}

/// Column, row and bytes of the texel that holds (u, v).
void add_texel(Figures& figures, const std::string& name, const ImageTexture& map,
               const Uv<double>& uv) {
  const auto [column, row] =
      texel_place(uv, map.image.width, map.image.height, map.v_axis, map.rounding);
  const Rgb8 texel = map.image.at(column, row);
  figures.emplace_back("03.texel_" + name, std::to_string(column) + ", " + std::to_string(row));
  figures.emplace_back(
      "03.color_" + name,
      std::to_string(texel.r) + ", " + std::to_string(texel.g) + ", " + std::to_string(texel.b));
}

/// How many texels a pixel of the globe covers: the area between its four corners.
double texels_under(const Lesson& lesson, int column, int row) {
  const View<> view = view_of(lesson.stage.camera, 800, 600);
  const Image& map = map_of(lesson).image;
  std::array<Uv<double>, 4> corners;
  const std::array<std::array<double, 2>, 4> shifts{
      {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Ray<double> ray{view.eye,
                          direction_through(view, column + shifts[i][0], row + shifts[i][1])};
    const double t = distance_to(lesson.objects[chapter_03::middle].shape, ray);
    corners[i] = uv_rtiow(ray.origin + ray.direction * t);
  }
  double twice = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Uv<double> a = corners[i], b = corners[(i + 1) % 4];
    twice += a.u * b.v - b.u * a.v;
  }
  return std::abs(twice) / 2 * map.width * map.height;
}

/// The texels with a center that the eye sees: the globe is the sphere of radius 1 around 0.
long long texels_seen(const Lesson& lesson) {
  const Image& map = map_of(lesson).image;
  long long count = 0;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Uv<double> center{(column + 0.5) / map.width, 1 - (row + 0.5) / map.height};
      count += dot(direction_rtiow(center), lesson.stage.camera.eye) > 1 ? 1 : 0;
    }
  }
  return count;
}

/// Chapter 00's file with the page's code: it looks for assets/ in the folder where it is run.
Image drawn_by_one_file() {
  const TemporaryFolder folder;
  const std::string file = folder / "drawn.png";
  const Outcome outcome =
      run("cd \"" TEXMAP_ASSETS_DIR "/..\" && \"" TEXMAP_BIN_DIR "/00_with_earth\" --out \"" +
          file + "\"");
  if (outcome.status != 0) throw std::runtime_error("00_with_earth: " + outcome.err);
  return load_image(file);
}

}  // namespace

void figures_of_03(Figures& figures) {
  const auto lesson = prepared<Lesson>();
  const std::vector<int> seen = objects_seen(lesson);
  const auto pixels = std::count(seen.begin(), seen.end(), static_cast<int>(chapter_03::middle));
  const ImageTexture& map = map_of(lesson);
  figures.emplace_back("03.pixels_of_the_globe", whole(pixels));
  const long long visible = texels_seen(lesson);
  figures.emplace_back("03.texels_a_pixel", whole((visible + pixels / 2) / pixels));
  figures.emplace_back("03.texels_in_the_middle", decimals(texels_under(lesson, 400, 300), 0));
  figures.emplace_back("03.texels_in_florida", decimals(texels_under(lesson, 409, 283), 0));
  figures.emplace_back("03.texels_near_the_pole", decimals(texels_under(lesson, 400, 240), 0));

  figures.emplace_back("03.pixels_other_than_one_file",
                       whole(count_different(picture(lesson), drawn_by_one_file())));

  Lesson closer = lesson;
  // As --zoom 4 does.
  closer.stage.camera.fov_y_degrees =
      360 / pi<double>() * std::atan(std::tan(pi<double>() / 6) / 4);
  figures.emplace_back("03.texels_closer", decimals(texels_under(closer, 400, 300), 1));

  add_texel(figures, "corner", map, {0, 0});
  add_texel(figures, "middle", map, {0.5, 0.5});
  add_texel(figures, "sahara", map, {0.53, 0.63});
  add_texel(figures, "amazon", map, {0.33, 0.47});
  add_texel(figures, "greenland", map, {0.39, 0.91});
  add_texel(figures, "last", map, {1, 1});
  add_texel(figures, "berlin", map, {0.5 + 13.4 / 360, 0.5 + 52.5 / 180});

  Lesson upside = prepared<Lesson>({"--texture", "uv_map.png"});
  const Image upright = picture(upside);
  std::get<chapter_03::Textured>(upside.objects[chapter_03::middle].paint).texture.v_axis =
      VAxis::down;
  figures.emplace_back("03.pixels_upside_down", whole(count_different(picture(upside), upright)));
}

}  // namespace texmap::test
