// Which layout a picture of the whole sphere probably has.
#include "probable_layout.hpp"

#include <cmath>
#include <numbers>
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

/// The mean square difference of two texels anywhere: twice the variance.
double spread_of(const Image& image) {
  double sum = 0;
  double squares = 0;
  for (const Rgb8& p : image.pixels) {
    for (const double channel : {p.r, p.g, p.b}) squares += channel * channel;
  }
  const auto count = static_cast<double>(image.pixels.size());
  const auto mean_square = [&](auto channel) {
    double total = 0;
    for (const Rgb8& p : image.pixels) total += channel(p);
    return square(total / count);
  };
  sum = mean_square([](const Rgb8& p) { return p.r; }) +
        mean_square([](const Rgb8& p) { return p.g; }) +
        mean_square([](const Rgb8& p) { return p.b; });
  return 2 * (squares / count - sum);
}

bool has_shape(const Image& image, Projection projection) {
  const double aspect = facts_of(projection).aspect;
  const double width = image.height * aspect;  // an own one may have been rounded
  return image.height >= 8 && std::abs(image.width - width) <= 0.5 * aspect + 0.5 &&
         (aspect != 1.5 || (image.width % 3 == 0 && image.height % 2 == 0));
}

/// The channels of a texel as numbers.
double channel_of(const Rgb8& p, int channel) {
  return channel == 0 ? p.r : channel == 1 ? p.g : p.b;
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

double bend_left(const Image& image, Projection projection) {
  // Across an inner edge the slope of a smooth picture jumps by `bend` times its slope along the
  // edge: found from the layouts by hand, with t from -1 to 1 along the edge. See the page.
  const auto bend = [projection](double t) {
    switch (projection) {
      case Projection::cube:
        return t;
      case Projection::equi_angular:
        return std::sin(t * std::numbers::pi / 2);
      case Projection::octahedral:
        return 2 * t;
      default:
        return t < 0 ? -2.0 : 2.0;
    }
  };
  double sum = 0;
  double count = 0;
  // The edge lies between the columns `edge - 1` and `edge`, or rows if `flipped`.
  const auto look = [&](int edge, int first, int last, bool flipped) {
    const auto at = [&](int across, int along, int channel) {
      return flipped ? channel_of(image.at(along, across), channel)
                     : channel_of(image.at(across, along), channel);
    };
    for (int along = first + 1; along < last; ++along) {
      const double t = 2 * (along + 0.5 - first) / (last + 1 - first) - 1;
      for (int channel = 0; channel < 3; ++channel) {
        const double jump = (at(edge + 1, along, channel) - at(edge, along, channel)) -
                            (at(edge - 1, along, channel) - at(edge - 2, along, channel));
        const double slope = (at(edge - 1, along + 1, channel) - at(edge - 1, along - 1, channel) +
                              at(edge, along + 1, channel) - at(edge, along - 1, channel)) /
                             4;
        sum += square(jump - bend(t) * slope);
        ++count;
      }
    }
  };
  if (facts_of(projection).aspect == 1.5) {
    for (const int edge : {image.width / 3, 2 * image.width / 3}) {
      look(edge, 0, image.height / 2 - 1, false);
      look(edge, image.height / 2, image.height - 1, false);
    }
  } else {
    look(image.width / 2, 0, image.height - 1, false);
    look(image.height / 2, 0, image.width - 1, true);
  }
  return sum / count;
}

std::optional<Projection> probable_layout(const Image& image) {
  std::optional<Projection> best;
  double least = 0;
  for (const ProjectionFacts& facts : projections) {
    const Projection projection = facts.projection;
    if (!has_shape(image, projection)) continue;
    const SeamFigures seams = seam_figures(image, projection);
    if (seams.spread < 1) continue;  // one color
    if (projection == Projection::plane) {
      if (is_disk(image)) return projection;
      continue;
    }
    if (seams.inside > 0.5 * seams.spread) continue;  // noise
    if (seams.across > 2 * seams.inside + 2) continue;
    const bool has_twin = facts.aspect == 1.5 || facts.aspect == 1;
    const double left = has_twin ? bend_left(image, projection) : 0;
    if (!best || left < least) {
      best = projection;
      least = left;
    }
  }
  return best;
}

std::string about_layout(const std::string& name, const Image& image) {
  const std::optional<Projection> layout = probable_layout(image);
  std::string all = name + ": probably " + (layout ? facts_of(*layout).word : "unknown") + "\n";
  for (const ProjectionFacts& facts : projections) {
    if (!has_shape(image, facts.projection) || facts.projection == Projection::plane) continue;
    const SeamFigures seams = seam_figures(image, facts.projection);
    all += text("  %s: neighbors across its seams differ %.2f times as much as those beside them",
                facts.word, std::sqrt(seams.across / (seams.inside + 1e-9)));
    const bool has_twin = facts.aspect == 1.5 || facts.aspect == 1;
    all += has_twin ? text("; bend left %.2f\n", bend_left(image, facts.projection)) : "\n";
  }
  return all;
}

}  // namespace texmap::chapter_10
