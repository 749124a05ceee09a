// Which layout a picture of the whole sphere probably has.
#include "probable_layout.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/measure/text.hpp"
#include "engine/render/convert_projection.hpp"

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

/// The other layout with the same shape and the same seams, if there is one.
std::optional<Projection> twin_of(Projection projection) {
  if (projection == Projection::cube) return Projection::equi_angular;
  if (projection == Projection::octahedral) return Projection::equal_area;
  return std::nullopt;
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
      const bool outside = std::hypot(x, y) > 1 + 4.0 / image.height;
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

/// How likely the picture is in this layout if its colors change equally fast everywhere on the
/// sphere and in every direction: the mean logarithm of the likelihood over the texels. It decides
/// between two layouts with the same seams, such as the cube and the equi-angular cube.
double likelihood(const Image& image, Projection projection) {
  const int width = image.width;
  const int height = image.height;
  const auto level = [&](int column, int row) {
    const Rgb8& p = image.at(column, row);
    return 0.3 * p.r + 0.6 * p.g + 0.1 * p.b;
  };
  // The slopes of the picture as slopes on the sphere, squared.
  std::vector<double> squares;
  double logarithms = 0;  // of the determinants: how much room a slope has in the picture
  const int stride = std::max(1, height / 256);
  constexpr int step = 2;
  for (int row = step; row + step < height; row += stride) {
    for (int column = step; column + step < width; column += stride) {
      const double right = level(column + step, row) - level(column - step, row);
      const double up = level(column, row - step) - level(column, row + step);
      if (right == 0 && up == 0) continue;  // flat: it says nothing of directions
      const Vec3<double> n =
          unproject(projection, Uv<double>{(column + 0.5) / width, 1 - (row + 0.5) / height});
      const Uv<Dual<double>> uv = project_two_steps(projection, n);
      const double east = right * uv.u.dx * width + up * uv.v.dx * height;
      const double north = right * uv.u.dy * width + up * uv.v.dy * height;
      const double room = std::log(std::abs(uv.u.dx * uv.v.dy - uv.u.dy * uv.v.dx));
      if (!std::isfinite(room + east + north)) continue;  // on a pole
      squares.push_back(square(east) + square(north));
      logarithms += room;
    }
  }
  if (squares.empty()) return 0;
  const auto count = static_cast<double>(squares.size());
  // Student's distribution with one degree of freedom: a coast is no surprise. Its width by
  // expectation and maximization.
  double variance = 0;
  for (const double x : squares) variance += std::sqrt(x) / count;
  variance *= variance;
  for (int i = 0; i < 40; ++i) {
    double sum = 0;
    for (const double x : squares) sum += 1.5 * x / (1 + x / variance);
    variance = sum / count;
  }
  double sum = logarithms / count - std::log(variance);
  for (const double x : squares) sum -= 1.5 * std::log(1 + x / variance) / count;
  return sum;
}

}  // namespace

std::optional<Projection> probable_layout(const Image& image) {
  for (const ProjectionFacts& facts : projections) {
    const Projection projection = facts.projection;
    if (!has_shape(image, projection)) continue;
    if (projection == Projection::plane) {
      if (is_disk(image)) return projection;
      continue;
    }
    const SeamFigures seams = seam_figures(image, projection);
    if (seams.spread < 1) continue;                   // one color, or a plain frame
    if (seams.inside > 0.5 * seams.spread) continue;  // noise
    if (seams.across > 2 * seams.inside + 2 || seams.across > 0.25 * seams.spread) continue;
    const std::optional<Projection> twin = twin_of(projection);
    if (!twin) return projection;
    const double advantage = likelihood(image, projection) - likelihood(image, *twin);
    if (std::abs(advantage) < 0.001) return std::nullopt;
    return advantage > 0 ? projection : *twin;
  }
  return std::nullopt;
}

std::string about_layout(const std::string& name, const Image& image) {
  const std::optional<Projection> layout = probable_layout(image);
  std::string all = name + ": probably " +
                    (layout ? facts_of(*layout).word : "not a picture of a sphere, or unknown") +
                    "\n";
  for (const ProjectionFacts& facts : projections) {
    if (!has_shape(image, facts.projection) || facts.projection == Projection::plane) continue;
    const SeamFigures seams = seam_figures(image, facts.projection);
    all += text("  %s: neighbors across its seams differ %.2f times as much as those on one side",
                facts.word, std::sqrt(seams.across / (seams.inside + 1e-9)));
    const bool has_twin = facts.aspect == 1.5 || facts.aspect == 1;
    if (has_twin) all += text("; log likelihood %.4f", likelihood(image, facts.projection));
    all += "\n";
  }
  return all;
}

}  // namespace texmap::chapter_10
