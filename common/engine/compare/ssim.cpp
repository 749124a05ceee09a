// Structural similarity: five blurred planes for each channel, then one formula.
#include "engine/compare/ssim.hpp"

#include <array>
#include <cstddef>

namespace texmap {
namespace {

constexpr double window_sigma = 1.5;  // pixels
constexpr double stabilizer_1 = (0.01 * 255) * (0.01 * 255);
constexpr double stabilizer_2 = (0.03 * 255) * (0.03 * 255);
constexpr std::array<std::uint8_t Rgb8::*, 3> channels = {&Rgb8::r, &Rgb8::g, &Rgb8::b};

}  // namespace

void ssim_rows(const Image& a, const Image& b, const TakeRow& take) {
  const Kernel window = bell(window_sigma, ssim_window_radius);
  const auto blurred = [&window](const Plane& plane) { return filtered(plane, window, window); };

  for_each_band(a.height, ssim_window_radius, [&](const Band& band) {
    const Image part_a = cut_out(a, band), part_b = cut_out(b, band);
    const int wide = part_a.width, high = part_a.height;
    Plane similarity(a.width, band.rows);
    Plane of_a(wide, high), of_b(wide, high), of_aa(wide, high), of_bb(wide, high),
        of_ab(wide, high);
    for (const auto channel : channels) {
      for (int y = 0; y < high; ++y) {
        for (int x = 0; x < wide; ++x) {
          const double level_a = part_a.at(x, y).*channel;
          const double level_b = part_b.at(x, y).*channel;
          of_a.row(y)[x] = level_a;
          of_b.row(y)[x] = level_b;
          of_aa.row(y)[x] = level_a * level_a;
          of_bb.row(y)[x] = level_b * level_b;
          of_ab.row(y)[x] = level_a * level_b;
        }
      }
      const Plane mean_a = blurred(of_a), mean_b = blurred(of_b);
      const Plane mean_aa = blurred(of_aa), mean_bb = blurred(of_bb), mean_ab = blurred(of_ab);
      for (int y = 0; y < band.rows; ++y) {
        for (int x = 0; x < a.width; ++x) {
          const double m_a = mean_a.row(y)[x];
          const double m_b = mean_b.row(y)[x];
          const double variance_a = mean_aa.row(y)[x] - m_a * m_a;
          const double variance_b = mean_bb.row(y)[x] - m_b * m_b;
          const double covariance = mean_ab.row(y)[x] - m_a * m_b;
          similarity.row(y)[x] +=
              (2 * (m_a * m_b) + stabilizer_1) * (2 * covariance + stabilizer_2) /
              ((m_a * m_a + m_b * m_b + stabilizer_1) * (variance_a + variance_b + stabilizer_2)) /
              3;
        }
      }
    }
    for (int y = 0; y < band.rows; ++y)
      take(band.first + y, {similarity.row(y), static_cast<std::size_t>(a.width)});
  });
}

}  // namespace texmap
