// FLIP: the paper's pipeline on bands of rows. Section numbers are the paper's.
#include "engine/compare/flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "texture/image_texture.hpp"

namespace texmap {
namespace {

using std::numbers::pi;
using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

/// The cofactors, with indices modulo 3, divided by the determinant.
Matrix inverse(const Matrix& m) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3, i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      result[i][j] = m[j1][i1] * m[j2][i2] - m[j1][i2] * m[j2][i1];
    }
  }
  const double determinant =
      m[0][0] * result[0][0] + m[0][1] * result[1][0] + m[0][2] * result[2][0];
  for (Triple& row : result) {
    for (double& value : row) value /= determinant;
  }
  return result;
}

Triple xyz_of_chromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

/// From linear light in sRGB's primaries to X, Y, Z with Y = 1 for white.
///
/// Source: ITU-R BT.709, table 1, item 1.3, for the primaries. White is D65 with five digits, as in
/// the FLIP authors' program; four digits change a figure by about 1e-5 of itself.
Matrix xyz_from_rgb() {
  const Triple red = xyz_of_chromaticity(0.64, 0.33);
  const Triple green = xyz_of_chromaticity(0.30, 0.60);
  const Triple blue = xyz_of_chromaticity(0.15, 0.06);
  Matrix matrix{};
  for (std::size_t i = 0; i < 3; ++i) matrix[i] = {red[i], green[i], blue[i]};
  const Triple amounts = times(inverse(matrix), xyz_of_chromaticity(0.31271, 0.32902));
  for (Triple& row : matrix) {
    for (std::size_t j = 0; j < 3; ++j) row[j] *= amounts[j];
  }
  return matrix;
}

/// Converts between light and the two color spaces, all relative to sRGB's white.
class Colors {
 public:
  Colors() : xyz_from_rgb_(xyz_from_rgb()), white_(times(xyz_from_rgb_, {1, 1, 1})) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (double& value : xyz_from_rgb_[i]) value /= white_[i];
    }
    rgb_from_xyz_ = inverse(xyz_from_rgb_);
  }

  /// Lightness, red-green, blue-yellow. All are linear in the light, so they can be blurred (4.1).
  [[nodiscard]] Triple ycxcz(const Triple& rgb) const {
    const auto [x, y, z] = times(xyz_from_rgb_, rgb);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
  }

  [[nodiscard]] Triple rgb(const Triple& ycxcz) const {
    const double y = (ycxcz[0] + 16) / 116;
    return times(rgb_from_xyz_, {y + ycxcz[1] / 500, y, y - ycxcz[2] / 200});
  }

  /// L*a*b* with a* and b* multiplied by L* / 100: dark colors look less colorful (4.1).
  [[nodiscard]] Triple hunt_lab(const Triple& rgb) const {
    const auto [x, y, z] = times(xyz_from_rgb_, rgb);
    const double fx = compressed(x), fy = compressed(y), fz = compressed(z);
    const double lightness = 116 * fy - 16;
    return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
  }

 private:
  /// The cube root, linear near 0, where its slope would be infinite.
  /// Source: CIE 15:2004, section 8.2.1.
  [[nodiscard]] static double compressed(double t) {
    constexpr double edge = 6.0 / 29;
    return t > edge * edge * edge ? std::cbrt(t) : t / (3 * edge * edge) + 4.0 / 29;
  }

  Matrix xyz_from_rgb_;  // divided by white
  Triple white_;
  Matrix rgb_from_xyz_{};
};

