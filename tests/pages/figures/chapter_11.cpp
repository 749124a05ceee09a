// The figures of chapter 11's page.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "11_bump_and_normal_maps/lesson.hpp"
#include "figures.hpp"
#include "support/dice.hpp"
#include "support/pictures.hpp"
#include "texture/normal_map.hpp"

namespace texmap::test {
namespace {

/// How far an ellipsoid with half-axes 1.5, 0.75 and 1.25 lies outside the unit sphere.
struct EllipsoidHeight {
  template <class Real>
  Color<Real> operator()(const Hit<Real>& hit) const {
    const Real x = hit.normal.x / Real(1.5);
    const Real y = hit.normal.y / Real(0.75);
    const Real z = hit.normal.z / Real(1.25);
    return gray(Real(1) / sqrt(x * x + y * y + z * z) - Real(1));
  }
};

/// The largest angle to the ellipsoid's normal, in radians, over 500 directions.
double worst_angle(SlopeFrom slopes, double step) {
  const Bumps<EllipsoidHeight> bumps{.height = {}, .slopes = slopes, .step = step};
  Dice dice(11);
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3d n = normalize(rounded<double>(dice.direction()));
    const Vec3d expected =
        normalize(Vec3d{n.x / (1.5 * 1.5), n.y / (0.75 * 0.75), n.z / (1.25 * 1.25)});
    const Vec3d found = bumps(Hit<double>{n, n, n, n}, 1.0);
    worst = std::max(worst, std::atan2(length(cross(found, expected)), dot(found, expected)));
  }
  return worst;
}

}  // namespace

void figures_of_11(Figures& figures) {
  const auto globe = [](const std::vector<std::string>& words) {
    return picture(prepared<chapter_11::Lesson>(words), 600, 600);
  };
  const Image bumps = globe({});
  const Image flat = globe({"--bump", "off"});
  figures.emplace_back("11.pixels", whole(static_cast<long long>(bumps.pixels.size())));
  figures.emplace_back("11.pixels_with_bumps", whole(count_different(bumps, flat)));
  figures.emplace_back("11.pixels_by_blinn",
                       whole(count_different(bumps, globe({"--bump", "blinn"}))));
  for (const int power : {1, 3, 5, 7, 8, 10, 12}) {
    const double step = std::pow(10.0, -power);
    const std::string name = "_step_" + std::to_string(power);
    figures.emplace_back("11.forward" + name, digits(worst_angle(SlopeFrom::forward, step), 2));
    figures.emplace_back("11.central" + name, digits(worst_angle(SlopeFrom::central, step), 2));
  }
  figures.emplace_back("11.duals", digits(worst_angle(SlopeFrom::duals, 1), 2));
  const auto degrees_from_z = [](const Vec3d& n) {
    return decimals(std::atan2(std::hypot(n.x, n.y), n.z) * 180 / std::numbers::pi, 2);
  };
  const Vec3d slope_of_quarter = raised_normal(Vec3d{0, 0, 1}, {{1, 0, 0}, {0, 1, 0}},
                                               Slope<double>{0, 0.25, 0}, 0.0, BumpForm::exact);
  figures.emplace_back("11.lean_of_quarter", degrees_from_z(slope_of_quarter));
  figures.emplace_back("11.lean_of_flat",
                       degrees_from_z(normal_of_color(Color<double>{128 / 255.0, 128 / 255.0, 1})));
}

}  // namespace texmap::test
