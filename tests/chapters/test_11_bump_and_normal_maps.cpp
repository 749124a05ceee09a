// Chapter 11: bumps and normal maps.
#include <doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "11_bump_and_normal_maps/lesson.hpp"
#include "11_bump_and_normal_maps/sheets.hpp"
#include "11_bump_and_normal_maps/studs.hpp"
#include "engine/picture/load_image.hpp"
#include "published/brick_normals.hpp"
#include "published/uv.hpp"
#include "support/lesson_laws.hpp"
#include "texture/uv_inverse.hpp"

using namespace texmap;
using namespace texmap::test;
using namespace texmap::chapter_11;

namespace {

constexpr int size = 300;

Lesson globe(const std::vector<std::string>& words) { return prepared<Lesson>(words); }
Image drawn(const Lesson& lesson) { return picture(lesson, size, size); }

/// The daily exercise's check: mean and standard deviation of each channel of a square.
struct Figures {
  double mean[3], deviation[3];
};
Figures figures_of(const Image& image, int center_column, int center_row, int edge) {
  double sum[3] = {0, 0, 0}, squares[3] = {0, 0, 0};
  for (int row = center_row - edge / 2; row < center_row + edge / 2; ++row) {
    for (int column = center_column - edge / 2; column < center_column + edge / 2; ++column) {
      const Rgb8 p = image.at(column, row);
      const double channels[3] = {double(p.r), double(p.g), double(p.b)};
      for (int k = 0; k < 3; ++k) {
        sum[k] += channels[k];
        squares[k] += channels[k] * channels[k];
      }
    }
  }
  Figures figures{};
  const double count = static_cast<double>(edge) * edge;
  for (int k = 0; k < 3; ++k) {
    figures.mean[k] = sum[k] / count;
    figures.deviation[k] = std::sqrt(squares[k] / count - figures.mean[k] * figures.mean[k]);
  }
  return figures;
}

}  // namespace

TEST_CASE("the daily exercise's two checks hold on our picture of its bricks") {
  const Image image = published_bricks(800, 600);
  if (const char* file = std::getenv("TEXMAP_PUBLISHED_BRICKS")) {
    MESSAGE("pixels that differ from " << file << ": "
                                       << count_different(image, load_image(file)) << ", by more than one level: " << count_different(image, load_image(file), 1));
  }
  const Figures left = figures_of(image, 200, 300, 100);
  const Figures right = figures_of(image, 600, 300, 100);
  for (int k = 0; k < 3; ++k) MESSAGE(left.mean[k] << " " << left.deviation[k] << " | " << right.mean[k] << " " << right.deviation[k]);
}