/// The HyAB distance of two colors: the distance in lightness plus that in a* and b* (4.1).
double hyab(const Triple& p, const Triple& q) {
  return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

/// Maps distances to 0 to 1. Viewers hardly tell large distances apart, so these share the last
/// 0.05 of the range (4.1).
class Spread {
 public:
  explicit Spread(const Colors& colors)
      : largest_(std::pow(hyab(colors.hunt_lab({0, 1, 0}), colors.hunt_lab({0, 0, 1})), exponent)),
        knee_(0.4 * largest_) {}

  [[nodiscard]] double operator()(double distance) const {
    const double error = std::pow(distance, exponent);
    if (error < knee_) return share_below_ / knee_ * error;
    return share_below_ + (error - knee_) / (largest_ - knee_) * (1 - share_below_);
  }

 private:
  static constexpr double exponent = 0.7;
  static constexpr double share_below_ = 0.95;
  double largest_;
  double knee_;
};

/// The contrast sensitivity of an opponent channel as a filter: one Gaussian or the sum of two,
/// a sqrt(pi / b) exp(-pi^2 x^2 / b) with x in degrees (4.1).
struct Sensitivity {
  struct Part {
    double share;
    Kernel kernel;
  };
  std::vector<Part> parts;

  Sensitivity(const std::vector<std::array<double, 2>>& a_and_b, double pixels_per_degree,
              int radius) {
    double sum = 0;
    for (const auto& [a, b] : a_and_b) {
      const double sigma = pixels_per_degree * std::sqrt(b / (2 * pi * pi));
      Kernel kernel = bell(sigma, radius);
      // bell() divides by the sum of the weights. The peak was 1 before, so 1 / peak is that sum
      // in each of the two directions.
      const double peak = kernel[static_cast<std::size_t>(radius)];
      parts.push_back({a * std::sqrt(pi / b) / (peak * peak), std::move(kernel)});
      sum += parts.back().share;
    }
    for (Part& part : parts) part.share /= sum;
  }

  [[nodiscard]] Plane operator()(const Plane& plane) const {
    Plane result(plane.width() - 2 * radius_of(parts[0].kernel),
                 plane.rows() - 2 * radius_of(parts[0].kernel));
    for (const auto& [share, kernel] : parts) {
      const Plane blurred = filtered(plane, kernel, kernel);
      for (int y = 0; y < result.rows(); ++y) {
        for (int x = 0; x < result.width(); ++x) result.row(y)[x] += share * blurred.row(y)[x];
      }
    }
    return result;
  }
};

/// Divides the positive weights by their sum, and the negative ones by the size of theirs.
Kernel balanced(Kernel kernel) {
  double above = 0, below = 0;
  for (const double weight : kernel) (weight > 0 ? above : below) += std::abs(weight);
  for (double& weight : kernel) weight /= weight > 0 ? above : below;
  return kernel;
}

/// The filters for one viewing distance.
struct Filters {
  int color_radius;      // three standard deviations of the widest Gaussian
  double feature_sigma;  // half the width of the smallest feature that counts, 0.082 degrees (4.2)
  int feature_radius;
  int margin;
  Sensitivity lightness, red_green, blue_yellow;
  Kernel smooth, slope, curvature;

  explicit Filters(double pixels_per_degree)
      : color_radius(
            static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixels_per_degree))),
        feature_sigma(0.5 * 0.082 * pixels_per_degree),
        feature_radius(static_cast<int>(std::ceil(3 * feature_sigma))),
        margin(std::max(color_radius, feature_radius)),
        lightness({{1, 0.0047}}, pixels_per_degree, color_radius),
        red_green({{1, 0.0053}}, pixels_per_degree, color_radius),
        blue_yellow({{34.1, 0.04}, {13.5, 0.025}}, pixels_per_degree, color_radius),
        smooth(bell(feature_sigma, feature_radius)),
        slope(smooth),
        curvature(smooth) {
    for (int x = -feature_radius; x <= feature_radius; ++x) {
      const auto place = static_cast<std::size_t>(x + feature_radius);
      slope[place] *= -x;
      curvature[place] *= x * x / (feature_sigma * feature_sigma) - 1;
    }
    slope = balanced(slope);
    curvature = balanced(curvature);
  }
};

/// The inner part of a plane, without `margin` pixels at each side.
Plane without_margin(const Plane& plane, int margin) {
  Plane inner(plane.width() - 2 * margin, plane.rows() - 2 * margin);
  for (int y = 0; y < inner.rows(); ++y)
    std::copy_n(plane.row(y + margin) + margin, inner.width(), inner.row(y));
  return inner;
}

/// What FLIP compares of a picture, in one band of rows.
struct Seen {
  Plane lightness, red_green, blue_yellow;  // blurred, L*a*b* with Hunt's adjustment
  Plane edges, points;                      // strength, 0 or more
};

