// Which layout a picture of the whole sphere probably has.
#include "probable_layout.hpp"

#include <cmath>
#include <numbers>

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

/// The mean square difference of two texels anywhere: twice the variance.
double spread_of(const Image& image) {
  Rgb sum{};
  double squares = 0;
  for (const Rgb8& p : image.pixels) {
    const Rgb levels{static_cast<double>(p.r), static_cast<double>(p.g), static_cast<double>(p.b)};
    sum = sum + levels;
    squares += square(levels.r) + square(levels.g) + square(levels.b);
  }
  const auto count = static_cast<double>(image.pixels.size());
  const double mean_squares = square(sum.r / count) + square(sum.g / count) + square(sum.b / count);
  return 2 * (squares / count - mean_squares);
}

bool has_shape(const Image& image, Projection projection) {
  const double aspect = facts_of(projection).aspect;
  const double width = image.height * aspect;  // an own one may have been rounded
  return image.height >= 8 && std::abs(image.width - width) <= 0.5 * aspect + 0.5 &&
         (aspect != 1.5 || (image.width % 3 == 0 && image.height % 2 == 0));
}

/// The layout of the same shape and the same seams: the one with the smoother inner edges.
std::optional<Projection> twin_of(Projection projection) {
  if (projection == Projection::cube) return Projection::equi_angular;
  if (projection == Projection::octahedral) return Projection::equal_area;
  return std::nullopt;
}

/// The color around the plane's disk is one color, and the disk is not.
bool is_disk(const Image& image) {
  const Rgb8& corner = image.at(0, 0);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const double x = 2 * (column + 0.5) / image.width - 1;
      const double y = 2 * (row + 0.5) / image.height - 1;
      const bool outside = std::hypot(x, y) > 1 + 2.0 / image.height;
      if (outside && image.at(column, row) != corner) return false;
    }
  }
  return true;
}

}  // namespace

SeamFigures seam_figures(const Image& image, Projection projection) {
  const int width = image.width;
  const int height = image.height;
  SeamFigures figures{.spread = spread_of(image)};
  int count = 0;
  const auto look = [&](const Texel& home, int right, int down) {
    const Texel beyond =
        texel_beside(projection, home, home.column + right, home.row + down, width, height);
    const Rgb8& here = image.at(home.column, home.row);
    figures.across += square_of_difference(here, image.at(beyond.column, beyond.row));
    figures.inside += square_of_difference(here, image.at(home.column - right, home.row - down));
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
  return figures;
}

double bend_correlation(const Image& image, Projection projection) {
  const LightImage bytes = light_of(image, TexelLight::encoded);
  const auto color = [&](const Vec3<double>& p) {
    return light_at(bytes, projection, project(projection, p));
  };
  const bool cube = facts_of(projection).aspect == 1.5;
  const double texel = std::numbers::pi / 2 / (image.height / 2.0);  // about, in radians
  double product = 0;
  double squares_along = 0;
  double squares_across = 0;
  // At a place of an edge: how the color changes along it, and how it bends across it.
  const auto look = [&](const Vec3<double>& place, const Vec3<double>& onward, double weight) {
    const Vec3<double> p = normalize(place);
    const Vec3<double> along = normalize(onward - p * dot(onward, p));
    const Vec3<double> across = cross(p, along);
    const Color<double> here = color(p);
    for (const double step : {4 * texel, 5 * texel, 6 * texel}) {
      const Color<double> change = color(p + along * step) + color(p - along * step) * -1.0;
      const Color<double> bent = color(p + across * step) + color(p - across * step) + here * -2.0;
      const double along_it = square(change.r) + square(change.g) + square(change.b);
      const double across_it = square(bent.r) + square(bent.g) + square(bent.b);
      const double share = 1 / (along_it + across_it + 1e-4);  // every place has the same say
      product += weight * share * (change.r * bent.r + change.g * bent.g + change.b * bent.b);
      squares_along += square(weight) * share * along_it;
      squares_across += share * across_it;
    }
  };
  const int places = image.height / 2;
  for (int i = 0; i < places; ++i) {
    const double t = (i + 0.5) / places;
    for (const double side : {-1.0, 1.0}) {
      for (const double other : {-1.0, 1.0}) {
        if (cube) {  // from the middle of each of the twelve edges to both its ends
          const double weight = std::sin(2 * std::atan(t)) - t;
          for (const double end : {-1.0, 1.0}) {
            look({side, end * t, other}, {0, end, 0}, weight);
            look({end * t, side, other}, {end, 0, 0}, weight);
            look({side, other, end * t}, {0, 0, end}, weight);
          }
        } else {  // from both poles to the equator, along four meridians
          look({0, side * (1 - t), other * t}, {0, 0, other}, 1 - t);
          look({other * t, side * (1 - t), 0}, {other, 0, 0}, 1 - t);
        }
      }
    }
  }
  return product / std::sqrt(squares_along * squares_across + 1e-30);
}

std::optional<Projection> probable_layout(const Image& image) {
  for (const ProjectionFacts& facts : projections) {
    const Projection projection = facts.projection;
    if (!has_shape(image, projection)) continue;
    if (spread_of(image) < 1) continue;  // one color
    if (projection == Projection::plane) {
      if (is_disk(image)) return projection;
      continue;
    }
    const SeamFigures seams = seam_figures(image, projection);
    if (seams.inside > 0.5 * seams.spread) continue;  // noise
    if (seams.across > 2 * seams.inside + 2) continue;
    const std::optional<Projection> twin = twin_of(projection);
    if (!twin) return projection;
    const double one = bend_correlation(image, projection);
    const double other = bend_correlation(image, *twin);
    const bool undecided = std::abs(one + other) < 0.005;
    if (undecided || min(std::abs(one), std::abs(other)) > 0.3) return std::nullopt;
    return one + other < 0 ? projection : *twin;
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
    if (has_twin) all += text("; bend %.3f", bend_correlation(image, facts.projection));
    all += "\n";
  }
  return all;
}

}  // namespace texmap::chapter_10
