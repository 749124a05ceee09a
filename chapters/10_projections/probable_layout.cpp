// Which layout a picture of the whole sphere probably has.
#include "probable_layout.hpp"

#include <cmath>

#include "engine/draw/convert_projection.hpp"

namespace texmap::chapter_10 {
namespace {

double square_of_difference(const Rgb8& a, const Rgb8& b) {
  const double r = a.r - b.r;
  const double g = a.g - b.g;
  const double blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

/// The mean square difference of any two texels of a set: twice its variance.
class Spread {
 public:
  void add(const Rgb8& p) {
    const Rgb levels{static_cast<double>(p.r), static_cast<double>(p.g), static_cast<double>(p.b)};
    sum_ = sum_ + levels;
    squares_ += square_of(levels);
    ++count_;
  }
  [[nodiscard]] double value() const {
    return 2 * (squares_ / count_ - square_of(sum_ * (1.0 / count_)));
  }

 private:
  [[nodiscard]] static double square_of(const Rgb& c) {
    return square(c.r) + square(c.g) + square(c.b);
  }
  Rgb sum_{};
  double squares_ = 0;
  double count_ = 0;
};

bool has_shape(const Image& image, Projection projection) {
  const double aspect = facts_of(projection).aspect;
  const double width = image.height * aspect;  // an own one may have been rounded
  return image.height >= 8 && std::abs(image.width - width) <= 0.5 * aspect + 0.5 &&
         (aspect != 1.5 || (image.width % 3 == 0 && image.height % 2 == 0));
}

/// True if all around the plane's disk is one color, and the disk is not.
bool is_disk(const Image& image) {
  Spread spread;
  for (const Rgb8& p : image.pixels) spread.add(p);
  if (spread.value() < 1) return false;
  const Rgb8& corner = image.at(0, 0);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const double x = 2 * (column + 0.5) / image.width - 1;
      const double y = 2 * (row + 0.5) / image.height - 1;
      const bool outside = std::sqrt(x * x + y * y) > 1 + 4.0 / image.height;
      if (outside && image.at(column, row) != corner) return false;
    }
  }
  return true;
}

/// How well a picture goes on where a layout says that it does.
struct SeamFigures {
  double inside = 0;  ///< mean square difference of neighbors on one side of a seam
  double across = 0;  ///< of neighbors across a seam
  double spread = 0;  ///< of any two texels next to the seams
};
SeamFigures seam_figures(const Image& image, Projection projection) {
  const int width = image.width;
  const int height = image.height;
  SeamFigures figures;
  Spread spread;
  int count = 0;
  const auto look = [&](const Texel& home, int right, int down) {
    const Texel beyond =
        texel_beside(projection, home, home.column + right, home.row + down, width, height);
    const Rgb8& here = image.at(home.column, home.row);
    figures.across += square_of_difference(here, image.at(beyond.column, beyond.row));
    figures.inside += square_of_difference(here, image.at(home.column - right, home.row - down));
    spread.add(here);
    ++count;
  };
  for (int row = 0; row < height; ++row) {
    look({0, row}, -1, 0);
    look({width - 1, row}, 1, 0);
  }
  if (projection != Projection::cylinder) {  // its first row reaches far from the pole
    for (int column = 0; column < width; ++column) {
      look({column, 0}, 0, -1);
      look({column, height - 1}, 0, 1);
    }
  }
  if (facts_of(projection).aspect == 1.5) {
    for (int column = 0; column < width; ++column) {
      look({column, height / 2 - 1}, 0, 1);
      look({column, height / 2}, 0, -1);
    }
  }
  figures.across /= count;
  figures.inside /= count;
  figures.spread = spread.value();
  return figures;
}

}  // namespace

std::vector<Projection> probable_layouts(const Image& image) {
  std::vector<Projection> found;
  for (const ProjectionFacts& facts : projections) {
    const Projection projection = facts.projection;
    if (!has_shape(image, projection)) continue;
    if (projection == Projection::plane) {
      if (is_disk(image)) found.push_back(projection);
      continue;
    }
    const SeamFigures seams = seam_figures(image, projection);
    if (seams.spread < 1) continue;                   // one color, or a plain frame
    if (seams.inside > 0.5 * seams.spread) continue;  // noise
    if (seams.across <= 2 * seams.inside + 2 && seams.across <= 0.25 * seams.spread)
      found.push_back(projection);
  }
  return found;
}

std::string about_layout(const std::string& name, const Image& image) {
  std::string words;
  for (const Projection projection : probable_layouts(image))
    words.append(words.empty() ? "" : " or ").append(facts_of(projection).word);
  return name + ": probably " + (words.empty() ? "not a picture of a sphere, or unknown" : words) +
         "\n";
}

}  // namespace texmap::chapter_10