Plane length_of(const Plane& across, const Plane& down) {
  Plane length(across.width(), across.rows());
  for (int y = 0; y < length.rows(); ++y) {
    for (int x = 0; x < length.width(); ++x) {
      const double p = across.row(y)[x], q = down.row(y)[x];
      length.row(y)[x] = std::sqrt(p * p + q * q);
    }
  }
  return length;
}

Seen seen(const Image& image, const Band& band, const Filters& filters, const Colors& colors) {
  // The band and its margin in the opponent channels.
  const Image part = cut_out(image, band);
  const int wide = part.width, high = part.height;
  const std::array<double, 256>& light = light_of_bytes<double>(TexelLight::linear);
  Plane y_plane(wide, high), cx_plane(wide, high), cz_plane(wide, high), luminance(wide, high);
  for (int y = 0; y < high; ++y) {
    for (int x = 0; x < wide; ++x) {
      const Rgb8 pixel = part.at(x, y);
      const Triple opponent = colors.ycxcz({light[pixel.r], light[pixel.g], light[pixel.b]});
      y_plane.row(y)[x] = opponent[0];
      cx_plane.row(y)[x] = opponent[1];
      cz_plane.row(y)[x] = opponent[2];
      luminance.row(y)[x] = (opponent[0] + 16) / 116;
    }
  }

  // Features, in the lightness before the blur (4.2).
  const Plane unblurred = without_margin(luminance, band.margin - filters.feature_radius);
  const Plane smooth = filtered_across(unblurred, filters.smooth);
  Plane edges = length_of(filtered(unblurred, filters.slope, filters.smooth),
                          filtered_down(smooth, filters.slope));
  Plane points = length_of(filtered(unblurred, filters.curvature, filters.smooth),
                           filtered_down(smooth, filters.curvature));

  // Color: blurred as the eye does, clamped to what a screen can show, converted to L*a*b* (4.1).
  const int rest = band.margin - filters.color_radius;
  Plane lightness = filters.lightness(without_margin(y_plane, rest));
  Plane red_green = filters.red_green(without_margin(cx_plane, rest));
  Plane blue_yellow = filters.blue_yellow(without_margin(cz_plane, rest));
  for (int y = 0; y < lightness.rows(); ++y) {
    for (int x = 0; x < lightness.width(); ++x) {
      Triple rgb = colors.rgb({lightness.row(y)[x], red_green.row(y)[x], blue_yellow.row(y)[x]});
      for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
      const Triple lab = colors.hunt_lab(rgb);
      lightness.row(y)[x] = lab[0];
      red_green.row(y)[x] = lab[1];
      blue_yellow.row(y)[x] = lab[2];
    }
  }
  return {std::move(lightness), std::move(red_green), std::move(blue_yellow), std::move(edges),
          std::move(points)};
}

}  // namespace

void flip_rows(const Image& a, const Image& b, double pixels_per_degree, const TakeRow& take) {
  const Colors colors;
  const Spread spread(colors);
  const Filters filters(pixels_per_degree);
  for_each_band(a.height, filters.margin, [&](const Band& band) {
    const Seen of_a = seen(a, band, filters, colors);
    const Seen of_b = seen(b, band, filters, colors);
    std::vector<double> values(static_cast<std::size_t>(a.width));
    for (int y = 0; y < band.rows; ++y) {
      for (int x = 0; x < a.width; ++x) {
        const auto lab = [x, y](const Seen& s) {
          return Triple{s.lightness.row(y)[x], s.red_green.row(y)[x], s.blue_yellow.row(y)[x]};
        };
        const double color = spread(hyab(lab(of_a), lab(of_b)));
        const double feature = std::max(std::abs(of_a.edges.row(y)[x] - of_b.edges.row(y)[x]),
                                        std::abs(of_a.points.row(y)[x] - of_b.points.row(y)[x]));
        // Two responses of at most 1 each have a length of at most sqrt(2) (4.2, 4.3).
        values[static_cast<std::size_t>(x)] =
            std::pow(color, 1 - std::sqrt(feature / std::numbers::sqrt2));
      }
      take(band.first + y, values);
    }
  });
}

}  // namespace texmap
