// The figures of chapter 09's page.
#include <cmath>
#include <string>

#include "09_texture_filtering/comparison.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"

namespace texmap::test {
namespace {

using chapter_09::Lesson;

/// The floor's footprint at the center of a pixel of 800 x 600, and how it is read.
void add_footprint(Figures& figures, const Lesson& lesson, int row) {
  const View<> view = view_of(lesson.stage.camera, 800, 600);
  const auto ray = ray_through(view, Dual<double>{400, 1, 0}, Dual<double>{double(row), 0, 1});
  const auto point = point_on(lesson.floor, ray, distance_to(lesson.floor, ray));
  const auto& texture = lesson.ground.texture;
  const PyramidLevel<int>& whole = texture.pyramid.levels.front();
  const Footprint<double> footprint =
      footprint_of<double>(lesson.ground.mapping(point), whole.width, whole.height);
  const auto reads = texture.taps_of(Uv<double>{0.5, 0.5}, footprint);
  const auto level = texture.place(reads.width);
  const std::string name = "09.row_" + std::to_string(row) + "_";
  figures.emplace_back(name + "distance", decimals(std::hypot(point.x.value, point.z.value), 1));
  figures.emplace_back(name + "longer", decimals(footprint.longer, 2));
  figures.emplace_back(name + "shorter", decimals(footprint.shorter, 2));
  figures.emplace_back(name + "ratio", decimals(footprint.longer / footprint.shorter, 1));
  figures.emplace_back(name + "reads", decimals(reads.count, 0));
  figures.emplace_back(name + "level", decimals(level.number + level.fraction, 2));
}

}  // namespace

void figures_of_09(Figures& figures) {
  const auto lesson = prepared<Lesson>();
  for (const int row : {500, 300, 218, 190}) add_footprint(figures, lesson, row);
  for (const auto& one : chapter_09::compare_filters(chapter_09::floor_of(lesson), 0, false)) {
    std::string name = "09." + one.name;
    for (char& letter : name) letter = letter == ' ' ? '_' : letter;
    figures.emplace_back(name + "_error", decimals(one.error, 4));
    figures.emplace_back(name + "_from_ideal", decimals(one.own_error, 4));
    figures.emplace_back(name + "_reads", decimals(one.reads, 1));
  }
  const Image sky_line = picture(prepared<Lesson>({"--filter", "trilinear", "--scene", "plane"}));
  figures.emplace_back("09.horizon_byte", whole(sky_line.at(400, 190).g));
  figures.emplace_back("09.pyramid_texels",
                       whole(static_cast<long long>(lesson.ground.texture.pyramid.texels.size())));
}

}  // namespace texmap::test
