// What each filter would show of checkers if it needed no pyramid: its own ideal.
#include "ideal.hpp"

#include <algorithm>
#include <cmath>

namespace texmap::chapter_09 {
namespace {

constexpr int cells = 48;  // in each direction of an ellipse; 384 make 0.0087 of ewa's 0.0088

/// The mean of +1 and -1, which alternate over the whole numbers (+1 from 0 to 1), from `low` to
/// `high`: a difference of triangle waves.
double mean_sign(double low, double high) {
  const auto integral = [](double x) {
    constexpr double whole = 0x1.8p52;                 // from here on doubles are whole numbers
    return std::abs(x - 2 * (x / 2 + whole - whole));  // of x / 2 its nearest
  };
  return (integral(high) - integral(low)) / (high - low);
}

/// The mean over an ellipse around (x, y), weighted as `Filtered::elliptical` weighs texels.
///
/// @param a, b, c  as in Filtered::Ellipse, in squares
double white_in_ellipse(double x, double y, double a, double b, double c) {
  // A square -1 <= s, t <= 1 is sheared so that its circle s^2 + t^2 <= 1 becomes the ellipse.
  const double wide = std::sqrt(a), shear = b / wide, high = std::sqrt(c - shear * shear);
  const double cell = 2.0 / cells;
  double sum = 0, weights = 0;
  for (int i = 0; i < cells; ++i) {
    const double s = (i + 0.5) * cell - 1, middle = x + wide * s;
    const double columns = mean_sign(middle - wide * cell / 2, middle + wide * cell / 2);
    for (int j = 0; j < cells; ++j) {
      const double t = (j + 0.5) * cell - 1, rest = 1 - s * s - t * t;
      if (rest <= 0) continue;
      const double row = y + shear * s + high * t;
      sum += square(rest) * columns * mean_sign(row - high * cell / 2, row + high * cell / 2);
      weights += square(rest);
    }
  }
  return 0.5 + 0.5 * sum / weights;
}

}  // namespace

double white_in_box(double x, double y, double width, double height) {
  return 0.5 +
         0.5 * mean_sign(x - width / 2, x + width / 2) * mean_sign(y - height / 2, y + height / 2);
}

double ideal_light(const FilteredTexture& texture, int squares, const Uv<Dual<double>>& uv) {
  const Uv<Dual<double>> down{uv.u, Dual<double>(1.0) - uv.v};
  const Uv<double> at{down.u.value, down.v.value};
  const PyramidLevel<int>& whole = texture.pyramid.levels.front();
  const double texel = static_cast<double>(squares) / whole.width;
  const auto square_at = [&](const Uv<double>& middle, double width) {
    return white_in_box(middle.u * squares, middle.v * squares, width * texel, width * texel);
  };
  const auto footprint = footprint_of<double>(down, whole.width, whole.height);
  switch (texture.filter) {
    case Filter::nearest:
      return square_at({(std::floor(at.u * whole.width) + 0.5) / whole.width,
                        (std::floor(at.v * whole.height) + 0.5) / whole.height},
                       1);
    case Filter::bilinear:
      return square_at(at, 1);  // four texels mixed are the mean over a box as wide as one
    case Filter::trilinear:
      return square_at(at, std::max(footprint.longer, 1.0));
    case Filter::ewa: {
      const auto ellipse = texture.ellipse_of(footprint);
      const double scale = squares / ellipse.level.width, area = scale * scale;
      return white_in_ellipse(at.u * squares, at.v * squares, ellipse.a * area, ellipse.b * area,
                              ellipse.c * area);
    }
    case Filter::anisotropic:
    case Filter::stochastic:
      break;
  }
  const auto reads = texture.taps_of(at, footprint);
  double sum = 0;
  for (int i = 0; i < static_cast<int>(reads.count); ++i)
    sum += square_at(reads.at(i), reads.width);
  return sum / reads.count;
}

}  // namespace texmap::chapter_09
